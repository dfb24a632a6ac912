# SPDX-License-Identifier: MIT
# PDF, and pages of PDF and PostScript files: --page, names with %d, what is said about the others.
. "$ROOT/tests/check.sh"

# pdf FILE CONTENT...: a document with one page of 200 by 100 points for each content stream.
pdf() {
    local file=$1 n=0 kids='' i
    shift
    for i in $(seq $#); do kids+="$((2 + 2 * i)) 0 R "; done
    {
        printf '%%PDF-1.4\n1 0 obj\n<< /Type /Catalog /Pages 2 0 R >>\nendobj\n'
        printf '2 0 obj\n<< /Type /Pages /Kids [%s] /Count %d >>\nendobj\n' "$kids" $#
        for i; do
            n=$((n + 1))
            printf '%d 0 obj\n<< /Type /Page /Parent 2 0 R /MediaBox [0 0 200 100] /Contents %d 0 R /Resources << >> >>\nendobj\n' $((2 + 2 * n)) $((3 + 2 * n))
            printf '%d 0 obj\n<< /Length %d >>\nstream\n%s\nendstream\nendobj\n' $((3 + 2 * n)) $((${#i} + 1)) "$i"
        done
        printf 'trailer\n<< /Root 1 0 R >>\n%%%%EOF\n'
    } >"$file"
}

# kinds FILE ARGS...: the number of lines (L, two points each) on the page.
lines_on() { plumbago --dump=list "$@" && grep -c '^stroke' "$TMP/out"; }

three_ps='%!PS
10 10 moveto 90 10 lineto stroke showpage
10 10 moveto 90 10 lineto stroke 10 20 moveto 90 20 lineto stroke showpage
10 10 moveto 90 10 lineto stroke 10 20 moveto 90 20 lineto stroke 10 30 moveto 90 30 lineto stroke showpage'
echo "$three_ps" >three.ps

if command -v pdftocairo >/dev/null; then
    pdf one.pdf '10 10 m 190 90 l S'
    pdf three.pdf '10 10 m 190 10 l S' '10 10 m 190 10 l S 10 20 m 190 20 l S' '10 10 m 190 10 l S 10 20 m 190 20 l S 10 30 m 190 30 l S'
    draws "a PDF" one.pdf
    plumbago --dump=list one.pdf
    is "its line lies where it should" "$(sed -n 's/^stroke.* M //p' "$TMP/out" | awk '{ printf "%.3f %.3f %.3f %.3f", $1, $2, $4, $5 }')" "3.528 31.750 67.028 3.528"
    is "its page" "$(awk '$1 == "page" { printf "page %.3f %.3f", $2, $3 }' "$TMP/out")" 'page 70.556 35.278'
    sources='three.pdf three.ps'
else
    refuses "PDF without poppler" 'poppler-utils' "$ROOT/tests/bad/page-tree-cycle.pdf"
    skip "PDF" "no pdftocairo here (Debian: poppler-utils)"
    sources='three.ps'
fi

for file in $sources; do
    is "$file: the first page by default" "$(lines_on $file)" 1
    grep -q 'warning: .*only the first page' "$TMP/err" && ok "$file: the others are not silently left out" || fail "$file: the others are not silently left out" "$(cat "$TMP/err")"
    is "$file: --page 2" "$(lines_on --page 2 $file)" 2
    [ ! -s "$TMP/err" ] && ok "$file: --page 2 says nothing" || fail "$file: --page 2 says nothing" "$(cat "$TMP/err")"
    is "$file: --page 3" "$(lines_on --page=3 - <$file)" 3
    refuses "$file: --page 4" 'no page 4, only 3' --page 4 $file
    misused "$file: several pages, one name" '%d' --page all -o one.png $file
    plumbago --page 2,3 -d 50 -o '%d%d-%03d.png' $file
    is "$file: a number in each place" "$status $(ls [0-9]*.png | tr '\n' ' ')" '0 22-002.png 33-003.png '
    rm -f [0-9]*.png
    plumbago --page all -d 50 -o 'all-%02d.png' $file
    is "$file: --page all" "$status $(echo all-*)" '0 all-01.png all-02.png all-03.png'
    plumbago --page 2-3 -d 50 $file
    is "$file: --page 2-3 names its pictures" "$status $(echo three-*)" '0 three-2.png three-3.png'
    same "$file: page 2 alone or among others" three-2.png all-02.png
    rm -f all-* three-*
    plumbago --page 3,1 -d 50 -o 'l-%d.png' $file
    is "$file: a list" "$status $(echo l-*)" '0 l-1.png l-3.png'
    rm -f l-*
    is "$file: dumps of all pages follow each other" "$(plumbago --page all --dump=strokes $file; grep -c ^strokes "$TMP/out")" 3
    is "$file: no line is drawn twice the same" "$(grep '^stroke ' "$TMP/out" | cut -d ' ' -f 2 | sort | uniq -d)" ''
done

example d.svg
draws "page 1 of an SVG" --page 1 d.svg
draws "all pages of an SVG" --page all d.svg
refuses "page 2 of an SVG" 'no page 2, only 1' --page 2 d.svg
for bad in 0 x 2-1 1, 1,,2 -3 1-x all2 99999999 1.5; do misused "--page=$bad" '--page' "--page=$bad" d.svg; done
draws "limits" --limit-time 5 --limit-memory 512 d.svg
for bad in 0 -1 x 1e7; do misused "--limit-time=$bad" 'limit-time' --limit-time=$bad d.svg; done
for bad in 0 -1 x 1e10; do misused "--limit-length=$bad" 'limit-length' --limit-length=$bad d.svg; done
refuses "60 km of line" 'needs more than 10000 m of pencil line; --limit-length allows more' "$ROOT/tests/bad/line-of-60-km.svg"
refuses "a line of less than is allowed" 'needs more than 1 m of pencil line' --limit-length 1 "$ROOT/examples/plan.svg"
# It is refused before it is drawn.
case $BUILD_DIR in *release*)
    "$BUILD_DIR/tests/tools/measure" "$PLUMBAGO" -o x.png "$ROOT/tests/bad/line-of-60-km.svg" >cost 2>"$TMP/err"
    is "60 km of line: refused in less than 2 seconds" "$(awk '{ print ($2 < 2) }' cost)" 1
    ;;
esac
for bad in 0 63 x 1e7; do misused "--limit-memory=$bad" 'limit-memory' --limit-memory=$bad d.svg; done
mkdir none && { PATH=$PWD/none plumbago one.pdf; } 2>/dev/null
[ -e one.pdf ] && { is "PDF without pdftocairo" $status 1; grep -q 'poppler-utils' "$TMP/err" && ok "and it says what to install" || fail "and it says what to install" "$(cat "$TMP/err")"; }
