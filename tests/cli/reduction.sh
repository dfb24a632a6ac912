# SPDX-License-Identifier: MIT
# The reduction: what is small is drawn on a larger sheet. The page keeps its size and its pixels.
. "$ROOT/tests/check.sh"

# svg WIDTH HEIGHT ELEMENTS: a drawing in mm.
svg() { echo "<svg xmlns='http://www.w3.org/2000/svg' width='$1mm' height='$2mm' viewBox='0 0 $1 $2' fill='none' stroke='#000' stroke-width='.15'>$3</svg>"; }
# factor ARGS...: the factor that -v tells.
factor() { "$PLUMBAGO" -v "$@" --dump=strokes -o /dev/null 2>&1 | sed -nE 's/.*: reduction ([0-9.]+): .*/\1/p'; }
# between NAME LOW HIGH VALUE
between() { if awk -v a="$2" -v b="$3" -v x="$4" 'BEGIN { exit !(x != "" && x >= a && x <= b) }'; then ok "$1"; else fail "$1" "$4, expected $2 to $3"; fi; }
# A text as outlines of a plain font of ours: h, n, u are drawn as filled shapes `x` high (x in mm), with strokes a sixth of that.
glyph() { # LETTER X Y HEIGHT
    awk -v c="$1" -v x="$2" -v y="$3" -v h="$4" 'BEGIN {
        t = h / 6; w = h * .75; up = c == "h" ? h * 1.4 : h
        if (c == "u") printf "M%g %gh%gv%gh%gv%gh%gv%gh%gz", x, y - h, t, h - t, w - 2 * t, t - h, t, h, -w
        else if (c == "h") printf "M%g %gv%gh%gv%gh%gv%gh%gv%gh%gv%gz", x, y, -up, t, up - h, w - t, h, -t, t - h, 2 * t - w, h - t
        else printf "M%g %gv%gh%gv%gh%gv%gh%gv%gz", x, y, -h, w, h, -t, t - h, 2 * t - w, h - t
    }'
}
text() { # WORD X Y HEIGHT
    local i
    for ((i = 0; i < ${#1}; i++)); do echo "<path fill='#000' stroke='none' d='$(glyph "${1:i:1}" "$(awk -v x="$2" -v i="$i" -v h="$4" 'BEGIN { print x + i * h }')" "$3" "$4")'/>"; done
}

# ---- lettering ----
for x in 2.4 1.25 1 .8 .6; do
    svg 84 30 "$(text hunhnu 5 10 $x)$(text nuhunh 5 20 $x)" >text-$x.svg
done
is "lettering of 2.4 mm needs nothing" "$(factor text-2.4.svg)" 1
between "lettering of 1.25 mm" 1.6 1.7 "$(factor text-1.25.svg)"
between "lettering of 1 mm" 2 2.1 "$(factor text-1.svg)"
between "lettering of .8 mm" 2.5 2.6 "$(factor text-.8.svg)"
between "lettering of .6 mm" 3.3 3.5 "$(factor text-.6.svg)"
between "larger lettering needs less" 1.6 1.7 "$(factor --scale 1.25 text-1.svg)"
is "lettering that is not drawn needs nothing" "$(factor --text none text-.6.svg)" 1
svg 84 40 "$(for y in 10 20 30; do text hunhnuhunhnu 5 $y 1.25; done)$(text n 60 10 .4)" >stray.svg
between "a stray tiny glyph changes nothing" 1.6 1.7 "$(factor stray.svg)"
svg 30 84 "<g transform='rotate(-90) translate(-84)'>$(text hunhnu 5 10 1)$(text nuhunh 5 20 1)</g>" >upright.svg
between "lettering that is read upward" 2 2.1 "$(factor upright.svg)"

# ---- lines: two widths of the pencil: some .6 mm for a sharpened HB, .94 mm for a blunt one ----
pairs() { # GAP: pairs of lines
    awk -v g="$1" 'BEGIN { for (y = 4; y < 56; y += 6) printf "<path d=\"M5 %gH75M5 %gH75\"/>", y, y + g }'
}
for g in 1 .5 .3 .2; do svg 80 60 "$(pairs $g)" >pairs-$g.svg; done
is "lines 1 mm apart need nothing" "$(factor pairs-1.svg)" 1
between "lines .5 mm apart, with a sharp point" 1 1.4 "$(factor pairs-.5.svg)"
between "lines .3 mm apart" 1.8 2.3 "$(factor pairs-.3.svg)"
between "lines .2 mm apart" 2.7 3.3 "$(factor pairs-.2.svg)"
between "lines .5 mm apart, with a blunt point" 1.8 2 "$(factor --point blunt pairs-.5.svg)"
between "a broader pencil needs more" "$(awk -v f="$(factor --point blunt pairs-.5.svg)" 'BEGIN { print f + .2 }')" 4 "$(factor --point blunt -p 8B pairs-.5.svg)"
svg 80 60 "$(awk 'BEGIN { for (y = 4; y < 56; y += .4) printf "<path d=\"M5 %gH75\"/>", y }')" >dense.svg
is "dense hatching is a tone" "$(factor dense.svg)" 1
svg 80 60 "$(awk 'BEGIN { srand(7); for (i = 0; i < 300; i++) printf "<path d=\"M5 %gH75\"/>", 5 + 30 * rand() }')" >texture.svg
is "an uneven texture is a tone, too" "$(factor texture.svg)" 1
svg 80 60 "$(awk 'BEGIN { for (a = 0; a < 180; a += 2) printf "<path d=\"M40 30L%g %g\"/>", 40 + 28 * cos(a / 57.3), 30 + 28 * sin(a / 57.3) }')" >rays.svg
is "rays that meet are no neighbours" "$(factor rays.svg)" 1

