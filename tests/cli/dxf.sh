# SPDX-License-Identifier: MIT
# DXF: what of a drawing is read, its size on paper, what is said about the rest.
. "$ROOT/tests/check.sh"
stage=$ROOT/tests/stage

# A drawing of one LINE of so many units, with $INSUNITS when given.
line() { # LENGTH [UNITS]
    printf '%s\n' 0 SECTION 2 HEADER 9 '$ACADVER' 1 AC1015
    if [ -n "${2:-}" ]; then printf '%s\n' 9 '$INSUNITS' 70 "$2"; fi
    printf '%s\n' 0 ENDSEC 0 SECTION 2 ENTITIES 0 LINE 8 0 10 0 20 0 11 "$1" 21 0 0 ENDSEC 0 EOF
}
# width NAME LENGTH UNITS EXPECTED ARGS...: of the page in mm
width() {
    local name=$1
    line "$2" "$3" >line.dxf
    is "$name" "$("$PLUMBAGO" -q --dump=list "${@:5}" line.dxf | awk '$1 == "page" { print $2 + 0 }')" "$4"
}
width "a line of 200 mm is drawn at 1:1" 200 4 210
width "without unit the unit is mm" 200 0 210
width "20 m are drawn at 1:50" 20 6 410
width "21 m do not fit A3 at 1:50" 21 6 220
width "10 feet are drawn at 1:10" 10 2 314.8
width "what is small is enlarged: 20 mm at 10:1" 20 4 210
width "40 km" 40 7 410
width "--scale is that of the building: 1:100" 20 6 205 --scale 1:100
width "--scale as a number" 20 6 205 --scale 0.01
width "--width" 20 6 150 --width 150mm
line 20 6 >line.dxf
"$PLUMBAGO" -v -o x.png line.dxf 2>err
if grep -q 'line\.dxf: DXF AC1015, m; 1:50 fits A3' err; then ok "-v tells version, unit and scale"; else fail "-v tells version, unit and scale" "$(tr '\n' '|' <err)"; fi

cp "$stage/blocks.dxf" .
plumbago -o x.png blocks.dxf
is "a block that holds itself: drawn" $status 0
for said in 'left out: 1 INSERT of itself' 'left out: 1 without a shape, or that refer to nothing'; do
    if grep -q "warning: blocks\.dxf: $said" "$TMP/err"; then ok "it says: $said"; else fail "it says: $said" "$(tr '\n' '|' <"$TMP/err")"; fi
done

# A grid of a thousand million copies is no drawing; the line beside it is.
awk '{ sub(/\r$/, "") } $0 == "ENTITIES" { print; print "0\nLINE\n8\n0\n10\n0\n20\n0\n11\n200\n21\n0"; next } { print }' "$ROOT/tests/bad/rows-1e9.dxf" >grid.dxf
"$PLUMBAGO" --dump=list grid.dxf >"$TMP/out" 2>"$TMP/err"
is "too many copies are left out: status" $? 0
is "the rest is drawn" "$(awk '$1 == "page" { print $2 + 0 }' "$TMP/out")" 210
is "it says so" "$(sed 's/.*warning: //' "$TMP/err")" "grid.dxf: left out: 1 INSERT of 1073676289 copies"

# Text: letters come as shapes, where they should be, and not as something else.
text() { # TAG...: a TEXT with more tags
    printf '%s\n' 0 SECTION 2 ENTITIES 0 LINE 8 0 10 0 20 0 11 200 21 0 0 TEXT 8 0 40 10 "$@" 0 ENDSEC 0 EOF
}
# Bounds of the first letter of a dump: x0 y0 x1 y1, rounded.
bounds() { awk '$1 == "fill" { x0 = y0 = 1e9; x1 = y1 = -1e9; n = 0
    for (i = 9; i <= NF; i++) if ($i ~ /^-?[0-9.]+(e-?[0-9]+)?$/) { n++; if (n % 2) { if ($i < x0) x0 = $i; if ($i > x1) x1 = $i } else { if ($i < y0) y0 = $i; if ($i > y1) y1 = $i } }
    printf "%.0f %.0f %.0f %.0f\n", x0, y0, x1, y1; exit }'; }
