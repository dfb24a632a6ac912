# SPDX-License-Identifier: MIT
# Does a pencil line lie where the drawing says? Each drawing is drawn ruler-straight at 96 dpi and compared with what
# rsvg-convert (SVG), pdftocairo (PDF) or Ghostscript (PostScript) makes of it: ink within 3 px both ways, for at least 97 % of the ink.
#
# That holds for drawings made of lines. A fill is drawn as its outline, so the inside of a dark area is no ink of ours;
# a light area painted over lines hides them in print, and need not for a hand. Drawings with such fills (by the display
# list: a fill darker than .95, or a lighter one that is opaque and comes after the first line), with images only or
# with a line wider than 2 mm are measured too, but only those without must pass; where the program says that it left
# text out, only our ink is asked to lie where the reference has some. The table of all is $BUILD_DIR/fidelity.tsv.
. "$ROOT/tests/check.sh"
table=$BUILD_DIR/fidelity.tsv
printf 'file\tclass\trecall\tprecision\tmean\tink of reference\tink of ours\n' >"$table"

# What a display list (from standard input) is made of: lines, areas, covers, wide, or nothing.
class_of() {
    awk '
    $1 == "clip" || $1 == "list" { next }
    { r = $4; g = $5; b = $6; a = $7; light = 1 - (1 - (.299 * r + .587 * g + .114 * b)) * a }
    $1 == "fill" && light < .95 { areas++ }
    $1 == "fill" && light >= .95 && a > .5 && lines { covers++ }
    $1 == "stroke" && light < .95 { lines++; if ($9 > 2) wide++ }
    END { print areas ? "areas" : covers ? "covers" : wide ? "wide" : lines ? "lines" : "nothing" }'
}

# The page of a PostScript file, in points: X0 Y0 WIDTH HEIGHT. Ours says how large it is; where that is the size of the
# %%BoundingBox, the page is that box, else it starts at the origin.
page_of() {
    "$PLUMBAGO" -q --dump=list "$1" 2>/dev/null | awk -v box="$(LC_ALL=C grep -a '^%%BoundingBox: *[-0-9]' "$1" | head -n 1 | tr -d '\r')" '
    NR == 1 { w = $2 / 25.4 * 72; h = $3 / 25.4 * 72; split(box, b, " ")
        found = (b[4] - b[2] - w) ^ 2 < 9 && (b[5] - b[3] - h) ^ 2 < 9
        print found ? b[2] : 0, found ? b[3] : 0, w, h; exit }'
}

# reference FILE OUT.png
reference() {
    local x y w h
    case $1 in
    *.svg) timeout 20 rsvg-convert -d 96 -p 96 "$1" -o "$2" ;;
    *.pdf) timeout 20 pdftocairo -png -r 96 -singlefile "$1" "${2%.png}" ;;
    *)
        read -r x y w h < <(page_of "$1")
        timeout 20 gs -q -dSAFER -dBATCH -dNOPAUSE -sDEVICE=pnggray -r96 -dGraphicsAlphaBits=4 -dFirstPage=1 -dLastPage=1 -dFIXEDMEDIA \
            -dDEVICEWIDTHPOINTS="$w" -dDEVICEHEIGHTPOINTS="$h" -sOutputFile="$2" -c "<< /Install { $x neg $y neg translate } >> setpagedevice" -f "$1"
        ;;
    esac >/dev/null 2>&1 && [ -s "$2" ]
}

