# SPDX-License-Identifier: MIT
# plumbago-list(5): what --dump=list prints is a drawing that gives the same list and the same picture; the page's examples
# work; faults are told with their line.
. "$ROOT/tests/check.sh"

# there_and_back FILE [ARGS]: the dump of the dump is the dump; the pictures are the same, byte for byte.
there_and_back() {
    local file=$1 name=${1##*/}
    shift
    "$PLUMBAGO" -q --dump=list "$file" "$@" -o first.list 2>/dev/null || { fail "$name $*: dumped" "exit status $?"; return; }
    "$PLUMBAGO" -q --dump=list first.list -o second.list 2>"$TMP/err" || fail "$name $*: read back" "$(head -n 1 "$TMP/err")"
    same "$name $*: the list read back is the list" first.list second.list
    "$PLUMBAGO" -q --dump=list - <first.list >second.list
    same "$name $*: from standard input" first.list second.list
    "$PLUMBAGO" -q -d 100 --dump=strokes "$file" "$@" -o first.strokes
    "$PLUMBAGO" -q -d 100 --dump=strokes first.list -o second.strokes
    same "$name $*: the same strokes" first.strokes second.strokes
}
# Gradients, clips and dashes, a scale on paper, an own width; a picture of one.
for drawing in gradients clip dashes solids transforms; do there_and_back "$ROOT/tests/image/$drawing.svg"; done
there_and_back "$ROOT/tests/image/state.eps"
there_and_back "$ROOT/tests/image/gradients.svg" --width 33
if /usr/bin/python3 -c 'import ezdxf' 2>/dev/null; then
    there_and_back "$ROOT/tests/stage/plan.dxf"
    "$PLUMBAGO" -q --dump=list "$ROOT/tests/stage/plan.dxf" -o plan.list
    "$PLUMBAGO" -q --dump=list --scale 1:200 "$ROOT/tests/stage/plan.dxf" -o first.list
    "$PLUMBAGO" -q --dump=list --scale 1:200 plan.list -o second.list
    same "--scale of a dump is that of the building" first.list second.list
else
    skip "a scale on paper" "no python3-ezdxf here"
fi
"$PLUMBAGO" -q --dump=list "$ROOT/tests/image/gradients.svg" -o gradients.list
"$PLUMBAGO" -q -d 100 -o first.png "$ROOT/tests/image/gradients.svg"
"$PLUMBAGO" -q -d 100 -o second.png gradients.list
same "the picture of a dump is the picture" first.png second.png

# Hatching runs where the list says, and turns with the list's matrix.
directions() { # the mean direction of the hatching of a fill with these words, degrees from 0 to 179
    printf '%s\n' 'plumbago-list 1' 'page 60 60' "$1" "fill - colour 0.7 0.7 0.7 1 nonzero $2 M 10 10 L 50 10 L 50 50 L 10 50 Z" end >hatched.list
    "$PLUMBAGO" -q --dump=strokes hatched.list | awk '/ hatch / { for (i = 1; i < NF && $i != "graphite"; i++); a = 2 * atan2($NF - $(i + 2), $(NF - 1) - $(i + 1)); c += cos(a); s += sin(a) }
        END { d = atan2(s, c) * 90 / 3.14159265; printf "%d", d < -0.5 ? d + 180.5 : d + 0.5 }'
}
near() { local off=$(((${2:-999} - $3 + 270) % 180 - 90)); check "$1: $2" test "${off#-}" -le 8; } # a hand strays
near "hatching along" "$(directions 'matrix 1 0 0 1 0 0' 'hatch 0')" 0
near "hatching down" "$(directions 'matrix 1 0 0 1 0 0' 'hatch -90')" 90
near "hatching at 30 degrees" "$(directions 'matrix 1 0 0 1 0 0' 'hatch 30')" 30
near "the same, turned over" "$(directions 'matrix -1 0 0 1 60 0' 'hatch 30')" 150
there_and_back hatched.list
refuses "a direction beyond a turn" 'direction of hatching' - <<<"$(sed 's/hatch 30/hatch 361/' hatched.list)"

# Omissions in a list are told again, and once.
printf '%s\n' '<svg xmlns="http://www.w3.org/2000/svg" width="99" height="99"><path d="M9 9h50" stroke="black"/><path d="M900 9h50" stroke="black"/><image width="9" height="9"/></svg>' >lost.svg
plumbago -v --dump=list lost.svg && cp "$TMP/out" lost.list
lost() { grep -E 'left out' "$TMP/err" | sed 's/lost\.[a-z]*//'; }
said=$(lost)
plumbago -v --dump=list lost.list
is "what is left out is told of the dump too" "$(lost)" "$said"
[ -n "$said" ] && ok "and that is something" || fail "and that is something" "nothing was left out"

# The page's examples: texts between .Bd and .Ed, each a list or a program.
unset -f plumbago
awk '/^\.Bd -literal/ { n++; inside = 1; next } /^\.Ed/ { inside = 0 } inside { gsub(/\\e/, "\\"); print >("example-" n) }' "$ROOT/man/plumbago-list.5"
for i in 1 2 3 4; do
    case $(head -n 1 example-$i) in
    plumbago-list*) cat example-$i >out.list ;;
    *python3) command -v python3 >/dev/null && python3 example-$i >out.list ;;
    *awk*) awk -f example-$i >out.list ;;
    *) printf '%s\n' '5 5' '50 30' '95 5' | sh example-$i >out.list ;;
    esac
    if "$PLUMBAGO" -q -o out.png out.list 2>"$TMP/err"; then ok "example $i of plumbago-list(5): $(head -n 1 example-$i)"; else fail "example $i of plumbago-list(5)" "$(head -n 1 "$TMP/err")"; fi
done
is "the matrix of the second example puts the y axis upright" "$(sh example-2 <<<'5 5' | "$PLUMBAGO" -q --dump=list - | grep -o 'M .*')" 'M 5 55'
plumbago() {
    "$PLUMBAGO" "$@" >"$TMP/out" 2>"$TMP/err"
    status=$?
}

# Faults, with the line.
fault() { # NAME PATTERN TEXT
    printf '%s\n' "$3" >wrong.list
    refuses "$1" "$2" -o wrong.png wrong.list
}
fault "a list without its end" 'wrong\.list:[23]: the text stops before its end' $'plumbago-list 1\npage 1 1'
fault "an unknown statement" "wrong\\.list:3: 'circle' stands where a statement should" $'plumbago-list 1\npage 1 1\ncircle 1 1 1\nend'
fault "a version of tomorrow" 'wrong\.list:1: version 2' $'plumbago-list 2\npage 1 1\nend'
fault "a clip that is not there" 'wrong\.list:3: there is no clip 3' $'plumbago-list 1\npage 1 1\nfill 3 colour 0 0 0 1 nonzero M 0 0\nend'
printf 'plumbago-list 1\npage 90 90\nwarning mind the gap\nstroke - colour 0 0 0 1 width 1 round M 1 1 L 8 8\nend\n' >said.list
plumbago -o said.png said.list
is "its warnings are passed on" "$status $(cat "$TMP/err")" '0 plumbago: warning: said.list: mind the gap'
refuses "there is no second page" 'it has no page 2, only 1' --page 2 -o two.png said.list
