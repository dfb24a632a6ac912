# SPDX-License-Identifier: MIT
# Writing fails after so many bytes: a file that may not grow, a reader that has gone. Exit status 1, one line, no file left,
# what was there stays. LONG=1: at every byte of the result (of more than 5,000, at
# so many), else at some.
. "$ROOT/tests/check.sh"
command -v prlimit >/dev/null || { skip "writes that fail" "no prlimit here (Debian: util-linux)" && exit; }
example a.svg

most=12 first=0
case $BUILD_DIR in *tsan*) first=1 ;; esac # the sanitizer itself writes a byte
[ -n "${LONG:-}" ] && most=5000

# places FILE: byte counts at which to fail
places() {
    local size step
    size=$(stat -c %s "$1")
    step=$((size / most + 1))
    { seq $first $step $((size - 1)); seq $first 2; seq $((size - 3)) $((size - 1)); } | sort -nu
}

# limited NAME OUTPUT COMMAND...: every place of what the command writes to OUTPUT
limited() {
    local name=$1 output=$2 n bad='' tried=0 before
    shift 2
    "$@" >"$TMP/out" || { fail "$name" "it fails without a limit" && return; }
    mv "$output" whole
    echo keep >"$output"
    before=$(listing)
    for n in $(places whole); do
        prlimit --fsize=$n "$@" 2>&1 >"$TMP/out" | cat >"$TMP/err" # the limit holds for the messages' file too, but not for a pipe
        local code=${PIPESTATUS[0]}
        tried=$((tried + 1))
        [ $code -eq 1 ] && [ "$(cat "$output")" = keep ] && [ "$(listing)" = "$before" ] && [ "$(wc -l <"$TMP/err")" -eq 1 ] &&
            grep -q "^plumbago[a-z-]*: .*$output: " "$TMP/err" && continue
        bad="$bad at $n: status $code, $(wc -l <"$TMP/err") lines;"
        echo keep >"$output"
    done
    rm -f "$output" whole
    if [ -z "$bad" ]; then ok "$name, failing at $tried places"; else fail "$name" "$(cut -c 1-200 <<<"$bad")"; fi
}
limited "a PNG" x.png "$PLUMBAGO" -q -d 30 -o x.png a.svg
limited "a PDF" x.pdf "$PLUMBAGO" -q -d 30 -o x.pdf a.svg
limited "a dump" x.txt "$PLUMBAGO" -q --dump=strokes -o x.txt a.svg
limited "a picture of controls" x.png "$PLUMBAGO" -q -d 30 --dump=controls -o x.png a.svg
[ -z "${LONG:-}" ] || limited "a large PNG" x.png "$PLUMBAGO" -q -d 150 -o x.png a.svg
[ -z "${LONG:-}" ] || limited "a large PDF in colour" x.pdf "$PLUMBAGO" -q -d 100 --colour -o x.pdf a.svg
"$BUILD_DIR/tests/tools/without_tmpfile" /bin/true &&
    limited "a PNG where no file can be without a name" x.png "$BUILD_DIR/tests/tools/without_tmpfile" "$PLUMBAGO" -q -d 30 -o x.png a.svg
if [ -n "${LONG:-}" ]; then
    printf '<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="6mm" viewBox="0 0 40 6"><path d="M3 3H37" stroke="black" fill="none"/></svg>' >line.svg
    "$PLUMBAGO" -q --squiggle 0 -o scan.png line.svg
    most=100 limited "a pencil" x.pencil "$PLUMBAGO_PROFILE" capture -o x.pencil scan.png # which takes a second
    rm line.svg scan.png
fi
limited "a pencil's picture" x.png "$PLUMBAGO_PROFILE" show --plot x.png HB

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
