# SPDX-License-Identifier: MIT
# The commands in the EXAMPLES sections of the man pages work: each ".Dl $ COMMAND" is run in a copy of examples/,
# where an earlier example of the same page has left its files.
. "$ROOT/tests/check.sh"
unset -f plumbago # the real one is on the PATH below
export PATH="$BUILD_DIR:$PATH"
for page in "$ROOT"/man/*.1 "$ROOT/man/plumbago-list.5"; do
    rm -rf work && cp -r "$ROOT/examples" work
    commands=$(sed -nE '/^\.Sh EXAMPLES/,/^\.Sh [^E]/p' "$page" | sed -nE 's/^\.Dl "?(\$|%) (.*)/\2/p' | sed -E 's/"$//; s/\\&//g; s/\\e/\\/g; s/\\\(dq/"/g; s/\\\(aq/'"'"'/g; s/\\-/-/g; s/""/"/g')
    [ -n "$commands" ] || { fail "examples of ${page##*/}" "there are none"; continue; }
    while IFS= read -r command; do
        name="${page##*/}: $command"
        absent=$(tr '|;&' '\n' <<<"$command" | awk '{ print $1 }' | while read -r word; do command -v "$word" >/dev/null || { [[ $word == *=* ]] || echo "$word"; }; done | head -n 1)
        if [ -n "$absent" ]; then
            skip "$name" "no $absent here"
        elif (cd work && set -o pipefail && eval "$command") </dev/null >"$TMP/out" 2>"$TMP/err"; then
            ok "$name"
        else
            fail "$name" "exit status $?: $(tail -n 1 "$TMP/err")"
        fi
    done <<<"$commands"
done
