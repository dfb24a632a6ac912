# SPDX-License-Identifier: MIT
# What --help lists, what the man page documents and what the program takes are the same options.
. "$ROOT/tests/check.sh"

# The long and short options in the --help text of a program, and those in the .It lines of its man page.
helped() { "$1" --help | grep -oE '(^|[ ,[])--?[a-zA-Z][-a-z]*' | tr -d ' ,[' | sort -u; }
documented() {
    sed -nE '/^\.It .*Fl/p' "$1" | sed -E 's/Fl Fl ([a-zA-Z])/--\1/g; s/Fl Fl /--/g; s/Fl \\?-([a-z])/--\1/g; s/Fl ([a-zA-Z0-9])/-\1/g; s/\\-/-/g' |
        grep -oE '(^|[ ,(])--?[a-zA-Z][-a-z]*' | tr -d ' ,(' | sort -u
}

for pair in "$PLUMBAGO:plumbago.1" "$PLUMBAGO_PROFILE:plumbago-profile.1"; do
    program=${pair%:*} page=$ROOT/man/${pair##*:} name=$(basename "${pair%:*}")
    help=$(helped "$program") man=$(documented "$page")
    if [ "$(wc -l <<<"$help")" -ge 4 ]; then ok "$name --help lists options"; else fail "$name --help lists options" "found: $help"; fi
    report "$name: every option of --help is in ${page##*/}" "$(comm -23 <(echo "$help") <(echo "$man"))"
    report "$name: every option of ${page##*/} is in --help" "$(comm -13 <(echo "$help") <(echo "$man"))"
    unknown=$(while read -r option; do
        # Taken: anything but an unknown option. An argument that none of them likes keeps the run short.
        case $option in --help | --version | -h | -V) continue ;; esac
        "$program" "$option" '?' </dev/null 2>&1 | grep -iE "(unknown|unrecogni[sz]ed|invalid|no such) option|no option" >/dev/null && echo "$option"
    done <<<"$help")
    report "$name takes every option of --help" "$unknown"
    wide=$("$program" --help | awk 'length($0) > 100')
    report "$name --help fits a terminal of 100 columns" "$wide"
done