# ---- shapes ----
triangles() { awk -v s="$1" 'BEGIN { srand(3); for (i = 0; i < 60; i++) printf "<path d=\"M%g %gl%g %gh%gz\"/>", 4 + 70 * rand(), 4 + 50 * rand(), s / 2, s * .87, -s }'; }
for s in 2 .5; do svg 80 60 "$(triangles $s)" >triangles-$s.svg; done
is "markers of 2 mm need nothing" "$(factor triangles-2.svg)" 1
between "markers of .5 mm" 2 2.6 "$(factor triangles-.5.svg)"
svg 80 60 "$(awk 'BEGIN { srand(5); for (i = 0; i < 300; i++) printf "<circle fill=\"#000\" stroke=\"none\" cx=\"%g\" cy=\"%g\" r=\".2\"/>", 4 + 70 * rand(), 4 + 50 * rand() }')" >cloud.svg
is "a cloud of dots needs nothing" "$(factor cloud.svg)" 1
svg 80 60 "$(awk 'BEGIN { for (x = 5; x < 70; x += .6) for (y = 5; y < 50; y += 3) printf "<path fill=\"#888\" stroke=\"none\" d=\"M%g %gh.6v.6h-.6z\"/>", x, y }')" >cells.svg
is "cells that adjoin are no markers" "$(factor cells.svg)" 1

# ---- what the choice goes by, and where it is told ----
is "another seed, the same factor" "$(factor -s 99 text-.8.svg)" "$(factor text-.8.svg)"
is "another resolution, the same factor" "$(factor -d 72 text-.8.svg)" "$(factor text-.8.svg)"
is "the factor that is asked for" "$(factor --reduction 1.75 text-.8.svg)" 1.75
is "none is asked for" "$(factor --reduction 1 text-.8.svg)" 1
for f in plan.svg thirty-six.svg chart.svg curve.svg hatching.svg barn.ps dragon.ps; do
    is "examples/$f has its true size" "$(factor "$ROOT/examples/$f")" 1
done
for f in 0.99 4.01 0 -1 small; do misused "--reduction $f" "reduction takes a number, 1 to 4" --reduction $f text-1.svg; done

# ---- the page ----
draws "reduced" -o r.png text-1.svg
draws "not reduced" --reduction 1 -o p.png text-1.svg
is "the picture keeps its pixels" "$(info r.png size)" "$(info p.png size)"
is "the picture keeps its resolution" "$(info r.png dpi)" "$(info p.png dpi)"
is "the picture tells the factor" "$(tr '\0' '=' <r.png | grep -aoE 'Plumbago-Reduction=[0-9.]+' | head -n 1)" "Plumbago-Reduction=$(factor text-1.svg)"
for f in pdf svg; do
    draws "reduced $f" -o r.$f text-1.svg
    draws "not reduced $f" --reduction 1 -o p.$f text-1.svg
done
is "SVG keeps its size" "$(grep -oE '(width|height|viewBox)="[^"]*"' r.svg | head -n 3)" "$(grep -oE '(width|height|viewBox)="[^"]*"' p.svg | head -n 3)"
is "PDF keeps its size" "$(grep -aoE '/MediaBox *\[[^]]*\]' r.pdf)" "$(grep -aoE '/MediaBox *\[[^]]*\]' p.pdf)"
is "the list is that of the drawing" "$("$PLUMBAGO" --dump=list -o - text-1.svg | cksum)" "$("$PLUMBAGO" --reduction 1 --dump=list -o - text-1.svg | cksum)"
# places FACTOR: where the strokes of a ruler begin and end.
places() { "$PLUMBAGO" --reduction "$1" --squiggle 0 --point blunt --dump=strokes -o - pairs-1.svg | awk '$1 == "stroke" { print $7, $8, $(NF - 1), $NF }' | sort; }
is "strokes lie on the page" "$(places 4)" "$(places 1)"

# A line is as much narrower as the sheet is larger, at any resolution; what is reduced is pressed harder, so that less ink than that is missing.
ink() { tool png_stats "$1" | awk '{ print 255 - $4 }'; }
for dpi in 300 96 30 10; do
    "$PLUMBAGO" --reduction 4 --squiggle 0 --point blunt -d $dpi -o four.png pairs-1.svg
    "$PLUMBAGO" --reduction 1 --squiggle 0 --point blunt -d $dpi -o one.png pairs-1.svg
    between "a quarter of the ink, made firmly, at $dpi dpi" .4 .6 "$(awk -v a="$(ink four.png)" -v b="$(ink one.png)" 'BEGIN { print a / b }')"
done

# ---- limits: what auto asks for is no reason to refuse a drawing ----
svg 84 60 "<path fill='#000' stroke='none' d='M4 20H80V58H4z'/>$(text hunhnu 5 10 .6)$(text nuhunh 5 15 .6)" >black.svg
metres=$("$PLUMBAGO" -v --reduction 1 --dump=strokes -o /dev/null black.svg 2>&1 | sed -nE 's/.* strokes, ([0-9.]+) m$/\1/p' | awk '{ print int(1.5 * $1 + 1) }')
plumbago --limit-length "$metres" -o black.png black.svg
is "auto gives way to the limit on length" $status 0
if grep -q 'the drawing is not reduced' "$TMP/err"; then ok "a warning says so"; else fail "a warning says so" "$(head -n 1 "$TMP/err")"; fi
refuses "a factor that is asked for does not" 'needs more than .* m of pencil line' --limit-length "$metres" --reduction 4 -o black-4.png black.svg
