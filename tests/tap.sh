# SPDX-License-Identifier: MIT
# Does the tap lose anything? What tap-svg writes, replayed by cairo's own interpreter and turned back, must show the ink
# that librsvg draws by itself. Drawings with what the tap leaves out on purpose (images, masks, filters, tiles of
# patterns) only have to pass without error.
. "$ROOT/tests/check.sh"

replay=$BUILD_DIR/tests/tools/tap_replay
svgs=$SHARED/corpus/svg
if [ ! -d "$svgs" ]; then skip "tap against librsvg" "no corpus at $svgs"; exit 0; fi
if ! command -v rsvg-convert >/dev/null; then skip "tap against librsvg" "no rsvg-convert"; exit 0; fi
if [ ! -x "$replay" ]; then skip "tap against librsvg" "no $replay: is libcairo-script-interpreter there?"; exit 0; fi

suite=$SHARED/corpus/resvg-suite.zip
unpack() { # ZIP
    if command -v unzip >/dev/null; then unzip -qo "$1"; elif command -v bsdtar >/dev/null; then bsdtar -xf "$1"; else return 1; fi
}
mkdir suite
(cd suite && unpack "$suite") 2>/dev/null || skip "the test suite" "cannot unpack $suite"

# compare FILE NAME: one case.
compare() {
    local file=$1 name=$2 said status
    "$TAP_SVG" <"$file" >script 2>said
    status=$?
    if ! rsvg-convert -z 2 "$file" -o reference.png 2>/dev/null; then
        # the tap is not to blame for what librsvg refuses by itself: any clear end will do
        if [ $status -le 5 ] || [ $status -eq 134 ]; then ok "$name (refused by librsvg too)"; else fail "$name" "exit status $status"; fi
    elif [ $status -ne 0 ]; then
        fail "$name" "exit status $status: $(head -n 1 said)"
    elif grep -qE '<(image|pattern|filter|mask)' "$file"; then
        ok "$name (not compared)"
    elif ! said=$("$replay" reference.png <script 2>&1); then
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
# cairo draws dashes of no length along upright lines as hairs, where nothing (or a dot) belongs
find suite -name '*.svg' | grep -v '/0-n-with-' | sort | while read -r file; do compare "$file" "$file"; done
