# SPDX-License-Identifier: MIT
# The least a shell test needs; `. "$ROOT/tests/check.sh"` reads it. A test script runs in an empty directory of its own
# and prints, by these functions, one line for each case: "ok NAME", "FAIL NAME: why" or "skip NAME: why".

ok() { echo "ok $1"; }
fail() { echo "FAIL $1: ${2:-}"; }
skip() { echo "skip $1: ${2:-}"; }

# check NAME COMMAND...: ok when the command succeeds; what it printed is the reason when it does not.
check() {
    local name=$1 said
    shift
    if said=$("$@" 2>&1); then ok "$name"; else fail "$name" "$(tail -n 1 <<<"$said" | cut -c 1-300)"; fi
}

# report NAME TEXT: for checks that list offenders: ok when the text is empty, else FAIL with it (at most 12 lines).
report() {
    if [ -z "$2" ]; then
        ok "$1"
    else
        fail "$1" "$(wc -l <<<"$2") found"
        head -n 12 <<<"$2" | sed 's/^/  /'
    fi
}

# plumbago ARGS...: runs the program; leaves the files `out` and `err` in $TMP and its exit status in $status.
plumbago() {
    "$PLUMBAGO" "$@" >"$TMP/out" 2>"$TMP/err"
    status=$?
}

# draws NAME ARGS...: the run succeeds and says nothing.
draws() {
    local name=$1
    shift
    plumbago "$@"
    if [ $status -ne 0 ]; then
        fail "$name" "exit status $status: $(head -n 1 "$TMP/err")"
    elif [ -s "$TMP/err" ]; then
        fail "$name" "it said: $(head -n 1 "$TMP/err")"
    else
        ok "$name"
    fi
}

listing() { find . -mindepth 1 | sort; }

# refuses NAME PATTERN ARGS...: the run fails as for a drawing that cannot be made: exit status 1, exactly one line
# on standard error that begins with "plumbago: " and matches PATTERN, nothing on standard output, no file more or less.
refuses() {
    local name=$1 pattern=$2 before
    shift 2
    before=$(listing)
    plumbago "$@"
    if [ $status -ne 1 ]; then
        fail "$name" "exit status $status, not 1: $(head -n 1 "$TMP/err")"
    elif [ "$(wc -l <"$TMP/err")" -ne 1 ]; then
        fail "$name" "$(wc -l <"$TMP/err") lines on standard error, not 1: $(head -n 2 "$TMP/err" | tr '\n' '|')"
    elif ! grep -q '^plumbago: ' "$TMP/err" || ! grep -qE -- "$pattern" "$TMP/err"; then
        fail "$name" "the message is: $(cat "$TMP/err")"
    elif [ -s "$TMP/out" ]; then
        fail "$name" "it wrote $(wc -c <"$TMP/out") bytes to standard output"
    elif [ "$(listing)" != "$before" ]; then
        fail "$name" "the files changed: $(diff <(echo "$before") <(listing) | tr '\n' ' ')"
    else
        ok "$name"
    fi
}

# misused NAME PATTERN ARGS...: the command line is wrong: exit status 2, a line that matches PATTERN (which names the
# option), a hint at --help, and no file more or less.
misused() {
    local name=$1 pattern=$2 before
    shift 2
    before=$(listing)
    plumbago "$@"
    if [ $status -ne 2 ]; then
        fail "$name" "exit status $status, not 2: $(head -n 1 "$TMP/err")"
    elif [ "$(wc -l <"$TMP/err")" -gt 2 ] || ! grep -q -- '--help' "$TMP/err"; then
        fail "$name" "not one line and a hint at --help: $(tr '\n' '|' <"$TMP/err")"
    elif ! head -n 1 "$TMP/err" | grep -q '^plumbago: ' || ! head -n 1 "$TMP/err" | grep -qE -- "$pattern"; then
        fail "$name" "the message is: $(head -n 1 "$TMP/err")"
    elif [ -s "$TMP/out" ]; then
        fail "$name" "it wrote $(wc -c <"$TMP/out") bytes to standard output"
    elif [ "$(listing)" != "$before" ]; then
        fail "$name" "the files changed: $(diff <(echo "$before") <(listing) | tr '\n' ' ')"
    else
        ok "$name"
    fi
}

# tool NAME ARGS...: runs the little program tests/tools/NAME.c.
tool() {
    local program=$1
    shift
    "$BUILD_DIR/tests/tools/$program" "$@"
}

# info FILE KEY: one field of png_info: size, dpi, ...
info() { tool png_info "$1" | sed -n "s/^$2 //p"; }

# same NAME FILE FILE: byte for byte.
same() { if cmp -s "$2" "$3"; then ok "$1"; else fail "$1" "$(cmp "$2" "$3" 2>&1 | head -n 1)"; fi; }
# differ NAME FILE FILE: both exist and are not the same.
differ() { if [ -s "$2" ] && [ -s "$3" ] && ! cmp -s "$2" "$3"; then ok "$1"; else fail "$1" "$2 and $3 are the same, or one is missing"; fi; }
# is NAME VALUE EXPECTED
is() { if [ "$2" = "$3" ]; then ok "$1"; else fail "$1" "got '$2', expected '$3'"; fi; }

# example FILE.svg: a small drawing, 40 mm by 30 mm: a frame, a diagonal, a circle and a curve.
example() {
    cat >"$1" <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="30mm" viewBox="0 0 40 30">
<g fill="none" stroke="black" stroke-width=".4">
<rect x="4" y="4" width="32" height="22"/>
<path d="M4 4 L36 26"/>
<circle cx="26" cy="12" r="5"/>
<path d="M8 22 C12 10 16 30 24 20"/>
</g>
</svg>
SVG
}
