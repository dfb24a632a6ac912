# SPDX-License-Identifier: MIT
# The shared library gives away what plumbago.h declares and nothing else; installed, a program finds it and the static one
# through pkg-config, and uninstalled, nothing of it is left.
. "$ROOT/tests/check.sh"

library=$(echo "$BUILD_DIR"/libplumbago.so.*.*.*)
[ -f "$library" ] || { fail "the shared library is built" "no $library"; exit; }
is "its soname" "$(objdump -p "$library" | awk '$1 == "SONAME" { print $2 }')" libplumbago.so.0
declared=$(sed -nE 's/^PLB_API .*[ *](plb_[a-z0-9_]+)\(.*/\1/p' "$ROOT/src/api/plumbago.h" | sort)
if [ "$(wc -l <<<"$declared")" -gt 25 ]; then ok "the header declares functions"; else fail "the header declares functions" "$declared"; fi
is "each line of the header with PLB_API is one" "$(grep -c '^PLB_API' "$ROOT/src/api/plumbago.h")" "$(wc -l <<<"$declared")"
exported=$(nm -D --defined-only "$library" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort)
case $BUILD_DIR in
*asan* | *ubsan* | *tsan* | *cover* | *failing*) skip "it exports what the header declares" "an instrumented build exports what its instruments need" ;;
*) report "it exports what the header declares" "$(diff <(echo "$declared") <(echo "$exported"))" ;;
esac

# ---- installed ----
case $BUILD_DIR in
"$ROOT"/build/release | build/release) ;;
*) skip "an installed library" "only the release build is installed"; exit ;;
esac
# `-o all`: what is there is installed, nothing is compiled.
install="make -s -C $ROOT -o all DESTDIR=$TMP/dest PREFIX=/opt/plumbago"
dest=$TMP/dest/opt/plumbago
# shellcheck disable=SC2086
check "make install" $install install
if [ "$(find "$dest" -type f | wc -l)" -gt 10 ]; then ok "files were installed"; else fail "files were installed" "$(find "$dest" -type f | wc -l)"; fi
# An installed tree that lies elsewhere for now.
export PKG_CONFIG_PATH=$dest/lib/pkgconfig
pkg_config() { pkg-config "$@" plumbago | sed "s#/opt/plumbago#$dest#g"; }
is "pkg-config knows the version" "$(pkg-config --modversion plumbago)" "$(basename "$library" | sed 's/libplumbago.so.//')"
cp "$ROOT/examples/line.c" .
# shellcheck disable=SC2046
check "an example is built with the shared library" cc line.c $(pkg_config --cflags --libs) -o shared
export LD_LIBRARY_PATH=$dest/lib
if ldd shared | grep -q "$dest/lib/libplumbago.so.0"; then ok "it needs libplumbago.so.0"; else fail "it needs libplumbago.so.0" "$(ldd shared | head -n 3 | tr '\n' '|')"; fi
check "it runs" ./shared
mv line.png shared.png 2>/dev/null
rm -f "$dest"/lib/libplumbago.so*
# shellcheck disable=SC2046
check "an example is built with the static one" cc line.c $(pkg_config --static --cflags --libs) -o static
check "it runs without the shared one" ./static
same "both draw the same" line.png shared.png
# shellcheck disable=SC2086
check "make uninstall" $install uninstall
report "nothing is left" "$(find "$dest" -type f -o -type l)"
