# SPDX-License-Identifier: MIT
# The seed: what it takes, and that it is the whole of what makes two runs differ.
. "$ROOT/tests/check.sh"
example a.svg
plumbago -o default.png a.svg
draws "-s 1" -s 1 -o one.png a.svg
same "1 is the default seed" one.png default.png
draws "--seed=2" --seed=2 -o two.png a.svg
differ "another seed, another drawing" two.png default.png
draws "-s 2 again" -s 2 -o again.png a.svg
same "the same seed, the same drawing" again.png two.png
draws "-s 0" -s 0 -o zero.png a.svg
differ "0 is a seed of its own" zero.png default.png
draws "-s 18446744073709551615" -s 18446744073709551615 -o max.png a.svg
differ "the largest seed is one of its own" max.png zero.png
draws "-s 9223372036854775808" -s 9223372036854775808 -o high.png a.svg
differ "the highest bit counts" high.png zero.png
draws "-s 4294967297" -s 4294967297 -o wide.png a.svg
differ "all 64 bits count" wide.png default.png

plumbago -s random -o random.png a.svg
is "-s random: status" $status 0
is "-s random: one line says which" "$(wc -l <"$TMP/err")" 1
seed=$(grep -oE '[0-9]+' "$TMP/err" | tail -n 1)
draws "-s random: the number it gave is a seed" -s "$seed" -o repeat.png a.svg
same "-s random: the seed it gave draws the same" repeat.png random.png
plumbago -s random -o random2.png a.svg
differ "-s random twice differs" random.png random2.png
plumbago -q -s random -o random3.png a.svg
is "-s random with -q: status" $status 0
if info random.png text | grep -q "$seed"; then ok "the PNG holds the random seed"; else fail "the PNG holds the random seed" "$(info random.png text | tr '\n' '|')"; fi

while IFS= read -r bad; do misused "-s '$bad'" "seed|-s" -s "$bad" a.svg; done <<'END'
-1
18446744073709551616
99999999999999999999999
1.5
1e3
abc
12abc
0x10
+5
 7
Random
END
misused "-s with nothing in it" "seed|-s" -s "" a.svg
