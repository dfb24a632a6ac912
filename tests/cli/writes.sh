# SPDX-License-Identifier: MIT
# Writing fails after so many bytes: a file that may not grow, a reader that has gone. Exit status 1, one line, no file left,
# what was there stays. LONG=1: at every byte of the picture, else at some.
. "$ROOT/tests/check.sh"
command -v prlimit >/dev/null || { skip "writes that fail" "no prlimit here (Debian: util-linux)" && exit; }
example a.svg

# places FILE: byte counts at which to fail
places() {
    local size step
    size=$(stat -c %s "$1")
    step=$((size / 12 + 1))
    [ -n "${LONG:-}" ] && step=1
    { seq 0 $step $((size - 1)); seq 0 2; seq $((size - 3)) $((size - 1)); } | sort -nu
}

# limited NAME OUTPUT ARGS...: every place of what the run writes to OUTPUT
limited() {
    local name=$1 output=$2 n bad='' tried=0
    shift 2
    local runs=$PLUMBAGO
    [ "$1" = without ] && runs="$BUILD_DIR/tests/tools/without_tmpfile $PLUMBAGO" && shift
    "$PLUMBAGO" -q "$@" -o "$output" a.svg || { fail "$name" "it fails without a limit" && return; }
    mv "$output" whole
    for n in $(places whole); do
        echo keep >"$output"
        prlimit --fsize=$n $runs -q "$@" -o "$output" a.svg 2>&1 >"$TMP/out" | cat >"$TMP/err" # the limit holds for the messages' file too, but not for a pipe
        local code=${PIPESTATUS[0]}
        tried=$((tried + 1))
        [ $code -eq 1 ] && [ "$(cat "$output")" = keep ] && [ "$(listing | wc -l)" -eq 3 ] && grep -q "^plumbago: .*$output: " "$TMP/err" && continue
        bad="$bad at $n: status $code, $(wc -l <"$TMP/err") lines;"
    done
    rm -f "$output" whole
    if [ -z "$bad" ]; then ok "$name, failing at $tried places"; else fail "$name" "$(cut -c 1-200 <<<"$bad")"; fi
}
limited "a PNG" x.png -d 30
limited "a PDF" x.pdf -d 30
limited "a dump" x.txt --dump=strokes
"$BUILD_DIR/tests/tools/without_tmpfile" /bin/true && limited "a PNG where no file can be without a name" x.png without -d 30

# the same on standard output, which has no name to keep
bad=
"$PLUMBAGO" -q -d 30 -o - a.svg >whole
for n in $(places whole); do
    prlimit --fsize=$n "$PLUMBAGO" -q -d 30 -o - a.svg 2>&1 >part | cat >"$TMP/err"
    code=${PIPESTATUS[0]}
    [ $code -eq 1 ] && [ "$(wc -l <"$TMP/err")" -eq 1 ] || bad="$bad at $n: status $code, $(wc -l <"$TMP/err") lines;"
done
if [ -z "$bad" ]; then ok "standard output"; else fail "standard output" "$(cut -c 1-200 <<<"$bad")"; fi

# a pipe whose reader has enough: quiet, and not a success
bad=
"$PLUMBAGO" -q -d 600 -o - a.svg >whole
for n in 0 1 8 33 1000 $(($(stat -c %s whole) / 2)); do
    "$PLUMBAGO" -q -d 600 -o - a.svg 2>"$TMP/err" | head -c $n >part
    code=${PIPESTATUS[0]}
    case $code in 141 | 1) ;; 0) [ $(($(stat -c %s whole) - n)) -le 65536 ] || bad="$bad at $n: success;" ;; *) bad="$bad at $n: status $code;" ;; esac
    [ "$(wc -l <"$TMP/err")" -le 1 ] || bad="$bad at $n: $(wc -l <"$TMP/err") lines;"
done
if [ -z "$bad" ]; then ok "a reader that has enough"; else fail "a reader that has enough" "$(cut -c 1-200 <<<"$bad")"; fi
rm -f whole part

# a full file system, where one can be made
mkdir full
if mount -t tmpfs -o size=16k tmpfs full 2>/dev/null; then
    echo keep >full/x.png
    plumbago -o full/x.png -d 300 a.svg
    is "a full file system: status" $status 1
    is "a full file system: one line" "$(wc -l <"$TMP/err")" 1
    is "a full file system: the output stays as it was" "$(cat full/x.png)" keep
    is "a full file system: nothing else" "$(find full -type f)" full/x.png
    umount full
else
    skip "a full file system" "none may be mounted here"
fi

# the other program
prlimit --fsize=50 "$PLUMBAGO_PROFILE" show HB 2>&1 >part | cat >"$TMP/err"
is "plumbago-profile show: status" ${PIPESTATUS[0]} 1
is "plumbago-profile show: one line" "$(wc -l <"$TMP/err")" 1
