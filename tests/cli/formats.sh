# SPDX-License-Identifier: MIT
# Formats of pictures: each holds the same picture, its resolution and what it says of itself; SVG holds the hand's paths.
. "$ROOT/tests/check.sh"
example a.svg
cat >lines.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="100mm" viewBox="0 0 120 100">
<g fill="none" stroke="black" stroke-width=".4">
<path d="M8 8H112M8 16L112 20M10 26V92M20 40C50 20 70 60 110 30M20 90L50 50M30 92L60 52L90 92"/><path d="M95 51A14 14 0 1 1 81 65"/>
<path stroke="#c03020" d="M30 62L22 66"/>
</g>
</svg>
SVG

# ---- pixels ----
plumbago --dpi 150 -o a.png a.svg
for suffix in jpg jpeg webp tif tiff; do
    plumbago --dpi 150 -o "a.$suffix" a.svg
    if [ $status -eq 1 ] && grep -q 'install lib.*-dev and build again' "$TMP/err"; then skip ".$suffix" "this build has no library for it"; continue; fi
    said=$(tool picture_compare "a.$suffix" a.png)
    limit=3
    case $suffix in tif*) limit=0 ;; esac
    if [[ $said =~ ^"size 236 177 dpi 150 pages 1 mean "([0-9])\.[0-9]+" max " ]] && [ "${BASH_REMATCH[1]}" -le $limit ]; then ok ".$suffix shows the PNG's picture"; else fail ".$suffix shows the PNG's picture" "$said"; fi
    if grep -aq 'Plumbago-Pencil: HB' "a.$suffix"; then ok ".$suffix says its pencil"; else fail ".$suffix says its pencil" "it does not"; fi
    cp "a.$suffix" again
    plumbago --dpi 150 --threads 1 -o "a.$suffix" a.svg
    same ".$suffix has the same bytes on one thread" "a.$suffix" again
    plumbago --dpi 150 --compress 9 -o "a.$suffix" a.svg
    plumbago --dpi 150 --compress 0 -o "b.$suffix" a.svg
    if [ "$(stat -c %s "a.$suffix")" -lt "$(stat -c %s "b.$suffix")" ]; then ok ".$suffix is smaller with --compress 9"; else fail ".$suffix is smaller with --compress 9" "$(stat -c %s "a.$suffix" "b.$suffix" | tr '\n' ' ')"; fi
    case $suffix in
    jp*) refuses ".$suffix is not without background" "JPEG cannot be without background" --background none -o "x.$suffix" a.svg ;;
    *)
        plumbago --dpi 150 --background none --colour -o "c.$suffix" lines.svg
        plumbago --dpi 150 --colour -o c.png lines.svg
        said=$(tool picture_compare "c.$suffix" c.png)
        if [[ $said =~ " mean "([0-9])\.[0-9]+" max " ]] && [ "${BASH_REMATCH[1]}" -le 2 ]; then ok ".$suffix without background looks the same on white"; else fail ".$suffix without background looks the same on white" "$said"; fi
        ;;
    esac
done
if [ -f a.webp ]; then
    cat >wide.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="1500mm" height="5mm" viewBox="0 0 1500 5"><path d="M1 2H1499" stroke="black"/></svg>
SVG
    refuses "WebP of more pixels than it holds" "WebP holds at most 16383 pixels a side" -o wide.webp wide.svg
fi

# ---- several pages in one file ----
example b.svg
draws "a PDF of two drawings" --dpi 50 -o both.pdf a.svg b.svg
if command -v pdfinfo >/dev/null && command -v pdftocairo >/dev/null; then
    is "its pages" "$(pdfinfo both.pdf 2>/dev/null | sed -n 's/^Pages: *//p')" 2
    plumbago --dpi 50 -o one.pdf b.svg
    pdftocairo -png -r 50 -f 2 -l 2 both.pdf two 2>/dev/null
    pdftocairo -png -r 50 one.pdf one 2>/dev/null
    same "its second page is the second drawing" two-2.png one-1.png
    report "it is a sound PDF" "$(pdfinfo both.pdf 2>&1 >/dev/null)"
    plumbago -q --dpi 50 --page all -o again.pdf both.pdf
    is "all pages of a PDF in one" "$status $(pdfinfo again.pdf 2>/dev/null | sed -n 's/^Pages: *//p')" "0 2"
