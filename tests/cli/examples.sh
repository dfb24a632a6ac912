# SPDX-License-Identifier: MIT
# The examples that use the library are built and draw what their first lines say.
. "$ROOT/tests/check.sh"

# runs NAME FILE...: the example ends well, says nothing of errors, and each file is there.
runs() {
    local name=$1 file missing=
    shift
    if ! "$BUILD_DIR/examples/$name" >said 2>&1; then fail "example $name" "$(head -n 1 said)"; return; fi
    for file in "$@"; do [ -s "$file" ] || missing+=" $file"; done
    is "example $name writes$(printf ' %s' "$@")" "$missing" ""
}
runs line line.png
runs lighthouse lighthouse.png lighthouse.svg
runs plot plot.pdf
if [ -x "$BUILD_DIR/examples/shells" ]; then
    runs shells shells.png
    is "example shells is told of progress up to the end" "$(sed 's/.*, //' said)" "100 % done"
else
    skip "example shells" "no C++ compiler here"
fi
if command -v rsvg-convert >/dev/null; then
    mkdir gallery
    check "the gallery is drawn" "$ROOT/examples/gallery/gallery.sh" "$PLUMBAGO" gallery
    is "it shows six drawings before and after" "$(find gallery -name '*-before.png' -size +0 | wc -l) $(find gallery -name '*-after.png' -size +0 | wc -l)" "6 6"
else
    skip "the gallery" "no rsvg-convert here"
fi
for example in "$BUILD_DIR"/examples/*; do
    case ${example##*/} in *.d | line | lighthouse | plot | shells) ;; *) fail "example ${example##*/}" "it is run by no test" ;; esac
done
is "the light is in the sky" "$(tool png_stats lighthouse.png >stats 2>&1 && echo drawn)" drawn

library=$BUILD_DIR/libplumbago.so.0
case $BUILD_DIR in
*asan* | *ubsan* | *tsan* | *cover* | *failing*) skip "example ridges.py" "Python cannot load an instrumented library" ;;
*)
    if command -v python3 >/dev/null; then
        check "example ridges.py" python3 "$ROOT/examples/ridges.py" "$library"
        if [ -s ridges.png ] && [ -s ridges.svg ]; then ok "example ridges.py writes ridges.png ridges.svg"; else fail "example ridges.py writes ridges.png ridges.svg" "it does not"; fi
        said=$(python3 "$ROOT/examples/ridges.py" "$library" 2>&1)
        if [[ $said =~ ^"darkness 0.0"[1-9] ]]; then ok "it finds the page darker than paper"; else fail "it finds the page darker than paper" "$said"; fi
    else
        skip "example ridges.py" "no python3 here"
    fi
    ;;
esac
