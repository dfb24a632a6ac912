#!/bin/sh
# SPDX-License-Identifier: MIT
# Many drawings at once: sh many.sh FOLDER DRAWING...
#
# draws them all into FOLDER on all processors, by GNU parallel where it is installed, else by xargs; one thread for each
# drawing is the fastest then. Those that are there already and newer than their drawing are kept.
#
# On several machines: MACHINES=anna,4/bert,: sh many.sh FOLDER DRAWING...
#
# Each machine is a name that ssh knows, with no password to type and the same version of plumbago in its PATH; 4/ in front
# keeps to four processes there, and : is this machine. parallel sends each drawing to whichever is free and brings its picture
# back. The bytes are those that this machine makes, so nobody needs to know which machine drew what. Where a machine fails,
# another gets the drawing.
set -eu
into=${1:?usage: sh many.sh FOLDER DRAWING...}
shift
mkdir -p "$into"
old() { for f; do p=$into/$(basename "${f%.*}").png; [ -n "$(find "$p" -newer "$f" 2>/dev/null)" ] || printf '%s\0' "$f"; done; }
if command -v parallel >/dev/null && [ -n "${MACHINES:-}" ]; then
    quoted=$(parallel --shellquote ::: "$into")
    old "$@" | parallel -0 -r -S "$MACHINES" --retries 3 --transferfile {} --return "$into/{/.}.png" --cleanup \
        "mkdir -p $quoted && plumbago -q --threads 1 -o $quoted/{/.}.png {}"
elif command -v parallel >/dev/null; then
    old "$@" | parallel -0 -r -q plumbago -q --threads 1 -o "$into/{/.}.png" {}
else
    old "$@" | xargs -0 -r -n 4 -P "$(getconf _NPROCESSORS_ONLN)" plumbago -q --threads 1 -o "$into/%s.png"
fi
