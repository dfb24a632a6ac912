# SPDX-License-Identifier: MIT
# README keeps its promises: the options it recommends give the sizes it names, its targets are in the Makefile.
. "$ROOT/tests/check.sh"
readme=$ROOT/README.md
for target in $(grep -oE '^ *(sudo )?make [a-z]+|`(sudo )?make [a-z]+' "$readme" | sed 's/.*make //' | sort -u); do
    if grep -qE "^[a-z: .-]*\b$target\b[a-z -]*:" "$ROOT/Makefile"; then ok "make $target"; else fail "make $target" "README names it, the Makefile does not"; fi
done
# recommended WORDS: the options in the row of the table that begins with these words
recommended() { sed -nE "s/^\\| $1[^|]*\\| \`([^\`]*)\`.*/\\1/p" "$readme"; }
printf '<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="4mm" viewBox="0 0 40 4"><path d="M2 2H38" stroke="#000"/></svg>' >wide.svg
# drawn WORDS FIELD EXPECTED: what png_info says of the picture
drawn() {
    local options
    options=$(recommended "$1")
    [ -n "$options" ] || { fail "$1" "no such row"; return; }
    # shellcheck disable=SC2086
    "$PLUMBAGO" $options -o "$1.png" wide.svg 2>"$TMP/err" || { fail "$1: $options" "$(head -n 1 "$TMP/err")"; return; }
    is "$1: $options" "$(info "$1.png" "$2" | cut -d' ' -f 1)" "$3"
}
drawn "an icon" size 64
drawn "a figure" size 1984
drawn "a slide" size 960
options=$(recommended "a poster")
# shellcheck disable=SC2086
check "a poster: $options" "$PLUMBAGO" $options wide.svg
if grep -qaE '/MediaBox \[0 0 2267\.7' poster.pdf; then ok "a poster is 800 mm wide"; else fail "a poster is 800 mm wide" "$(grep -aom 1 '/MediaBox[^/]*' poster.pdf)"; fi
