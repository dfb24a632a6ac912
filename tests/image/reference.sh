# SPDX-License-Identifier: MIT
# Small drawings as they have always come out: tests/image/reference/*.png. A change of the output for the same input
# and seed is news for the user (NEWS.md), so it must not happen unnoticed. Run with ACCEPT=1 to make what the
# program draws now the reference; look at the pictures before.
#
# On the machine that made them the pixels are equal. Another version of librsvg or cairo may place a curve's points
# otherwise by a hair, so elsewhere close is enough: the ink within a pixel, and the mean grey within .3 of 255.
. "$ROOT/tests/check.sh"
references=$ROOT/tests/image/reference
new=$BUILD_DIR/tests/image
mkdir -p "$references" "$new"

compare() { # NAME
    local said recall precision grey_a grey_b
    if said=$(tool png_compare "$references/$1.png" "$new/$1.png"); then
        ok "$1"
        return
    fi
    read -r _ recall _ precision _ < <(tool ink_compare "$references/$1.png" "$new/$1.png" 1 26 26)
    read -r _ _ _ grey_a _ < <(tool png_stats "$references/$1.png")
    read -r _ _ _ grey_b _ < <(tool png_stats "$new/$1.png")
    if awk "BEGIN { d = $grey_a - $grey_b; exit !($recall >= .98 && $precision >= .98 && d * d <= .09) }"; then
        ok "$1 (close, not equal: $said)"
    else
        fail "$1" "$said; recall $recall, precision $precision, mean grey $grey_a and $grey_b; see $new/$1.png and tests/image/reference/$1.png"
    fi
}

while read -r name file options; do
    # shellcheck disable=SC2086
    if ! "$PLUMBAGO" -q $options -o "$new/$name.png" "$ROOT/tests/image/$file" 2>"$TMP/err"; then
        fail "$name" "$(head -n 1 "$TMP/err")"
    elif [ "${ACCEPT:-}" = 1 ]; then
        cp "$new/$name.png" "$references/$name.png" && ok "$name (accepted)"
    elif [ -f "$references/$name.png" ]; then
        compare "$name"
    else
        fail "$name" "no reference yet: look at $new/$name.png, then run with ACCEPT=1"
    fi
done <<'END'
lines-HB lines.svg -d 100
lines-2H lines.svg -d 100 -p 2H
lines-8B lines.svg -d 100 -p 8B -s 7
lines-hla lines.svg -d 100 --model hla
curves-hla curves.svg -d 100 --model hla -p 6B
curves-spring curves.svg -d 100 --model hla --arm spring -p B
dashes-straight dashes.svg -d 100 --squiggle 0
state-3B state.eps -d 100 -p 3B
transforms-none transforms.svg -d 80 --background none
controls curves.svg -d 80 --dump=controls
controls-hla curves.svg -d 80 --dump=controls --model hla
END
