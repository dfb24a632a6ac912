# SPDX-License-Identifier: MIT
# plumbago-profile: the reports, a reader of the format that is not ours, files made to be wrong, the command line, and
# one of the eight pencils captured again (LONG=1: all).
. "$ROOT/tests/check.sh"
# Under AddressSanitizer: the fonts of a plot's labels stay in fontconfig's own cache.
echo leak:libfontconfig >"$TMP/leaks"
export LSAN_OPTIONS=suppressions=$TMP/leaks:print_suppressions=0

tool() {
    "$PLUMBAGO_PROFILE" "$@" >"$TMP/out" 2>"$TMP/err"
    status=$?
}
listing() { find . | sort; }

# does NAME ARGS...: the run succeeds and says nothing on standard error.
does() {
    local name=$1
    shift
    tool "$@"
    if [ $status -ne 0 ]; then fail "$name" "exit status $status: $(head -n 1 "$TMP/err")"; elif [ -s "$TMP/err" ]; then fail "$name" "it said: $(head -n 1 "$TMP/err")"; else ok "$name"; fi
}
# refused STATUS NAME PATTERN ARGS...: that status, one line on standard error that matches, no file more or less.
refused() {
    local wanted=$1 name=$2 pattern=$3 before
    shift 3
    before=$(listing)
    tool "$@"
    if [ $status -ne "$wanted" ]; then
        fail "$name" "exit status $status, not $wanted: $(head -n 1 "$TMP/err")"
    elif [ "$(wc -l <"$TMP/err")" -ne 1 ] || ! grep -q '^plumbago-profile: ' "$TMP/err" || ! grep -qE -- "$pattern" "$TMP/err"; then
        fail "$name" "the message is: $(tr '\n' '|' <"$TMP/err")"
    elif [ "$(listing)" != "$before" ]; then
        fail "$name" "the files changed: $(diff <(echo "$before") <(listing) | tr '\n' ' ')"
    else
        ok "$name"
    fi
}

