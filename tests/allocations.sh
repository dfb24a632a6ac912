# SPDX-License-Identifier: MIT
# The n-th allocation fails, for small drawings of each format, a profile and a capture: a build of its own. LONG=1: for every n,
# else for the first of each case and some of the others.
. "$ROOT/tests/check.sh"
case $BUILD_DIR in */release) ;; *) skip "allocations that fail" "once is enough: with the plain release build" && exit ;; esac
unset MAKEFLAGS MAKELEVEL MFLAGS BUILD CC CFLAGS SUFFIX
if ! make -s -C "$ROOT" -j2 BUILD=failing failing >"$TMP/make" 2>&1; then
    fail "the build for failing allocations" "$(grep -m 1 -E 'error|Error' "$TMP/make")"
    exit
fi
# Helpers that hand out what the taps wrote, for those start slowly.
mkdir helpers drawings
cat >drawings/small.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="15mm" viewBox="0 0 20 15"><clipPath id="c"><path d="M0 0H18V15H0Z"/></clipPath>
<g fill="none" stroke="black" stroke-width=".3" clip-path="url(#c)"><path d="M2 2H16M16 2V12"/><path d="M2 12C6 2 10 14 16 8" stroke-dasharray="3 1"/></g>
<path d="M4 4H8V8H4Z" fill="#999"/></svg>
SVG
cat >drawings/small.ps <<'PS'
%!PS
<< /PageSize [60 45] >> setpagedevice
/box { newpath moveto 10 0 rlineto 0 10 rlineto closepath } def
5 5 box stroke gsave 20 20 translate 30 rotate 0 0 box fill grestore
[3 1] 0 setdash 5 40 moveto 20 30 40 30 55 40 curveto stroke (unused) pop 3 array pop showpage
PS
cat >drawings/small.list <<'LIST'
plumbago-list 1
page 20 15
omit image 1 a picture
gradient linear pad 1 1 0 0 1 0 0 2 2 8 8 0 0 0 0 1 1 1 1 1 1
clip - nonzero M 0 0 L 18 0 L 18 15 L 0 15 Z
clip 0 evenodd M 1 1 L 17 0 L 18 15 L 0 15 Z
stroke 1 colour 0 0 0 1 width 0.3 round dash 3 1 @ 0 M 2 12 C 6 2 10 14 16 8
stroke 0 colour 0 0 0 1 width 0.3 round M 2 2 L 16 2
fill - gradient@0 0.5 0.5 0.5 1 nonzero M 4 4 L 8 4 L 8 8 L 4 8 Z
end
LIST
cp "$ROOT/tests/stage/entities.dxf" drawings/small.dxf
printf 'plumbago-list 1\npage 11 11\nfill - colour .6 .6 .6 1 nonzero M 2 2 L 9 2 L 9 9 Z\nend\n' >drawings/hatch.list
"$BUILD_DIR/tap-svg" <drawings/small.svg >svg.out
"$BUILD_DIR/tap-ps" <drawings/small.ps >ps.out
"$BUILD_DIR/tap-dxf" <drawings/small.dxf >dxf.out 2>/dev/null
for tap in svg ps dxf; do # in the script itself, by the shell alone: in their cage they may read no other file, nor start another program
    {
        printf '#!/bin/sh\nwhile read -r l; do :; done\nwhile IFS= read -r l; do printf "%%s\\n" "$l"; done <<"THE END"\n'
        cat $tap.out
        printf '\nTHE END\n'
    } >helpers/tap-$tap
    chmod +x helpers/tap-$tap
done
printf '<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="6mm" viewBox="0 0 40 6"><path d="M3 3H37" stroke="black" fill="none"/></svg>' >line.svg
"$PLUMBAGO" -q --squiggle 0 -o drawings/scan.png line.svg
"$ROOT/build/failing/tests/failing/test_allocations" helpers drawings ${LONG:+whole} 2>"$TMP/err"
code=$?
[ $code -eq 0 ] || fail "allocations that fail" "exit status $code: $(grep -m 1 -E 'ERROR|runtime error|SUMMARY' "$TMP/err" | cut -c 1-200)"
failed=$(sed -n 's/ allocations failed$//p' "$TMP/err")
if [ "${failed:-0}" -gt $([ -n "${LONG:-}" ] && echo 1000 || echo 300) ]; then ok "$failed allocations failed"; else fail "many allocations failed" "only ${failed:-0}"; fi
