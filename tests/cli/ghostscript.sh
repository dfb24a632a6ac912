# SPDX-License-Identifier: MIT
# PostScript that our own reader cannot draw whole goes through Ghostscript: fonts, shadings, operators it lacks. The page
# stays the same, nothing is left behind, and without Ghostscript the user hears what is missing.
. "$ROOT/tests/check.sh"

items() { grep -cE '^(stroke|fill)' "$TMP/out"; }
head_line() { awk '$1 == "page" { printf "page %.3f %.3f\n", $2, $3 }' "$TMP/out"; }

cat >text.eps <<'PS'
%!PS-Adobe-3.0 EPSF-3.0
%%BoundingBox: 10 20 210.0 120
%%HiResBoundingBox: 10.5 20.5 209.5 119.5
20 30 moveto 200 30 lineto stroke
/Helvetica findfont 24 scalefont setfont 20 60 moveto (Pencil) show
showpage
PS
sed '/show$/d' text.eps >plain.eps
sed '/^showpage/d' text.eps >no-showpage.eps
printf '%%!PS\n10 10 moveto 100 100 lineto stroke\n/Courier findfont 20 scalefont setfont 10 50 moveto (one) show showpage\n10 10 moveto (two) show showpage\n' >pages.ps
printf '%%!PS\n10 10 moveto\n20 frobnicate\nstroke showpage\n' >unknown.ps

# The same without Ghostscript, in a PATH with all else that is needed.
mkdir none
for program in pdftocairo sh rm; do command -v $program >/dev/null && ln -s "$(command -v $program)" none/; done
without() { PATH=$PWD/none plumbago "$@"; }

without --dump=list text.eps
is "without gs: drawn, but for the text" "$status $(items)" '0 1'
grep -q 'warning: .*left out: 1 text string; .*ghostscript' "$TMP/err" && ok "without gs: a warning says what to install" || fail "without gs: a warning says what to install" "$(cat "$TMP/err")"
page=$(head_line)
without unknown.ps
grep -q 'unknown.ps:3: .*frobnicate.*Debian: ghostscript, poppler-utils' "$TMP/err" && ok "without gs: the error names the operator" || fail "without gs: the error names the operator" "$(cat "$TMP/err")"

if ! command -v gs >/dev/null || ! command -v pdftocairo >/dev/null; then
    skip "Ghostscript" "no gs or no pdftocairo here (Debian: ghostscript, poppler-utils)"
    exit 0
fi
export TMPDIR=$PWD/temporary
mkdir temporary
plumbago --dump=list text.eps
is "its letters are drawn" "$status $(items)" '0 7'
is "its page is the same" "$(head_line)" "$page"
[ ! -s "$TMP/err" ] && ok "nothing is left out" || fail "nothing is left out" "$(cat "$TMP/err")"
# The line lies where our own reader puts it, to a hundredth of a millimetre (cairo's numbers).
line() { grep '^stroke' "$TMP/out" | grep -oE 'M .*' | awk '{ printf "%.2f %.2f %.2f %.2f\n", $2, $3, $5, $6 }'; }
ours=$(plumbago --dump=list plain.eps; line)
is "its line lies where it did" "$(plumbago --dump=list text.eps; line)" "$ours"
is "a file without showpage" "$(plumbago --dump=list no-showpage.eps; items)" 7
is "page 1 of two" "$(plumbago --page 1 --dump=list pages.ps; items)" 4
is "page 2 of two" "$(plumbago --page 2 --dump=list pages.ps; items)" 3
plumbago -v --dump=list plain.eps
grep -q Ghostscript "$TMP/err" && fail "without text Ghostscript is not asked" "$(cat "$TMP/err")" || ok "without text Ghostscript is not asked"
refuses "what neither knows is told in our words" 'unknown.ps:3: .*frobnicate' unknown.ps
# A limit of ours is final where it is met before the first letter; behind that Ghostscript's own limits hold.
printf '%%!PS\n/f { f 1 } def f\n/Helvetica findfont 24 scalefont setfont 20 60 moveto (x) show\n' >deep.ps
refuses "a limit is final" 'execstackoverflow' deep.ps
# A stall is no answer, nor is a full disk: without its text the drawing would be another one.
printf '%%!PS-Adobe-3.0 EPSF-3.0\n%%%%BoundingBox: 0 0 99 99\n/Helvetica findfont 24 scalefont setfont 20 60 moveto (x) show {} loop\n' >endless.eps
refuses "Ghostscript does not end" 'endless.eps: Ghostscript needs more than 1 second' --limit-time 1 endless.eps
printf '%%!PS\n2 { /Helvetica findfont 24 scalefont setfont 20 60 moveto (x) show showpage } repeat\n' >loop.ps
plumbago --dump=list loop.ps
grep -q 'only the first page' "$TMP/err" && ok "pages shown by a loop are noticed" || fail "pages shown by a loop are noticed" "$(cat "$TMP/err")"
for word in filter findresource; do
    printf '%%!PS\n10 10 moveto 100 100 lineto stroke\n{ currentfile /A /B %s } stopped clear showpage\n' $word >$word.ps
    plumbago -v --dump=list $word.ps
    grep -q "$word.ps:3: '$word' is left to Ghostscript; read by Ghostscript" "$TMP/err" && ok "$word is Ghostscript's" || fail "$word is Ghostscript's" "$(cat "$TMP/err")"
done
printf '%%!PS\n(/etc/passwd) (r) file\n/Helvetica findfont 24 scalefont setfont 20 60 moveto (x) show showpage\n' >asks.ps
refuses "what is refused is not asked elsewhere" "'file' is refused" asks.ps
is "no temporary file is left" "$(ls temporary)" ''
# Stopped in the middle by a signal: the folder goes, too.
printf '%%!PS\n/Helvetica findfont 24 scalefont setfont 1 1 2000 { 60 moveto (Plumbago) show } for showpage\n' >long.ps
for signal in INT TERM KILL; do
    "$PLUMBAGO" -q -o long.png long.ps 2>/dev/null &
    pid=$!
    for _ in $(seq 200); do [ -n "$(ls temporary)" ] && break; sleep .01; done
    seen=$(ls temporary)
    kill -$signal $pid
    wait $pid 2>/dev/null
    for _ in $(seq 300); do [ -z "$(ls temporary)" ] && break; sleep .01; done
    if [ -z "$seen" ]; then skip "killed by $signal" "it was too fast"; else is "killed by $signal: its temporary folder goes" "$(ls temporary)" ''; fi
done
