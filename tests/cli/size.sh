# SPDX-License-Identifier: MIT
# Size on paper and resolution are two things. 40 mm by 30 mm at 300 dpi are 472.4 by 354.3 pixels.
. "$ROOT/tests/check.sh"
example a.svg

# size NAME WIDTH HEIGHT ARGS...: draws, and the picture is so large, up to one pixel of rounding.
size() {
    local name=$1 width=$2 height=$3 got
    shift 3
    rm -f x.png
    plumbago "$@" -o x.png a.svg
    if [ $status -ne 0 ]; then fail "$name" "exit status $status: $(head -n 1 "$TMP/err")"; return; fi
    got=$(info x.png size)
    if awk -v g="$got" -v w="$width" -v h="$height" 'BEGIN { split(g, a, " "); exit !((a[1] - w) ^ 2 <= 1 && (a[2] - h) ^ 2 <= 1) }'; then
        ok "$name"
    else
        fail "$name" "$got pixels, expected $width $height"
    fi
}
# resolution NAME DPI ARGS...: what the picture says of itself (pHYs holds whole pixels a metre).
resolution() {
    local name=$1 dpi=$2
    shift 2
    rm -f x.png
    plumbago "$@" -o x.png a.svg
    if info x.png dpi | awk -v d="$dpi" '{ exit !(($1 - d) ^ 2 < .0004 * d && $1 == $2) }'; then ok "$name"; else fail "$name" "pHYs says '$(info x.png dpi)', expected $dpi"; fi
}

size "the file's own size at the default 300 dpi" 472 354
resolution "300 dpi is written" 300
for dpi in 72 96 150 600; do
    size "-d $dpi" $((dpi * 40 * 10 / 254)) $((dpi * 30 * 10 / 254)) -d $dpi
    resolution "$dpi dpi is written" $dpi -d $dpi
done
size "a fraction of a dpi" 157 118 -d 99.9
size "--dpi=100" 157 118 --dpi=100
size "the smallest: 10 dpi" 16 12 -d 10
size "--width 80mm: the height follows" 945 709 --width 80mm
size "--width in inches" 600 450 --width 2in
size "--width in centimetres" 945 709 --width 8cm
size "--width in points" 600 450 --width 144pt
size "--width in CSS pixels" 600 450 --width 192px
size "--width without a unit is in CSS pixels" 600 450 --width 192
size "--width as a fraction" 500 375 --width 500/300in
size "--height 15mm: the width follows" 236 177 --height 15mm
size "--width and --height" 600 300 --width 2in --height 1in
size "--scale 2" 945 709 --scale 2
size "--scale 0.25" 118 89 --scale 0.25
size "--scale 1e-1" 47 35 --scale 1e-1
size "--scale with -d" 315 236 --scale 2 -d 100
size "--scale 50%" 236 177 --scale 50%
size "--scale 1/2" 236 177 --scale 1/2
size "--scale 1:2" 236 177 --scale 1:2
# Pictures for screens: exactly so many pixels.
exact() { # NAME "WIDTH HEIGHT" OPTIONS...
    local name=$1 expected=$2
    shift 2
    plumbago -o exact.png "$@" a.svg
    is "$name" "$(info exact.png size | tr 'x' ' ')" "$expected"
}
exact "--pixels 1200: the height follows" "1200 900" --pixels 1200
exact "--pixels 801" "801 601" --pixels 801
exact "--pixels 800x600" "800 600" --pixels 800x600
exact "--pixels 500x500: the page gets the shape" "500 500" --pixels 500x500
exact "--pixels with --width" "640 480" --pixels 640 --width 120mm
exact "--pixels on a page with both sides: what fits" "200 400" --pixels 600x400 --width 20mm --height 40mm
exact "--page-size A6: it lies as the drawing does" "1748 1240" --page-size A6
exact "--page-size A6-portrait" "1240 1748" --page-size A6-portrait
exact "--margin grows the page" "709 591" --margin 10mm
resolution "--pixels: the picture says its resolution" 600.07 --pixels 945
resolution "--width leaves the resolution" 300 --width 80mm

for text in "Software: plumbago" "seed" "pencil" "model"; do
    plumbago -o x.png a.svg
    if info x.png text | grep -qi "$text"; then ok "the PNG says: $text"; else fail "the PNG says: $text" "$(info x.png text | tr '\n' '|')"; fi
