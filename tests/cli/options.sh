# SPDX-License-Identifier: MIT
# Every option of plumbago, once as it should be and once as it should not.
. "$ROOT/tests/check.sh"
example a.svg

# ---- what prints and ends ----
plumbago --version
is "--version: exit status" $status 0
is "--version: one line" "$(cat "$TMP/out")" "plumbago $(awk '/define PLB_VERSION_(MAJOR|MINOR|PATCH) / { v = v dot $3; dot = "." } END { print v }' "$ROOT/src/api/plumbago.h")"
plumbago --help
is "--help: exit status" $status 0
if grep -q -- '--dpi' "$TMP/out" && [ ! -s "$TMP/err" ]; then ok "--help: to standard output"; else fail "--help: to standard output" "$(head -n 1 "$TMP/err")"; fi
plumbago --list-pencils
is "--list-pencils: exit status" $status 0
is "--list-pencils: the eight, hard to soft" "$(awk 'NR > 1 { print $1 }' "$TMP/out" | tr '\n' ' ')" "2H H F HB B 3B 6B 8B "

# ---- output and what it is called ----
draws "no option" a.svg
if [ -s a.png ]; then ok "the output is called after the input"; else fail "the output is called after the input" "no a.png: $(listing | tr '\n' ' ')"; fi
mv a.png default.png
draws "-o FILE" -o out.png a.svg
same "-o FILE holds the same" out.png default.png
for spelling in "--output out2.png" "--output=out2.png" "-oout2.png"; do
    rm -f out2.png
    # shellcheck disable=SC2086
    draws "$spelling" $spelling a.svg
    same "$spelling holds the same" out2.png default.png
done
draws "options after the file" a.svg -o after.png
same "options after the file: the same" after.png default.png
draws "-- ends the options" -o dashes.png -- a.svg
same "-- ends the options: the same" dashes.png default.png
draws "-o twice: the last counts" -o first.png -o second.png a.svg
if [ -s second.png ] && [ ! -e first.png ]; then ok "-o twice: only the last is written"; else fail "-o twice: only the last is written" "$(listing | tr '\n' ' ')"; fi
mkdir sub && example sub/b.svg
draws "a file in a folder" sub/b.svg
if [ -s sub/b.png ]; then ok "its output lies beside it"; else fail "its output lies beside it" "$(listing | tr '\n' ' ')"; fi
example plain && draws "a name without an ending" plain
if [ -s plain.png ]; then ok "a name without an ending gets .png"; else fail "a name without an ending gets .png" "$(listing | tr '\n' ' ')"; fi
example two.dots.svg && draws "a name with dots" two.dots.svg
if [ -s two.dots.png ]; then ok "only the last ending is replaced"; else fail "only the last ending is replaced" "$(listing | tr '\n' ' ')"; fi
mkdir v1.2 && example v1.2/plain && draws "a folder with a dot" v1.2/plain
if [ -s v1.2/plain.png ]; then ok "a folder's dot is no ending"; else fail "a folder's dot is no ending" "$(listing | tr '\n' ' ')"; fi

# ---- the pencil ----
for grade in 2H H F HB B 3B 6B 8B; do draws "-p $grade" -p $grade -o $grade.png a.svg; done
same "HB is the default" HB.png default.png
draws "-p in lower case" -p hb -o lower.png a.svg
same "-p in lower case: the same" lower.png default.png
darker=$(for grade in 2H HB 3B 8B; do tool png_stats $grade.png | awk '{ print $4 }'; done)
if [ "$(sort -rn <<<"$darker")" = "$darker" ]; then ok "softer pencils are darker"; else fail "softer pencils are darker" "mean greys of 2H HB 3B 8B: $(tr '\n' ' ' <<<"$darker")"; fi
misused_or_refused() { # a pencil that is not there is a file that is not there: 1, one line
    refuses "$@"
}
misused_or_refused "unknown grade" "9B" -p 9B -o x.png a.svg
misused_or_refused "a pencil file that is not there" "none\.pencil" -p none.pencil -o x.png a.svg
head -c 3000 /dev/urandom >junk.pencil
misused_or_refused "a pencil file of random bytes" "junk\.pencil" -p junk.pencil -o x.png a.svg
: >empty.pencil
misused_or_refused "an empty pencil file" "empty\.pencil" -p empty.pencil -o x.png a.svg
misused_or_refused "a drawing as pencil" "a\.svg" -p a.svg -o x.png a.svg
misused_or_refused "a directory as pencil" "sub" -p sub -o x.png a.svg
if cp "$ROOT/profiles/HB.pencil" copy.pencil 2>/dev/null; then
    draws "-p FILE.pencil" -p copy.pencil -o copy.png a.svg
    same "-p FILE.pencil: the same as the grade it copies" copy.png default.png
    head -c 2000 "$ROOT/profiles/HB.pencil" >cut.pencil
    misused_or_refused "a pencil file cut short" "cut\.pencil" -p cut.pencil -o x.png a.svg