text 10 20 20 30 1 H >text.dxf
read -r x0 y0 x1 y1 < <("$PLUMBAGO" -q --dump=list text.dxf | bounds)
if [ "$x0" -ge 25 ] && [ "$x0" -le 27 ] && [ "$y0" -eq 5 ] && [ "$y1" -eq 15 ] && [ "$x1" -le 35 ]; then ok "a letter stands on its line, 10 mm high"; else fail "a letter stands on its line, 10 mm high" "$x0 $y0 $x1 $y1"; fi
text 10 100 20 30 11 100 21 30 72 1 73 0 1 H >text.dxf
read -r x0 y0 x1 y1 < <("$PLUMBAGO" -q --dump=list text.dxf | bounds)
is "a centred letter is where it should be" "$(((x0 + x1 + 1) / 2))" 105
text 10 20 20 30 50 90 1 H >text.dxf
read -r x0 y0 x1 y1 < <("$PLUMBAGO" -q --dump=list text.dxf | bounds)
if [ $((x1 - x0)) -eq 10 ] && [ $x1 -eq 25 ]; then ok "a letter turned by 90 degrees"; else fail "a letter turned by 90 degrees" "$x0 $y0 $x1 $y1"; fi
text 10 20 20 30 1 '</text><rect width="99" height="99"/>' >text.dxf
is "markup in a text is text" "$("$PLUMBAGO" -q --dump=list text.dxf | grep -c 'M [0-9. e-]* L [0-9. e-]* L [0-9. e-]* L [0-9. e-]* Z$' | awk '{ print $1 < 30 }')" 1

