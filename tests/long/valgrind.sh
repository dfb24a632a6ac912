# SPDX-License-Identifier: MIT
# The main cases under valgrind: no error, no leak. Foreign programs run as they are.
. "$ROOT/tests/check.sh"
command -v valgrind >/dev/null || { skip "valgrind" "not here (Debian: valgrind)" && exit; }
nm "$PLUMBAGO" 2>/dev/null | grep -q '__[at]san_init' && { skip "valgrind" "a sanitizer is in this build" && exit; }
example a.svg
printf '%%!PS-Adobe-3.0 EPSF-3.0\n%%%%BoundingBox: 0 0 72 72\n9 9 moveto 63 63 lineto 63 9 lineto stroke 36 36 9 0 360 arc fill\n' >a.eps

# clean NAME ARGS...
clean() {
    local name=$1
    shift
    valgrind --quiet --trace-children=no --leak-check=full --show-leak-kinds=definite,indirect,possible --errors-for-leak-kinds=definite,indirect,possible \
        --error-exitcode=99 --log-file="$TMP/valgrind" "$PLUMBAGO" -q -d 20 "$@" >"$TMP/out" 2>"$TMP/err"
    local code=$?
    if [ $code -ne 0 ]; then fail "$name" "exit status $code: $(head -n 1 "$TMP/err")$(head -n 2 "$TMP/valgrind" | tr '\n' ' ')"
    elif grep -q "^==" "$TMP/valgrind"; then fail "$name" "$(grep -c "^==" "$TMP/valgrind") lines: $(grep -m 2 "^==" "$TMP/valgrind" | tr "\n" " ")" # lines with -- are notes: calls it does not know
    else ok "$name"; fi
}
clean "SVG, graphite" -o a.png a.svg
clean "SVG, the papers' algorithm" --model hla -o a.png a.svg
clean "SVG, in colour" --colour -o a.png a.svg
clean "SVG, two threads" --threads 2 -o a.png a.svg
clean "SVG, a PDF" -o a.pdf a.svg
clean "SVG, strokes" --dump=strokes -o a.txt a.svg
clean "PostScript" -o a.png a.eps
clean "gradients" --colour -o a.png "$ROOT/tests/image/gradients.svg"
clean "lettering" -o a.png "$ROOT/tests/image/lettering.svg"
