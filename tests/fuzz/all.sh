#!/bin/bash
# SPDX-License-Identifier: MIT
# Every fuzzer in turn, and the counts: tests/fuzz/all.sh BUILD_DIR MINUTES [NAME...]. Each runs so many minutes of processor time
# (those of DXF and of the whole program, Python scripts, by the clock), from the kept inputs and from those that earlier runs found
# (BUILD_DIR/corpus-NAME). What breaks something lies in BUILD_DIR/found-NAME.
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$1 minutes=${2:-1}
shift 2
[ $# -gt 0 ] || set -- $(cd "$root/tests/fuzz" && ls fuzz_*.c | sed 's/^fuzz_\(.*\)\.c$/\1/') dxf whole
failed=0

# Waits until process $1 has used $2 seconds of processor time, then asks it to end and report; gives its exit status.
run_for() {
    while kill -0 "$1" 2>/dev/null && [ "$(ps -o cputimes= -p "$1" | tr -d ' ')" -lt "$2" ] 2>/dev/null; do sleep 1; done
    kill -INT "$1" 2>/dev/null
    wait "$1"
}

printf '%-14s %10s %8s %8s %8s  %s\n' harness runs 'runs/s' edges inputs result
for name; do
    mkdir -p "$build/corpus-$name" "$build/found-$name"
    log=$build/fuzz-$name.log
    if [ "$name" = dxf ]; then
        nice "$root/tests/fuzz/fuzz_dxf.py" "$root/src/tap/dxf/tap_dxf.py" fuzz $((minutes * 60)) 1 "$build/found-dxf" "$root"/tests/fuzz/corpus-dxf/* "$root"/tests/stage/*.dxf >"$log" 2>&1
        code=$?
        printf '%-14s %s\n' dxf "$(tail -n 1 "$log")"
    elif [ "$name" = whole ]; then
        nice "$root/tests/fuzz/whole.py" "$build/../ubsan/plumbago" $((minutes * 60)) 1 "$build/found-whole" "$root"/tests/image/*.svg \
            "$root"/tests/image/*.eps "$root"/tests/stage/*.dxf "$root"/tests/stage/*.ps "$root"/tests/stage/*.list >"$log" 2>&1
        code=$?
        printf '%-14s %s\n' whole "$(tail -n 1 "$log")"
    else
        seeds=("$root/tests/fuzz/corpus-$name")
        [ "$name" = profile ] && seeds+=("$root/profiles")
        nice "$build/fuzz_$name" -handle_int=1 -print_final_stats=1 -timeout=30 -rss_limit_mb=2048 -max_len=65536 \
            -artifact_prefix="$build/found-$name/" "$build/corpus-$name" "${seeds[@]}" >"$log" 2>&1 &
        run_for $! $((minutes * 60))
        code=$?
        printf '%-14s %10s %8s %8s %8s  %s\n' "$name" "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" \
            "$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log")" "$(grep -o 'cov: [0-9]*' "$log" | tail -n 1 | cut -d' ' -f2)" \
            "$(ls "$build/corpus-$name" | wc -l)" "$([ $code -eq 0 ] && echo good || grep -m 1 -E 'ERROR|runtime error' "$log" | cut -c 1-120)"
    fi
    [ $code -eq 0 ] || failed=1
done
exit $failed
