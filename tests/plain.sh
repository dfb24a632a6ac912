# SPDX-License-Identifier: MIT
# tap-plain against tap-svg: what it takes for plain must become the same list, number for number to 0.002 mm on paper;
# where it refuses it writes nothing, and the program ends as if it had not been asked. Real drawings where
# they are at hand.
. "$ROOT/tests/check.sh"
tap_plain=$BUILD_DIR/tap-plain
chances=0

svg='<svg xmlns="http://www.w3.org/2000/svg"'
page="$svg width='120' height='90' viewBox='-3 2 240 180' stroke='#123'>"

# The same text, or the same words with numbers no further apart than 0.002 mm: in what the `matrix` maps to the page, in the
# units that it maps.
same_list() { # FILE1 FILE2
    cmp -s "$1" "$2" || awk -v second="$2" '
        BEGIN { number = "^[-+]?[0-9.]+(e-?[0-9]+)?$"; slack = 0.002 }
        { if ((getline other < second) < 1 || NF != split(other, b, " ")) { print "line " NR " differs"; exit 1 }
          for (k = 1; k <= NF; k++) if ($k "" != b[k] "" && !($k ~ number && b[k] ~ number && ($k - b[k]) ^ 2 <= slack ^ 2)) {
              print "line " NR ": " $k " is not " b[k]; exit 1 } }
        $1 == "matrix" { slack = 0.002 / sqrt($2 * $5 - $3 * $4) }
        END { if ((getline other < second) > 0) { print "the second goes on"; exit 1 } }' "$1"
}

# by_both NAME FILE: the case; 1: the file is not plain.
by_both() {
    local why
    "$tap_plain" <"$2" >short 2>said || return 1
    if ! "$TAP_SVG" <"$2" >long 2>said; then
        fail "$1" "librsvg refuses what is taken for plain: $(head -n 1 said)"
    elif ! why=$(same_list long short); then
        fail "$1" "$why"
    else
        ok "$1"
    fi
    return 0
}

# plain NAME TEXT: tap-plain takes it.     unplain NAME TEXT: it refuses, in one line and before it has written a byte.
plain() { printf '%s' "$2" >case.svg; by_both "$1" case.svg || fail "$1" "$(cat said)"; }
unplain() {
    printf '%s' "$2" | "$tap_plain" >short 2>said
    local code=$?
    if [ $code -eq 3 ] && [ ! -s short ] && grep -q '^not plain: ' said && [ "$(wc -l <said)" -eq 1 ]; then
        ok "$1"
    else
        fail "$1" "status $code, $(wc -c <short) bytes, said: $(head -n 1 said)"
    fi
}

# shapes NAME TEXT...: each as a shape of a page.
shapes() { local name=$1 one; shift; for one; do plain "$name: $one" "$page$one</svg>"; done; }
unlike() { local name=$1 one; shift; for one; do unplain "$name: $one" "$page$one</svg>"; done; }

shapes "shape" '<path d="M1 2L30 40"/>' '<path d=""/>' '<path/>' '<line x1="1" y2="20"/>' '<line x1="1mm" y1="2pt" x2=".5in" y2="1cm"/>' \
    '<polyline points="1,2 3,4 5,6"/>' '<polyline points="1 2,3-4"/>' '<polyline points=" 1-2 3-4 "/>' '<polygon points="1 2 30 4 5.5.5"/>' \
    '<rect x="1" y="2" width="30" height="20"/>' '<rect width="30" height="20" rx="4"/>' '<rect width="30" height="20" ry="40"/>' \
    '<rect width="30" height="20" rx="4" ry="7"/>' '<rect width="30"/>' '<circle cx="9" cy="9" r="5.25"/>' '<circle r="0"/>' \
    '<ellipse cx="20" cy="30" rx="10" ry="5"/>'
