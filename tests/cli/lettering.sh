# SPDX-License-Identifier: MIT
# Text in SVG is known by its characters, and --lettering hand letters those in its own alphabet; a list that says them does the same.
. "$ROOT/tests/check.sh"

cat >text.svg <<'X'
<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="30mm" viewBox="0 0 60 30" font-family="DejaVu Sans">
<text x="5" y="10" font-size="4">R 25 &#xd8;</text><text font-size="4" transform="translate(40 25) rotate(-90)">up</text>
<g opacity=".5"><text x="5" y="20" font-size="4" text-decoration="underline">so</text></g><rect x="50" y="5" width="1" height="4"/></svg>
X
if ! fc-list 2>/dev/null | grep -q DejaVuSans; then
    skip "characters of text" "no DejaVu Sans here"
else
    plumbago --dump=list text.svg -o text.list || fail "characters of text" "the drawing is not read"
    said=$(grep -o 'U+[0-9a-f]*' text.list | tr '\n' ' ')
    if [ "$said" = "U+52 U+32 U+35 U+d8 U+75 U+70 U+73 U+6f " ]; then ok "characters of text"; else fail "characters of text" "they are: $said"; fi
    if [ "$(grep -c '^fill' text.list)" = 4 ] && [ "$(grep -c ' text ' text.list)" = 3 ]; then ok "a bar is no character"; else fail "a bar is no character" "$(grep -o '^fill.*text.\{40\}' text.list | tr '\n' ';')"; fi
    direction=$(sed -nE 's/.* text ([0-9.e-]+) (-?[0-9.e-]+) U.75 .*/\1 \2/p' text.list | awk '{ print ($1 > 3.99 && $1 < 4.01 && $2 > -90.1 && $2 < -89.9) }')
    if [ "$direction" = 1 ]; then ok "size and direction of turned text"; else fail "size and direction of turned text" "$(grep 'U+75' text.list | cut -c1-100)"; fi
    plumbago --dump=strokes text.svg -o font.txt && plumbago --dump=strokes --lettering hand text.svg -o hand.txt && plumbago --dump=strokes --lettering hand text.list -o list.txt
    if ! cmp -s font.txt hand.txt && cmp -s hand.txt list.txt; then ok "lettering by hand, from SVG and from the list"; else fail "lettering by hand, from SVG and from the list"; fi
fi
