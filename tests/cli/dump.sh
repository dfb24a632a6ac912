# SPDX-License-Identifier: MIT
# --dump shows what a stage made: text for a person and for diff, or a picture.
. "$ROOT/tests/check.sh"
example a.svg
for what in list strokes; do
    plumbago --dump=$what a.svg
    is "--dump=$what: status" $status 0
    if [ -s "$TMP/out" ] && [ ! -s "$TMP/err" ] && [ "$(listing)" = ./a.svg ]; then ok "--dump=$what goes to standard output"; else fail "--dump=$what goes to standard output" "$(listing | tr '\n' ' ') $(head -n 1 "$TMP/err")"; fi
    cp "$TMP/out" $what.txt
    if LC_ALL=C grep -qE '[^[:print:][:space:]]' $what.txt || [ "$(tail -c 1 $what.txt | od -An -c | tr -d ' ')" != '\n' ]; then fail "--dump=$what is text" "other bytes, or no final newline"; else ok "--dump=$what is text"; fi
    if grep -qiE '\b(nan|inf)\b' $what.txt; then fail "--dump=$what holds numbers" "$(grep -iE -m 1 '\b(nan|inf)\b' $what.txt)"; else ok "--dump=$what holds numbers"; fi
    plumbago --dump=$what -o file.txt a.svg
    same "--dump=$what -o FILE" file.txt $what.txt
    plumbago --dump $what a.svg
    same "--dump $what, two words" "$TMP/out" $what.txt
    "$PLUMBAGO" --dump=$what <a.svg >"$TMP/out" 2>"$TMP/err"
    same "--dump=$what of standard input" "$TMP/out" $what.txt
    plumbago --dump=$what -d 600 -p 8B -s 99 a.svg
    if [ $what = list ]; then same "the list has nothing to do with pencil, seed and dpi" "$TMP/out" list.txt; fi
    plumbago --dump=$what --scale 2 a.svg
    differ "--dump=$what is in mm of the page asked for" "$TMP/out" $what.txt
    rm -f file.txt $what.txt
    refuses "--dump=$what of nothing" "nothing\.svg" --dump=$what nothing.svg
    refuses "--dump=$what to a folder that is not there" "no/x" --dump=$what -o no/x a.svg
done
plumbago --dump=strokes a.svg && cp "$TMP/out" 300.txt
for dpi in 72 150 600; do
    plumbago --dump=strokes -d $dpi a.svg
    same "$dpi dpi: the same drawing, stroke for stroke" "$TMP/out" 300.txt
done
plumbago --dump=strokes a.svg
# A frame (four lines), a diagonal, a circle, a curve: at least four strokes, at most a dozen.
lines=$(($(wc -l <"$TMP/out") - 1))
if [ $lines -ge 4 ] && [ $lines -le 12 ]; then ok "one line a stroke"; else fail "one line a stroke" "$lines lines"; fi
cp "$TMP/out" first.txt
sed 's|</g>|<path d="M10 24 L30 24"/></g>|' a.svg >b.svg
plumbago --dump=strokes b.svg
lost=$(tail -n +2 first.txt | grep -vxFf "$TMP/out")
report "an added line leaves the other strokes as they were" "$lost"

draws "--dump=controls" --dump=controls a.svg
if [ -s a.png ] || [ -s a-controls.png ]; then ok "--dump=controls writes a picture"; else fail "--dump=controls writes a picture" "$(listing | tr '\n' ' ')"; fi
rm -f a.png a-controls.png
draws "--dump=controls -o" --dump=controls -o c.png a.svg
check "--dump=controls is a PNG" tool png_info c.png
is "--dump=controls is in colour" "$(info c.png colour | cut -c 1-3)" rgb
is "--dump=controls has the drawing's size" "$(info c.png size)" "472 354"
"$PLUMBAGO" --dump=controls -o - a.svg >d.png 2>"$TMP/err"
same "--dump=controls to standard output" d.png c.png