shapes "path data" '<path d="m1 2 3 4 5 6zl1 1m5 5h9v9H1V2z"/>' '<path d="M1,2C3,4,5,6,7,8c1 2 3 4 5 6S9 9 8 7s1 2 3-4"/>' \
    '<path d="M1 2Q9 9 20 5q1 2 3 4T9 9t1 1 2 2"/>' '<path d="M10 10A20 30 15 0 1 50 50a20 10 0 10-9-9A1 1 0 11 3 4"/>' \
    '<path d="M10 10A0 3 0 0 1 50 50A3 3 0 0 0 50 50"/>' \
    '<path d="M50 10a9 9 0 1 1-.001 0"/>' '<path d="M50 10a9 40 0 1 1 0 1e-6z"/>' '<path d="M50 10a9 9 0 1 1 1e-9 0L9 9"/>' '<path d="M5 5L9 7M50 10a1e-9 9 0 1 1 0 0"/>' '<path d="M.5.5-.5-.5 1e1 1E+1 1.e0 2"/>' '<path d="M1 1zm2 2zM5 5L5 5L9 9"/>' \
    '<path d="M0 0L10 10L20 20L15 15L15 15C15 15 15 15 15 15z"/>' '<path d="M1 2L3 4M9 9"/>' '<path d="M1 1C1 1 1 1 1 1" stroke-linecap="round"/>' \
    '<path d="M5 5L5.0001 5" fill="none" stroke-linecap="round"/>' '<path d="M3 3h5h5v2h-9.25z"/>'
shapes "style" '<path d="M1 2L30 40L9 70" fill="none" stroke="red" stroke-width="3"/>' '<path d="M1 2L30 40L9 7" fill="rgb(1, 20,255)" stroke="none"/>' \
    '<path d="M1 2L30 40L9 7" style="fill:#0F0; stroke : Black;stroke-width:2px ;;fill-rule:evenodd;font-family:&quot;a;b&quot;"/>' \
    '<path d="M1 2L30 40L9 7" stroke-linecap="square" stroke-linejoin="bevel" stroke-miterlimit="1.5" stroke-width="0"/>' \
    '<path d="M1 2L30 40L9 7" stroke-dasharray="3 4,5" stroke-dashoffset="-70" stroke-linejoin="round"/>' \
    '<g stroke-dasharray="3mm" stroke-linecap="round"><path d="M1 2L3 4" stroke-dasharray="none"/><path d="M1 2L3 4"/><path d="M1 2L3 4"/></g>' \
    '<g fill="DarkSlateGray"><g fill="none"/><path d="M1 2L30 40L9 7" opacity="1" display="inline" visibility="visible" paint-order="markers fill stroke"/></g>' \
    '<g display="none"><path d="nonsense"/><text>no</text></g><path d="M1 2L3 4"/>' '<g visibility="hidden"><path d="M1 2L3 4"/><path visibility="visible" d="M1 2L3 9"/></g>' \
    '<path d="M1 2L3 4" stroke-width="2" fill="none"/><path d="M1 2L3 4" stroke-width="2" fill="none"/>'
shapes "opacity" '<path d="M1 2L30 40L9 7" fill-opacity=".5"/>' '<path d="M1 2L30 40L9 7" fill="#12a" fill-opacity=".25" stroke-opacity="0.8"/>' \
    '<g fill-opacity="0"><path d="M1 2L30 40L9 7" stroke-opacity="0.999" color="teal" stroke="currentColor"/><path d="M1 2L30 40L9 7" fill="currentColor" fill-opacity="2"/></g>'
shapes "transform" '<g transform="translate(3)scale(2 .5) , rotate(30,1 2)"><path transform="matrix(1 .2 -.3 2 5 6) skewX(9)" d="M1 2L30 40"/></g>' \
    '<path transform=" rotate ( -370 ) skewY(-3) scale(-1-2)" d="M1 2L30 40"/>' '<path transform="" d="M1 2L3 4"/>'
shapes "document" '<title>T</title><desc>d<b xmlns="urn:x">e</b></desc><metadata/><defs><path id="a" d="x"/></defs><!-- no --><path d="M1 2L3 4"><title/></path>' \
    '<n:named xmlns:n="urn:n"><path d="M1 1L9 9"/></n:named><path xmlns:n="urn:n" n:type="arc" id="a" class="b" d="M1 2L3 4"/>' '<g/>' \
    '<a href="b"><path d="M1 2L3 4" x="9" width="z" unknown="1" xml:lang="en-GB" xml:id="i" style="font:9px a;background:red;-any-thing:1"/></a>' '&amp; text <![CDATA[ more ]]>'