# measure FILE MUST: MUST is `must` for our own drawings, whatever they are made of.
measure() {
    local file=$1 name class code line recall precision mean ink_a ink_b
    name=$(basename "$(dirname "$file")")/$(basename "$file")
    rm -f ref.png ours.png
    if ! reference "$file" ref.png; then
        printf '%s\treference fails\n' "$name" >>"$table"
        return
    fi
    timeout 120 "$PLUMBAGO" --squiggle 0 -d 96 -o ours.png "$file" 2>"$TMP/err"
    code=$?
    if [ $code -ne 0 ]; then
        printf '%s\twe fail: exit status %s %s\n' "$name" $code "$(grep -v 'warning: ' "$TMP/err")" >>"$table"
        fail "$name" "it is not drawn: exit status $code $(grep -v 'warning: ' "$TMP/err" | cut -c 1-200)"
        return
    fi
    class=$("$PLUMBAGO" -q --dump=list "$file" 2>/dev/null | class_of)
    # A blank page is judged, too, unless there is nothing but images: something would be missing.
    [ "$class" = nothing ] && ! LC_ALL=C grep -qaE '<image|\b(color)?image\b|%%BeginPhotoshop' "$file" && class=lines
    # Where text was left out (the program says so), what is drawn must lie right still.
    grep -q 'text.* left out' "$TMP/err" && { [ "$class" = lines ] || [ "$class" = nothing ]; } && class=text
    read -r _ recall _ precision _ mean _ ink_a ink_b < <(tool ink_compare ref.png ours.png 3)
    printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$name" "$class" "$recall" "$precision" "$mean" "$ink_a" "$ink_b" >>"$table"
    [ "$ink_a" -eq 0 ] && [ "$2" = may ] && return # the reference is blank: nothing to judge by
    case $class:$2 in
    lines:* | *:must) line="recall $recall, precision $precision" ;;
    text:*) [ "$ink_b" -gt 0 ] || return
        line="precision $precision, text left out" recall=$precision ;;
    *) return ;;
    esac
    counted=$((counted + 1))
    if awk "BEGIN { exit !($recall >= .97 && $precision >= .97) }"; then
        ok "$name: $line"
    else
        fail "$name" "$line (at least .97 each)"
        mkdir -p "$BUILD_DIR/fidelity" && cp ref.png "$BUILD_DIR/fidelity/${name//\//-}-reference.png" && cp ours.png "$BUILD_DIR/fidelity/${name//\//-}-ours.png"
    fi
}

counted=0
rm -rf "$BUILD_DIR/fidelity"
if command -v rsvg-convert >/dev/null; then
    for file in "$ROOT"/tests/image/*.svg; do measure "$file" must; done
    is "our own SVG drawings are made of lines" $counted "$(find "$ROOT"/tests/image -name '*.svg' | wc -l)"
    counted=0
    if [ -d "$SHARED/corpus/svg" ]; then
        for file in "$SHARED"/corpus/svg/*.svg; do measure "$file" may; done
        if [ $counted -ge 10 ]; then ok "$counted SVG drawings of the corpus are made of lines"; else fail "enough SVG drawings to judge by" "only $counted are made of lines"; fi
    else
        skip "SVG drawings of the corpus" "no corpus here"
    fi
else
    skip "SVG against rsvg-convert" "no rsvg-convert here (Debian: librsvg2-bin)"
fi
counted=0
if command -v gs >/dev/null; then
    for file in "$ROOT"/tests/image/*.eps; do measure "$file" must; done
    is "our own PostScript drawings are made of lines" $counted "$(find "$ROOT"/tests/image -name '*.eps' | wc -l)"
    counted=0
    if [ -d "$SHARED/corpus/ps" ]; then
        for file in "$SHARED"/corpus/ps/*.{eps,ps,mps}; do measure "$file" may; done
        if [ $counted -ge 6 ]; then ok "$counted PostScript drawings of the corpus are made of lines"; else fail "enough PostScript drawings to judge by" "only $counted are made of lines"; fi
    else
        skip "PostScript drawings of the corpus" "no corpus here"
    fi
else
    skip "PostScript against Ghostscript" "no gs here (Debian: ghostscript)"
fi
if [ -d "$SHARED/corpus/pdf" ]; then
    if command -v pdftocairo >/dev/null; then
        for file in "$SHARED"/corpus/pdf/*.pdf; do measure "$file" may; done
        is "every PDF of the corpus draws" "$(grep -c '^pdf/.*\.pdf	.*[0-9]$' "$table")" "$(find "$SHARED/corpus/pdf" -name '*.pdf' | wc -l)"
    else
        skip "PDF against pdftocairo" "no pdftocairo here (Debian: poppler-utils)"
    fi
fi