done
plumbago -p 3B -s 4711 -o x.png a.svg
if info x.png text | grep -q 4711 && info x.png text | grep -q 3B; then ok "the PNG's text has seed and pencil in it"; else fail "the PNG's text has seed and pencil in it" "$(info x.png text | tr '\n' '|')"; fi

# A drawing keeps its place at every size: the ink's box, in mm of a page 40 by 30, is that of the frame, give or
# take a millimetre for the width of the pencil and the wobble of its ends.
place() { # NAME X0 Y0 X1 Y1 ARGS...
    local name=$1 expected="$2 $3 $4 $5" got
    shift 5
    plumbago --squiggle 0 -o x.png "$@" a.svg
    got=$(tool png_stats x.png 40 | awk -v s="$(info x.png size)" '{ split(s, a, " "); printf "%.2f %.2f %.2f %.2f\n", $10 / a[1] * 40, $11 / a[2] * 30, ($12 + 1) / a[1] * 40, ($13 + 1) / a[2] * 30 }')
    if awk -v g="$got" -v e="$expected" 'BEGIN { split(g, a, " "); split(e, b, " "); for (i = 1; i <= 4; i++) if ((a[i] - b[i]) ^ 2 > 1) exit 1 }'; then
        ok "$name"
    else
        fail "$name" "the ink's box is $got mm, expected $expected"
    fi
}
place "ink lies where it should" 4 4 36 26
place "ink lies where it should at 96 dpi" 4 4 36 26 -d 96
place "ink lies where it should at 600 dpi" 4 4 36 26 -d 600
place "ink lies where it should at --scale 3" 4 4 36 26 --scale 3
place "ink lies where it should with a margin" 9.33 8.4 30.67 21.6 --margin 10mm
place "ink lies where it should on a sheet" 6.3 5.05 33.69 24.95 --page-size A6-landscape --margin 5mm -d 150
place "a page of other proportions: fitted and centred" 12 4 28 26 --width 80mm --height 30mm

while IFS='|' read -r option value; do
    # shellcheck disable=SC2086
    misused "$option '$value'" "${option/#-d/dpi}" $option "$value" a.svg
done <<'END'
-d|0
-d|-300
-d|nan
-d|inf
-d|1e9
-d|1e999
-d|9.99
-d|4801
-d|300x
-d|
--dpi|three
--dpi|0x100
--width|-3
--width|0
--width|0mm
--width|nan
--width|inf
--width|10furlongs
--width|mm
--width|1e300
--height|-3cm
--height|0in
--height|1/0in
--scale|0
--scale|-1
--scale|nan
--scale|inf
--scale|2mm
--scale|1e999
END
misused "--width with --scale" "scale|width" --width 50mm --scale 2 a.svg
misused "--page-size with --width" "page-size and width" --page-size A4 --width 50mm a.svg
misused "--pixels with -d" "pixels and dpi" --pixels 100 -d 72 a.svg
for wrong in 0 x 5x 5x0 -3 1e3 800x600x2; do misused "--pixels $wrong" pixels --pixels $wrong a.svg; done
misused "--page-size of another name" "page-size takes A0, A1" --page-size A77 a.svg
misused "--margin -1mm" margin --margin -1mm a.svg
refuses "margins that leave nothing" "leave nothing" --width 20mm --margin 10mm -o x.png a.svg
refuses "pixels that ask for too fine a page" "10 to 4800" --pixels 100000 -o x.png a.svg
misused "--height with --scale" "scale|height" --height 50mm --scale 2 a.svg
# A page that is too large for a picture is refused before its memory is asked for.
case $BUILD_DIR in *asan* | *tsan*) limit=unlimited ;; *) limit=4000000 ;; esac # a sanitiser reserves far more
for asked in "--width 90m" "--scale 1e6" "-d 4800 --width 20000mm" "--width 1e9mm"; do
    # shellcheck disable=SC2086
    (ulimit -v $limit; exec timeout 20 "$PLUMBAGO" $asked -o huge.png a.svg) >"$TMP/out" 2>"$TMP/err"
    status=$?
    if { [ $status -eq 1 ] || [ $status -eq 2 ]; } && [ ! -e huge.png ] && [ "$(wc -l <"$TMP/err")" -le 2 ]; then ok "$asked: refused"; else fail "$asked: refused" "exit status $status: $(head -n 2 "$TMP/err" | tr '\n' '|')"; fi
done
