# SPDX-License-Identifier: MIT
# Stopped midway: no temporary file, no half output, no helper left running.
# Alone: it measures how soon programs end.
. "$ROOT/tests/check.sh"
# A drawing that takes a while: 20,000 lines on a large sheet.
awk 'BEGIN { print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800mm\" height=\"600mm\" viewBox=\"0 0 800 600\"><g stroke=\"black\" stroke-width=\".3\">";
    for (i = 0; i < 20000; i++) printf "<path d=\"M%d %dL%d %d\"/>\n", i * 7919 % 800, i * 104729 % 600, i * 1299709 % 800, i * 15485863 % 600;
    print "</g></svg>" }' >long.svg

# stop SIGNAL SECONDS: starts, waits, sends the signal to the program alone.
stop() {
    echo keep >long.png
    # A background job of a script ignores SIGINT; env gives it back its default.
    env --default-signal=INT,TERM,HUP "$PLUMBAGO" -d 300 long.svg 2>"$TMP/err" &
    local pid=$! code
    sleep "$2"
    if ! kill -0 $pid 2>/dev/null; then
        wait $pid
        skip "$1 after $2 s" "it was done (or failed) before: $?"
        return
    fi
    kill -s "$1" $pid
    local sent=$SECONDS
    wait $pid
    code=$?
    is "$1 after $2 s: the status says so" $code $((128 + $(kill -l "$1")))
    if [ $((SECONDS - sent)) -le 3 ]; then ok "$1 after $2 s: it ends at once"; else fail "$1 after $2 s: it ends at once" "$((SECONDS - sent)) s"; fi
    is "$1 after $2 s: the output is as it was" "$(head -c 5 long.png)" keep
    is "$1 after $2 s: no other file" "$(listing | tr '\n' ' ')" "./long.png ./long.svg "
    sleep .3
    local left
    left=$(ps -eo ppid=,args= 2>/dev/null | awk '$1 == 1' | grep -c "^ *1 .*$BUILD_DIR/[t]ap-svg")
    is "$1 after $2 s: no helper is left" "$left" 0
}
for signal in INT TERM HUP; do
    for after in .15 1; do stop $signal $after; done
done

# The same where a file cannot be without a name: one with a name is there while the picture is made, and goes with it.
without="$BUILD_DIR/tests/tools/without_tmpfile"
"$without" /bin/true
if [ $? -eq 125 ]; then
    skip "without O_TMPFILE" "this kernel cannot be told to refuse it"
    exit
fi
# Waits for files in this folder that have the name of temporary files.
temporary() { local n; for n in {1..600}; do [ -n "$(find . -name '.plumbago-*')" ] && return; kill -0 $pid 2>/dev/null || break; sleep .1; done; false; }
gone() { local n; for n in {1..100}; do [ -z "$(find . -name '.plumbago-*')" ] && return; sleep .1; done; false; }
sed -i '2000,19999d' long.svg
for signal in INT TERM HUP KILL; do
    echo keep >long.png
    env --default-signal=INT,TERM,HUP "$without" "$PLUMBAGO" -d 1200 long.svg 2>"$TMP/err" &
    pid=$!
    if temporary; then ok "without O_TMPFILE, $signal: a temporary file is there"; else fail "without O_TMPFILE, $signal: a temporary file is there" "it never came"; fi
    kill -s $signal $pid
    wait $pid
    is "without O_TMPFILE, $signal: the status says so" $? $((128 + $(kill -l $signal)))
    if gone; then ok "without O_TMPFILE, $signal: nothing is left"; else fail "without O_TMPFILE, $signal: nothing is left" "$(listing | tr '\n' ' ')"; fi
    is "without O_TMPFILE, $signal: the output is as it was" "$(head -c 5 long.png)" keep
done
example a.svg
"$PLUMBAGO" -o with.png a.svg 2>"$TMP/err"
for n in 1 2; do
    "$without" "$PLUMBAGO" -o without.png a.svg 2>"$TMP/err"
    is "without O_TMPFILE: drawn, $n" $? 0
    same "without O_TMPFILE: the same picture, $n" without.png with.png
done
echo keep >without.png
"$without" "$PLUMBAGO" -d 10 --dump=strokes -o without.png a.svg 2>"$TMP/err"
is "without O_TMPFILE: a dump" "$? $(head -c 9 without.png)" "0 $("$PLUMBAGO" --dump=strokes a.svg | head -c 9)"
is "without O_TMPFILE: nothing is left" "$(find . -name '.plumbago-*')" ""

# Killed between the two steps in which a file takes another's place: the temporary name goes.
if strace -o /dev/null true 2>/dev/null; then
    echo keep >taken.png
    strace -o /dev/null -e trace=rename -e inject=rename:signal=SIGKILL "$PLUMBAGO" -d 20 -o taken.png a.svg 2>"$TMP/err"
    is "killed at rename: the status says so" $? $((128 + 9))
    if gone; then ok "killed at rename: no name is left"; else fail "killed at rename: no name is left" "$(listing | tr '\n' ' ')"; fi
else
    skip "killed at rename" "no strace here, or it may not trace (Debian: strace)"
fi

# Stopped for longer than a silent reader may take (Ctrl-Z), and resumed: the same drawing. A reader that is slow to get a
# processor is not at fault either.
printf '%%!PS\n/Helvetica findfont 24 scalefont setfont 1 1 40 { 60 moveto (Plumbago) show } for showpage\n' >letters.ps
example stopped.svg
for drawing in stopped.svg letters.ps; do
    [ $drawing = letters.ps ] && ! command -v gs >/dev/null && continue
    "$PLUMBAGO" -q --limit-time 2 --dump=list $drawing >whole.txt
    setsid "$PLUMBAGO" -q --limit-time 2 --dump=list -o resumed.txt $drawing 2>"$TMP/err" &
    pid=$!
    sleep .1
    kill -s STOP -- -$pid 2>/dev/null
    sleep 8
    kill -s CONT -- -$pid 2>/dev/null
    wait $pid
    is "$drawing, stopped for 8 s: drawn" "$? $(cat "$TMP/err")" "0 "
    same "$drawing, stopped for 8 s: the same" resumed.txt whole.txt
done
