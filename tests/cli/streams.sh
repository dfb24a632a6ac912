# SPDX-License-Identifier: MIT
# Pipes: standard input and output, closed and broken ones, and strange file names.
. "$ROOT/tests/check.sh"
example a.svg
plumbago -o ref.png a.svg

"$PLUMBAGO" <a.svg >stdout.png 2>"$TMP/err"
is "a filter: status" $? 0
same "a filter: standard input to standard output" stdout.png ref.png
"$PLUMBAGO" - <a.svg >dash.png 2>"$TMP/err"
same "- is standard input" dash.png ref.png
"$PLUMBAGO" -o - a.svg >dash2.png 2>"$TMP/err"
same "-o - is standard output" dash2.png ref.png
cat a.svg | "$PLUMBAGO" -o named.png - >"$TMP/out" 2>"$TMP/err"
same "from a pipe to a file" named.png ref.png
"$PLUMBAGO" -o - a.svg 2>"$TMP/err" | cat >piped.png
same "from a file to a pipe" piped.png ref.png
(sleep .3; head -c 200 a.svg; sleep .3; tail -c +201 a.svg) | "$PLUMBAGO" >slow.png 2>"$TMP/err"
same "from a slow pipe" slow.png ref.png
"$PLUMBAGO" >nothing.png </dev/null 2>"$TMP/err"
is "an error in a filter: status" $? 1
if [ ! -s nothing.png ] && [ "$(wc -l <"$TMP/err")" -eq 1 ]; then ok "an error in a filter: no byte, one line"; else fail "an error in a filter: no byte, one line" "$(cat "$TMP/err")"; fi

"$PLUMBAGO" -o - a.svg >&- 2>"$TMP/err"
is "standard output closed: status" $? 1
is "standard output closed: one line" "$(wc -l <"$TMP/err")" 1
"$PLUMBAGO" --version >&- 2>"$TMP/err"
is "--version, standard output closed" $? 1
"$PLUMBAGO" -o closed.png a.svg >&- 2>&- <&-
is "a file drawn with all three closed: status" $? 0
same "a file drawn with all three closed" closed.png ref.png
"$PLUMBAGO" -o x.png - <&- 2>"$TMP/err" >"$TMP/out"
is "standard input closed: status" $? 1
is "standard input closed: one line" "$(wc -l <"$TMP/err")" 1
if [ -e x.png ]; then fail "standard input closed: no output" "x.png is there"; else ok "standard input closed: no output"; fi
"$PLUMBAGO" -o x.png nothing.svg 2>&-
is "standard error closed: status" $? 1

"$PLUMBAGO" -d 1200 -o - a.svg 2>"$TMP/err" | head -c 10 >/dev/null
codes=("${PIPESTATUS[@]}")
if [ ! -s "$TMP/err" ] || [ "$(wc -l <"$TMP/err")" -eq 1 ]; then ok "a broken pipe: at most one line"; else fail "a broken pipe: at most one line" "$(head -n 2 "$TMP/err")"; fi
case ${codes[0]} in 141 | 1) ok "a broken pipe is no success" ;; *) fail "a broken pipe is no success" "exit status ${codes[0]}" ;; esac
if grep -qi 'panic\|abort\|assert\|internal' "$TMP/err"; then fail "a broken pipe: quiet" "$(cat "$TMP/err")"; else ok "a broken pipe: quiet"; fi

while IFS= read -r name; do
    printf -v name '%b' "$name"
    shown=$(printf '%q' "$name")
    mkdir -p strange && rm -rf strange/* && (cd strange && example "./$name.svg" && "$PLUMBAGO" -- "$name.svg") 2>"$TMP/err"
    is "the file name $shown: status" $? 0
    same "the file name $shown" "strange/$name.png" ref.png
    (cd strange && "$PLUMBAGO" -- "$name.none") 2>"$TMP/err"
    is "the file name $shown, not there: one line" "$? $(wc -l <"$TMP/err")" "1 1"
done <<'END'
with blanks
a\nnew line
-o
--help
quote"s and 'quotes'
$(touch pwned)
;touch pwned
100%s%n%d
grüße-\xff\xfe
*
#
tab\tand\\backslash
bell\a\e[31m
END
if find . -name 'pwned*' | grep -q .; then fail "names are not commands" "one was run"; else ok "names are not commands"; fi
long=$(printf 'n%.0s' {1..250})
example "$long.svg"
plumbago "$long.svg"
if [ $status -eq 0 ] && [ -s "$long.png" ] || { [ $status -eq 1 ] && [ "$(wc -l <"$TMP/err")" -eq 1 ]; }; then ok "a name of 254 bytes"; else fail "a name of 254 bytes" "exit status $status: $(cut -c 1-100 "$TMP/err")"; fi
deep=$(printf 'd/%.0s' {1..3000})
refuses "a path of 6000 bytes" "." "${deep}x.svg"
plumbago ""
case $status in 1 | 2) ok "an empty name is refused" ;; *) fail "an empty name is refused" "exit status $status" ;; esac
mkdir elsewhere && (cd elsewhere && "$PLUMBAGO" ../a.svg) 2>"$TMP/err"
same "a relative path: the output lies beside the input" a.png ref.png
"$PLUMBAGO" -o "$PWD/absolute.png" "$PWD/a.svg" 2>"$TMP/err"
same "absolute paths" absolute.png ref.png
