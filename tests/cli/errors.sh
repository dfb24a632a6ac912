# SPDX-License-Identifier: MIT
# Files can go wrong in many ways, and in each no output is touched, and one line says why.
. "$ROOT/tests/check.sh"
example a.svg
echo keep >kept.png

refuses "a file that is not there" "nothing\.svg" nothing.svg
refuses "a file in a folder that is not there" "no/where\.svg" no/where.svg
refuses "a file with a file in its path" "a\.svg/b\.svg" a.svg/b.svg
mkdir folder.svg
refuses "a folder" "folder\.svg: this is a folder; name the drawings in it" folder.svg
: >empty.svg
refuses "an empty file" "empty\.svg" empty.svg
refuses "no bytes on standard input" "stdin|standard input|-" - </dev/null
head -c 20000 /dev/urandom >junk.svg
refuses "random bytes" "junk\.svg" junk.svg
head -c 20000 /dev/zero >zero.svg
refuses "zeros" "zero\.svg" zero.svg
echo "Dear reader, this is a letter." >letter.txt
refuses "a text" "letter\.txt" letter.txt
cp "$BUILD_DIR/plumbago" program && refuses "a program" "program" program
rm program
# The message names what users take for a drawing, and tells what helps.
named() { # NAME PATTERN BYTES
    printf '%b' "$3" >picture
    refuses "$1" "picture: this is $2" picture
}
named "a PNG" 'a raster picture \(PNG\): .*trace' '\0211PNG\r\n\0032\n'
named "a JPEG" 'a raster picture \(JPEG\)' '\0377\0330\0377\0340\0000\0020JFIF'
named "a GIF" 'a raster picture \(GIF\)' 'GIF89a\0001'
named "a WebP" 'a raster picture \(WebP\)' 'RIFF\0001\0001\0001\0001WEBPVP8 '
named "a TIFF" 'a raster picture \(TIFF\)' 'II*\0000\0010'
named "a DWG" 'an AutoCAD drawing \(DWG\): save it as DXF' 'AC1015\0000\0000'
named "HPGL" 'a plot \(HPGL\): hp2xx' 'IN;SP1;PU10,10;PD20,20;'
printf '<?xml version="1.0"?>\n<!-- a > b -->\n<mxfile host="a"><diagram/></mxfile>' >flow.drawio && refuses "a file of draw.io" 'flow\.drawio: this is a draw\.io file: export it as SVG' flow.drawio
named "a zip" 'an archive' 'PK\0003\0004'
printf '%%!PS\n10 10 moveto 20 20 lineto stroke showpage\n' | gzip >packed.ps.gz
refuses "packed PostScript" 'packed\.ps\.gz: packed \(gzip\) PostScript: unpack it first' packed.ps.gz
printf '\037\235\220' >packed.Z && refuses "a file packed by compress" 'packed\.Z: this is packed \(compress\): unpack it' packed.Z
gzip -c a.svg >packed.svgz && draws "packed SVG is drawn" -o packed.png packed.svgz
printf '<html><body>no drawing</body></html>' >page.html && refuses "a page of HTML" "page\.html" page.html
printf '%%PDF-1.4\n%%junk\n' >broken.pdf && refuses "a broken PDF" "broken\.pdf" broken.pdf
printf '\037\213\010\000junk' >broken.svgz && refuses "a broken svgz" "broken\.svgz" broken.svgz
printf '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><path d="M1 1' >cut.svg
plumbago cut.svg
if [ $status -eq 0 ] || { [ $status -eq 1 ] && [ "$(wc -l <"$TMP/err")" -eq 1 ] && [ ! -e cut.png ]; }; then ok "a cut SVG: drawn as far as it goes, or refused"; else fail "a cut SVG: drawn as far as it goes, or refused" "exit status $status: $(head -n 1 "$TMP/err")"; fi
rm -f cut.png
printf '%%!PS\n10 10 moveto\n20 20 lineto\n) stroke\n' >bad.ps
refuses "a fault in PostScript names its line" "bad\.ps:4: " bad.ps
printf '%%!PS\n10 10 moveto\n20 frobnicate\nstroke\n' >unknown.ps
refuses "an unknown PostScript operator is named, with its line" "unknown\.ps:3: .*frobnicate" unknown.ps
mkfifo pipe.svg
cat a.svg >pipe.svg &
draws "a named pipe" -o pipe.png pipe.svg
wait
rm -f pipe.svg pipe.png
refuses "a device that is empty" "/dev/null" -o x.png /dev/null

# Root may read and write everything, so for these it runs as nobody.
nobody=
if [ "$(id -u)" -eq 0 ]; then
    chmod 755 "$TMP"
    nobody="setpriv --reuid=65534 --regid=65534 --clear-groups"
    $nobody sh -c '[ -x "$1" ]' sh "$TAP_SVG" 2>/dev/null || nobody=impossible # it must reach the programs, too
