# SPDX-License-Identifier: MIT
# SVG that is newer than librsvg, or would be drawn as pixels, is rewritten before librsvg sees it: each drawing here comes to the
# same display list as one that says the same in old words.
. "$ROOT/tests/check.sh"

svg() { # NAME BODY
    echo "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' width='100mm' height='60mm' viewBox='0 0 200 120'>$2</svg>" >"$1.svg"
}

# alike NAME NEW OLD: the items of both lists are the same, numbers within 0.02 mm (and 0.01 of colours), clips aside.
alike() {
    svg new "$2"
    svg old "$3"
    local side
    for side in new old; do
        if ! "$PLUMBAGO" -q --dump=list -o $side.list $side.svg 2>err; then
            fail "$1" "$(head -n 1 err)"
            return
        fi
        grep -E '^(fill|stroke) ' $side.list | sed -E 's/^(fill|stroke) [^ ]+/\1/' >$side.items
    done
    local said
    said=$(awk '
        NR == FNR { line[FNR] = $0; n = FNR; next }
        { k = split(line[FNR], a, " "); bad = k != NF
          for (i = 1; i <= NF && !bad; i++) { d = $i - a[i]; bad = $i != a[i] && !($i ~ /^-?[0-9.e-]+$/ && a[i] ~ /^-?[0-9.e-]+$/ && d <= .02 && d >= -.02) }
          if (bad) { print "item " FNR ": " substr($0, 1, 100) " for " substr(line[FNR], 1, 100); exit } }
        END { if (FNR != n && !bad) print FNR " items, not " n }' new.items old.items)
    if [ -s old.items ]; then is "$1" "$said" ""; else fail "$1" "the drawing in old words is empty"; fi
}

line="stroke='#000' fill='none'"
alike "var(), fallbacks, the nearest element that says the property" \
    "<style>:root{--ink:#123;--thin:1} .a{stroke:var(--ink);stroke-width:var(--thin)} g{--ink:#456}</style><path class='a' d='M9 9h90'/><g><path class='a' d='M9 19h90'/></g><path d='M9 29h90' style='stroke:var(--no, #789)'/><path d='M9 39h90' stroke='#000' style='stroke:var(--no)'/>" \
    "<path d='M9 9h90' stroke='#123'/><g><path d='M9 19h90' stroke='#456'/></g><path d='M9 29h90' stroke='#789'/>"
alike "custom properties that go in circles paint nothing, and end" \
    "<style>:root{--a:var(--b);--b:var(--a)}</style><path d='M9 9h90' $line/><path d='M9 19h90' style='stroke:var(--a)'/>" "<path d='M9 9h90' $line/>"
alike "oklch, lab, hwb, color-mix, color, light-dark" \
    "<g stroke-width='1'><path d='M9 9h90' stroke='oklch(62.8% .2577 29.23)'/><path d='M9 19h90' stroke='lab(50 0 0)'/><path d='M9 29h90' stroke='hwb(0 20% 20%)'/><path d='M9 39h90' style='stroke:color-mix(in srgb, #fff 25%, black)'/><path d='M9 49h90' stroke='color(srgb .5 .5 .5)'/><path d='M9 59h90' style='stroke:light-dark(#333, #eee)'/></g>" \
    "<g stroke-width='1'><path d='M9 9h90' stroke='#f00'/><path d='M9 19h90' stroke='#777'/><path d='M9 29h90' stroke='#c33'/><path d='M9 39h90' stroke='#404040'/><path d='M9 49h90' stroke='#808080'/><path d='M9 59h90' stroke='#333'/></g>"
alike "the property d" "<path style='d:path(\"M9 9h90\")' $line/>" "<path d='M9 9h90' $line/>"
alike "pathLength" "<path d='M9 9h100' pathLength='10' stroke-dasharray='1 2' $line/>" "<path d='M9 9h100' stroke-dasharray='10 20' $line/>"
alike "non-scaling strokes" "<g transform='scale(5)'><path d='M2 2h30' vector-effect='non-scaling-stroke' stroke-width='3' $line/></g>" \
    "<g transform='scale(5)'><path d='M2 2h30' stroke-width='.3175' $line/></g>"
alike "transform-origin and transform-box" \
    "<rect x='40' y='40' width='20' height='20' style='transform:rotate(30deg);transform-origin:50px 50px' $line/><rect x='90' y='40' width='20' height='20' style='transform-box:fill-box;transform-origin:center;transform:rotate(30deg)' $line/>" \
    "<rect x='40' y='40' width='20' height='20' transform='rotate(30 50 50)' $line/><rect x='90' y='40' width='20' height='20' transform='rotate(30 100 50)' $line/>"
alike "lists of places" "<text x='20 60 90' y='30 40 50' font-size='12'>abc</text>" \
    "<text x='20' y='30' font-size='12'>a</text><text x='60' y='40' font-size='12'>b</text><text x='90' y='50' font-size='12'>c</text>"
alike "text on a path that is straight" "<defs><path id='p' d='M20 30h150'/></defs><text font-size='12'><textPath href='#p'>l</textPath></text>" "<text x='20' y='30' font-size='12'>l</text>"
alike "a drawing in the drawing" \
    "<style>rect{stroke-width:3}</style><image x='20' y='20' width='80' height='80' href=\"data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 40 40'%3E%3Cstyle%3E.a{stroke:%23f00}%3C/style%3E%3Cpath class='a' d='M5 5h30'/%3E%3C/svg%3E\"/><path class='a' d='M9 9h90' $line/>" \
    "<g transform='translate(20 20) scale(2)'><path d='M5 5h30' stroke='#f00'/></g><path d='M9 9h90' $line/>"
alike "a switch between HTML and a text" \
    "<switch><foreignObject width='9' height='9' requiredFeatures='http://www.w3.org/TR/SVG11/feature#Extensibility'><div xmlns='http://www.w3.org/1999/xhtml'>Pump</div></foreignObject><text x='20' y='30' font-size='12'>Pump</text></switch>" \
    "<text x='20' y='30' font-size='12'>Pump</text>"
alike "the notice that text is no SVG" \
    "<path d='M9 9h90' $line/><switch><g requiredFeatures='http://www.w3.org/TR/SVG11/feature#Extensibility'/><text x='9' y='99'>Text is not SVG - cannot display</text></switch>" \
    "<path d='M9 9h90' $line/>"
alike "a line of HTML" \
    "<foreignObject x='20' y='20' width='100' height='20'><div xmlns='http://www.w3.org/1999/xhtml' style='font-size:10px'>valve</div></foreignObject>" \
    "<text x='70' y='33.5' font-size='10' text-anchor='middle'>valve</text>"
alike "tiles of lines" "<pattern id='p' width='10' height='10' patternUnits='userSpaceOnUse'><path d='M0 5h10' $line/></pattern><rect width='20' height='10' fill='url(#p)'/>" \
    "<path d='M0 5h10' $line/><path d='M10 5h10' $line/>"
alike "a grid along the tile's sides is half as wide" "<pattern id='p' width='10' height='10' patternUnits='userSpaceOnUse'><path d='M0 10V0H10' stroke-width='2' $line/></pattern><rect width='10' height='10' fill='url(#p)'/>" \
    "<path d='M0 10V0H10' stroke-width='1' stroke-opacity='.6' $line/>"
pixel='iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGOIAgAAXABb2LRWWgAAAABJRU5ErkJggg=='
alike "an opaque picture lays paper" "<image x='20' y='20' width='40' height='20' preserveAspectRatio='none' xlink:href='data:image/png;base64,$pixel'/>" \
    "<rect x='20' y='20' width='40' height='20' fill='#fff'/>"

# shows NAME BODY ITEMS: so many items are left on the list that leave a mark.
shows() {
    svg one "$2"
    "$PLUMBAGO" -q --dump=list -o one.list one.svg 2>err
    is "$1" "$(grep -cE '^(fill|stroke) ' one.list)" "$3"
}
shows "a mask that lets nothing through" "<mask id='m'><rect width='200' height='120'/></mask><path d='M9 9h90' mask='url(#m)' $line/>" 0

# inside NAME BODY BOX: all strokes lie within the box x0,y0,x1,y1 (mm).
inside() {
    svg one "$2"
    "$PLUMBAGO" -q --fill=none --dump=strokes -o one.strokes one.svg 2>err
    is "$1" "$(awk -v b="$3" 'BEGIN { split(b, v, ",") } /^stroke / { for (i = 7; i < NF; i += 2) if ($i < v[1] - .06 || $i > v[3] + .06 || $(i + 1) < v[2] - .06 || $(i + 1) > v[4] + .06) bad++; n++ } END { print ((n > 0 && !bad) ? "inside" : n + 0 " strokes, " bad + 0 " points outside") }' one.strokes)" inside
}
inside "a mask of a white shape clips" "<mask id='m'><rect x='40' y='0' width='40' height='99' fill='#fff'/></mask><path d='M0 50h200' mask='url(#m)' $line/>" 20,0,40,49.5
inside "a black shape in a mask is cut out" \
    "<mask id='m'><rect width='200' height='120' fill='white'/><rect x='0' width='100' height='120' fill='black'/></mask><g mask='url(#m)'><path d='M0 50h200' $line/></g>" 50,0,100,60
inside "a soft mask clips to what it lets through" \
    "<radialGradient id='g'><stop offset='0' stop-color='#fff'/><stop offset='1' stop-color='#fff' stop-opacity='0'/></radialGradient><mask id='m'><circle cx='100' cy='60' r='40' fill='url(#g)'/></mask><path d='M0 60h200' mask='url(#m)' $line/>" 30,0,70,60
inside "a clip path that is clipped" \
    "<clipPath id='b'><rect x='60' width='140' height='120'/></clipPath><clipPath id='a' clip-path='url(#b)'><rect width='100' height='120'/></clipPath><path d='M0 50h200' clip-path='url(#a)' $line/>" 30,0,50,60

# Rules are found by what they ask for: 500 rules and 4,000 elements take .4 s, and took 6 s when each rule was tried with each element.
awk 'BEGIN {
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" height=\"600\"><style>:root{--a:#123}"
    for (k = 0; k < 500; k++) print ".c" k "{fill:none;stroke:var(--a);stroke-width:" 1 + k % 3 "}"
    print "</style>"
    for (k = 0; k < 4000; k++) print "<path class=\"c" k % 500 "\" d=\"M" k % 100 * 8 " " int(k / 100) * 6 "l5 3\"/>"
    print "</svg>" }' >rules.svg
"$PLUMBAGO" -q --limit-time 2 --dump=list -o rules.list rules.svg 2>err
is "many rules and many elements take a moment" "$(grep -c '^stroke ' rules.list) $(head -n 1 err)" "4000 "
