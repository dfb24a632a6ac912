# SPDX-License-Identifier: MIT
# The documents keep up with the code: comments in the public header, functions in plumbago(3), pages without faults.
. "$ROOT/tests/check.sh"
cd "$ROOT" || exit 1

# A paragraph of the header that declares something has a comment before its first function.
bare=$(awk 'BEGIN { RS = ""; FS = "\n" }
    { for (i = 1; i <= NF; i++) { if ($i ~ /\/\*/) break; if ($i ~ /^PLB_API [a-z]/) { print $i; break } } }' src/api/plumbago.h)
report "every prototype of plumbago.h has its comment" "$bare"

for page in man/plumbago.1 man/plumbago-profile.1 man/plumbago.3 man/pencil.5 man/plumbago-list.5; do
    if [ -f $page ]; then ok "$page is there"; else fail "$page is there" "no such file"; fi
done
header=$(grep -oE '\bplb_[a-z_]+\(' src/api/plumbago.h | tr -d '(' | sort -u)
manual=$(grep -ohE '\bplb_[a-z_]+' man/plumbago.3 2>/dev/null | sort -u)
report "every function is in plumbago(3)" "$(comm -23 <(echo "$header") <(echo "$manual"))"
names=$(grep -oE '\bplb_[a-z_]+' src/api/plumbago.h | sort -u)
report "plumbago(3) names nothing that is not there" "$(comm -13 <(echo "$names") <(echo "$manual"))"

if command -v mandoc >/dev/null; then
    for page in man/*.[1-9]; do
        report "$page is clean mdoc" "$(mandoc -Tlint -Wwarning "$page" 2>&1)"
    done
else
    skip "the pages are clean mdoc" "no mandoc here"
fi
for section in SYNOPSIS DESCRIPTION "EXIT STATUS" EXAMPLES LIMITATIONS; do
    if grep -qE "^\.Sh (\"?$section\"?)\$" man/plumbago.1; then ok "plumbago(1) has $section"; else fail "plumbago(1) has $section" "no .Sh $section"; fi
done
for target in demo check; do
    if grep -q "make $target" README.md; then ok "README names make $target"; else fail "README names make $target" "it does not"; fi
done
version=$(awk '/define PLB_VERSION_(MAJOR|MINOR|PATCH) / { v = v dot $3; dot = "." } END { print v }' src/api/plumbago.h)
if grep -qF "$version" NEWS.md; then ok "NEWS names version $version"; else fail "NEWS names version $version" "it does not"; fi
# Every file and folder that the README links to is there.
dead=$(for f in README.md NEWS.md tests/README.md; do
    [ -f $f ] && grep -oE '\]\([^)#]+\)' $f | sed 's/^](//; s/)$//' | grep -vE '^(https?|mailto):' |
        while IFS= read -r link; do [ -e "$(dirname $f)/$link" ] || echo "$f: $link"; done
done)
report "no dead links" "$dead"
# C in comments and documents is British.
american=$(grep -rnwiE 'color|colors|center|centered|gray|grays|behavior|neighbor|neighbors|initialize|recognize|normalize|serialize' src --include='*.[ch]' | grep -vE 'cairo|png_|PNG_|rsvg|setgray|settinggray|"[^"]*(gray|[Cc]olor|center)[^"]*"|#include' | cut -c 1-160)
report "British spelling in src" "$american"