plain "size in mm" "$svg width='40mm' height='3cm'><path d='M1 2L30 40'/></svg>"
plain "size by the viewBox" "$svg viewBox='0,0 300 200'><path d='M1 2L30 40'/></svg>"
plain "one extent and a viewBox" "$svg width='9in' height='100%' viewBox='0 0 300 200'><path d='M1 2L30 40'/></svg>"
for fit in none 'xMinYMax meet' 'xMaxYMid slice' xMidYMid; do
    plain "preserveAspectRatio $fit" "$svg width='90' height='60' viewBox='1 2 30 40' preserveAspectRatio='$fit'><path d='M1 2L30 40'/></svg>"
done
plain "shapes without antialiasing" "$page<path shape-rendering='crispEdges' d='M1 2L30 40'/></svg>"
unplain "another preserveAspectRatio" "$svg width='90' height='60' viewBox='1 2 30 40' preserveAspectRatio='defer none'><path d='M1 2L30 40'/></svg>"
plain "a page like a hair" "$svg width='9000' height='1'><path d='M1 2L30 40'/></svg>"
plain "a wide viewBox" "$svg width='100mm' height='100mm' viewBox='0 0 3e8 3e8'><path d='M1e7 2e6L3e7 4e7' stroke='red' stroke-width='1e5'/></svg>"
plain "a prefix" "<s:svg xmlns:s='http://www.w3.org/2000/svg' width='9' height='9'><s:path d='M1 2L3 4' stroke='red'/></s:svg>"
plain "a document type" "<?xml version='1.0' encoding='ISO-8859-1'?><!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd'>$page<path d='M1 2L3 4'/></svg>"
{ # each colour and opacity that there is
    echo "$page"
    for ((i = 0; i < 256; i++)); do echo "<path fill='rgb($i,$((255 - i)),$((i * 7 % 256)))' fill-opacity='0.$((1000 + i * 3))' d='M1 2L3 4L5 8z'/><path fill='#$(printf '%02x%02x%02x' $i $i $i)' d='M1 2L3 4L5 8z'/>"; done
    echo '</svg>'
} >colours.svg
by_both "256 colours" colours.svg || fail "256 colours" "$(cat said)"
{
    echo "$page"
    for ((i = 0; i < 3000; i++)); do echo "<path stroke='#$((i % 9))0$((i % 7))' d='M$((i * 7 % 200)).$i $((i % 180))l$((i % 13 - 6)).5 $((i % 11 - 5))$([ $((i % 3)) = 0 ] && echo "C$i 2 3 4 $((i % 99)) 5z")'/>"; done
    echo '</svg>'
} >many.svg
for ((i = 1; i <= 20; i++)); do # documents by chance; those that are beyond limits refuse
    awk -v seed=$i -f "$ROOT/tests/tools/plain_svg.awk" >chance.svg
    by_both "by chance, seed $i" chance.svg && chances=$((chances + 1))
done
if [ $chances -ge 10 ]; then ok "$chances of 20 documents by chance are plain"; else fail "documents by chance" "only $chances of 20 are plain"; fi
by_both "3,000 paths" many.svg || fail "3,000 paths" "$(cat said)"

unlike "beyond" '<text>a</text>' '<use href="#a"/>' '<style>*{fill:red}</style>' '<svg/>' '<switch/>' '<image/>' '<defs><style/></defs>' \
    '<defs><linearGradient id="a"/></defs>' '<marker/>' '<path><path/></path>' '<foreignObject/>' '<?pi?>' '<path transform="scale(0)" d="M1 2L3 4"/>'
