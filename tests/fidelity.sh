# SPDX-License-Identifier: MIT
# Does a pencil drawing show what the print shows? Each drawing is drawn ruler-straight at 96 dpi and compared with what
# rsvg-convert (SVG), Ghostscript (PostScript) or pdftocairo (PDF) makes of it; tests/tools/drawing_compare.c tells how:
# lines and outlines of areas must have ink within 3 px and the other way round, areas must have the print's mean tone.
#
# Our own drawings must reach .97 both ways. Of those in ../shared/corpus every one that the reference draws must be
# drawn, with medians of at least .98 and none below .90. The table of all is $BUILD_DIR/fidelity.tsv; beside it, in
# $BUILD_DIR/fidelity/, lie contact sheets: the reference left, ours right, in the table's order, twelve to a sheet.
. "$ROOT/tests/check.sh"
table=$BUILD_DIR/fidelity.tsv
pictures=$BUILD_DIR/fidelity
rm -rf "$pictures"
mkdir -p "$pictures"
printf 'file\trecall\tprecision\ttone\tprint px\tarea px\tdrawing px\tsheet\twhat it says\n' >"$table"

# The page of a PostScript file, in points: X0 Y0 WIDTH HEIGHT. Ours says how large it is; where that is the size of the
# %%BoundingBox, the page is that box, else it starts at the origin.
page_of() {
    "$PLUMBAGO" -q --dump=list "$1" 2>/dev/null | awk -v box="$(LC_ALL=C tr '\r' '\n' <"$1" | grep -a '^%%BoundingBox: *[-0-9]' | head -n 1)" '
    $1 == "page" { w = $2 / 25.4 * 72; h = $3 / 25.4 * 72; sub(/^%%BoundingBox: */, "", box); split(box, b, " ")
        found = (b[3] - b[1] - w) ^ 2 < 9 && (b[4] - b[2] - h) ^ 2 < 9
        print found ? b[1] : 0, found ? b[2] : 0, w, h; exit }'
}

# reference FILE OUT.png [again]: `again` for a PostScript file that does not show its page itself.
reference() {
    local x y w h
    case $1 in
    *.svg) timeout 20 rsvg-convert -d 96 -p 96 "$1" -o "$2" ;;
    *.pdf) timeout 20 pdftocairo -png -r 96 -singlefile -f 1 -l 1 "$1" "${2%.png}" ;;
    *)
        read -r x y w h < <(page_of "$1")
        timeout 20 gs -q -dSAFER -dBATCH -dNOPAUSE -sDEVICE=png16m -r96 -dGraphicsAlphaBits=4 -dTextAlphaBits=4 -dFirstPage=1 -dLastPage=1 \
            -dFIXEDMEDIA -dDEVICEWIDTHPOINTS="$w" -dDEVICEHEIGHTPOINTS="$h" -sOutputFile="$2" \
            -c "<< /Install { $x neg $y neg translate } >> setpagedevice" -f "$1" ${3:+-c showpage}
        ;;
    esac >/dev/null 2>&1 && [ -s "$2" ]
}

# How dark the pencil can be: a black square's mean, drawn the same way.
darkest() {
    echo '<svg xmlns="http://www.w3.org/2000/svg" width="30mm" height="30mm" viewBox="0 0 30 30"><path d="M2 2H28V28H2Z"/></svg>' >black.svg
    "$PLUMBAGO" -q --squiggle 0 -d 96 -o black.png black.svg
    tool png_sheet middle.png -x 20,20,70,70 black.png
    tool png_stats middle.png | awk '{ print 1 - $4 / 255 }'
}

