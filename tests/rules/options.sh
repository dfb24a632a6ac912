# SPDX-License-Identifier: MIT
# The options that --help lists, man pages document, shells complete and the program takes are the same options.
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
    wide=$("$program" --help | awk 'length($0) > 80')
    report "$name --help fits a terminal of 80 columns" "$wide"
done

# ---- the settings of the library are options, and plumbago(3) says when each counts ----
settings=$(grep -oE '^    \{\{"[a-z-]+"' "$ROOT/src/api/settings/settings_table.c" | tr -d ' {"')
if [ "$(wc -l <<<"$settings")" -ge 25 ]; then ok "the table of settings is found"; else fail "the table of settings is found" "$settings"; fi
help=$(helped "$PLUMBAGO")
report "every setting is an option" "$(while read -r s; do grep -qx -- "--$s" <<<"$help" || echo "$s"; done <<<"$settings")"
report "every setting is in plumbago(3)" "$(while read -r s; do grep -qE "^\.Cm (.* )?$s( |\$)" "$ROOT/man/plumbago.3" || echo "$s"; done <<<"$settings")"

# ---- completions ----
for shell in bash zsh fish; do
    "$PLUMBAGO" --completions $shell >$shell.txt
    case $shell in fish) mark='-l ' ;; *) mark='--' ;; esac
    report "$shell completes every long option" "$(grep '^--' <<<"$help" | grep -v '^--color$' | while read -r o; do grep -q -- "$mark${o#--}\b" $shell.txt || echo "$o"; done)"
    report "$shell completes no other" "$(grep -oE -- "(^| |\{|'|,)$mark[a-z][-a-z]*" $shell.txt | sed -E 's/.*(--|-l )/--/' | sort -u | comm -23 - <(grep '^--' <<<"$help" | sort -u))"
    if command -v $shell >/dev/null; then check "$shell reads the file" $shell -n $shell.txt; else skip "$shell reads the file" "no $shell here"; fi
done
# Gives what bash offers after the words given; the last may be empty.
offers() {
    bash -c '. ./bash.txt; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _plumbago; printf "%s\n" "${COMPREPLY[@]}" | sort | tr "\n" " "' - plumbago "$@"
}
: >plan.svg
is "bash offers arms" "$(offers --arm '')" "hand jerk lognormal spring torque "
is "bash offers an arm after =" "$(offers --arm = s)" "spring "
is "bash offers pencils" "$(offers -p 6)" "6B "
is "bash offers options" "$(offers --pap)" "--paper "
is "bash offers drawings" "$(offers -q pl)" "plan.svg "
