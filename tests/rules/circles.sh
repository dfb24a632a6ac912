# SPDX-License-Identifier: MIT
# No circle of calls between files: whoever understands a file needs those that it calls, never itself again. A file and
# its calls are an object and the symbols that the object uses: the graph of the library's objects, and of each tap's, has no cycle.
. "$ROOT/tests/check.sh"
[ -f "$BUILD_DIR/libplumbago.a" ] || { fail "the library is built" "no $BUILD_DIR/libplumbago.a"; exit; }

# "OBJECT SYMBOL USER" for each use of a symbol that another object of the list defines.
uses() {
    nm -g -A "$@" 2>/dev/null | awk '
        { object = $1; sub(/:[^:]*$/, "", object) }
        $NF ~ /^(_GLOBAL_OFFSET_TABLE_|__gcov|__asan|__ubsan|__tsan|__odr|__llvm)/ { next }
        $(NF - 1) ~ /^[TDRBCVW]$/ { home[$NF] = object; next }
        $(NF - 1) == "U" { n++; user[n] = object; symbol[n] = $NF }
        END { for (i = 1; i <= n; i++) if (symbol[i] in home && home[symbol[i]] != user[i]) print home[symbol[i]], symbol[i], user[i] }'
}

# The rest of those uses when objects that call none, or that none calls, have been taken away again and again: the circles
# and the ways from one to another.
circles() {
    awk '
        { home[NR] = $1; symbol[NR] = $2; user[NR] = $3; called[$1]++; calls[$3]++ }
        END {
            do {
                taken = 0
                for (i in home) if (!calls[home[i]] || !called[user[i]]) {
                    called[home[i]]--; calls[user[i]]--; delete home[i]; taken = 1
                }
            } while (taken)
            for (i = 1; i <= NR; i++) if (i in home) print user[i] " calls " symbol[i] " of " home[i]
        }'
}

# The graph can tell: two files that call each other, and one that both call.
printf '%s\n' 'a.o in_a b.o' 'b.o in_b a.o' 'c.o in_c a.o' 'c.o in_c b.o' 'a.o in_a d.o' | circles >"$TMP/found"
if [ "$(cat "$TMP/found")" = "$(printf '%s\n' 'b.o calls in_a of a.o' 'a.o calls in_b of b.o')" ]; then ok "a circle is found"; else fail "a circle is found" "$(cat "$TMP/found")"; fi

cd "$BUILD_DIR" || exit 1
# The objects of all folders but the programs' and the taps': each of those is linked for itself.
library=$(find api base system list profile input plan stroke surface film figure -name '*.o' 2>/dev/null | while read -r o; do [ -f "$ROOT/src/${o%.o}.c" ] && echo "$o"; done | sort)
report_circles() {
    local name=$1
    shift
    uses "$@" | circles >"$TMP/found"
    report "no circle of calls between files: $name" "$(cat "$TMP/found")"
}
# shellcheck disable=SC2086
report_circles "the library" $library
# shellcheck disable=SC2046
report_circles "the programs" $(find tool -name '*.o' | while read -r o; do [ -f "$ROOT/src/${o%.o}.c" ] && echo "$o"; done)
for tap in "$ROOT"/src/tap/*/; do
    tap=${tap%/}
    tap=${tap##*/}
    objects=$(find "tap/$tap" tap/common -name '*.o' 2>/dev/null | while read -r o; do [ -f "$ROOT/src/${o%.o}.c" ] && echo "$o"; done | sort)
    [ -n "$objects" ] || continue
    # shellcheck disable=SC2086
    report_circles "tap/$tap" $objects
done
