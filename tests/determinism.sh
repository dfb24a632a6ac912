# SPDX-License-Identifier: MIT
# The same input, options and seed give the same bytes: twice, from a pipe, in another place, at another time, by
# another compiler at another level of optimisation. And what is random in a line hangs on that line alone. LONG=1: more
# drawings and options, more builds, and each build with every number of threads, locale and time zone.
. "$ROOT/tests/check.sh"
example a.svg
cp "$ROOT/tests/image/program.eps" b.eps
cp "$ROOT/tests/image/curves.svg" c.svg
names="a.svg b.eps c.svg"
if [ -n "${LONG:-}" ]; then
    for name in solids gradients lettering dashes; do cp "$ROOT/tests/image/$name.svg" . && names="$names $name.svg"; done
    cp "$ROOT/tests/stage/plan.dxf" . && names="$names plan.dxf"
fi
draw() { # DIRECTORY PROGRAM ARGS...: draws them all
    local into=$1 program=$2 name
    shift 2
    mkdir -p "$into"
    for name in $names; do "$program" "$@" -o "$into/${name%.*}.png" $name 2>>"$TMP/err" || echo "exit status $? for $name" >"$into/failed"; done
}
alike() { # NAME DIRECTORY [REFERENCE]
    local said
    if said=$(diff -r "$2" "${3:-ref}" 2>&1); then ok "$1"; else fail "$1" "$(tr '\n' ';' <<<"$said" | cut -c 1-200)"; fi
}
draw ref "$PLUMBAGO"
if [ -e ref/failed ]; then fail "the drawings are drawn" "$(cat ref/failed)"; else ok "the drawings are drawn"; fi
draw twice "$PLUMBAGO" && alike "twice" twice
mkdir piped && for name in $names; do "$PLUMBAGO" <$name >piped/${name%.*}.png 2>>"$TMP/err"; done
alike "from standard input" piped
(export MALLOC_PERTURB_=165 && draw perturbed "$PLUMBAGO") && alike "memory filled with another byte" perturbed
(ulimit -s 16384 2>/dev/null; export PADDING="$(printf 'x%.0s' {1..5000})" && draw stack "$PLUMBAGO") && alike "another stack and environment" stack
mkdir -p far/away && cp $names far/away && (cd far/away && draw named "$PLUMBAGO") && alike "another directory" far/away/named
cp a.svg "another name.svg" && "$PLUMBAGO" -o renamed.png "another name.svg" 2>>"$TMP/err"
same "another file name" renamed.png ref/a.png
command -v taskset >/dev/null && { taskset -c 0 "$PLUMBAGO" -o one-core.png a.svg 2>>"$TMP/err"; same "on one core" one-core.png ref/a.png; }
"$PLUMBAGO" -s 2 -o seed2.png a.svg 2>>"$TMP/err"
differ "another seed: another drawing" seed2.png ref/a.png
draw spring "$PLUMBAGO" --arm spring && draw spring2 "$PLUMBAGO" --arm spring && alike "the other arm, twice" spring spring2

# ---- an added line leaves the rest alone ----
sed 's|</g>|<path d="M10 24.5 L17 24.5"/></g>|' a.svg >added.svg
"$PLUMBAGO" -o added.png added.svg 2>>"$TMP/err"
# The line's box at 300 dpi with 1.5 mm around it.
if said=$(tool png_compare ref/a.png added.png 100 272 219 307); then ok "an added line changes nothing elsewhere"; else fail "an added line changes nothing elsewhere" "$said"; fi
if tool png_compare ref/a.png added.png >/dev/null; then fail "the added line is there" "the pictures are the same"; else ok "the added line is there"; fi
tac_group=$(sed -n '/<rect/p; /<path d="M4/p; /<circle/p; /<path d="M8/p' a.svg | tac)
{ sed '/<rect/,$d' a.svg; echo "$tac_group"; echo '</g></svg>'; } >reversed.svg
"$PLUMBAGO" -o reversed.png reversed.svg 2>>"$TMP/err"
if said=$(tool png_compare ref/a.png reversed.png); then
    ok "the order of the lines changes nothing"
else
    # Where lines cross, graphite lies on graphite: the sum may be rounded in another order.
    if awk '{ exit !($4 <= 2) }' <<<"$said"; then ok "the order of the lines changes nothing but rounding"; else fail "the order of the lines changes nothing" "$said"; fi
fi
# ---- two equal lines in two places are not alike ----
printf '<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="30mm" viewBox="0 0 40 30"><path d="M5 10H35M5 20H35" stroke="#000" stroke-width=".4"/></svg>' >twins.svg
printf '<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="30mm" viewBox="0 0 40 30"><path d="M5 20H35M5 20H35" stroke="#000" stroke-width=".4"/></svg>' >double.svg
printf '<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="30mm" viewBox="0 0 40 30"><path d="M5 20H35" stroke="#000" stroke-width=".4"/></svg>' >single.svg
for name in twins double single; do "$PLUMBAGO" -d 254 -o $name.png $name.svg 2>>"$TMP/err"; done
if tool png_compare double.png single.png >/dev/null; then ok "a line that a file holds twice is drawn once"; else fail "a line that a file holds twice is drawn once" "the pictures differ"; fi

