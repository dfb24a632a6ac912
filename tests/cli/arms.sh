# SPDX-License-Identifier: MIT
# Every model draws with every arm that the help names, a real drawing, and each pair in its own way.
. "$ROOT/tests/check.sh"
names() { "$PLUMBAGO" --help | grep -oE -- "^ +--$1 [a-z|]+" | head -n 1 | sed 's/.* //' | tr '|' ' '; }
models=$(names model) arms=$(names arm)
# shellcheck disable=SC2086
if [ "$(wc -w <<<"$models")" -ge 2 ] && [ "$(wc -w <<<"$arms")" -ge 5 ]; then ok "the help names models and arms"; else fail "the help names models and arms" "'$models' '$arms'"; fi
for model in $models; do
    for arm in $arms; do
        draws "model $model with arm $arm" --dpi 40 --model "$model" --arm "$arm" "$ROOT/examples/plan.svg" -o "$model-$arm.png"
    done
done
alike=$(sha256sum -- *.png 2>/dev/null | sort | uniq -w 64 -D)
report "no two of them are alike" "$alike"
