# SPDX-License-Identifier: MIT
# No unfinished business, no paths of one machine, a licence line in every source file, comments that are plain sentences.
. "$ROOT/tests/check.sh"
cd "$ROOT" || exit 1
git rev-parse >/dev/null 2>&1 && files=$(git ls-files) || files=$(find . -type f -not -path './build/*' -not -path './.git/*' | sed 's|^\./||')
# Text only; a file deleted but not yet committed is left out.
files=$(tr '\n' '\0' <<<"$files" | xargs -0 grep -slI . /dev/null)
search() { tr '\n' '\0' <<<"$files" | xargs -0 grep -nIE -- "$1" /dev/null | cut -c 1-200; }
# The words are written in two parts so that this file does not hold them.
report "no unfinished business" "$(search "\b(TO""DO|FIX""ME|XX""X|HA""CK)\b|\b[Ss]t""ub(s|bed)?\b|not yet imple""mented")"
report "no paths of one machine" "$(search "/ho""me/[a-z]|/wo""rk/|/tmp/ba""sh|/Us""ers/")"
report "no blanks at line ends" "$(tr '\n' '\0' <<<"$(grep -E '\.([chsS]|sh|md)$|Makefile$' <<<"$files")" | xargs -0 grep -nE '[[:blank:]]+$' /dev/null | cut -c 1-160)"
tabs=$(tr '\n' '\0' <<<"$(grep -E '\.[ch]$' <<<"$files")" | xargs -0 grep -lP '\t' /dev/null)
report "no tabs in C" "$tabs"
# heads PATTERN LINES: the files whose first LINES lines hold no line that matches PATTERN.
heads() { xargs -d '\n' awk -v pattern="$1" -v lines="$2" 'FNR == 1 { if (file && !found) print file; file = FILENAME; found = 0 } FNR <= lines && $0 ~ pattern { found = 1 } END { if (file && !found) print file }'; }
unlicensed=$(grep -E '\.([ch]|sh|awk)$|^Makefile$|^tests/run$' <<<"$files" | heads 'SPDX-License-Identifier: MIT' 3)
report "every source file names its licence" "$unlicensed"
unsaid=$(grep -E '^src/.*\.h$|^src/.*\.c$' <<<"$files" | heads '^ [*] [A-Z]|^/[*] [A-Z].*[a-z][a-z][a-z].*[a-z][a-z][a-z]' 4)
unsaid=$(for f in $unsaid; do case $f in *.c) [ -f "${f%.c}.h" ] || echo "$f" ;; *) echo "$f" ;; esac; done)
report "every file says what it does (a .c of the same name as its .h may leave it to the .h)" "$unsaid"
large=$(xargs -d '\n' stat -c '%s %n' <<<"$files" | awk '$1 > 1048576')
report "no text file over 1 MiB" "$large"
# A comment opens with a sentence: subject, verb, object. The words are of another century.
in_c=$(grep -E '^(src|tests|examples)/.*\.[ch]$' <<<"$files")
in_scripts=$(grep -E '^(src|tests|examples)/.*\.(sh|awk|py)$|^Makefile$|^tests/run$' <<<"$files")
lines() { tr '\n' '\0' <<<"$1" | xargs -0 grep -nE -- "$2" /dev/null | cut -c 1-160; }
report "no comment opens with Of or What" "$(lines "$in_c" '/\* (Of|What) '; lines "$in_scripts" '^ *# (Of|What) '
    tr '\n' '\0' <<<"$in_c" | xargs -0 awk 'FNR <= 4 && /^ \* (Of|What) / { print FILENAME ":" FNR ": " $0 }')"
old_words='\b(lest|an''ew|for nau''ght|as [a-z ]+ (has|have|had) it)\b'
report "no words of another century in comments" "$(lines "$in_c" "(/\*|^ \*|//).*$old_words"; lines "$in_scripts" "^ *#.*$old_words")"
