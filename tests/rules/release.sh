# SPDX-License-Identifier: MIT
# The installed files are complete, and one version number is said everywhere.
. "$ROOT/tests/check.sh"
unset MAKEFLAGS MAKELEVEL MFLAGS
version=$(make -s -C "$ROOT" version)
if [[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]]; then ok "a version of three numbers"; else fail "a version of three numbers" "$version"; fi
is "plumbago --version" "$("$PLUMBAGO" --version | head -n 1)" "plumbago $version"
is "plumbago-profile --version" "$("$PLUMBAGO_PROFILE" --version | head -n 1)" "plumbago-profile $version"
is "the newest in NEWS" "$(sed -n 's/^## \([0-9.]*\).*/\1/p' "$ROOT/NEWS.md" | head -n 1)" "$version"
is "the newest in the packages' changelog" "$(sed -n '1s/.*(\([0-9.]*\).*/\1/p' "$ROOT/examples/packaging/debian/changelog")" "$version"
stale=$(grep -noE '\bplb_version\b.*|(/\* "|\.Ql )[0-9]+\.[0-9]+\.[0-9]+' "$ROOT/src/api/plumbago.h" "$ROOT"/man/*.3 | grep -E '[0-9]+\.[0-9]+\.[0-9]+' | grep -vF "$version")
report "the header and its manual" "$stale"

# Into a folder, from what is built: make is told that the programs are new enough.
root=$PWD/root
build=${BUILD_DIR##*/}
if ! make -s -C "$ROOT" -o all BUILD="${build%%-*}" SUFFIX="${build#"${build%%-*}"}" DESTDIR="$root" PREFIX=/opt/plumbago install >"$TMP/out" 2>&1; then
    fail "make install" "$(tail -n 1 "$TMP/out")"
    exit
fi
cd root/opt/plumbago || exit 1
missing=$(for f in bin/plumbago bin/plumbago-profile libexec/plumbago/tap-svg include/plumbago.h lib/libplumbago.a share/plumbago/profiles/HB.pencil \
    share/man/man1/plumbago.1 share/man/man7/plumbago.7; do [ -s $f ] || echo $f; done)
report "make install: all is there" "$missing"
export PKG_CONFIG_PATH=$PWD/lib/pkgconfig
is "pkg-config's version" "$(pkg-config --modversion plumbago)" "$version"
is "pkg-config's place" "$(pkg-config --variable=prefix plumbago)" /opt/plumbago
report "nothing speaks of another place" "$(grep -rl /usr/local share lib/pkgconfig 2>/dev/null)"
if find . -path '*/profiles/*' -o -path '*/man/*' -type f | xargs stat -c '%a %n' | grep -q '^[0-9]*[1357]\b.*\.[0-9]$'; then fail "manuals are no programs"; else ok "manuals are no programs"; fi
make -s -C "$ROOT" BUILD="${build%%-*}" SUFFIX="${build#"${build%%-*}"}" DESTDIR="$root" PREFIX=/opt/plumbago uninstall >"$TMP/out" 2>&1
report "make uninstall: nothing stays" "$(find "$root" ! -type d)"
