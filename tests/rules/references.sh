# SPDX-License-Identifier: MIT
# Each file that is kept for comparison has its source, and is compared: no golden, reference picture or corpus is left over.
. "$ROOT/tests/check.sh"
cd "$ROOT/tests" || exit 1

# Each golden text beside its drawing, or made from one of the drawings of image/.
sourceless=$(for golden in stage/*.list.txt stage/*.strokes.txt stage/*.list; do
    [ -e "$golden" ] || continue
    name=${golden#stage/} && name=${name%.txt} && name=${name%.list} && name=${name%.strokes}
    ls stage/"$name" stage/"$name".ps image/"$name".svg image/"$name".eps 2>/dev/null | grep -q . || echo "tests/$golden"
done)
report "each golden of tests/stage has its drawing" "$sourceless"

# The names that reference.sh draws are those of the pictures.
drawn=$(sed -n "/<<'END'/,/^END/p" image/reference.sh | awk 'NF > 1 && !/END/ { print $1 ".png" }' | sort)
report "each reference picture is compared" "$(comm -13 <(echo "$drawn") <(ls image/reference | sort))"
sources=$(sed -n "/<<'END'/,/^END/p" image/reference.sh | awk 'NF > 1 && !/END/ { print $2 }' | sort -u)
report "each has its drawing" "$(for s in $sources; do [ -s "image/$s" ] || echo "tests/image/$s"; done)"

harnesses=$(for h in fuzz/fuzz_*.c fuzz/fuzz_*.py; do h=${h#fuzz/fuzz_} && echo "${h%.*}"; done | sort)
corpora=$(for c in fuzz/corpus-*; do [ -n "$(ls "$c" 2>/dev/null)" ] && echo "${c#fuzz/corpus-}"; done | sort)
report "each fuzzer has inputs that are replayed, and each corpus its fuzzer" "$(comm -3 <(echo "$harnesses") <(echo "$corpora") | tr -d '\t')"