# ---- a second reader of the format, after pencil(5) alone: od and awk ----------------------------------------
# Prints "centre MEDIAN", "pairs N", "cells N", "half PX", "tenth PX", "lines N", "columns N", "name NAME", "bounds A B C D",
# "depth GREYS" of the grain.
independent() {
    od -An -v -tu1 "$1" | tr -s ' \n' '\n\n' | awk '
    NF { b[n++] = $1 }
    function le(at, size,   v, i) { v = 0; for (i = size - 1; i >= 0; i--) v = v * 256 + b[at + i]; return v }
    function leb(   v, f) { v = 0; f = 1; while (b[at] >= 128) { v += (b[at++] - 128) * f; f *= 128 } v += b[at++] * f; return v }
    function single(at,   u, e) {
        u = le(at, 4); e = int(u / 8388608) % 256
        return (u >= 2147483648 ? -1 : 1) * (1 + u % 8388608 / 8388608) * 2 ^ (e - 127)
    }
    function die(why) { print "bad", why; bad = 1; exit }
    END {
        if (bad) exit
        split("137 80 78 67 76 13 10 26", magic, " ")
        for (i = 0; i < 8; i++) if (b[i] != magic[i + 1]) die("magic")
        if (le(8, 2) != 1 || le(12, 4) != n) die("header")
        for (at = 16; at < n - 4;) {
            tag = sprintf("%c%c%c%c", b[at], b[at + 1], b[at + 2], b[at + 3]); size = le(at + 4, 4); at += 8; end = at + size
            if (tag == "NAME") { name = ""; for (i = at; i < end; i++) name = name sprintf("%c", b[i]); print "name", name }
            if (tag == "SCAN") { print "half", le(at + 4, 4) / 1000; print "tenth", le(at + 8, 4) / 1000; print "lines", le(at + 12, 4); print "columns", le(at + 16, 8) }
            if (tag == "GRAI" && size == 6642) printf "depth %.1f\n", exp(single(at + 6 + 4 * (1 + 36 + 390 + 18 + 825 + 51 + 4 + 200 + 2)))
            if (tag == "BNDS") print "bounds", b[at], b[at + 1], b[at + 2], b[at + 3]
            if (tag == "HMID") {
                total = sum = 0; for (i = 0; i < 256; i++) total += le(at + 4 * i, 4)
                for (i = 0; i < 256; i++) { sum += le(at + 4 * i, 4); if (sum * 2 >= total) break }
                print "centre", i
            }
            if (tag == "COOC") {
                cells = le(at, 4); at += 4; pairs = cell = 0
                for (k = 0; k < cells; k++) { cell += leb(); pairs += leb() }
                if (cell > 65536 || at != end) die("cells")
                print "cells", cells; print "pairs", pairs
            }
            at = end
        }
        if (at != n - 4) die("sections")
    }' | sort
}
# The same figures from `show`.
shown() {
    "$PLUMBAGO_PROFILE" show "$1" | awk '
    $1 == "pencil" { print "name", $2 }
    /^width at half/ { v = $7; sub(/\(/, "", v); print "half", v }
    /^width at a tenth/ { v = $9; sub(/\(/, "", v); print "tenth", v }
    /^measured on/ { print "lines", $3; print "columns", $5 }
    /^  depth/ { print "depth", $2 }
    /^bounds/ { sub(/,/, "", $5); print "bounds", $3, $5, $8, $10 }
    /^centre +[0-9]/ { print "centre", $2 }
    /^co-occurrence/ { print "pairs", $2; print "cells", $5 }' | sort
}
rounded() { awk '$1 == "half" || $1 == "tenth" { printf "%s %.2f\n", $1, int($2 * 100 + 0.5) / 100; next } { print }'; }
# CRC-32 by gzip, which keeps it in the last eight bytes of what it writes.
crc() { head -c -4 "$1" | gzip -c | tail -c 8 | head -c 4 | od -An -tx1; }

for grade in 2H H F HB B 3B 6B 8B; do
    file=$ROOT/profiles/$grade.pencil
    theirs=$(independent "$file" | rounded) ours=$(shown "$file" | rounded)
    if [ -n "$theirs" ] && [ "$theirs" = "$ours" ]; then ok "$grade: another reader finds the same figures"; else fail "$grade: another reader finds the same figures" "$(diff <(echo "$theirs") <(echo "$ours") | head -n 4 | tr '\n' ' ')"; fi
    if [ "$(crc "$file")" = "$(tail -c 4 "$file" | od -An -tx1)" ]; then ok "$grade: gzip has the same checksum"; else fail "$grade: gzip has the same checksum" "$(crc "$file")"; fi
    if cmp -s <("$PLUMBAGO_PROFILE" show "$grade") <("$PLUMBAGO_PROFILE" show "$file"); then ok "$grade: built in as in its file"; else fail "$grade: built in as in its file"; fi
done

# ---- reports ---------------------------------------------------------------------------------------------------
does "show" show HB
for words in 'pencil +HB' 'resolution +300 dpi' 'width at half depth +0\.[0-9]+ mm' 'centre +1[0-9][0-9] grey' 'correlation +0\.[0-9]+' 'cross-section' 'CC BY 4\.0' 'assigned, not known'; do
    if grep -qE "$words" "$TMP/out"; then ok "show says $words"; else fail "show says $words" "it does not"; fi
done
does "show in lower case" show hb
does "show draws" show --plot hb.png HB
if [ "$(head -c 4 hb.png | od -An -tx1 | tr -d ' ')" = 89504e47 ] && [ "$(wc -c <hb.png)" -gt 20000 ]; then ok "the plot is a PNG"; else fail "the plot is a PNG"; fi
does "a pencil compared with itself" compare HB hb
if [ "$(grep -cE ' (0|0\.0+)  ' "$TMP/out")" -eq 11 ]; then ok "differs in nothing"; else fail "differs in nothing" "$(grep -vE ' (0|0\.0+)  ' "$TMP/out" | tail -n 1)"; fi
does "hard and soft compared" compare 2H 8B
if awk '/^centre / && $4 < -80 { c = 1 } /^width/ && $4 > 0.1 { w = 1 } /ACE/ && $3 > 1.3 && $3 <= 2 { a = 1 } END { exit !(c && w && a) }' "$TMP/out"; then ok "differ in darkness, width, co-occurrence"; else fail "differ in darkness, width, co-occurrence" "$(tr '\n' '|' <"$TMP/out")"; fi
"$PLUMBAGO_PROFILE" compare 8B 2H | awk '/^co-occ|^line hist|^centre hist|^cross/ { print $(NF > 3 ? 3 : 2) }' >back
"$PLUMBAGO_PROFILE" compare 2H 8B | awk '/^co-occ|^line hist|^centre hist|^cross/ { print $(NF > 3 ? 3 : 2) }' >forth
if cmp -s back forth; then ok "distances are the same both ways"; else fail "distances are the same both ways"; fi
if [ -e /dev/full ]; then
    "$PLUMBAGO_PROFILE" show HB >/dev/full 2>"$TMP/err"
    if [ $? -eq 1 ] && [ "$(wc -l <"$TMP/err")" -eq 1 ]; then ok "a full disk is noticed"; else fail "a full disk is noticed" "$(cat "$TMP/err")"; fi
fi

# ---- files made to be wrong ------------------------------------------------------------------------------------
good=$ROOT/profiles/HB.pencil
: >empty.pencil
head -c 7 "$good" >magic-cut.pencil
head -c 16 "$good" >header-only.pencil
head -c 5000 "$good" >cut.pencil
{ cat "$good"; echo; } >longer.pencil
sed 's/300/301/; s/HB/HC/' "$good" >text-edited.pencil
sed 's/\r$//' "$good" >sent-as-text.pencil
{ head -c 8 "$good"; printf '\002'; tail -c +10 "$good"; } >version-2.pencil
{ head -c 12 "$good"; printf '\377\377\377\377'; tail -c +17 "$good"; } >size-4g.pencil
head -c 5000000 /dev/zero >five-megabytes-of-nothing.pencil
{ head -c 8 "$good"; head -c 5000000 /dev/zero; } >five-megabytes.pencil
cp "$ROOT/examples/plan.svg" drawing.pencil
for f in *.pencil; do
    case $f in version-2*) words='version 2' ;; five*) words='too large' ;; *) words='pencil profile' ;; esac
    refused 1 "${f%.pencil} is refused" "^plumbago-profile: $f: .*$words" show "$f"
