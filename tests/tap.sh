# SPDX-License-Identifier: MIT
# Does the tap lose anything? The display list that tap-svg writes, drawn by cairo, must show the ink that librsvg draws by
# itself. Drawings with what the tap leaves out on purpose (images, masks, filters, tiles of
# patterns) only have to pass without error.
. "$ROOT/tests/check.sh"

# tap NAME STATUS [ARGS...] <SVG: runs it; leaves `list` and `said`.
tap() {
    local name=$1 wanted=$2 status
    shift 2
    "$TAP_SVG" "$@" >list 2>said
    status=$?
    if [ $status -ne "$wanted" ]; then
        fail "$name" "exit status $status, not $wanted: $(head -n 1 said)"
    elif [ $status -ne 0 ] && [ "$(wc -l <said)" -ne 1 ]; then
        fail "$name" "$(wc -l <said) lines of message"
    else
        ok "$name"
    fi
}
# has NAME TEXT: the list of the last run has it.
has() { if grep -q -- "$2" list; then ok "$1"; else fail "$1" "no \"$2\" in the list"; fi; }
root='<svg xmlns="http://www.w3.org/2000/svg"'
corner='<path d="M10 10h40v20h-20v30h-20z"/>'

tap "an L-shape" 0 <<<"$root width='100' height='50'>$corner</svg>"
has "the page is in millimetres" '^page 26.4583333 13.2291667$'
has "the list is whole" '^end$'
tap "an L-shape in a group with opacity" 0 <<<"$root width='100' height='100'><g opacity='.5'>$corner</g></svg>"
has "the group's opacity is its shapes'" '^fill - colour 0 0 0 0.5 '
tap "an L-shape in a turned root" 0 <<<"$root width='100' height='100' transform='rotate(10)'>$corner</svg>"
tap "a box far to the left" 0 <<<"$root width='100' height='100'><rect x='-1e5' width='2e5' height='9'/></svg>"
tap "an L-shape in a pattern" 0 <<<"$root width='100' height='100'><pattern id='p' width='.2' height='.2'>$corner</pattern><rect width='90' height='90' fill='url(#p)'/></svg>"
has "the pattern's tiles are there" '^fill [0-9][0-9]* colour '
tap "a clip path in box units" 0 <<<"$root width='100' height='100'><clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='.5'/></clipPath><circle r='50' clip-path='url(#c)'/></svg>"
tap "images, masks and filters are counted" 0 <<<"$root width='100' height='100'><mask id='m'><rect width='9' height='9' fill='#fff'/></mask><filter id='f'><feOffset dx='1'/></filter><image width='9' height='9'/><g mask=\"url(#m)\">$corner</g><g style='filter:url(#f)'>$corner</g><g filter=\"url(#f)\">$corner</g></svg>"
has "one image" '^omit image 1$'
if grep -q "^omit mask" list; then fail "a mask that clips is no omission" "$(grep ^omit list)"; else ok "a mask that clips is no omission"; fi
has "two filters" '^omit filter 2$'
tap "no size: that of what is drawn" 0 <<<"$root><path d='M30 30h60v96h-60' fill='none' stroke='red' stroke-width='.001'/></svg>"
has "the extents" '^page 15.87[45][0-9]* 25.4'
gzip -c <<<"$root width='9' height='9'>$corner</svg>" >packed
tap "packed" 0 <packed
tap "text can be left out" 0 --no-text <<<"$root width='9' height='9'><text y='9'>No</text></svg>"
if grep -q ' M ' list; then fail "no text" "there is a path"; else ok "no text"; fi
tap "empty input" 2 </dev/null
tap "not XML" 2 <<<"hello"
tap "malformed XML" 2 <<<"$root width='9' height='9'>$corner<g></svg>"
if grep -q '^[0-9]*: not well-formed' said; then ok "the message has the line"; else fail "the message has the line" "$(cat said)"; fi
tap "malformed XML, recovered" 0 --recover <<<"$root width='9' height='9'>$corner<g></svg>"
has "what could be read is there" '^fill '
tap "Latin-1 that claims to be UTF-8, recovered" 0 --recover < <(printf '%s><text>\xa9 \xe9</text>%s</svg>' "$root width='9' height='9'" "$corner")
has "the rest is there" '^fill '
tap "no height" 3 <<<"$root width='9' height='0'>$corner</svg>"
tap "larger than 100 m" 3 <<<"$root width='101000mm' height='9'>$corner</svg>"
tap "unknown option" 1 --frobnicate </dev/null
"$TAP_SVG" <<<"$root width='9' height='9'>$(yes "$corner" | head -n 20000)</svg>" 2>said | head -c 100 >list
if [ -s said ]; then fail "a reader that goes away" "$(head -n 1 said)"; else ok "a reader that goes away"; fi

replay=$BUILD_DIR/tests/tools/tap_replay
svgs=$SHARED/corpus/svg
if [ ! -d "$svgs" ]; then skip "tap against librsvg" "no corpus at $svgs"; exit 0; fi
if ! command -v rsvg-convert >/dev/null; then skip "tap against librsvg" "no rsvg-convert"; exit 0; fi
if [ ! -x "$replay" ]; then skip "tap against librsvg" "no $replay"; exit 0; fi

suite=$SHARED/corpus/resvg-suite.zip
unpack() { # ZIP
    if command -v unzip >/dev/null; then unzip -qo "$1"; elif command -v bsdtar >/dev/null; then bsdtar -xf "$1"; else return 1; fi
}
mkdir suite
(cd suite && unpack "$suite") 2>/dev/null || skip "the test suite" "cannot unpack $suite"

# compare FILE NAME: one case. The tap rewrites some of what librsvg 2.54 does not know, as clip paths that are clipped: then the
# list must show what the suite's own picture, beside the drawing, shows.
compare() {
    local file=$1 name=$2 said status
    "$TAP_SVG" <"$file" >list 2>said
    status=$?
    if ! rsvg-convert -z 2 "$file" -o reference.png 2>/dev/null; then
        # the tap is not to blame for what librsvg refuses by itself: any clear end will do
        if [ $status -le 5 ] || [ $status -eq 134 ]; then ok "$name (refused by librsvg too)"; else fail "$name" "exit status $status"; fi
    elif [ $status -ne 0 ]; then
        fail "$name" "exit status $status: $(head -n 1 said)"
    elif grep -qE '<(image|pattern|filter|mask)' "$file"; then
        ok "$name (not compared)"
    elif ! said=$("$replay" reference.png <list 2>&1) && ! "$replay" "${file%.svg}.png" <list >more 2>&1; then
        fail "$name" "recall and precision $said"
    else
        ok "$name"
    fi
}

for file in "$svgs"/*.svg; do
    case $file in
        */vpype-no-size.svg) ;; # rsvg-convert cuts this drawing off
        *) compare "$file" "$(basename "$file")" ;;
    esac
done
# cairo draws dashes of no length along upright lines as hairs, where nothing (or a dot) belongs, and cannot draw gradients
# that are squeezed flat; the list knows neither how lines are joined nor pens that are wider one way than the other
not_drawn='/0-n-with-|fallback-on-lines|/stroke-linejoin/(bevel|miter-clip|round)\.|/stroke-miterlimit/|/line/with-transform'
find suite -name '*.svg' | grep -vE "$not_drawn" | sort | while read -r file; do compare "$file" "$file"; done
