# SPDX-License-Identifier: MIT
# Functions and files stay short. The budget: median 15 lines, 95th percentile 60, none over 100; files 700 lines.
# A function counts from the last line of its head to its closing brace, both in column 0: the layout of this project.
. "$ROOT/tests/check.sh"
cd "$ROOT" || exit 1

# "LINES FILE:LINE NAME" for each function.
functions() {
    awk '
    FNR == 1 { start = 0; head = "" }
    /^[A-Za-z_].*\)[[:space:]]*\{.*\}$/ { name = $0; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name); print 1, FILENAME ":" FNR, name; next }
    /^\{/ && head ~ /\)$/ { start = FNR - 1; next }
    /^\}/ && start { print FNR - start + 1, FILENAME ":" start, name; start = 0; next }
    !start && /^[A-Za-z_].*\(/ { name = $0; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name) }
    { head = $0 }' "$@"
}
sources=$(find src -name '*.[ch]' | sort)
# shellcheck disable=SC2086
functions $sources | sort -rn >"$TMP/functions"
count=$(wc -l <"$TMP/functions")
rank() { sed -n "$((count - (count * $1 + 99) / 100 + 1))p" "$TMP/functions"; }
read -r median _ < <(rank 50)
read -r p95 _ < <(rank 95)
echo "$count functions: median $median lines, 95th percentile $p95, longest $(head -n 1 "$TMP/functions")"
if [ "$count" -gt 50 ]; then ok "functions were found"; else fail "functions were found" "only $count"; fi
if [ "$median" -le 15 ]; then ok "the median function has at most 15 lines"; else fail "the median function has at most 15 lines" "$median"; fi
if [ "$p95" -le 60 ]; then ok "95 % of the functions have at most 60 lines"; else fail "95 % of the functions have at most 60 lines" "$p95"; fi
report "no function has over 100 lines" "$(awk '$1 > 100' "$TMP/functions")"
long=$(find src tests examples -name '*.[ch]' -exec wc -l {} + | awk '$2 != "total" && $1 > 700')
report "no file has over 700 lines" "$long"