# Polylines: the frame of a spline is not drawn, and no SEQEND is needed; line types with letters are dashed, and the letters counted.
vertices() { # FLAG X Y ...
    local flag=$1
    shift
    while [ $# -gt 1 ]; do printf '%s\n' 0 VERTEX 8 0 10 "$1" 20 "$2" 70 "$flag"; shift 2; done
}
{ printf '%s\n' 0 SECTION 2 ENTITIES 0 POLYLINE 8 0 66 1 70 4; vertices 16 0 0 50 90 99 0; vertices 8 0 0 50 30 99 0; printf '%s\n' 0 SEQEND 0 ENDSEC 0 EOF; } >frame.dxf
is "the frame of a spline is left out" "$("$PLUMBAGO" -q --dump=list frame.dxf | grep '^stroke' | grep -o '[ML] [0-9]' | wc -l)" 3
{ printf '%s\n' 0 SECTION 2 ENTITIES 0 POLYLINE 8 0 66 1 70 0; vertices 0 0 0 50 30 99 0; printf '%s\n' 0 LINE 8 0 10 0 20 9 11 99 21 9 0 ENDSEC 0 EOF; } >open.dxf
is "a polyline without its end, and what follows" "$("$PLUMBAGO" -q --dump=list open.dxf | grep -c '^stroke')" 2
{ printf '%s\n' 0 SECTION 2 TABLES 0 TABLE 2 LTYPE 0 LTYPE 2 GAS 70 0 3 gas 72 65 73 3 40 9.5 49 5 74 0 49 -2 74 2 75 0 340 0 46 1 50 0 44 0 45 0 9 GAS 49 -2.5 74 0
  printf '%s\n' 0 ENDTAB 0 ENDSEC 0 SECTION 2 ENTITIES 0 LINE 8 0 6 GAS 10 0 20 0 11 200 21 0 0 ENDSEC 0 EOF; } >gas.dxf
is "a line type with letters is dashed" "$("$PLUMBAGO" -q --dump=list gas.dxf | grep -c ' dash ')" 1
plumbago -o x.png gas.dxf
if grep -q 'left out: the letters and shapes in the line types of 1 line$' "$TMP/err"; then ok "its letters are counted"; else fail "its letters are counted" "$(head -n 1 "$TMP/err")"; fi

# Faults.
printf '%s\n' 0 SECTION 2 ENTITIES 0 LINE 8 0 10 zero 20 0 11 9 21 9 0 ENDSEC 0 EOF >word.dxf
refuses "a word for a coordinate names its line" "word\.dxf:1[0-9]: not well-formed DXF: " word.dxf
printf '%s\n' 0 SECTION 2 ENTITIES 0 LINE 8 0 10 0 20 0 11 9 21 9 oops 0 0 ENDSEC 0 EOF >code.dxf
refuses "a word for a group code names its line" "code\.dxf:[0-9]+: not well-formed DXF: .*oops" code.dxf
printf 'AutoCAD Binary DXF\r\n\032\0rest' >binary.dxf
refuses "binary DXF" "binary\.dxf: binary DXF is not read" binary.dxf
line 200 4 | head -n -3 >cut.dxf
plumbago -o x.png cut.dxf
is "a file that ends in the middle: drawn" $status 0
if grep -q 'warning: cut\.dxf: the file ends in the middle' "$TMP/err"; then ok "and it says so"; else fail "and it says so" "$(head -n 1 "$TMP/err")"; fi
line 200 4 | tr '\n' '\r' >mac.dxf
draws "line ends of old" -o x.png mac.dxf
line 200 4 | sed 's/$/\r/' >dos.dxf
draws "line ends of DOS" -o x.png dos.dxf

# Without the library the reason is told.
mkdir only && cp "$BUILD_DIR/tap-svg" only/ && printf '#!/bin/sh\nexit 127\n' >only/tap-dxf && chmod +x only/tap-dxf && cp "$BUILD_DIR/plumbago" only/
PLUMBAGO=$PWD/only/plumbago refuses "no python" "reading DXF needs python3" line.dxf
sed 's|for lib in (.*)$|for lib in ["/nonexistent"]|' "$ROOT/src/tap/dxf/tap_dxf.py" >only/tap-dxf
PLUMBAGO=$PWD/only/plumbago refuses "no ezdxf" "reading DXF needs the package python3-ezdxf" line.dxf
rm only/tap-dxf
if [ ! -e "$(sed -n 's/.*PLB_LIBEXECDIR="\([^"]*\)".*/\1/p' <<<"${CFLAGS:-}")/tap-dxf" ] && [ ! -e /usr/local/libexec/plumbago/tap-dxf ]; then
    PLUMBAGO=$PWD/only/plumbago refuses "no tap-dxf" "the helper program tap-dxf is missing" line.dxf
fi

# Whoever draws, and whatever else is installed: matplotlib, which would want a home folder, is not asked.
"$PLUMBAGO" -q --dump=list "$stage/entities.dxf" >whole 2>"$TMP/err" || cp "$TMP/err" whole
mkdir home && mkdir -m 000 closed
for home in "HOME=$PWD/home" HOME= "HOME=$PWD/closed" HOME=/nonexistent "--unset=HOME" "MPLBACKEND=nonsense" "XDG_CONFIG_HOME=relative" "PYTHONPATH=$PWD/home"; do
    env "$home" "$PLUMBAGO" -q --dump=list "$stage/entities.dxf" >again 2>"$TMP/err"
    is "with ${home/$PWD\//}" "$? $(cat "$TMP/err")" "0 "
    same "with ${home/$PWD\//}: the same" again whole
done
if [ "$(id -u)" -eq 0 ] && setpriv --reuid=65534 --regid=65534 --clear-groups test -x "$PLUMBAGO" 2>/dev/null; then
    setpriv --reuid=65534 --regid=65534 --clear-groups "$PLUMBAGO" -q --dump=list - <"$stage/entities.dxf" >again 2>"$TMP/err"
    is "by nobody" "$? $(cat "$TMP/err")" "0 "
    same "by nobody: the same" again whole
else
    skip "by nobody" "the tests are not run by root, or he may not enter the build's folder"
fi
# The reason is the true one: a package that is there and fails says how.
mkdir only2 && cp "$BUILD_DIR/plumbago" only2/ && sed 's/^    import ezdxf$/    raise RuntimeError("it is broken")/' "$ROOT/src/tap/dxf/tap_dxf.py" >only2/tap-dxf && chmod +x only2/tap-dxf
PLUMBAGO=$PWD/only2/plumbago refuses "a package that fails" "python3-ezdxf cannot be used: RuntimeError: it is broken" line.dxf
# Ten lines, in processor time; most of it loads the library.
{ printf '%s\n' 0 SECTION 2 ENTITIES; for i in {1..10}; do printf '%s\n' 0 LINE 8 0 10 $i 20 0 11 $i 21 9; done; printf '%s\n' 0 ENDSEC 0 EOF; } >ten.dxf
case $BUILD_DIR in
*release*)
    best=9
    for i in 1 2 3; do
        cost=$({ TIMEFORMAT='%U %S'; time "$BUILD_DIR/tap-dxf" <ten.dxf >"$TMP/out" 2>"$TMP/err"; } 2>&1 | awk '{ print $1 + $2 }')
        best=$(awk -v a="$best" -v b="$cost" 'BEGIN { print a < b ? a : b }')
    done
    is "ten lines take less than half a second ($best s)" "$(awk -v b="$best" 'BEGIN { print b < .5 }')" 1
    ;;
esac

# The same bytes each time (the library's sets have an order of their own in each process).
"$PLUMBAGO" -q --dump=list "$stage/plan.dxf" >first
for i in 2 3; do "$PLUMBAGO" -q --dump=list "$stage/plan.dxf" >again && same "run $i gives the same list" first again; done

# The corpus, where it is: every file leaves a mark.
if [ -d "$SHARED/corpus/dxf" ]; then
    for file in "$SHARED"/corpus/dxf/*.dxf; do
        plumbago -q -o x.png "$file"
        is "${file##*/}: drawn" "$status $(wc -l <"$TMP/err")" "0 0"
    done
else
    skip "the corpus" "no corpus here"
fi
