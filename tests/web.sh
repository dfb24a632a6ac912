# SPDX-License-Identifier: MIT
# The core for browsers draws, byte for byte, what the program draws. `make web` builds it; where that was not run, or there is no
# Node, nothing is tested. `make check-web` builds it first.
. "$ROOT/tests/check.sh"
command -v node >/dev/null || { skip "the core for browsers" "no node here"; exit; }
[ -f "$ROOT/build/web/plumbago.wasm" ] || { skip "the core for browsers" "not built: make web"; exit; }
command -v clang-14 >/dev/null || { skip "the core for browsers" "no clang-14 here, and what is built may be old"; exit; }
# The build is brought up to date.
env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS make -C "$ROOT" web-files >"$TMP/log" 2>&1 || { fail "make web-files" "$(tail -n 1 "$TMP/log")"; exit; }

mkdir cases
# drawn NAME FILE SETTING=VALUE...: the case of that name, drawn by the program with those settings.
drawn() {
    local name=$1 file=$2 options=() json= setting
    shift 2
    for setting; do
        options+=("--${setting%%=*}" "${setting#*=}")
        json+="${json:+, }\"${setting%%=*}\": \"${setting#*=}\""
    done
    "$PLUMBAGO" -q --dump=list "$file" -o "cases/$name.list" && "$PLUMBAGO" -q "cases/$name.list" -o "cases/$name.png" "${options[@]}" &&
        echo "{$json}" >"cases/$name.json" || fail "$name is drawn by the program" "exit status $?"
}
i=0
pencils=(2H H F HB B 3B 6B 8B)
for file in "$ROOT"/tests/image/*.svg; do
    name=${file##*/}
    drawn "${name%.svg}" "$file" dpi=100 seed=$i pencil=${pencils[i++ % 8]}
done
drawn clips "$ROOT/tests/stage/clips.list" dpi=120 arm=jerk
drawn hatching "$ROOT/tests/stage/hatching.list" dpi=72 background=paper
drawn letters "$ROOT/tests/stage/letters.list" dpi=150 model=hla
drawn shapes "$ROOT/tests/stage/shapes.list" dpi=90 arm=lognormal
drawn plan "$ROOT/examples/plan.svg" dpi=75 width=120mm
drawn chart "$ROOT/examples/chart.svg" dpi=75 background=none
node "$ROOT/tests/web/same.mjs" "$ROOT/build/web" cases 2>"$TMP/err" || fail "the comparison ends" "$(grep -m 1 Error "$TMP/err")"

# Bytes that a page loads, after gzip.
size=$(gzip -9 -c "$ROOT/build/web/plumbago.wasm" | wc -c)
echo "plumbago.wasm: $size bytes gzipped, HB.pencil $(gzip -9 -c "$ROOT/build/web/HB.pencil" | wc -c)"
