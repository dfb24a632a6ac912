# SPDX-License-Identifier: MIT
# Stopped midway: no temporary file, no half output, no helper left running.
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
