# SPDX-License-Identifier: MIT
# Stage goldens: the display list and the strokes of our own small drawings, as text, against what was committed.
# ACCEPT=1 makes what is there now the reference.
. "$ROOT/tests/check.sh"
unset -f plumbago
# hatching to a tone has no golden strokes: its spacing is measured on the pencil
for drawing in lines dashes clip use transforms units style solids gradients; do
    for stage in list strokes; do
        [ "$drawing $stage" = "gradients strokes" ] && continue
        golden=$ROOT/tests/stage/$drawing.$stage.txt
        "$PLUMBAGO" -q --dump=$stage "$ROOT/tests/image/$drawing.svg" -o now.txt || { fail "$drawing, $stage" "it is not drawn"; continue; }
        # the tap hands over 24.8 fixed point: the last digit may differ between versions of cairo
        if [ -n "${ACCEPT:-}" ]; then cp now.txt "$golden"; fi
        if [ ! -f "$golden" ]; then fail "$drawing, $stage" "no reference yet: run with ACCEPT=1"; continue; fi
        if awk '
            NR == FNR { line[FNR] = $0; n = FNR; next }
            { k = split(line[FNR], a, " "); if (k != NF) bad = 1
              for (i = 1; i <= NF; i++) { d = $i - a[i]; if ($i != a[i] && !($i ~ /^-?[0-9.]+$/ && a[i] ~ /^-?[0-9.]+$/ && d <= .004 && d >= -.004) && !(length($i) == 16 && length(a[i]) == 16)) bad = 1 } }
            END { exit bad || FNR != n }' "$golden" now.txt; then ok "$drawing, $stage"; else fail "$drawing, $stage" "differs: $(diff "$golden" now.txt | head -n 4 | cut -c1-160 | tr '\n' ' ')"; fi
    done
done
for drawing in entities blocks plan; do # DXF
    golden=$ROOT/tests/stage/$drawing.dxf.list.txt
    "$PLUMBAGO" -q --dump=list "$ROOT/tests/stage/$drawing.dxf" -o now.txt
    if [ -n "${ACCEPT:-}" ]; then cp now.txt "$golden"; fi
    if cmp -s now.txt "$golden"; then ok "$drawing.dxf, list"; else fail "$drawing.dxf, list" "differs: $(diff "$golden" now.txt | head -n 4 | cut -c1-160 | tr '\n' ' ')"; fi
done
for program in program paths state; do
    golden=$ROOT/tests/stage/$program.list.txt
    "$PLUMBAGO" -q --dump=list "$ROOT/tests/image/$program.eps" -o now.txt
    if [ -n "${ACCEPT:-}" ]; then cp now.txt "$golden"; fi
    if cmp -s now.txt "$golden"; then ok "$program, list"; else fail "$program, list" "differs: $(diff "$golden" now.txt | head -n 4 | cut -c1-160 | tr '\n' ' ')"; fi
done
