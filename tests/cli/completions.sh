# SPDX-License-Identifier: MIT
# The shells themselves are asked what the completions complete. Lines "what is typed|what it becomes"; a shell that is not
# here is skipped.
. "$ROOT/tests/check.sh"
for shell in bash zsh fish; do "$PLUMBAGO" --completions $shell >plumbago.$shell; done
cp plumbago.zsh _plumbago
touch drawing.svg mine.pencil
mkdir folder
export HOME=$PWD XDG_CONFIG_HOME=$PWD XDG_DATA_HOME=$PWD XDG_CACHE_HOME=$PWD TERM=dumb

lines='plumbago --squ|--squiggle
plumbago --list-p|--list-pencils
plumbago --arm je|jerk
plumbago --arm=je|--arm=jerk
plumbago -p 2|2H
plumbago -p mi|mine.pencil
plumbago --pencil=6|--pencil=6B
plumbago -q --page-size lett|letter
plumbago --background white dr|drawing.svg
plumbago -o fo|folder/'

# bash: the words as readline cuts them, at blanks and equal signs; what is completed stands behind the last sign.
in_bash() { # LINE
    bash --norc -c '
        . ./plumbago.bash
        read -ra COMP_WORDS <<<"${1//=/ = }"
        COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
        _plumbago
        [ "${1%=*}" = "$1" ] || { word=${1%=*}= && word=${word##* }; }
        printf "%s%s\n" "${word:-}" "${COMPREPLY[*]}"
        [ ! -d "${COMPREPLY[0]}" ] || echo /' bash "$1" | tr -d '\n'
}

# zsh: a shell on a terminal of its own gets the line and the tab key; then ^G prints the line. It ends with a blank where the
# word is whole, with an equal sign where the value is to follow.
cat >ask.zsh <<'ZSH'
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "PS1= RPS1=; fpath=($PWD \$fpath); autoload -Uz compinit; compinit -u -D; show() { print -r -- \"<\$BUFFER>\"; BUFFER=; zle accept-line }; zle -N show; bindkey '^G' show; print REA''DY"
zpty -r shell said '*READY*' || exit 1
zpty -w -n shell $1$'\t\C-g'
zpty -r shell said '*<*>*' || exit 1
print -r -- ${${said##*<}%%>*}
zpty -d shell
ZSH
in_zsh() { timeout 20 zsh -f ask.zsh "$1" | sed "s/ *$//; s/=$//; s/.* //"; }

# fish tells each proposal and its description.
in_fish() { timeout 20 fish --no-config -c "source plumbago.fish; complete -C '$1'" | cut -f 1; }

for shell in bash zsh fish; do
    command -v $shell >/dev/null || { skip "completion in $shell" "no $shell here"; continue; }
    while IFS='|' read -r line expected; do
        said=$(in_$shell "$line" </dev/null)
        is "$shell: $line" "$said" "$expected"
    done <<<"$lines"
done