fi

# ---- the model and the arm ----
draws "--model hla" --model hla -o hla.png a.svg
differ "the models differ" hla.png default.png
draws "--model graphite" --model graphite -o model.png a.svg
same "graphite is the default model" model.png default.png
draws "--arm jerk" --arm jerk --model hla -o jerk.png a.svg
same "jerk is the default arm of hla" jerk.png hla.png
draws "--arm hand" --arm hand -o hand.png a.svg
same "hand is the default arm of graphite" hand.png default.png
draws "--arm spring" --arm spring -o spring.png a.svg
differ "hand and spring differ" hand.png spring.png
draws "--arm jerk with graphite" --arm jerk -o jerk.png a.svg
differ "jerk and spring differ" jerk.png spring.png
for arm in lognormal torque; do
    draws "--arm $arm" --arm $arm -o $arm.png a.svg
    differ "$arm and jerk differ" $arm.png jerk.png
    draws "--arm $arm with hla" --arm $arm --model hla --squiggle 0 -o $arm-0.png a.svg
done
is "with --squiggle 0 the arms draw the same lines" "$(tool ink_compare lognormal-0.png torque-0.png 1 26 26 | cut -d ' ' -f 1-4)" "recall 1.0000 precision 1.0000"
differ "lognormal and torque differ" lognormal.png torque.png
misused "an empty --arm" arm --arm= a.svg
draws "--squiggle 0" --squiggle 0 -o straight.png a.svg
differ "--squiggle changes the drawing" straight.png default.png
draws "--squiggle 5/300in" --squiggle 5/300in -o squiggle.png a.svg
same "the default squiggle is 5/300 in" squiggle.png default.png
draws "--squiggle=1mm" --squiggle=1mm -o wild.png a.svg
differ "--squiggle takes a unit" wild.png default.png
misused "--squiggle -1mm" squiggle --squiggle -1mm a.svg
misused "--squiggle nan" squiggle --squiggle nan a.svg
misused "--squiggle of another unit" squiggle --squiggle 3kg a.svg
misused "--squiggle 1/0in" squiggle --squiggle 1/0in a.svg
misused "--model of another name" model --model photo a.svg
misused "--arm of another name" arm --arm left a.svg

# ---- what is drawn ----
cat >fill.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40"><rect x="5" y="5" width="20" height="20"/>
<path d="M2 35H38" fill="none" stroke="#000" stroke-width=".3"/></svg>
SVG
draws "no --fill" -o fill.png fill.svg
draws "--fill hatch" --fill hatch -o fill-hatch.png fill.svg
same "hatch is the default fill" fill-hatch.png fill.png
draws "--fill outline" --fill outline -o fill-outline.png fill.svg
is "--fill outline draws no more than the outline" "$("$PLUMBAGO" --fill outline --dump=strokes fill.svg | grep -c '^stroke ')" 5
is "--fill hatch has many strokes" "$("$PLUMBAGO" --dump=strokes fill.svg | grep '^stroke ' | grep -c hatch | awk '{ print ($1 > 30) }')" 1
draws "--fill none" --fill none -o fill-none.png fill.svg
is "--fill none leaves the line" "$("$PLUMBAGO" --fill none --dump=strokes fill.svg | grep -c '^stroke ')" 1
misused "--fill of another name" fill --fill gold fill.svg

cat >text.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="20mm" viewBox="0 0 40 20"><path d="M5 5h.4v4.6h2v.4h-2.4z"/>
<path d="M10 5h3v.4h-1.3v4.6h-.4v-4.6h-1.3z"/><path d="M2 15H38" fill="none" stroke="#000" stroke-width=".3"/></svg>
SVG
draws "no --text" -o text.png text.svg
draws "--text hand" --text hand -o text-hand.png text.svg
same "hand is the default for text" text-hand.png text.png
is "--text hand makes an L of two strokes and a T of two" "$("$PLUMBAGO" --text hand --dump=strokes text.svg | grep -c letter)" 4
is "--text outline draws 6 sides and 8" "$("$PLUMBAGO" --text outline --dump=strokes text.svg | grep -c '^stroke ')" 15
is "--text none leaves the line" "$("$PLUMBAGO" --text none --dump=strokes text.svg | grep -c '^stroke ')" 1
cat >stop.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="20mm" viewBox="0 0 40 20"><path d="M5 5h.5v5h-.5z"/><path d="M6 9.4h.6v.6h-.6z"/><path d="M30 9.4h.6v.6h-.6z"/></svg>
SVG
is "--text none: a stop goes with the letter beside it, another dot stays" "$("$PLUMBAGO" --text none --dump=strokes stop.svg | awk '/^stroke / { if ($7 < 20) near++; else far++ } END { print near + 0, (far > 0) }')" "0 1"
misused "--text of another name" text --text gold text.svg