done
rm -f ./*.pencil
refused 1 "a pencil that is not there" 'no-such: neither one of the eight' show no-such
refused 1 "a folder for a pencil" 'cannot be read' show .

# ---- the command line ------------------------------------------------------------------------------------------
refused 2 "no command" 'which command'
refused 2 "unknown command" 'no such command' draw HB
refused 2 "unknown option" '--nonsense' show HB --nonsense
refused 2 "show without a pencil" 'one PENCIL' show
refused 2 "show with two" 'one PENCIL' show HB B
refused 2 "compare with one" 'two PENCILs' compare HB
refused 2 "capture without a scan" 'SCAN' capture -o x.pencil
refused 2 "capture without -o" '-o FILE' capture x.png
refused 2 "--plot with compare" '--plot' compare HB B --plot x.png
refused 2 "-o with show" '--plot' show HB -o x
refused 2 "--centre upside down" '--centre' capture x.png -o y --centre 200-100
refused 2 "--centre beyond white" '--centre' capture x.png -o y --centre 0-256
refused 2 "--centre of words" '--centre' capture x.png -o y --centre dark-light
refused 2 "--width 0" '--width' capture x.png -o y --width 0
refused 1 "--width of a hair's hair" 'width of 0.0001 mm is not between 0.05 and 2' capture hb.png -o y --width 0.0001
refused 1 "--width of a brush" 'width of 2.1 mm' capture hb.png -o y --width 2.1mm
refused 2 "--width in inches" '--width' capture x.png -o y --width 1in
refused 1 "--grain of no pencil" '9B' capture hb.png -o y --grain 9B
refused 2 "--dpi nan" '--dpi' capture x.png -o y --dpi nan
refused 2 "--name too long" '--name' capture x.png -o y --name 12345678901234567890123456789012
refused 1 "a scan that is not there" 'absent.png' capture absent.png -o x.pencil
refused 1 "a scan that is no PNG" 'not a readable PNG' capture "$good" -o x.pencil
refused 1 "a scan without a line" 'no usable line' capture hb.png -o x.pencil --centre 250-255
refused 1 "a provenance that is not there" 'absent.txt' capture hb.png -o x.pencil --provenance @absent.txt
refused 1 "a plot into no folder" 'no-folder' show HB --plot no-folder/x.png
does "--help" --help
does "--version" --version
if grep -qE '^plumbago-profile [0-9]+\.[0-9]+' "$TMP/out"; then ok "the version is a number"; else fail "the version is a number"; fi

# ---- the hand: drawn lines, captured, stray as they were drawn --------------------------------------------------
awk 'BEGIN { for (i = 0; i < 4; i++) { f = "hand-" i ".svg"
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"106mm\" height=\"12mm\" viewBox=\"0 0 106 12\"><path d=\"M3 %.2fH103\" stroke=\"#000\" stroke-width=\".3\"/></svg>", 6 + i / 100 >f } }'
hand_of() { "$PLUMBAGO_PROFILE" show "$1" | sed -n 's/^hand  *//p'; }
for len in 0.42mm 0.08mm; do
    check "lines of a squiggle of $len" "$PLUMBAGO" --ruler none --squiggle $len -o "hand-$len-%s.png" hand-?.svg
    does "capture of them" capture --as-measured -o "hand-$len.pencil" hand-$len-hand-?.png