else
    skip "the pages of a PDF" "no pdfinfo or pdftocairo here"
fi
refuses "one drawing that fails: no file" "no\.svg" --dpi 50 -o none.pdf a.svg no.svg b.svg
misused "several drawings in one PNG" "need a %s" -o both.png a.svg b.svg
if plumbago --dpi 150 -o both.tif a.svg b.svg && [ $status -eq 0 ]; then
    is "a TIFF of two drawings" "$(tool picture_compare both.tif a.png | cut -d ' ' -f 7)" 2
fi

# ---- paths ----
draws "-o x.svg" -o x.svg lines.svg
is "its page has its true size" "$(grep -o 'width="120mm" height="100mm" viewBox="0 0 120 100"' x.svg | wc -l)" 1
is "it has one layer" "$(grep -c 'inkscape:groupmode="layer" inkscape:label="HB"' x.svg)" 1
is "a path for each stroke" "$(grep -c '<path ' x.svg)" "$(plumbago --dump=strokes lines.svg && grep -c '^stroke ' "$TMP/out")"
draws "a blunt point in SVG" --point blunt -o blunt.svg lines.svg
is "its lines are all as broad as the layer's" "$(grep -c '<path .*stroke-width' blunt.svg)" 0
grep -o '<path .*stroke-width="[0-9.]*"' x.svg | sed 's/.*width="//; s/"$//' | sort -n >widths
is "a sharp point's are finer, and differ" "$(awk 'NR == 1 { low = $1 } { high = $1 } END { print (low >= 0.24 && high <= 0.4 && high > low) }' widths)" 1
if command -v inkscape >/dev/null; then
    # It lists the document, the layer and each path with its box, px of 1/96 inch.
    HOME=$TMP inkscape --query-all x.svg >objects 2>/dev/null
    is "Inkscape reads each path" "$(wc -l <objects)" $(($(grep -c '<path ' x.svg) + 2))
    report "... at its place on the page" "$(awk -F, '!($2 > 0 && $3 > 0 && $2 + $4 < 120 / 25.4 * 96 && $3 + $5 < 100 / 25.4 * 96)' objects)"
else
    skip "Inkscape reads each path" "no inkscape here"
fi
for way in "--arm hand" "--arm jerk" "--model hla" "--arm spring" "--arm lognormal --hand left" "--arm torque" "--squiggle 0"; do
    # shellcheck disable=SC2086
    plumbago $way --dpi 600 -o x.png lines.svg
    # shellcheck disable=SC2086
    plumbago $way -o x.svg lines.svg
    said=$(tool path_axis x.svg x.png)
    if [[ $said =~ "windows "([0-9]+)" worst 0.0"[0-4].*" twice 0" ]] && [ "${BASH_REMATCH[1]}" -gt 100 ]; then ok "paths lie in the ink, $way"; else fail "paths lie in the ink, $way" "$said"; fi
done
plumbago --colour -o x.svg lines.svg
is "a layer for each pencil" "$(grep -o 'inkscape:label="[^"]*"' x.svg | tr '\n' ' ')" 'inkscape:label="HB" inkscape:label="HB #c03020" '
is "of its colour" "$(grep -c 'stroke="#c03020"' x.svg)" 1
plumbago -o d.svg lines.svg && plumbago --dpi 96 --threads 1 -o e.svg lines.svg
same "resolution and threads change no path" d.svg e.svg
if command -v rsvg-convert >/dev/null; then
    check "rsvg-convert renders it" rsvg-convert -o r.png x.svg
    if [ -f r.png ] && tool png_stats r.png >stats 2>&1; then ok "with ink"; else fail "with ink" "$(head -n 1 stats)"; fi
fi
if command -v vpype >/dev/null; then check "vpype reads it" vpype read x.svg stat; else skip "vpype reads it" "no vpype here"; fi
draws "what was drawn is drawn again" --dpi 50 -o redrawn.png x.svg