unlike "value" '<path fill="url(#a)" d="M1 2L3 4"/>' '<g opacity=".5"/>' '<path stroke-opacity="50%" d="M1 2L3 4"/>' '<path color="inherit"/>' '<path fill="inherit"/>' \
    '<path fill="#12"/>' '<path fill="rgb(300,0,0)"/>' '<path fill="rgb(1%,2%,3%)"/>' '<path stroke-width="1em"/>' '<path stroke-width="-1"/>' '<path stroke-width="2%"/>' \
    '<path stroke-dasharray="1 0" d="M1 2L3 4"/>' '<path stroke-dasharray="1 2," d="M1 2L3 4"/>' '<path clip-path="url(#a)"/>' '<path mask="url(#a)"/>' '<path filter="url(#a)"/>' \
    '<path marker-end="url(#a)"/>' '<path vector-effect="non-scaling-stroke"/>' '<path paint-order="stroke"/>' '<path paint-order="markers stroke fill"/>' '<path style="width:3px"/>' '<path transform-origin="1 2"/>' '<path style="fill:red !important"/>' \
    '<path style="a:(;fill:red;)"/>' '<path style="a:b);fill:red"/>' '<path style="a:&quot;&#10;&quot;;fill:red"/>' '<path style="/**/fill:red"/>' '<path style="fill"/>' '<path style="Fill:red"/>' '<path style="font-family:&quot;a"/>' '<path systemLanguage="de"/>' '<path xml:lang="?"/>'
unlike "fault" '<path d="M1"/>' '<path d="L1 2"/>' '<path d="M1 2X"/>' '<path d="M1 2L3 4,"/>' '<path d="M1 2 3"/>' '<path d="M1 2A1 1 0 2 0 3 4"/>' '<path d="M1e400 2L3 4"/>' \
    '<path d="M1 2e"/>' '<path d="M1 2L1e9 1e9"/>' '<polyline points="1 2 3"/>' '<polyline points="1,2 ,3,4"/>' '<polyline points="1,2 3,4,"/>' '<polygon points="1,2 3,4, "/>' '<polyline/>' '<rect width="-1" height="2"/>' '<circle r="x"/>' \
    '<path transform="rotate(1 2)"/>' '<path transform="scale(1,)"/>' '<path transform="nonsense"/>' '<path d="M5 5"/>' '<path d="M5 5" stroke-linecap="square"/>' \
    '<path d="M5 5L5 5" stroke-linecap="square"/>' '<path d="M5 5L9 9M1 1L2 2" stroke-linecap="square"/>' '<g><path d="M1 2L3 4"/>' '<path d="M1 2" d="M1 2"/>' '&none;' '<x:y/>'
unplain "a warning of libxml2" "$page<b xmlns='x'/></svg>"
unplain "an element of no name space" "$page<g xmlns=''><path d='M1 2L3 4'/></g></svg>"
unplain "a page too narrow" "$svg width='1e-3' height='70'><path d='M1 2L3 4'/></svg>"
unplain "no page" "$svg><path d='M1 2L3 4'/></svg>"
unplain "no size" "$svg width='50%' height='50%'><path d='M1 2L3 4'/></svg>"
unplain "a turned root" "$svg width='9' height='9' transform='rotate(3)'><path d='M1 2L3 4'/></svg>"
unplain "an entity" "<!DOCTYPE svg [<!ENTITY e '<path d=\"M1 2L3 4\"/>'>]>$page&e;</svg>"
unplain "an attribute by default" "<!DOCTYPE svg [<!ATTLIST path stroke CDATA 'red'>]>$page<path d='M1 2L3 4'/></svg>"
unplain "a style sheet" "<?xml-stylesheet href='a.css'?>$page<path d='M1 2L3 4'/></svg>"
unplain "no name space" "<svg width='9' height='9'><path d='M1 2L3 4'/></svg>"
unplain "not XML" "hello"
unplain "nothing" ""
unplain "a depth of 201" "$page$(printf '<g>%.0s' {1..201})$(printf '</g>%.0s' {1..201})</svg>"

unplain "packed" "$(gzip -c </dev/null | tr -d '\0')"