done
free=$(hand_of hand-0.42mm.pencil) steady=$(hand_of hand-0.08mm.pencil)
if awk -v a="${free%% *}" -v b="${steady%% *}" 'BEGIN { exit !(a > 0.6 && a < 1.6 && b > 0.08 && b < 0.45) }'; then ok "the hand is measured"; else fail "the hand is measured" "$free, $steady"; fi
# At twice the resolution the grain shows finer gaps, and the line is the same line.
px_of() { "$PLUMBAGO_PROFILE" show "$1" | sed -n 's/^measured on.* \([0-9]*\) px of line/\1/p'; }
check "the same at 600 dpi" "$PLUMBAGO" -d 600 --ruler none --squiggle 0.08mm -o 'fine-%s.png' hand-?.svg
does "capture at 600 dpi" capture --as-measured -o fine.pencil fine-hand-?.png
if [ "$(px_of fine.pencil)" -gt 8800 ]; then ok "all of the line is found, but for its ends"; else fail "all of the line is found" "$(px_of fine.pencil) of 9448 px"; fi
fine=$(hand_of fine.pencil)
if awk -v a="${steady%% *}" -v b="${fine%% *}" 'BEGIN { exit !(b > 0.8 * a && b < 1.25 * a) }'; then ok "and the hand"; else fail "and the hand" "$steady, $fine"; fi
is "scans of one line: no warning" "$("$PLUMBAGO_PROFILE" capture --as-measured -o marks.pencil hand-0.08mm-hand-0.png 2>&1)" ""
printf '<svg xmlns="http://www.w3.org/2000/svg" width="106mm" height="32mm" viewBox="0 0 106 32"><path d="M3 4H103M5 12H100M5 20H100M5 28H100" stroke="#000" stroke-width=".4"/></svg>' >marks.svg
check "a sheet of four lines" "$PLUMBAGO" marks.svg
tool capture --as-measured -o marks.pencil marks.png
is "a sheet of four lines: it is captured, with one warning" "$status $(grep -c '^plumbago-profile: warning: marks.png: the scan shows many marks, of which .* [23][0-9] %' "$TMP/err") $(wc -l <"$TMP/err")" "0 1 1"
does "capture --free-hand" capture --as-measured --free-hand -o free.pencil hand-0.08mm-hand-?.png
if [ "$(hand_of free.pencil)" = "a free one" ]; then ok "--free-hand leaves it out"; else fail "--free-hand leaves it out" "$(hand_of free.pencil)"; fi
is "compare tells hands apart" "$("$PLUMBAGO_PROFILE" compare hand-0.08mm.pencil free.pencil | awk '/^hand/ { print $2, $3 }')" "${steady%% *} 1.000"
check "a line by a steady hand" "$PLUMBAGO" --ruler none -p hand-0.08mm.pencil --dump=controls -o steady.png hand-0.svg
check "a line by a free hand" "$PLUMBAGO" -p free.pencil --dump=controls -o free.png hand-0.svg
if cmp -s steady.png free.png; then fail "a profile's hand draws"; else ok "a profile's hand draws"; fi
check "a squiggle goes by the free hand" "$PLUMBAGO" -p hand-0.08mm.pencil --squiggle 0.3mm --dump=controls -o a.png hand-0.svg
check "whatever the profile" "$PLUMBAGO" -p free.pencil --squiggle 0.3mm --dump=controls -o b.png hand-0.svg
if cmp -s a.png b.png; then ok "with --squiggle the profile's hand does not count"; else fail "with --squiggle the profile's hand does not count"; fi

