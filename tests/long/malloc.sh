# SPDX-License-Identifier: MIT
# The n-th allocation of the whole process fails, that of any library counted, for every n; and then all later ones as well. Each
# time: exit status 1, one line, no output; or the picture as ever. STEP=N takes every N-th.
. "$ROOT/tests/check.sh"
case $BUILD_DIR in */release*) ;; *) skip "allocations of libraries that fail" "a sanitizer has allocations of its own" && exit ;; esac
if ! cc -O1 -Wall -shared -fPIC -o fail.so "$ROOT/tests/long/failing_malloc.c" 2>"$TMP/err" || ! LD_PRELOAD=$PWD/fail.so /bin/true; then
    skip "allocations of libraries that fail" "what makes them fail needs another C library"
    exit
fi
example a.svg
cp "$ROOT/tests/image/lettering.svg" "$ROOT/tests/image/gradients.svg" "$ROOT/tests/image/state.eps" "$ROOT/tests/stage/entities.dxf" .
printf '<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="6mm" viewBox="0 0 40 6"><path d="M3 3H37" stroke="black" fill="none"/></svg>' >line.svg
"$PLUMBAGO" -q --squiggle 0 -o scan.png line.svg
printf '%%!PS\n9 9 moveto 90 90 lineto stroke showpage 9 90 moveto 90 9 lineto stroke showpage\n' >two.ps

# once WHAT: how the run with this allocation failing ended; empty when well
once() {
    local code=$1 output=$2 lines
    lines=$(wc -l <err)
    if [ $code -eq 1 ]; then
        if [ "$lines" -ne 1 ] || ! grep -q '^plumbago' err; then echo "$lines lines: $(head -n 1 err)"; elif [ -e "$output" ]; then echo "refused, yet there is an output"; fi
    elif [ $code -ne 0 ]; then
        echo "status $code: $(head -n 1 err)"
    elif ! cmp -s "$output" ref; then
        echo "it succeeds with another result"
    fi
}

# failing NAME OUTPUT STEP PROGRAM ARGS...: the output is OUTPUT, or what is written to standard output for "-"
failing() {
    local name=$1 output=$2 step=${STEP:-$3} all n bad='' count=0 code trouble
    shift 3
    "$@" >out 2>err || { fail "$name" "it fails by itself: $(head -n 1 err)" && return; }
    [ "$output" = - ] && output=out
    mv "$output" ref
    for all in '' 1; do
        for ((n = 1; ; n += step)); do
            rm -f mark "$output"
            timeout 60 env ${all:+FAIL_ALL=1} FAIL_AT=$n FAIL_MARK=mark LD_PRELOAD="$PWD/fail.so" "$@" >out 2>err
            code=$?
            [ -e mark ] || break
            [ "$output" = out ] && [ $code -eq 1 ] && [ ! -s out ] && rm out
            count=$((count + 1))
            trouble=$(once $code "$output")
            [ -z "$trouble" ] || bad="$bad at $n${all:+ and later}: $trouble;"
        done
    done
    rm -f "$output" ref
    if [ -n "$bad" ]; then fail "$name" "$(cut -c 1-400 <<<"$bad")"
    elif [ $count -lt 8 ]; then fail "$name" "only $count allocations"
    else ok "$name: $count allocations failed"; fi
}
failing "SVG" x.png 1 "$PLUMBAGO" -q -d 30 -o x.png a.svg
failing "SVG, in colour, two threads" x.png 3 "$PLUMBAGO" -q -d 30 --colour --threads 2 -o x.png gradients.svg
failing "SVG, lettering" x.png 3 "$PLUMBAGO" -q -d 30 -o x.png lettering.svg
failing "SVG, the papers' algorithm" x.png 1 "$PLUMBAGO" -q -d 30 --model hla -o x.png a.svg
failing "SVG, habits" x.png 1 "$PLUMBAGO" -q -d 30 --overshoot 1mm --restate 1 --construction -o x.png a.svg
failing "SVG, a PDF" x.pdf 1 "$PLUMBAGO" -q -d 30 -o x.pdf a.svg
failing "SVG, strokes" x.txt 1 "$PLUMBAGO" -q --dump=strokes -o x.txt a.svg
failing "PostScript" x.png 3 "$PLUMBAGO" -q -d 30 -o x.png state.eps
failing "DXF" x.png 3 "$PLUMBAGO" -q -d 30 -o x.png entities.dxf
failing "a pencil shown" - 1 "$PLUMBAGO_PROFILE" show HB
failing "pencils compared" - 1 "$PLUMBAGO_PROFILE" compare HB 6B
# A pencil's picture and that of controls are left out: fontconfig, which finds the font for their words, dies where an
# allocation fails.
failing "pages" x-2.png 3 "$PLUMBAGO" -q -d 30 --page 1-2 -o x-%d.png two.ps
failing "a pencil captured" x.pencil 3 "$PLUMBAGO_PROFILE" capture -o x.pencil scan.png
