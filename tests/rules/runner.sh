# SPDX-License-Identifier: MIT
# tests/run itself: several at a time, results in the order of the list, one line for each, an honest count; nothing stays behind.
. "$ROOT/tests/check.sh"
run=$ROOT/tests/run
export TMPDIR=$PWD/temporary
mkdir temporary
here=${PWD#/} up=$(tr -c '/\n' '.' <<<"${ROOT#/}" | sed -E 's/\.+/../g')
echo 'sleep .4; echo ok slow' >slow.sh
echo 'echo ok quick; [ "$(ls)" = "" ] && echo ok it begins in an empty folder' >quick.sh
echo 'echo ok before; exit 3' >ends.sh
echo 'true' >silent.sh
printf '# Alone: it is a test\necho ok alone\n' >alone.sh
echo 'trap "echo ok interrupted; exit" INT; kill -INT $$; sleep 1; echo FAIL interrupts are ignored' >interrupted.sh
all=''
for t in slow quick ends silent alone interrupted; do all="$all $up/$here/$t.sh"; done
# shellcheck disable=SC2086
"$run" -j 3 "$BUILD_DIR" $all >said
is "status" $? 1
is "the order is the list's, those that run alone first" "$(awk '/passed .* failed .* s$/ { sub(/.*\//, "", $1); printf "%s ", $1 }' said)" \
    "alone.sh slow.sh quick.sh ends.sh silent.sh interrupted.sh "
is "the count" "$(tail -n 1 said)" "6 passed, 2 failed"
is "an exit status without a reason is a failure" "$(grep -c 'FAIL .*ends.sh: exit status 3' said)" 1
is "a test without a case is a failure" "$(grep -c 'FAIL .*silent.sh: it ran no case' said)" 1
is "nothing stays behind" "$(ls temporary)" ""
echo 'echo $$ >"$MARK"; sleep 30; echo ok late' >late.sh
export MARK=$PWD/mark
"$run" -j 2 "$BUILD_DIR" "$up/$here/late.sh" >said 2>&1 &
for _ in {1..100}; do [ -s mark ] && break; sleep .1; done
kill -TERM $!
wait $! 2>/dev/null
is "stopped: status" $? 143
for _ in {1..50}; do kill -0 "$(cat mark)" 2>/dev/null || break; sleep .1; done
if kill -0 "$(cat mark)" 2>/dev/null; then fail "stopped: its tests stop" "one runs on"; else ok "stopped: its tests stop"; fi
is "stopped: nothing stays behind" "$(ls temporary)" ""
