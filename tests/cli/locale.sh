# SPDX-License-Identifier: MIT
# The reader's language and time change nothing: a locale with a decimal comma above all.
. "$ROOT/tests/check.sh"
example a.svg
plumbago -d 99.5 --squiggle 0.3mm -o ref.png a.svg
plumbago --dump=list a.svg && cp "$TMP/out" ref.txt
for name in C.UTF-8 POSIX tr_TR.UTF-8; do
    LC_ALL=$name LANG=$name TZ=Asia/Kolkata "$PLUMBAGO" -d 99.5 --squiggle 0.3mm -o x.png a.svg 2>"$TMP/err"
    same "LC_ALL=$name" x.png ref.png
done
# de_DE is made for the test: only what is needed, in this directory.
if command -v localedef >/dev/null && mkdir locales && localedef -i de_DE -f UTF-8 "$PWD/locales/de_DE.UTF-8" 2>/dev/null; then
    export LOCPATH=$PWD/locales
    is "the decimal comma is there" "$(LC_ALL=de_DE.UTF-8 locale decimal_point)" ,
    LC_ALL=de_DE.UTF-8 "$PLUMBAGO" -d 99.5 --squiggle 0.3mm -o de.png a.svg 2>"$TMP/err"
    same "LC_ALL=de_DE.UTF-8" de.png ref.png
    LC_ALL=de_DE.UTF-8 "$PLUMBAGO" --dump=list a.svg >de.txt 2>"$TMP/err"
    same "LC_ALL=de_DE.UTF-8, --dump=list" de.txt ref.txt
    LC_ALL=de_DE.UTF-8 "$PLUMBAGO" -d 99,5 -o x.png a.svg 2>"$TMP/err"
    is "a comma is no decimal point" $? 2
    unset LOCPATH
else
    skip "a decimal comma" "no localedef, or no source of de_DE (Debian: locales)"
fi
env -i "$PLUMBAGO" -d 99.5 --squiggle 0.3mm -o empty.png a.svg 2>"$TMP/err"
is "an empty environment: status" $? 0
same "an empty environment" empty.png ref.png
HOME=/nonexistent XDG_CACHE_HOME=/nonexistent "$PLUMBAGO" -d 99.5 --squiggle 0.3mm -o home.png a.svg 2>"$TMP/err"
same "without a home" home.png ref.png
if [ -s "$TMP/err" ]; then fail "without a home: not a word" "$(head -n 1 "$TMP/err")"; else ok "without a home: not a word"; fi
