# SPDX-License-Identifier: MIT
# Several drawings in one call, and what their pictures are called.
. "$ROOT/tests/check.sh"
example a.svg
sed 's/M4/M5/' a.svg >b.svg
mkdir out sub && cp b.svg sub/a.svg && cp b.svg 'x%d %s.svg'
plumbago -q -o one.png a.svg && plumbago -q -o two.png b.svg

draws "two files" a.svg b.svg
same "two files: the first beside it" a.png one.png
same "two files: the second beside it" b.png two.png
draws "-o 'out/%s.png'" -o 'out/%s.png' a.svg b.svg
same "-o 'out/%s.png': the first" out/a.png one.png
same "-o 'out/%s.png': the second" out/b.png two.png
draws "%s with one file" -o 'out/%s-%s.png' a.svg
same "%s twice" out/a-a.png one.png
draws "%s and PDF" -o 'out/%s.pdf' a.svg b.svg
if [ -s out/a.pdf ] && [ -s out/b.pdf ]; then ok "%s and PDF: both are there"; else fail "%s and PDF: both are there" "$(ls out | tr '\n' ' ')"; fi
draws "a name that looks like a place" -o 'out/%s.png' 'x%d %s.svg' a.svg
same "a name that looks like a place: it is none" 'out/x%d %s.png' two.png
misused "two files, one name" FILE -o both.png a.svg b.svg
misused "two files of one name" "same name" -o 'out/%s.png' a.svg sub/a.svg
cp a.svg a.ps && cp a.svg sub/b.svg
misused "two files beside each other, one picture" "same name.* a\.png" a.svg a.ps
misused "one file by two names" "same name" ./a.svg a.svg
misused "the name that comes twice is told" "same name.* out/b\.png" -o 'out/%s.png' a.svg b.svg sub/b.svg
draws "one name in two folders" a.svg sub/a.svg
misused "standard input among others" "standard input" - a.svg

rm -f out/*
echo "no drawing" >bad.svg
plumbago -o 'out/%s.png' a.svg bad.svg b.svg
is "one fails: exit status" $status 1
is "one fails: one line" "$(wc -l <"$TMP/err")" 1
if [ -s out/a.png ] && [ -s out/b.png ] && [ ! -e out/bad.png ]; then ok "one fails: the others are drawn"; else fail "one fails: the others are drawn" "$(ls out | tr '\n' ' ')"; fi
plumbago --dump=strokes a.svg b.svg
is "text of two drawings on standard output" "$(grep -c '^strokes' "$TMP/out")" 2

export PATH="${PLUMBAGO%/*}:$PATH"
cp b.svg 'b b.svg'
sh "$ROOT/examples/many.sh" 'ma ny' a.svg 'b b.svg' >"$TMP/out" 2>&1
same "examples/many.sh draws the first" 'ma ny/a.png' one.png
same "examples/many.sh draws the second" 'ma ny/b b.png' two.png
if command -v parallel >/dev/null; then
    MACHINES=: sh "$ROOT/examples/many.sh" 'machi nes' a.svg 'b b.svg' >"$TMP/out" 2>&1
    same "on machines: the first" 'machi nes/a.png' one.png
    same "on machines: the second" 'machi nes/b b.png' two.png
    touch -d '1 minute ago' a.svg
    before=$(stat -c %y 'machi nes/a.png')
    MACHINES=: sh "$ROOT/examples/many.sh" 'machi nes' a.svg 2>"$TMP/err"
    is "on machines: what is new enough stays" "$? $(stat -c %y 'machi nes/a.png')" "0 $before"
else
    skip "many.sh on machines" "no GNU parallel here (Debian: parallel)"
fi