fi
if [ "$nobody" = impossible ]; then
    skip "files that may not be read or written" "root may do everything, and there is no way to be somebody else"
else
    mkdir locked && cp a.svg secret.svg && cp a.svg locked/ && chmod 000 secret.svg && chmod 555 locked
    program=$PLUMBAGO
    as_nobody() { $nobody "$program" "$@"; }
    PLUMBAGO=as_nobody
    refuses "an unreadable file" "secret\.svg: .*[Pp]ermission" secret.svg
    refuses "a folder that may not be written" "locked/a\.png: .*[Pp]ermission" locked/a.svg
    PLUMBAGO=$program
    chmod 755 locked && rm -rf secret.svg locked
fi

# ---- the output ----
refuses "an output folder that is not there" "no/x\.png" -o no/x.png a.svg
mkdir -p folder/a.png # a folder takes the picture, but not where another lies
refuses "an output that is a directory" "folder/a\.png" -o folder a.svg
refuses "an output named like a directory" "out\.png/" -o out.png/ a.svg
refuses "an output under a file" "a\.svg/x\.png" -o a.svg/x.png a.svg
if [ -w /dev/full ]; then
    refuses "a full device as output file" "/dev/full" -o /dev/full a.svg
    if [ -c /dev/full ]; then ok "the device is still one"; else fail "the device is still one" "/dev/full was replaced"; fi
    "$PLUMBAGO" -o - a.svg >/dev/full 2>"$TMP/err"
    status=$?
    is "standard output on a full device: status" $status 1
    is "standard output on a full device: one line" "$(wc -l <"$TMP/err")" 1
    "$PLUMBAGO" --dump=list a.svg >/dev/full 2>"$TMP/err"
    is "a dump on a full device" $? 1
    "$PLUMBAGO" --dump=strokes a.svg >/dev/full 2>"$TMP/err"
    is "a dump of strokes on a full device" $? 1
    for option in --help --version --list-pencils; do
        "$PLUMBAGO" $option >/dev/full 2>"$TMP/err"
        is "$option on a full device" $? 1
    done
else
    skip "full devices" "no /dev/full here"
fi
draws "a device as output file" -o /dev/null a.svg
if [ -c /dev/null ]; then ok "/dev/null is still a device"; else fail "/dev/null is still a device" "it was replaced"; fi

# ---- an output that is there already ----
for bad in nothing.svg empty.svg junk.svg bad.ps; do
    plumbago -o kept.png $bad
    is "a failure with $bad leaves the output alone" "$(cat kept.png)" keep
done
cp kept.png a.png
plumbago -p 9B a.svg
is "a failure with a pencil leaves the output alone" "$(cat a.png)" keep
plumbago a.svg
if tool png_info a.png >/dev/null 2>&1; then ok "a success replaces it"; else fail "a success replaces it" "a.png is no PNG"; fi
cp kept.png target.png && ln -s target.png link.png
plumbago -o link.png a.svg
if tool png_info link.png >/dev/null 2>&1; then ok "an output that is a link is written"; else fail "an output that is a link is written" "it is no PNG"; fi
ln -s nowhere/x.png dangling.png
plumbago -o dangling.png a.svg
if [ $status -eq 1 ] || tool png_info dangling.png >/dev/null 2>&1; then ok "an output that is a dangling link: written or refused"; else fail "an output that is a dangling link: written or refused" "status $status"; fi
chmod 640 a.png && umask 022 && plumbago -o fresh.png a.svg
is "a new output has the usual mode" "$(stat -c %a fresh.png)" 644
(umask 077 && "$PLUMBAGO" -o private.png a.svg)
is "a new output heeds the umask" "$(stat -c %a private.png)" 600
cp a.svg same.svg && before=$(sha256sum <same.svg)
plumbago -o same.svg same.svg
if [ $status -ne 0 ] && [ "$(sha256sum <same.svg)" = "$before" ]; then ok "the output may not be the input"; elif [ $status -eq 0 ]; then ok "the output may be the input"; else fail "the output is the input" "status $status and the input has changed"; fi
example picture.png && before=$(sha256sum <picture.png)
plumbago picture.png
if [ "$(sha256sum <picture.png)" = "$before" ] && [ $status -ne 0 ]; then ok "a drawing named .png is not overwritten unasked"; else fail "a drawing named .png is not overwritten unasked" "exit status $status, and the input is gone"; fi
left=$(find . -name '.*' -type f -o -name '*tmp*' -o -name '*.part*' -o -name '*~')
report "no temporary file is left" "$left"
