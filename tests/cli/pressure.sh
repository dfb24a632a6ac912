# SPDX-License-Identifier: MIT
# How hard the pencil is pressed.
. "$ROOT/tests/check.sh"
example a.svg
grey() { tool png_stats "$1" | awk '{ print $4 }'; }

draws "no --pressure" -o default.png a.svg
draws "--pressure 1" --pressure 1 -o usual.png a.svg
same "1 is the usual pressure" usual.png default.png
for model in graphite hla; do
    for pressure in 0.2 0.5 1 2 3; do
        draws "--model $model --pressure $pressure" --model $model --pressure $pressure -o $model-$pressure.png a.svg
    done
    is "$model: the harder the darker" "$(for p in 0.2 0.5 1 2 3; do echo "$(grey $model-$p.png) $p"; done | sort -rn | awk '{ print $2 }' | tr '\n' ' ')" "0.2 0.5 1 2 3 "
done
for wrong in 0.1 3.1 -1 0 hard nan ''; do
    misused "--pressure '$wrong'" pressure --pressure "$wrong" a.svg
done
misused "--pressure without an argument" pressure --pressure