# ---- threads, locales, time zones, builds ----
# A locale with a decimal comma is made for the test where the system has none.
locales=C.UTF-8
if LC_ALL=de_DE.UTF-8 locale decimal_point 2>/dev/null | grep -q ,; then
    locales="$locales de_DE.UTF-8"
elif command -v localedef >/dev/null && mkdir locales && localedef -i de_DE -f UTF-8 "$PWD/locales/de_DE.UTF-8" 2>/dev/null; then
    export LOCPATH=$PWD/locales
    locales="$locales de_DE.UTF-8"
else
    skip "a decimal comma" "no localedef, or no source of de_DE (Debian: locales)"
fi

# matrix NAME PROGRAM ARGS...: 1, 2 and 8 threads in each of these locales, in two time zones by turns (LONG=1: in both), against
# what one run made in the C locale
matrix() {
    local name=$1 threads locale zone turn=0 zones=(Pacific/Auckland America/St_Johns) these
    shift
    for threads in 1 2 8; do
        turn=$((1 - turn))
        for locale in $locales; do
            turn=$((1 - turn))
            these=("${zones[turn]}")
            [ -z "${LONG:-}" ] || these=("${zones[@]}")
            for zone in "${these[@]}"; do
                rm -rf cell
                (export LC_ALL=$locale LANGUAGE=de TZ=$zone && draw cell "$@" --threads $threads)
                alike "$name, $threads threads, $locale, $zone" cell
            done
        done
    done
}
matrix "this build" "$PLUMBAGO"

# The library in a program that has set its locale: the programs never do.
in_locale() { # LOCALE THREADS DIRECTORY: what it says is the decimal point
    mkdir "$3" && (cd "$3" && LC_ALL=$1 "$BUILD_DIR/tests/tools/in_locale" "$BUILD_DIR" ../c.svg "$2" c.png c.pdf c.txt 2>>"$TMP/err")
}
is "the library in a program in the C locale" "$(in_locale C 1 host-C)" .
same "it draws as the program does" host-C/c.png ref/c.png
for locale in $locales; do
    case $locale in de_*) point=, ;; *) point=. ;; esac
    is "the library in a program in $locale" "$(in_locale $locale 2 host-$locale)" $point
    alike "the library in a program in $locale draws the same" host-$locale host-C
done

case $BUILD_DIR in
*/cover* | */asan* | */ubsan* | */tsan*) skip "other builds" "not from an instrumented build" ;;
*)
    unset MAKEFLAGS MAKELEVEL MFLAGS BUILD CC CFLAGS SUFFIX
    build() { # NAME MAKE-VARIABLES...
        local name=$1 folder
        shift
        folder=build/release
        for word; do case $word in BUILD=*) folder=build/${word#BUILD=} ;; SUFFIX=*) folder=$folder${word#SUFFIX=} ;; esac; done
        if ! make -s -C "$ROOT" -j2 "$@" "$folder/plumbago" "$folder/tap-svg" "$folder/tap-plain" "$folder/tap-ps" "$folder/tap-model" "$folder/tap-dxf" >"$TMP/make" 2>&1; then
            fail "$name" "it does not build: $(grep -m 1 -E 'error|Error' "$TMP/make")"
        elif [ -n "${LONG:-}" ]; then
            matrix "$name" "$ROOT/$folder/plumbago"
        else
            rm -rf other && draw other "$ROOT/$folder/plumbago" && alike "$name" other
        fi
    }
    # This build is left alone: other tests are using it.
    plain=
    make -s -q -C "$ROOT" CC=gcc build/release/flags 2>/dev/null || plain=SUFFIX=-gcc
    build "gcc -O2" BUILD=release $plain
    build "gcc -O0" BUILD=debug
    [ -z "${LONG:-}" ] || build "gcc -O3" BUILD=release SUFFIX=-O3 CFLAGS=-O3
    if command -v clang >/dev/null; then
        build "clang -O2" BUILD=release SUFFIX=-clang CC=clang
        [ -z "${LONG:-}" ] || build "clang -O0" BUILD=debug SUFFIX=-clang CC=clang
        [ -z "${LONG:-}" ] || build "clang -O3" BUILD=release SUFFIX=-clang-O3 CC=clang CFLAGS=-O3
    else
        skip "clang" "no clang here"
    fi
    if [ -n "${LONG:-}" ] && [ "$(uname -m)" = x86_64 ]; then
        build "gcc -O3 for this machine's own processor" BUILD=release SUFFIX=-native "CFLAGS=-O3 -march=native"
    fi
    ;;
esac
