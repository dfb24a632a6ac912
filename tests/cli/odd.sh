# SPDX-License-Identifier: MIT
# Odd surroundings: links that lead nowhere, the drawing as its own result, no room for temporary files, hardly any
# descriptors or memory, names and values that would break a line of a message.
. "$ROOT/tests/check.sh"
example a.svg
cp a.svg kept.svg
printf '%%!PS-Adobe-3.0 EPSF-3.0\n%%%%BoundingBox: 0 0 99 99\n/Helvetica findfont 20 scalefont setfont 9 50 moveto (odd) show 9 9 moveto 90 9 lineto stroke\n' >text.eps

# ---- links ----
mkdir elsewhere
ln -s elsewhere/target.png dangling.png
draws "a link to what is not there yet" -o dangling.png a.svg
is "it stays a link" "$(readlink dangling.png)" elsewhere/target.png
is "the picture is where it leads" "$([ -s elsewhere/target.png ] && echo there)" there
ln -s ../chain.png elsewhere/second
ln -s elsewhere/second first.png
draws "a link to a link" -o first.png a.svg
is "both stay links" "$([ -L first.png ] && [ -L elsewhere/second ] && [ -f chain.png ] && echo yes)" yes
ln -s loop2.png loop1.png && ln -s loop1.png loop2.png
refuses "links that lead to each other" 'loop1.png: cannot be written: ' -o loop1.png a.svg
ln -s nowhere/x.png lost.png
refuses "a link into a folder that is not there" 'lost.png: cannot be written: ' -o lost.png a.svg

# ---- the drawing as its own result ----
ln a.svg hard.png && ln -s a.svg soft.png && cp a.svg named.png
for name in hard.png soft.png; do misused "the result would replace the drawing: $name" 'would replace' -o $name a.svg; done
misused "the result would replace the drawing: the name without the folder" 'would replace' -o "$PWD/named.png" named.png
"$PLUMBAGO" -o named.png <named.png >"$TMP/out" 2>"$TMP/err"
is "the result would replace what standard input is" $? 2
"$PLUMBAGO" --dump=list a.svg >>a.svg 2>"$TMP/err"
is "the result would go on where the drawing ends" $? 2
"$PLUMBAGO" -o - <a.svg >>a.svg 2>"$TMP/err"
is "the same with both redirected" $? 2
same "the drawing is as it was" a.svg kept.svg

# ---- one line, whatever was given ----
one_line() { is "$1: one line without control bytes" "$(wc -l <"$TMP/err") $(LC_ALL=C tr -d '\n' <"$TMP/err" | LC_ALL=C tr -d '\040-\176\200-\377' | wc -c)" "1 0"; }
plumbago $'--dpi=1\n2\e[2J' a.svg && one_line "a value"
plumbago $'--no\nsuch' a.svg && one_line "an option"
plumbago $'-\e' a.svg && one_line "a letter"
plumbago $'no\nsuch\e[2J.svg' && one_line "a file"
plumbago -p $'no\nsuch' a.svg && one_line "a pencil"
plumbago -o $'no\nfolder/x.png' a.svg && one_line "an output"
cp a.svg $'two\nlines.svg'
"$PLUMBAGO" -v -d 30 $'two\nlines.svg' 2>"$TMP/err"
is "-v with a name of two lines" "$? $(grep -vc '^plumbago: ' "$TMP/err")" "0 0"
for args in $'show no\nsuch' $'show --plot=no\nfolder/x.png HB' $'capture --dpi=\e1 -o x a' $'capture -o x no\nsuch.png' $'capture --provenance=@no\nsuch -o x a.png'; do
    # shellcheck disable=SC2086
    (IFS=' '; "$PLUMBAGO_PROFILE" $args >"$TMP/out" 2>"$TMP/err")
    one_line "plumbago-profile ${args//[[:cntrl:]]/?}"
done
cp a.svg -- -dash.svg && cp a.svg ./--dpi
draws "a name that begins with a dash" -d 30 -o x.png -- -dash.svg
draws "a name like an option" -d 30 -o x.png -- --dpi