draws "--hand right" --hand right -o right.png a.svg
same "right is the default hand" right.png default.png
draws "--hand left" --hand left -o left.png a.svg
differ "--hand left draws otherwise" left.png right.png
draws "--hand none" --hand none -o any.png a.svg
differ "--hand none draws otherwise" any.png right.png
draws "--hand left with hla" --hand left --model hla -o hla-left.png a.svg
same "hla knows no hands" hla-left.png hla.png
misused "--hand of another name" hand --hand both a.svg

# ---- habits ----
draws "--overshoot 0" --overshoot 0 -o none.png a.svg
same "no overshoot is the default" none.png default.png
draws "--restate 0" --restate 0 -o none.png a.svg
same "no restating is the default" none.png default.png
echo '<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="60mm" viewBox="0 0 90 60"><path fill="none" stroke="#000" stroke-width=".3" d="M20 15H70V45H20Z"/></svg>' >box.svg
plumbago -q --dump=strokes -o box.txt box.svg
for habit in "--overshoot 1mm" "--restate 1" "--construction"; do
    # shellcheck disable=SC2086
    plumbago -q --dump=strokes $habit -o habit.txt box.svg
    differ "$habit changes the strokes" habit.txt box.txt
    # shellcheck disable=SC2086
    draws "$habit" $habit -o habit.png box.svg
done
is "--construction: a guide for each side" "$(grep -c guide habit.txt)" 4
for wrong in "--overshoot -1mm" "--overshoot 2kg" "--restate 1.5" "--restate -1" "--restate some" "--construction=3"; do
    # shellcheck disable=SC2086
    misused "$wrong" "overshoot|restate|construction" $wrong a.svg
done

# ---- the background ----
draws "--background white" --background white -o white.png a.svg
same "white is the default background" white.png default.png
is "white: 8-bit grey" "$(info white.png colour) $(info white.png depth)" "grey 8"
draws "--background none" --background none -o none.png a.svg
is "none: 8-bit grey with alpha" "$(info none.png colour) $(info none.png depth)" "grey+alpha 8"
far=$(tool png_compare white.png none.png | awk '{ print ($4 <= 2 && $1 == "different" && $3 == "max") ? "" : $0 }')
report "none over white is white, but for rounding" "$far"
draws "--background paper" --background paper -o paper.png a.svg
is "paper: 8-bit grey" "$(info paper.png colour) $(info paper.png depth)" "grey 8"
draws "paper on one thread" --threads 1 --background paper -o again.png a.svg
same "paper: the same bytes on one thread" paper.png again.png
draws "paper in colours" --background paper --colour -o warm.png a.svg
is "paper in colours: 8-bit RGB" "$(info warm.png colour) $(info warm.png depth)" "rgb 8"
for suffix in jpg pdf svg; do draws "paper in $suffix" --background paper -o "paper.$suffix" a.svg; done
misused "--background of another name" background --background pink a.svg

# ---- a folder for the pictures, and pictures that are there ----
mkdir folder
draws "-o FOLDER" -o folder a.svg
same "-o FOLDER: the picture lies in it" folder/a.png default.png
rm folder/a.png
draws "-o FOLDER/" -o folder/ a.svg two.dots.svg
same "-o FOLDER/: several pictures lie in it" folder/two.dots.png default.png
refuses "-o FOLDER/ that is not there" "nowhere/a.png" -o nowhere/ a.svg
mkdir dumps && plumbago --dump=strokes -o dumps a.svg
if [ -s dumps/a.txt ]; then ok "-o FOLDER: a dump has the suffix .txt"; else fail "-o FOLDER: a dump has the suffix .txt" "$(listing | tr '\n' ' ')"; fi
echo mine >kept.png
plumbago --no-clobber -o kept.png a.svg
is "--no-clobber: exit status" $status 0
is "--no-clobber: the picture stays" "$(cat kept.png)" mine
if grep -q 'kept.png is there already' "$TMP/err"; then ok "--no-clobber says so"; else fail "--no-clobber says so" "$(cat "$TMP/err")"; fi
draws "--no-clobber where there is none" --no-clobber -o fresh.png a.svg
same "--no-clobber where there is none: drawn" fresh.png default.png

