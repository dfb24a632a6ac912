#!/bin/bash
# SPDX-License-Identifier: MIT
# Draws the gallery: gallery.sh PLUMBAGO OUT_DIR. Of each drawing NAME.svg here, and of the architect's sheet of the examples, OUT_DIR gets NAME-before.png,
# the drawing as rsvg-convert shows it, and NAME-after.png, as the pencil draws it, both 700 pixels wide.
set -eu
plumbago=${1:?usage: gallery.sh PLUMBAGO OUT_DIR} out=${2:?usage: gallery.sh PLUMBAGO OUT_DIR}
here=$(cd "$(dirname "$0")" && pwd)
command -v rsvg-convert >/dev/null || { echo "gallery.sh: rsvg-convert is missing" >&2; exit 1; }
show() { # NAME FILE OPTION...
    name=$1 file=$2
    shift 2
    rsvg-convert -w 700 --background-color white -o "$out/$name-before.png" "$file"
    "$plumbago" -q --pixels 700 --compress 9 "$@" -o "$out/$name-after.png" "$file"
}
show sheet "$here/../plan.svg" --background paper
show chart "$here/chart.svg"
show schematic "$here/schematic.svg" --background paper
show map "$here/map.svg" --pencil 3B
show formula "$here/formula.svg"
show lettering "$here/lettering.svg" --lettering hand --background paper
