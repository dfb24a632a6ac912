#!/bin/bash
# SPDX-License-Identifier: MIT
# Rebuilds the eight pencils from the scans: profiles/capture.sh [PROGRAM [OUTPUT_DIR]]. The scans do not belong to this
# repository; without them the script says so and changes nothing. GRADES='HB B' makes those alone. See README.md for what was
# chosen here.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-${PLUMBAGO_PROFILE:-$here/../build/release/plumbago-profile}}
scans=${SCANS:-$here/../../shared/scans/hdbpmn}
out=${2:-$here}
if ! [ -d "$scans" ]; then
    echo "profiles/capture.sh: no scans in $scans; the pencils stay as they are" >&2
    exit 0
fi
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The two writers whose scans are sharp. Left out: a line of the printed grid runs close beside the first three, the
# fourth is a doubled stroke (both by eye), and the last two are under 3 px wide: their edge is the scanner's blur.
left_out='ex02_w0028_v_x1548_y1817|ex03_w0028_h_x0224_y0010|ex03_w0028_h_x0477_y2731|ex03_w0028_v_x0403_y0116|ex03_w0028_h_x1040_y1399|ex03_w0028_h_x1265_y0305'
ls "$scans"/line_*_w0028_*.png "$scans"/line_*_w0054_*.png | grep -Ev "$left_out" >"$work/lines"

# grade, centre medians taken, width at half depth in mm, pencil that lends its grain
while read -r grade centre width lender; do
    case " ${GRADES:-$grade} " in *" $grade "*) ;; *) continue ;; esac
    xargs -a "$work/lines" "$program" capture -v --name "$grade" --centre "$centre" -o "$work/all.pencil" 2>"$work/log"
    sed -n 's/^plumbago-profile: \(.*\): used: .*/\1/p' "$work/log" | sort >"$work/used"
    {
        echo "Captured from scans of real pencil lines, sorted into grades by darkness: lines whose median grey at the"
        echo "centre is $centre. The grade is assigned, not known; so is the width: the measured cross-section was"
        echo "stretched to $width mm at half depth."
        [ -z "$lender" ] || echo "These lines were pressed too hard to show the paper's tooth: their grain is in part that of $lender, by choice."
        echo "Scans: hdBPMN, the hand-drawn BPMN data set, by Bernhard Schaefer, Han van der Aa, Henrik Leopold and Heiner"
        echo "Stuckenschmidt (Sketch2BPMN, CAiSE 2021), GitHub dwslab/hdBPMN, commit 1d7e5fcd17de, licence CC BY 4.0."
        echo "Changed: cropped to single lines, turned to grey, some transposed; only statistics of them are kept here."
        echo "Lines (exercise, writer, horizontal or vertical, place in the scan):"
        sed 's/.*line_\(.*\)\.png/  \1/' "$work/used"
    } >"$work/provenance"
    xargs -a "$work/used" "$program" capture --free-hand --name "$grade" --width "$width" ${lender:+--grain "$out/$lender.pencil"} --provenance "@$work/provenance" -o "$out/$grade.pencil"
    echo "$grade: $(wc -l <"$work/used") lines"
done <<'END'
2H 192-208 0.42
H  182-198 0.44
F  172-188 0.46
HB 166-182 0.47
B  156-172 0.49
3B 136-160 0.52
6B 112-132 0.58 3B
8B 92-112  0.64 3B
END