# ---- temporary files, which Ghostscript needs ----
if command -v gs >/dev/null && command -v pdftocairo >/dev/null; then
    draws "with Ghostscript" -d 30 -o text.png text.eps
    rm text.png
    export TMPDIR=/nonexistent
    refuses "no folder for temporary files" 'cannot make a temporary folder in /nonexistent' -o text.png text.eps
    draws "which SVG does not need" -d 30 -o x.png a.svg
    mkdir small
    if mount -t tmpfs -o size=4k tmpfs small 2>/dev/null; then
        export TMPDIR=$PWD/small
        refuses "no room for temporary files" 'text.eps: Ghostscript finds no room for its temporary files' -o text.png text.eps
        is "nothing is left there" "$(ls small)" ""
        umount small
    else
        skip "no room for temporary files" "no file system may be mounted here"
    fi
    unset TMPDIR
    # Temporary files count as memory: a drawing of a few lines cannot fill the disk, neither by one large file nor by many small.
    for fill in '/f null (w) .tempfile exch pop def { f s writestring } loop' '{ /f null (w) .tempfile exch pop def 40 { f s writestring } repeat f flushfile } loop'; do
        printf '%s\n' '%!PS' '/Helvetica findfont 20 scalefont setfont 10 10 moveto (a) show' '/s 65535 string def' "{ $fill } stopped" showpage >fill.ps
        mkdir fill
        (TMPDIR=$PWD/fill exec "$PLUMBAGO" -d 20 --limit-memory 64 -o y.png fill.ps) >"$TMP/out" 2>"$TMP/err" &
        reader=$!
        top=0
        while kill -0 $reader 2>/dev/null; do
            now=$(du -sk fill 2>/dev/null | cut -f 1)
            [ "${now:-0}" -le $top ] || top=$now
            sleep .01
        done
        wait $reader
        is "Ghostscript fills the disk: one line" "$? $(cat "$TMP/err")" \
            "1 plumbago: fill.ps: Ghostscript writes more temporary files than it may (64 MB)"
        # The bytes written between two looks of the watch come on top, and a busy machine looks late. Without a watch the disk ends it.
        check "its temporary files end near the limit: $top KiB" test $top -gt 0 -a $top -le $((2 * 64 * 1024))
        is "and are gone" "$(ls fill)" ""
        rm -rf fill
    done
    for n in 4 6 8 10; do
        plumbago_few() { (ulimit -n $n; exec "$PLUMBAGO" -q -d 30 -o text.png text.eps) >"$TMP/out" 2>"$TMP/err"; }
        plumbago_few
        code=$?
        if [ $code -eq 0 ]; then ok "$n descriptors are enough for Ghostscript"; else is "$n descriptors: one line" "$code $(wc -l <"$TMP/err")" "1 1"; fi
        rm -f text.png
    done
else
    skip "temporary files" "no gs or no pdftocairo here"
fi

# ---- hardly anything ----
for n in 4 6 9; do
    (ulimit -n $n; exec "$PLUMBAGO" -q -d 30 -o x.png a.svg) >"$TMP/out" 2>"$TMP/err"
    is "$n descriptors: one line" "$? $(wc -l <"$TMP/err")" "1 1"
done
case $BUILD_DIR in
*asan* | *tsan*) skip "little memory for the readers" "a build with this sanitizer has no such limit" ;;
*)
    sed 's|</g>|<text x="5" y="9" font-size="4">odd</text></g>|' a.svg >text.svg
    refuses "little memory for librsvg" 'text.svg: librsvg needs more than 64 MB' --limit-memory 64 -o y.png text.svg
    (ulimit -v 61440 && exec "$PLUMBAGO" -d 20 -o y.png text.svg) >"$TMP/out" 2>"$TMP/err"
    is "little memory for all: the reader's is named" "$? $(cat "$TMP/err")" "1 plumbago: text.svg: librsvg needs more than 60 MB for this drawing"
    # With more it gets further: somewhere in its libraries, or through. Never to another drawing, never to other words.
    "$PLUMBAGO" -d 20 -o ample.png text.svg
    other=''
    refused=0
    for mib in 65 66 68 72 80 86 90 94 97 100 105 110 116 122; do
        rm -f y.png
        "$PLUMBAGO" -d 20 --limit-memory $mib -o y.png text.svg >"$TMP/out" 2>"$TMP/err"
        code=$?
        if [ $code -eq 1 ] && [ "$(cat "$TMP/err")" = "plumbago: text.svg: librsvg needs more than $mib MB for this drawing" ] && ! [ -e y.png ]; then refused=$((refused + 1))
        elif [ $code -ne 0 ] || [ -s "$TMP/err" ] || ! cmp -s ample.png y.png; then other="$other $mib: $code $(head -n 1 "$TMP/err")"; fi
    done
    is "a little more: the same drawing, or the same words" "$other" ""
    [ $refused -gt 0 ] || skip "the same words" "65 MB are enough here"
    command -v pdftocairo >/dev/null && command -v gs >/dev/null && gs -q -dSAFER -dBATCH -dNOPAUSE -sDEVICE=pdfwrite -o a.pdf text.eps &&
        refuses "little memory for pdftocairo and librsvg" 'a.pdf: (pdftocairo|librsvg) needs more than 64 MB' --limit-memory 64 -o y.png a.pdf
    # Some 60 MB of lines: without numpy ezdxf itself needs little.
    awk 'BEGIN { print "0\nSECTION\n2\nENTITIES"; for (k = 0; k < 40000; k++) printf "0\nLINE\n8\n0\n10\n%d\n20\n0\n11\n%d\n21\n9\n", k, k; print "0\nENDSEC\n0\nEOF" }' >many.dxf
    /usr/bin/python3 -c 'import ezdxf' 2>/dev/null &&
        refuses "little memory for ezdxf" 'too much memory|ezdxf needs more than' --limit-memory 64 -o y.png many.dxf
    ;;
