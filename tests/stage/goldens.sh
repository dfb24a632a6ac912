# SPDX-License-Identifier: MIT
# Stage goldens: the display list and the strokes of our own small drawings, as text, against what was committed.
# ACCEPT=1 makes what is there now the reference.
. "$ROOT/tests/check.sh"
unset -f plumbago

# like SLACK GOLDEN NOW: the same words, numbers within SLACK mm; identities of strokes (16 digits) are anything.
like() {
    awk -v slack="$1" '
        function is_number(w) { return w ~ /^-?[0-9.]+(e-?[0-9]+)?$/ }
        NR == FNR { line[FNR] = $0; n = FNR; next }
        { k = split(line[FNR], a, " "); if (k != NF) bad = 1
          for (i = 1; i <= NF; i++) { d = $i - a[i]; if ($i != a[i] && !(is_number($i) && is_number(a[i]) && d <= slack && d >= -slack) && !(length($i) == 16 && length(a[i]) == 16)) bad = 1 } }
        END { exit bad || FNR != n }' "$2" "$3"
}

# golden NAME STAGE FILE GOLDEN SLACK: what comes of a drawing that cannot be read is no reference.
golden() {
    local case="$1, $2" file=$3 golden=$4
    rm -f now.txt
    if ! "$PLUMBAGO" -q --dump="$2" "$file" -o now.txt 2>said || [ ! -s now.txt ]; then fail "$case" "it is not drawn: $(head -n 1 said)"; return; fi
    if [ -n "${ACCEPT:-}" ]; then cp now.txt "$golden"; fi
    if [ ! -f "$golden" ]; then fail "$case" "no reference yet: run with ACCEPT=1"; return; fi
    if like "$5" "$golden" now.txt; then ok "$case"; else fail "$case" "differs: $(diff "$golden" now.txt | head -n 4 | cut -c1-160 | tr '\n' ' ')"; fi
}

# Hatching to a tone has no golden strokes: its spacing is measured on the pencil. The tap hands over 24.8 fixed point: the
# last digit may differ between versions of cairo.
for drawing in lines dashes clip use transforms units style solids lettering gradients; do
    for stage in list strokes; do
        [ "$drawing $stage" = "gradients strokes" ] || golden $drawing $stage "$ROOT/tests/image/$drawing.svg" "$ROOT/tests/stage/$drawing.$stage.txt" .004
    done
done
for drawing in entities blocks plan; do
    if /usr/bin/python3 -c 'import ezdxf' 2>/dev/null; then
        golden $drawing.dxf list "$ROOT/tests/stage/$drawing.dxf" "$ROOT/tests/stage/$drawing.dxf.list.txt" .0005
    else
        skip "$drawing.dxf, list" "no python3-ezdxf here"
    fi
done
for program in program paths state; do
    golden $program list "$ROOT/tests/image/$program.eps" "$ROOT/tests/stage/$program.list.txt" 1e-9
done
for model in cube.obj tube.stl pyramid.ply colours.off; do
    golden $model list "$ROOT/tests/stage/$model" "$ROOT/tests/stage/$model.list.txt" .0005
done
