# SPDX-License-Identifier: MIT
# Hatching has the fill's tone: the mean grey of hatched squares, with hard and soft pencils, is within a tenth of what plumbago(7)
# says that a pencil whose darkest is r makes of the fill's; and a darker fill never comes out much lighter.
. "$ROOT/tests/check.sh"
unset -f plumbago
square() {
    cat >square.svg <<SVG
<svg xmlns="http://www.w3.org/2000/svg" width="30mm" height="30mm" viewBox="0 0 30 30"><rect x="-9" y="-9" width="48" height="60" fill="#$1$1$1"/></svg>
SVG
}
for pencil in 2H HB 6B; do
    square 00
    "$PLUMBAGO" -p $pencil --shade same -d 150 -o black.png square.svg || fail "$pencil, black" "it is not drawn"
    darkest=$(tool png_stats black.png | awk '{ print 1 - $4 / 255 }')
    before=1
    for hex in 1a 33 4d 66 80 99 b3 cc e6; do
        square $hex
        want=$(awk -v g=$((16#$hex)) 'BEGIN { print 1 - g / 255 }')
        # a page filled to its edge is paper when light: so the square is seen through a page that is smaller than it
        sed -i 's/x="-9" y="-9" width="48" height="60"/x="1" y="1" width="28" height="28"/' square.svg
        "$PLUMBAGO" -p $pencil --shade same -d 150 -o grey.png square.svg || fail "$pencil, $hex" "it is not drawn"
        got=$(tool png_stats grey.png | awk '{ print (1 - $4 / 255) * 900 / 784 }')
        if awk -v got="$got" -v want="$want" -v most="$darkest" 'BEGIN { w = want / (1 + (most ^ -2 - 1) * want ^ 2) ^ .5; exit !(got > w - .1 && got < w + .1) }'
        then ok "$pencil, $hex: darkness $got"; else fail "$pencil, $hex" "darkness $got for $want, the darkest is $darkest"; fi
        if awk -v got="$got" -v before="$before" 'BEGIN { exit !(got < before + .03) }'
        then ok "$pencil, $hex is no darker than the tone before"; else fail "$pencil, $hex is no darker than the tone before" "$got, $before"; fi
        before=$got
    done
done

# ---- a softer pencil for what is too dark ----
cat >dark.svg <<SVG
<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="30mm" viewBox="0 0 60 30"><rect x="2" y="2" width="26" height="26"/>
<rect x="32" y="2" width="26" height="26" fill="#ccc"/><path d="M1 1H59" stroke="#000" stroke-width=".3"/></svg>
SVG
darkness() { "$PLUMBAGO" "$@" -d 150 -o dark.png dark.svg && tool png_stats dark.png | awk '{ print (1 - $4 / 255) * 1800 / 676 }'; }
for pencil in 2H HB 3B 8B; do
    got=$(darkness -p $pencil)
    check "$pencil and a softer one: black is black, $got" awk -v got="$got" 'BEGIN { exit !(got > 1.0 && got < 1.15) }' # with the light square's .2
done
# A scale that is measured, for a ruler's lines here, is the soft pencil's own: the same dark comes out as by hand.
sed -i 's/height="26"\/>$/height="26" fill="#333333"\/>/' dark.svg
by_hand=$(darkness) by_ruler=$(darkness --squiggle 0)
sed -i 's/ fill="#333333"//' dark.svg
check "a dark has one tone by hand and by ruler: $by_hand, $by_ruler" awk -v a="$by_hand" -v b="$by_ruler" 'BEGIN { exit !(a > .8 && b - a < .05 && a - b < .05) }'
own=$(darkness --shade same)
check "HB alone has its own darkest, $own" awk -v got="$own" 'BEGIN { exit !(got > .78 && got < .92) }'
is "a pencil that goes no darker changes nothing" "$(darkness --shade 2H)" "$own"
strokes() { "$PLUMBAGO" "$@" --dump=strokes dark.svg | awk '$4 == "hatch" { n[$6]++ } END { print (n["soft"] > 20), (n["graphite"] > 5) }'; }
is "darks are soft, light tones are the pencil's" "$(strokes)" "1 1"
is "with one pencil no stroke is soft" "$(strokes --shade same)" "0 1"
is "nor in colour" "$(strokes --colour | cut -d ' ' -f 1)" 0
"$PLUMBAGO" -o dark-layers.svg dark.svg
is "paths have a layer for each pencil" "$(grep -o 'inkscape:label="[^"]*"' dark-layers.svg | sort | tr '\n' ' ')" 'inkscape:label="8B" inkscape:label="HB" '
"$PLUMBAGO" -d 100 --background none -o through.png dark.svg
"$PLUMBAGO" -d 100 -o over.png dark.svg
far=$(tool png_compare over.png through.png | awk '{ print ($4 <= 2 && $1 == "different" && $3 == "max") ? "" : $0 }')
is "two pencils on nothing look as on white, but for rounding" "$far" ""

# a gradient by its local tone: seen through four windows side by side
before=1
for x in 0 20 40 60; do
    cat >gradient.svg <<SVG
<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="20mm" viewBox="$x 0 20 20"><linearGradient id="g" gradientUnits="userSpaceOnUse" x1="0" x2="80" y1="0" y2="0"><stop offset="0"/><stop offset="1" stop-color="#fff"/></linearGradient>
<rect x="-10" y="-10" width="100" height="40" fill="url(#g)"/></svg>
SVG
    "$PLUMBAGO" -p 6B --shade same -d 150 -o gradient.png gradient.svg || fail "a gradient from $x mm" "it is not drawn"
    got=$(tool png_stats gradient.png | awk '{ print 1 - $4 / 255 }')
    if awk -v got="$got" -v x=$x -v before="$before" 'BEGIN { want = 1 - (x + 10) / 80; want /= (1 + (.834 ^ -2 - 1) * want ^ 2) ^ .5; exit !(got > want - .1 && got < want + .12 && got < before) }'
    then ok "its tone from $x mm: $got"; else fail "its tone from $x mm" "$got, before $before"; fi
    before=$got
done