esac
# Without any font text would be boxes.
printf '<?xml version="1.0"?><fontconfig></fontconfig>\n' >fonts.conf
printf '<svg xmlns="http://www.w3.org/2000/svg" width="99" height="99"><path d="M9 9L90 90" stroke="#000"/><text x="9" y="50">odd</text></svg>\n' >letters.svg
FONTCONFIG_FILE=$PWD/fonts.conf "$PLUMBAGO" --dump=list letters.svg >"$TMP/out" 2>"$TMP/err"
is "no font is told" "$? $(cat "$TMP/err") $(grep -cE '^(fill|stroke)' "$TMP/out")" \
    "0 plumbago: warning: letters.svg: there is no font here: its text is left out (Debian: fonts-dejavu-core) 1"
# A stack that no program can work with is told; one that may grow is enlarged.
(ulimit -s 64 && exec "$PLUMBAGO" -d 20 -o y.png a.svg) >"$TMP/out" 2>"$TMP/err"
is "a stack of 64 KB" "$? $(cat "$TMP/err")" "1 plumbago: the stack may have 64 KB only (ulimit -s): 256 are needed"
(ulimit -s 64 && exec "$PLUMBAGO_PROFILE" show HB) >"$TMP/out" 2>"$TMP/err"
is "a stack of 64 KB for the other program" "$? $(wc -l <"$TMP/err")" "1 1"
case $BUILD_DIR in *release*)
    for n in '-s 256' '-Ss 64'; do
        # shellcheck disable=SC2086
        (ulimit $n && exec "$PLUMBAGO" -d 20 -o y.png a.svg) >"$TMP/out" 2>"$TMP/err"
        is "a stack by ulimit $n" "$? $(cat "$TMP/err")" "0 "
    done
    ;;
esac
for home in '' relative /nonexistent "$(printf 'x%.0s' {1..5000})"; do
    HOME=$home "$PLUMBAGO" -d 30 -o x.png a.svg 2>"$TMP/err"
    is "a home called '$(cut -c 1-20 <<<"$home")'" "$? $(wc -c <"$TMP/err")" "0 0"
done

# ---- readers that stop, or go ----
awk 'BEGIN { print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"200mm\" height=\"200mm\" viewBox=\"0 0 200 200\"><g stroke=\"#000\">"; for (i = 0; i < 400; i++) printf "<path d=\"M%d 0L%d 200\"/>", i / 2, 200 - i / 2; print "</g></svg>" }' >large.svg
mkfifo pipe
"$PLUMBAGO" -q -d 300 -o - large.svg >pipe 2>"$TMP/err" &
pid=$!
{ head -c 100 >/dev/null; sleep .5; cat >rest; } <pipe # it stops for a while
wait $pid
is "a reader that stops for a while" "$? $(wc -c <"$TMP/err")" "0 0"
"$PLUMBAGO" -q -d 300 -o pipe large.svg 2>"$TMP/err" &
pid=$!
head -c 100 <pipe >/dev/null # it goes
wait $pid
code=$?
case $code in 1 | 141) ok "a named pipe whose reader goes" ;; *) fail "a named pipe whose reader goes" "exit status $code" ;; esac
