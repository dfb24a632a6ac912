# SPDX-License-Identifier: MIT
# The program counts what a drawing holds and the pencil does not draw, by kind, as it is seen: one warning for each file, and with -v
# a line for each kind.
. "$ROOT/tests/check.sh"

# warns NAME TEXT FILE: the one warning of the run ends with the text; an empty text: there is none.
warns() {
    plumbago -v --dump=list "$3"
    local said
    said=$(grep 'warning: ' "$TMP/err" | grep -v 'leaves a mark')
    is "$1" "${said#plumbago: warning: "$3": }" "$2"
}
details() { if grep -qxF "plumbago: $2" "$TMP/err"; then ok "$1"; else fail "$1" "$(cat "$TMP/err")"; fi; }
svg() { # NAME <BODY
    { echo "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' width='100' height='100'>"; cat; echo "</svg>"; } >"$1.svg"
}
picture="<image width='9' height='9' xlink:href='data:image/png;base64,'/>"
line="<path d='M10 10h50' stroke='black'/>"

svg nothing <<<"$line<defs>$picture</defs><symbol id='s'>$picture</symbol><!-- <image/> mask=\"url(#m)\" --><g display='none'>$picture</g>"
warns "what is only defined, hidden or remarked is not lost" "" nothing.svg
svg used <<<"$line<defs><g id='a'>$picture$picture</g></defs><use xlink:href='#a'/><use xlink:href='#a'/>"
warns "what is used twice is lost twice" "left out: 4 raster images" used.svg
details "-v: a line for the kind" "used.svg: raster images: 4, left out"
svg mask <<<"<mask id='m'>$picture</mask><g mask='url(#m)'>$picture</g>"
warns "a mask upon a picture that lets nothing through" "" mask.svg
svg masks <<<"<mask id='m'>$picture</mask><g mask='url(#m)'>$line$picture</g><g style='fill:red; mask : url(#m)'>$line</g><g mask='url(#absent)'>$line</g>"
warns "masks upon lines are applied" "" masks.svg
is "what they let through is drawn" "$(grep -c '^stroke' "$TMP/out")" 1
svg filter <<<"<filter id='f'><feOffset/></filter><style>.f{filter: url(#f)}</style><g filter='url(#f)'>$line</g><g class='f'>$line</g><g filter='none'>$line</g>"
warns "filters, also by a style sheet" "left out: 2 filters" filter.svg
svg foreign <<<"$line<switch><foreignObject requiredFeatures='http://www.w3.org/TR/SVG11/feature#Extensibility'/><path d='M0 9h9'/></switch><foreignObject width='9' height='9'/>"
warns "a foreign object without a substitute" "left out: 1 foreign object" foreign.svg
svg pattern <<<"<pattern id='p' width='9' height='9' patternUnits='userSpaceOnUse'><path d='M0 0h9'/></pattern><rect width='90' height='90' fill='url(#p)'/>"
warns "patterns are drawn" "" pattern.svg
svg blend <<<"$line<g style='mix-blend-mode:difference'>$line</g>"
warns "blend modes" "left out: 1 blend mode" blend.svg
svg unseen <<<"$line<path d='M500 500h50' stroke='black'/>"
warns "what lies off the page is no cause for a warning" "" unseen.svg
details "-v: but is told" "unseen.svg: shapes off the page: 1, left out"
svg glyphs <<<"$line<text x='9' y='9'>a&#x10FFFD;</text>"
warns "a character that no font has" "no font here has a character of the text, which is drawn as a box: U+10FFFD" glyphs.svg
svg many <<<"<filter id='f'><feOffset/></filter><g filter='url(#f)'>$line</g>$picture<foreignObject/>"
warns "several kinds: one warning" "left out: 1 raster image, 1 foreign object, 1 filter" many.svg
plumbago -q --dump=list many.svg
is "-q: silence" "$(cat "$TMP/err")" ""

cat >image.ps <<'PS'
%!PS-Adobe-3.0 EPSF-3.0
%%BoundingBox: 0 0 100 100
10 10 moveto 90 90 lineto stroke
4 4 1 [4 0 0 4 0 0] { <a5a5a5a5> } image
4 4 true [4 0 0 4 0 0] { <a5a5a5a5> } imagemask
showpage
PS
warns "PostScript: images and stencils" "left out: 2 raster images" image.ps