# A reader that goes away, options that are not there.
printf '%s' "$page$(yes '<path d="M1 2L30 40"/>' | head -n 40000)</svg>" >many.svg
"$tap_plain" <many.svg 2>said | head -c 100 >short
if [ -s said ]; then fail "a reader that goes away" "$(head -n 1 said)"; else ok "a reader that goes away"; fi
"$tap_plain" --what </dev/null >short 2>said
if [ $? -eq 1 ] && [ ! -s short ]; then ok "an unknown option"; else fail "an unknown option" "$(head -n 1 said)"; fi

# The whole program, with tap-plain and without: the same strokes, warnings and messages.
mkdir without && cp "$PLUMBAGO" "$TAP_SVG" without/
whole() { # NAME FILE
    "$PLUMBAGO" --dump=strokes -o - "$2" >with.out 2>with.err
    echo $? >>with.err
    without/plumbago --dump=strokes -o - "$2" >without.out 2>without.err
    echo $? >>without.err
    if ! cmp -s with.out without.out; then fail "$1" "other strokes"; elif ! cmp -s with.err without.err; then fail "$1" "it said: $(head -n 1 with.err)"; else ok "$1"; fi
}
is_asked() { "$PLUMBAGO" -v -o x.png "$1" 2>&1 | grep -q "tap-plain reads it"; }
printf '%s' "$page<path d='M1 2L30 40'/></svg>" >plain.svg
printf '%s' "$page<path d='M1 2L30 40'/>" >cut.svg
printf '%s' "$page<path d='M1 2L30 40'/><g opacity='.5'><path d='M90 2L30 40'/></g><image width='9' height='9'/></svg>" >late.svg
gzip -c plain.svg >packed.svg
for file in plain cut late packed; do whole "the program: $file" $file.svg; done
if is_asked plain.svg && is_asked cut.svg; then ok "tap-plain is asked"; else fail "tap-plain is asked" "it is not"; fi
if is_asked packed.svg || is_asked "$ROOT/examples/chart.svg"; then fail "tap-plain is not asked in vain" "it is"; else ok "tap-plain is not asked in vain"; fi
mkdir dying && cp "$PLUMBAGO" "$TAP_SVG" dying/ && printf '#!/bin/sh\ncat >/dev/null\necho junk\nkill -SEGV $$\n' >dying/tap-plain && chmod +x dying/tap-plain
"$PLUMBAGO" --dump=strokes -o - plain.svg >with.out
if dying/plumbago --dump=strokes -o - plain.svg 2>said | cmp -s - with.out && [ ! -s said ]; then ok "tap-plain may die"; else fail "tap-plain may die" "$(head -n 1 said)"; fi
# libxml2 compares each attribute with those before it: what tap-plain has no time for, tap-svg is not asked for.
{ echo "$page<path "; seq 300000 | sed 's/.*/a&="1"/'; echo '/></svg>'; } >slow.svg
refuses "no time" 'tap-plain needs more than 1 seconds' --limit-time 1 slow.svg

# Tells which of the drawings may be plain and which may not.
taken=0 left=0
compare_all() {
    local file
    while read -r file; do
        if by_both "$file" "$file"; then taken=$((taken + 1)); else left=$((left + 1)); fi
    done
}
compare_all < <(find "$ROOT/examples" "$ROOT/tests/image" "$ROOT/tests/bad" -maxdepth 1 -name '*.svg' | sort)
if [ $taken -ge 6 ]; then ok "$taken of $((taken + left)) drawings of our own are plain"; else fail "drawings that are plain" "only $taken of $((taken + left))"; fi
if [ ! -d "$SHARED/corpus/svg" ]; then skip "real drawings" "no corpus at $SHARED/corpus/svg" && exit; fi
mkdir suite
(cd suite && unzip -qo "$SHARED/corpus/resvg-suite.zip") 2>/dev/null || skip "the test suite" "cannot unpack $SHARED/corpus/resvg-suite.zip"
compare_all < <(find "$SHARED/corpus/svg" suite -name '*.svg' | sort)
if [ $taken -ge 150 ]; then ok "$taken of $((taken + left)) are plain"; else fail "drawings that are plain" "only $taken of $((taken + left))"; fi
