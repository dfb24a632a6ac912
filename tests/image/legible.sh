# SPDX-License-Identifier: MIT
# Lettering can be read: text with capitals of 2.5 mm, drawn at 300 dpi, goes through a program that reads print
# (tesseract), which gets at least nine words of ten; and fewer when the text is left out.
. "$ROOT/tests/check.sh"
unset -f plumbago
command -v tesseract >/dev/null || { skip "lettering can be read" "tesseract is not installed"; exit 0; }
cat >text.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="95mm" height="45mm" viewBox="0 0 95 45"><g font-family="DejaVu Sans" font-size="3.45">
<text x="5" y="8">The quick brown fox jumps over the lazy dog</text>
<text x="5" y="16">Ground floor plan Kitchen Bath Hall</text>
<text x="5" y="24" font-family="DejaVu Sans Mono">Drawing number 4739 revision B</text>
<text x="5" y="32">Five wizards boxing jump quickly</text></g></svg>
SVG
words="The quick brown fox jumps over the lazy dog Ground floor plan Kitchen Bath Hall Drawing number 4739 revision B Five wizards boxing jump quickly"

# words_read OPTION...: how many of the words are read from the drawing.
words_read() {
    "$PLUMBAGO" -q -d 300 "$@" text.svg -o text.png || return
    local n=0 word read
    read=" $(tesseract text.png - --psm 6 --dpi 300 2>/dev/null | tr -s '\n' ' ') "
    for word in $words; do
        case $read in *" $word "*) n=$((n + 1)) ;; esac
    done
    echo "$n"
}

for seed in 1 2 3; do
    n=$(words_read --seed "$seed")
    if [ "${n:-0}" -ge 22 ]; then ok "2.5 mm, seed $seed ($n of 25 words)"; else fail "2.5 mm, seed $seed" "only ${n:-0} of 25 words are read; see the drawing of tests/image/legible.sh"; fi
done
n=$(words_read --text none)
if [ "${n:-25}" -eq 0 ]; then ok "--text none leaves nothing to read"; else fail "--text none leaves nothing to read" "$n words are read"; fi