# ---- capture from the real scans -------------------------------------------------------------------------------
scans=$SHARED/scans/hdbpmn
if ! [ -d "$scans" ]; then
    skip "the eight pencils captured anew" "no scans here"
    skip "capture of a real line" "no scans here"
    exit 0
fi
case $BUILD_DIR in
*tsan*) skip "the eight pencils captured anew" "capture has one thread, and takes half an hour under the thread sanitizer" ;;
*)
    mkdir again
    grades='2H H F HB B 3B 6B 8B'
    [ -n "${LONG:-}" ] || grades=F
    check "capture.sh runs" env GRADES="$grades" bash "$ROOT/profiles/capture.sh" "$PLUMBAGO_PROFILE" "$PWD/again"
    for grade in $grades; do
        if cmp -s "again/$grade.pencil" "$ROOT/profiles/$grade.pencil"; then ok "$grade captured anew: the same bytes"; else fail "$grade captured anew: the same bytes"; fi
    done
    ;;
esac
# The measuring script of the evidence found for this line: centre 175, 6.5 px at half depth, 730 columns.
line=$scans/line_ex03_w0054_h_x0480_y1141.png
does "capture of a real line" capture "$line" -o one.pencil --name 'one line' --provenance 'a test'
"$PLUMBAGO_PROFILE" show one.pencil >"$TMP/out"
if awk '/^centre +[0-9]/ { c = $2 } /^width at half/ { w = $7; sub(/\(/, "", w) } /^measured/ { n = $5 }
    END { exit !(c >= 176 && c <= 180 && w > 6.3 && w < 6.8 && n > 700 && n <= 740) }' "$TMP/out"; then ok "its figures are those of another program"; else fail "its figures are those of another program" "$(head -n 7 "$TMP/out" | tr '\n' '|')"; fi
before=$(cksum <one.pencil)
does "capture without the correction" capture --as-measured "$line" -o raw.pencil --name 'one line' --provenance 'a test'
if cmp -s one.pencil raw.pencil; then fail "the correction changes something"; else ok "the correction changes something"; fi
tool capture "$scans/absent.png" -o one.pencil
if [ "$before" = "$(cksum <one.pencil)" ] && [ $status -eq 1 ]; then ok "a failed capture leaves the old file"; else fail "a failed capture leaves the old file"; fi
tool capture -v --centre 170-190 "$line" -o one.pencil
if [ $status -eq 0 ] && grep -q 'used: centre' "$TMP/err"; then ok "-v says what was found"; else fail "-v says what was found" "$(head -n 1 "$TMP/err")"; fi
