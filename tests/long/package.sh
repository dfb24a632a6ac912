# SPDX-License-Identifier: MIT
# `make package` builds Debian packages that hold what they should, and lintian finds no error in them.
. "$ROOT/tests/check.sh"
for program in dpkg-buildpackage dh; do
    command -v $program >/dev/null || { skip "Debian packages" "no $program here (Debian: debhelper dpkg-dev)" && exit; }
done
unset MAKEFLAGS MAKELEVEL MFLAGS BUILD CC CFLAGS SUFFIX
cp -r "$ROOT" source
rm -rf source/build
if ! make -s -C source package >"$TMP/out" 2>&1; then
    fail "make package" "$(tail -n 1 "$TMP/out")"
    exit
fi
version=$(make -s -C "$ROOT" version)
cd source/build/package || exit 1
holds() { # PACKAGE PATTERN...
    local package=$1 pattern missing=''
    shift
    dpkg-deb -c "$package"_"$version"_*.deb >"$TMP/list" 2>"$TMP/err" || { fail "$package is built" "$(cat "$TMP/err")" && return; }
    for pattern; do grep -qE "$pattern" "$TMP/list" || missing+="$pattern "; done
    report "$package has its files" "$missing"
}
holds plumbago '\./usr/bin/plumbago$' '\./usr/bin/plumbago-profile$' '/libexec/plumbago/tap-'{svg,plain,ps,dxf}'$' '/man1/plumbago.1.gz$' \
    '/man1/plumbago-profile.1.gz$' '/man5/pencil.5.gz$' '/man5/plumbago-list.5.gz$' '/man7/plumbago.7.gz$' '/thumbnailers/plumbago.thumbnailer$' \
    '/bash-completion/completions/plumbago$' '/zsh/vendor-completions/_plumbago$' '/fish/vendor_completions.d/plumbago.fish$'
holds libplumbago0 '/libplumbago.so.0 ->' "/libplumbago.so.$version\$"
holds libplumbago-dev '/include/plumbago.h$' '/libplumbago.a$' '/libplumbago.so ->' '/pkgconfig/plumbago.pc$' '/man3/plumbago.3.gz$'

# Those who link with the library need, even to ask pkg-config, all the libraries plumbago.pc names.
depends=$(dpkg-deb -f libplumbago-dev_*.deb Depends) missing=''
for library in $(dpkg-deb --fsys-tarfile libplumbago-dev_*.deb | tar -xO --wildcards '*/plumbago.pc' | sed -n 's/^Requires[^:]*: //p'); do
    owner=$(dpkg-query -S "*/pkgconfig/$library.pc" 2>/dev/null | sed 's/:.*//;q')
    [[ " $depends" == *" ${owner:-nobody}"[\ ,]* || " $depends" == *" $owner" ]] || missing+="$library (${owner:-no package}) "
done
report "libplumbago-dev brings the libraries of plumbago.pc" "$missing"

# libtiff is loaded when a TIFF is written, so nothing but the rules asks for its package.
for package in plumbago libplumbago0; do
    depends=$(dpkg-deb -f "$package"_*.deb Depends)
    if [[ " $depends" == *" libtiff"[0-9]* ]]; then ok "$package brings libtiff"; else fail "$package brings libtiff" "$depends"; fi
done

# As installed, in a folder: the program finds its taps beside it, the thumbnailer makes a square picture.
mkdir root && for p in *.deb; do dpkg-deb -x "$p" root; done
export PATH=$PWD/root/usr/bin:$PATH
example a.svg
if root/usr/libexec/plumbago/plumbago-thumbnailer 128 a.svg thumbnail 2>"$TMP/err"; then ok "a thumbnail"; else fail "a thumbnail" "$(head -n 1 "$TMP/err")"; fi
is "its size" "$(info thumbnail size)" "128 128"
if command -v lintian >/dev/null; then
    report "lintian finds no error" "$(lintian --fail-on none --suppress-tags bogus-mail-host,bogus-mail-host-in-debian-changelog,initial-upload-closes-no-bugs *.changes 2>/dev/null | grep '^E:')"
else
    skip "lintian finds no error" "no lintian here (Debian: lintian)"
fi
