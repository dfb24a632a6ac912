# SPDX-License-Identifier: MIT
# The pictures are right: PDF at its true size, threads that change nothing, smaller and larger files of the same picture.
. "$ROOT/tests/check.sh"
example a.svg

# ---- threads ----
draws "--threads 1" --threads 1 -o one.png a.svg
for n in 2 8 64; do
    draws "--threads $n" --threads $n -o many.png a.svg
    same "--threads $n: the same bytes" many.png one.png
done
for value in 0 65 -1 1.5 two ""; do misused "--threads '$value'" threads --threads "$value" a.svg; done

# ---- compression ----
for level in 0 1 5 9; do
    draws "--compress $level" --compress $level -o c$level.png a.svg
    if tool png_compare one.png c$level.png >"$TMP/said"; then ok "--compress $level: the same picture"; else fail "--compress $level: the same picture" "$(cat "$TMP/said")"; fi
done
if [ "$(wc -c <c0.png)" -gt "$(wc -c <c1.png)" ] && [ "$(wc -c <c1.png)" -ge "$(wc -c <c9.png)" ]; then ok "more compression, smaller files"; else fail "more compression, smaller files" "$(wc -c c?.png | tr '\n' ' ')"; fi
for value in 10 -1 fast ""; do misused "--compress '$value'" compress --compress "$value" a.svg; done

# ---- PDF ----
draws "-o x.pdf" -o x.pdf a.svg
misused "no picture of another format" "x\.gif: no picture is written with the suffix \.gif: end the name in \.png" -o x.gif a.svg
misused "no picture of another format, in capitals" "\.EPS" -o x.EPS a.svg
draws "-o y.PDF, with nothing behind" --background none -o y.PDF a.svg
draws "-o z.pdf, with other threads" --threads 3 -o z.pdf a.svg
same "a PDF has the same bytes again" x.pdf z.pdf
if [ "$(head -c 5 x.pdf)" = "%PDF-" ]; then ok "it is a PDF"; else fail "it is a PDF" "$(head -c 20 x.pdf | od -c | head -n 2)"; fi
if command -v pdfinfo >/dev/null && command -v pdfimages >/dev/null; then
    # 40 mm by 30 mm are 113.386 by 85.039 pt.
    size=$(pdfinfo x.pdf 2>&1 | sed -n 's/^Page size: *//p')
    case $size in "113.386 x 85.039"* | "113.386 x 85.0394"*) ok "the page has its true size" ;; *) fail "the page has its true size" "$size" ;; esac
    pdfimages -png x.pdf page >"$TMP/said" 2>&1
    if tool png_compare one.png page-000.png >>"$TMP/said"; then ok "its image is the PNG's"; else fail "its image is the PNG's" "$(head -n 1 "$TMP/said")"; fi
    if pdfinfo y.PDF 2>&1 | grep -q '^Producer: *Plumbago'; then ok "it says who made it"; else fail "it says who made it" "$(pdfinfo y.PDF 2>&1 | head -n 1)"; fi
else
    skip "the page has its true size" "no pdfinfo or pdfimages here"
fi
if command -v gs >/dev/null; then
    gs -q -dNOPAUSE -dBATCH -dPDFSTOPONERROR -dPDFSTOPONWARNING -sDEVICE=pnggray -r72 -o gs.png x.pdf >"$TMP/said" 2>&1
    if [ -s gs.png ] && [ ! -s "$TMP/said" ]; then ok "another reader has no complaint"; else fail "another reader has no complaint" "$(head -n 1 "$TMP/said")"; fi
fi

# ---- colour ----
cat >c.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="30mm" viewBox="0 0 40 30" fill="none" stroke-width=".5"><path stroke="#d02020" d="M5 5H35"/><path stroke="#2040d0" d="M5 15H35"/><path stroke="#e0c000" d="M20 3V27"/><path stroke="#000" d="M5 25H15"/></svg>
END
draws "--colour" --colour -o c.png c.svg
is "--colour: RGB" "$(info c.png colour)" rgb
draws "--colour with nothing behind" --colour --background none -o c4.png c.svg
is "--colour with nothing behind: RGBA" "$(info c4.png colour)" rgb+alpha
draws "--colour in a PDF" --colour -o c.pdf c.svg
draws "--colour with other threads" --colour --threads 5 -o c5.png c.svg
same "--colour with other threads: the same bytes" c5.png c.png
draws "without --colour" -o grey.png c.svg
is "without --colour: grey" "$(info grey.png colour)" grey
misused "--colour takes no value" colour --colour=red c.svg

# A picture that takes another's place keeps its mode and its owner; a new one has what umask leaves.
example mode.svg
for mode in 600 640 444; do
    echo old >mode.png && chmod $mode mode.png
    plumbago -d 20 -o mode.png mode.svg
    is "the mode $mode is kept" "$status $(stat -c %a mode.png)" "0 $mode"
    rm -f mode.png
done
(umask 027 && "$PLUMBAGO" -d 20 -o mode.png mode.svg)
is "a new file has what umask leaves" "$(stat -c %a mode.png)" 640
if [ "$(id -u)" -eq 0 ]; then
    chown 65534:65534 mode.png
    plumbago -d 20 -o mode.png mode.svg
    is "the owner is kept" "$(stat -c '%u:%g %a' mode.png)" "65534:65534 640"
fi

# Standard output that is closed: one line.
for args in --help --version --list-pencils '--dump=list mode.svg' '-o - mode.svg'; do
    # shellcheck disable=SC2086
    "$PLUMBAGO" $args 2>"$TMP/err" >&-
    is "standard output is closed: $args" "$? $(cat "$TMP/err")" "1 plumbago: standard output: cannot be written: Bad file descriptor"
done
