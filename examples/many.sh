#!/bin/sh
# SPDX-License-Identifier: MIT
# Many drawings at once: sh many.sh FOLDER DRAWING...
#
# draws them all into FOLDER on all processors, by GNU parallel where it is installed, else by xargs; one thread for each
# drawing is the fastest then. With MACHINES=anna,bert (names that ssh knows, with plumbago on each) parallel sends the
# drawings there and brings the pictures back. Those that are there already and newer than their drawing are kept.
set -eu
into=${1:?usage: sh many.sh FOLDER DRAWING...}
shift
mkdir -p "$into"
old() { for f; do p=$into/$(basename "${f%.*}").png; [ -n "$(find "$p" -newer "$f" 2>/dev/null)" ] || printf '%s\0' "$f"; done; }
if command -v parallel >/dev/null && [ -n "${MACHINES:-}" ]; then
    old "$@" | parallel -0 -S "$MACHINES" --transferfile {} --return "$into/{/.}.png" --cleanup \
        "mkdir -p '$into' && plumbago -q --threads 1 -o '$into/{/.}.png' {}"
elif command -v parallel >/dev/null; then
    old "$@" | parallel -0 plumbago -q --threads 1 -o "$into/{/.}.png" {}
else
    old "$@" | xargs -0 -r -n 4 -P "$(getconf _NPROCESSORS_ONLN)" plumbago -q --threads 1 -o "$into/%s.png"
fi
