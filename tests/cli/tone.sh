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
    "$PLUMBAGO" -p $pencil -d 150 -o black.png square.svg || fail "$pencil, black" "it is not drawn"
    darkest=$(tool png_stats black.png | awk '{ print 1 - $4 / 255 }')
    before=1
    for hex in 1a 33 4d 66 80 99 b3 cc e6; do
        square $hex
        want=$(awk -v g=$((16#$hex)) 'BEGIN { print 1 - g / 255 }')
        # a page filled to its edge is paper when light: so the square is seen through a page that is smaller than it
        sed -i 's/x="-9" y="-9" width="48" height="60"/x="1" y="1" width="28" height="28"/' square.svg
        "$PLUMBAGO" -p $pencil -d 150 -o grey.png square.svg || fail "$pencil, $hex" "it is not drawn"
        got=$(tool png_stats grey.png | awk '{ print (1 - $4 / 255) * 900 / 784 }')
        if awk -v got="$got" -v want="$want" -v most="$darkest" 'BEGIN { w = want / (1 + (most ^ -1.5 - 1) * want ^ 1.5) ^ (2 / 3); exit !(got > w - .1 && got < w + .1) }'
        then ok "$pencil, $hex: darkness $got"; else fail "$pencil, $hex" "darkness $got for $want, the darkest is $darkest"; fi
        if awk -v got="$got" -v before="$before" 'BEGIN { exit !(got < before + .03) }'
        then ok "$pencil, $hex is no darker than the tone before"; else fail "$pencil, $hex is no darker than the tone before" "$got, $before"; fi
        before=$got
    done
done

# a gradient by its local tone: seen through four windows side by side
before=1
for x in 0 20 40 60; do
    cat >gradient.svg <<SVG
<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="20mm" viewBox="$x 0 20 20"><linearGradient id="g" gradientUnits="userSpaceOnUse" x1="0" x2="80" y1="0" y2="0"><stop offset="0"/><stop offset="1" stop-color="#fff"/></linearGradient>
<rect x="-10" y="-10" width="100" height="40" fill="url(#g)"/></svg>
SVG
    "$PLUMBAGO" -p 6B -d 150 -o gradient.png gradient.svg || fail "a gradient from $x mm" "it is not drawn"
    got=$(tool png_stats gradient.png | awk '{ print 1 - $4 / 255 }')
    if awk -v got="$got" -v x=$x -v before="$before" 'BEGIN { want = 1 - (x + 10) / 80; want /= (1 + (.834 ^ -1.5 - 1) * want ^ 1.5) ^ (2 / 3); exit !(got > want - .1 && got < want + .12 && got < before) }'
    then ok "its tone from $x mm: $got"; else fail "its tone from $x mm" "$got, before $before"; fi
    before=$got
done