# put_on_sheet NAME REFERENCE OURS: the pair's sheet is in $sheet; a new one is begun when it is full.
pairs=()
put_on_sheet() {
    [ ${#pairs[@]} -ge 24 ] && finish_sheet
    [ ${#pairs[@]} -eq 0 ] && sheet=sheet-$((10#${sheet##*-} + 1))
    cp "$2" "$pictures/$1-reference.png" && cp "$3" "$pictures/$1-ours.png"
    pairs+=("$pictures/$1-reference.png" "$pictures/$1-ours.png")
}
finish_sheet() {
    [ ${#pairs[@]} -gt 0 ] && tool png_sheet "$pictures/$sheet.png" -c 2 -g 12 -m 1000 "${pairs[@]}"
    pairs=()
}

# measure FILE: draws and compares; a row of the table. Sets recall, precision; fails when the file is not drawn.
measure() {
    local file=$1 tone print areas drawing said flat
    name=$(basename "$(dirname "$file")")/$(basename "$file") flat=${1##*/}
    rm -f ref.png ours.png
    if ! reference "$file" ref.png && ! { [[ $file == *.*ps ]] && reference "$file" ref.png again; }; then
        printf '%s\tthe reference program fails\n' "$name" >>"$table"
        return 1
    fi
    if ! timeout 120 "$PLUMBAGO" --squiggle 0 -d 96 -o ours.png "$file" 2>"$TMP/err"; then
        printf '%s\tis not drawn: %s\n' "$name" "$(grep -v 'warning: ' "$TMP/err")" >>"$table"
        fail "$name is drawn" "$(grep -v 'warning: ' "$TMP/err" | cut -c 1-200)"
        return 1
    fi
    said=$(sed 's/^plumbago: warning: [^ ]*: //' "$TMP/err" | tr '\n' ';')
    read -r _ recall _ precision _ tone _ print _ areas _ drawing < <(tool drawing_compare ref.png ours.png "$black")
    put_on_sheet "$flat" ref.png ours.png
    printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$name" "$recall" "$precision" "$tone" "$print" "$areas" "$drawing" "$sheet" "$said" >>"$table"
    [ $((print + areas)) -gt 0 ] # a blank reference: nothing to judge by
}

at_least() { awk "BEGIN { exit !($1 >= $2) }"; }
median() { sort -n | awk '{ v[NR] = $1 } END { print NR ? (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 : 0 }'; }

# judge WHAT FILE...: drawings of ours.
judge_own() {
    local file
    for file in "$@"; do
        measure "$file" || continue
        if at_least "$recall" .97 && at_least "$precision" .97; then ok "$name"; else fail "$name" "recall $recall, precision $precision (at least .97 each)"; fi
    done
}

# judge_corpus FORMAT FILE...: others' drawings. Where the program says that it left something out, recall is not asked for.
judge_corpus() {
    local format=$1 file low='' r=() p=()
    shift
    for file in "$@"; do
        [ -f "$file" ] && measure "$file" || continue
        p+=("$precision")
        at_least "$precision" .90 || low+="$name: precision $precision"$'\n'
        grep -q ' left out\|ignored' "$TMP/err" && continue
        r+=("$recall")
        at_least "$recall" .90 || low+="$name: recall $recall"$'\n'
    done
    report "$format: no drawing of the corpus is below .90" "${low%$'\n'}"
    for kind in recall precision; do
        [ $kind = recall ] && m=$(printf '%s\n' "${r[@]}" | median) || m=$(printf '%s\n' "${p[@]}" | median)
        if at_least "$m" .98; then ok "$format: median $kind $m"; else fail "$format: median $kind" "$m, not .98"; fi
    done
}

sheet=sheet-0
black=$(darkest)
echo "the pencil's darkest area: $black"
judge_format() { # FORMAT PROGRAM PACKAGE ENDING...
    local format=$1 program=$2 package=$3 ending own=() others=()
    shift 3
    if ! command -v "$program" >/dev/null; then
        skip "$format against $program" "no $program here (Debian: $package)"
        return
    fi
    for ending in "$@"; do
        mapfile -t -O ${#own[@]} own < <(ls "$ROOT"/tests/image/*."$ending" 2>/dev/null)
        mapfile -t -O ${#others[@]} others < <(ls "$SHARED/corpus/$format"/*."$ending" 2>/dev/null)
    done
    judge_own "${own[@]}"
    if [ ${#others[@]} -gt 0 ]; then judge_corpus "$format" "${others[@]}"; else skip "$format of the corpus" "no corpus here"; fi
}
judge_format svg rsvg-convert librsvg2-bin svg
judge_format ps gs ghostscript eps ps mps
judge_format pdf pdftocairo poppler-utils pdf
finish_sheet