# ---- errors that teach ----
misused "a refused number says its range" "dpi takes .*10 to 4800 pixels per inch.*not '5'" -d 5 a.svg
misused "a refused word says its choices" "arm takes hand, jerk, spring, lognormal or torque, or auto; not 'left'" --arm left a.svg
misused "a refused length says how lengths are written" "width takes .* mm, written as 84mm" --width wide a.svg
misused "a refused seed says that random is one" "seed takes a whole number.*random" --seed no a.svg
misused "an unknown option names the nearest" "no option --widht; did you mean --width" --widht 3 a.svg
misused "an unknown option with a value" "did you mean --paper" --papr=rough a.svg
plumbago --frobnicate a.svg
if grep -q 'did you mean' "$TMP/err"; then fail "nothing near is guessed" "$(cat "$TMP/err")"; else ok "nothing near is guessed"; fi
for option in -h -V; do plumbago $option; is "$option: exit status" $status 0; done
draws "--color is --colour" --color -o color.png a.svg
draws "--colour" --colour -o colour.png a.svg
same "--color is --colour: the same" color.png colour.png
if command -v script >/dev/null; then
    is "no FILE on a terminal: exit status" "$(script -qec "'$PLUMBAGO' 2>bare.txt" /dev/null </dev/null >/dev/null; echo $?)" 2
    if grep -q 'which drawing? usage: plumbago' bare.txt; then ok "no FILE on a terminal asks for one"; else fail "no FILE on a terminal asks for one" "$(cat bare.txt)"; fi
else
    skip "no FILE on a terminal" "no script here"
fi
misused "--completions of another shell" "completions" --completions csh

# ---- talk ----
plumbago --width 192 -o bare.png a.svg
is "a length without a unit is noted once: exit status" $status 0
is "a length without a unit is noted once" "$(cat "$TMP/err")" "plumbago: note: --width 192 is 192 px, 50.8 mm; write 192mm for millimetres"
plumbago --width 50.8mm -o unit.png a.svg
same "a length without a unit is in px" bare.png unit.png
draws "-q: no note" -q --width 192 -o bare.png a.svg
draws "0 needs no unit" --squiggle 0 --overshoot 0 -o bare.png a.svg
echo '<svg xmlns="http://www.w3.org/2000/svg" width="24" height="24"><path stroke="#000" d="M2 2L22 22"/></svg>' >icon.svg
plumbago -o icon.png icon.svg
is "a small page is hinted at" "$(cat "$TMP/err")" "plumbago: warning: icon.svg: the page is 6.35 by 6.35 mm, small for a pencil; --width 100mm draws it larger"
draws "a small page that is asked for is not" --width 15mm -o icon.png icon.svg
draws "-q: no hint" -q -o icon.png icon.svg
plumbago -v -o v.png a.svg
if [ $status -eq 0 ] && [ -s "$TMP/err" ] && [ ! -s "$TMP/out" ]; then ok "-v says something, on standard error"; else fail "-v says something, on standard error" "status $status, $(wc -c <"$TMP/err") and $(wc -c <"$TMP/out") bytes"; fi
same "-v draws the same" v.png default.png
plumbago -v -v -v -o v.png a.svg
is "-v three times" $status 0
draws "-q" -q -o q.png a.svg
same "-q draws the same" q.png default.png
draws "-q after -v is quiet" -v -q -o q.png a.svg
plumbago -q nothing.svg
is "-q keeps errors: status" $status 1
is "-q keeps errors: one line" "$(wc -l <"$TMP/err")" 1

# ---- wrong command lines ----
misused "an unknown long option" "frobnicate" --frobnicate a.svg
misused "an unknown short option" "Z" -Z a.svg
for option in -o --output -p --pencil -d --dpi --width --height --scale -s --seed --squiggle --model --arm --hand --overshoot --restate --fill --text --background; do
    misused "$option without an argument" "${option#--}" $option
done
misused "--version with an argument" "version" --version=3
misused "an empty -o" "output|-o" -o '' a.svg
misused "an empty --dpi" "dpi" --dpi= a.svg
misused "--dump of another name" "dump" --dump=soup a.svg
misused "half an option is none of ours" "outp|backg" --backgroun white --outp x a.svg
