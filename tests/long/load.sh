# SPDX-License-Identifier: MIT
# Real load: LOAD drawings (200) through `make -j2`, killed at random moments until it has been killed KILLS times (8). What
# there is between, and after `make` once more, is complete and the same as of a run that nobody disturbs. (2,000 take longer
# than a test may: TEST_TIMEOUT=4000 LOAD=2000 KILLS=30 LOAD_SECONDS=12 tests/run build/release tests/long/load.sh)
. "$ROOT/tests/check.sh"
count=${LOAD:-200} kills=${KILLS:-8} RANDOM=${LOAD_SEED:-1}
mapfile -t drawings < <(find "$ROOT/examples" "$ROOT/tests/image" -name '*.svg'; find "$SHARED/corpus" -path '*/hostile' -prune -o -size -60k \( -name '*.svg' -o -name '*.eps' -o -name '*.ps' -o -name '*.pdf' \) -print 2>/dev/null)
[ -d "$SHARED/corpus" ] || skip "drawings of the corpus" "not here; our own are used"

# Drawings that cannot be drawn have no place here; each is read once, within a time.
usable=()
mapfile -t drawings < <(printf '%s\n' "${drawings[@]}" | sort)
for d in "${drawings[@]}"; do
    [ ${#usable[@]} -lt "${LOAD_DRAWINGS:-40}" ] || break
    timeout 5 "$PLUMBAGO" -q -d 20 -o "$TMP/once.png" "$d" 2>/dev/null && usable+=("$d")
done
rm -f "$TMP/once.png"
is "some drawings can be drawn" "$([ ${#usable[@]} -gt 3 ] && echo yes)" yes

# the makefile: number N is drawing N modulo their count, with seed N
for ((i = 0; i < ${#usable[@]}; i++)); do ln -s "${usable[i]}" "in-$i"; done
{
    echo "all:$(for ((i = 0; i < count; i++)); do printf ' %d.png' $i; done)"
    for ((i = 0; i < count; i++)); do
        printf '%d.png: in-%d\n\t@"%s" -q -d 20 --seed %d -o $@ $<\n' $i $((i % ${#usable[@]})) "$PLUMBAGO" $i
    done
} >Makefile
mkdir calm storm
for d in calm storm; do cp -P Makefile in-* $d; done

# made WHERE: make's exit status there, and its first words where it fails
made() {
    local code said
    said=$(cd "$1" && make -s -j2 2>&1)
    code=$?
    if [ $code -eq 0 ]; then echo 0; else echo "$code: $(grep -v -m 1 '^make' <<<"$said")"; fi
}
is "nobody disturbs: make succeeds" "$(made calm)" 0

# compare: every PNG in storm is the one in calm
compare() { local f bad=''; for f in storm/*.png; do [ ! -e "$f" ] || cmp -s "$f" "calm/${f##*/}" || bad="$bad ${f##*/}"; done; echo "$bad"; }
broken='' done_kills=0 killed=0
for ((k = 0; k < kills; k++)); do
    # make and what it starts are a session of their own, so that all of it, and nothing else, dies
    (cd storm && exec setsid make -s -j2 >"$TMP/storm" 2>&1) &
    group=$!
    sleep "$((RANDOM % ${LOAD_SECONDS:-4})).$((RANDOM % 10))$((RANDOM % 10))"
    killed=$((killed + $(pgrep -c -s $group || true)))
    kill -KILL -- -$group 2>/dev/null
    wait $group 2>/dev/null
    [ "$(find storm -name '*.png' | wc -l)" -lt "$count" ] && done_kills=$((done_kills + 1)) # else it had done all before
    broken="$broken$(compare)"
done
if [ $done_kills -gt 0 ]; then ok "make was killed $done_kills times, with $killed processes"; else fail "make was killed" "it was done before each time: more LOAD"; fi
is "between kills nothing is half done" "$broken" ""
is "once more: make succeeds" "$(made storm)" 0
is "once more: all are there" "$(find storm -name '*.png' | wc -l)" "$count"
is "once more: all are the same as undisturbed" "$(compare)" ""
is "nothing else is left" "$(find storm -name '.plumbago*' | wc -l)" 0
