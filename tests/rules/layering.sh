# SPDX-License-Identifier: MIT
# Who may include whom, and who may call what. The table is the project's shape: data moves one way, through small
# types, so each folder can be read (and replaced) alone.
. "$ROOT/tests/check.sh"
cd "$ROOT/src" || exit 1

# FOLDER: the folders (or single headers) it may include. stroke and surface meet only in base/patch.h; a planned stroke
# lies in list/stroke_list.h. A tap is a program of its own. What is not listed is not allowed.
allowed() {
    case $1 in
    base) echo base ;;
    system) echo base system ;;
    list) echo base list ;;
    profile) echo base system profile ;;
    input) echo base system list input ;;
    plan) echo base system list profile plan ;;
    stroke) echo base list profile stroke ;;
    surface) echo base system list profile surface ;;
    film) echo base system list profile stroke surface film ;;
    api) echo base system list profile input plan stroke surface film api ;;
    tool) echo api/plumbago.h tool ;;
    web) echo base system list profile input api web ;;
    tap) echo base list tap ;;
    *) echo none ;;
    esac
}

# Lines "FILE:LINE:HEADER" of every #include "HEADER".
ours=$(grep -nHE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' $(find . -name '*.[ch]' | sed 's|^./||') | sed -E 's/^([^:]*:[0-9]+):[^"]*"([^"]*)".*/\1:\2/')
theirs=$(grep -nHE '^[[:space:]]*#[[:space:]]*include[[:space:]]*<' $(find . -name '*.[ch]' | sed 's|^./||') | sed -E 's/^([^:]*:[0-9]+):[^<]*<([^>]*)>.*/\1:\2/')

check_table() {
    local file line header folder
    local -A table
    for folder in */; do table[${folder%/}]=" $(allowed "${folder%/}") "; done
    while IFS=: read -r file line header; do
        [ -n "$file" ] || continue
        [ -f "$header" ] || { echo "src/$file:$line: \"$header\" is not written as folder/header.h, or not there"; continue; }
        case ${table[${file%%/*}]} in
        *" ${header%%/*} "* | *" $header "*) ;;
        *) echo "src/$file:$line: ${file%%/*} may not include $header" ;;
        esac
    done <<<"$ours"
}
report "includes follow the table of layers" "$(check_table)"

# A tap is a folder; what two taps need lies in tap/common.
other_taps=$(sed -nE 's#^tap/([^/]*)/(.*):tap/([^/]*)/(.*)#\1 \3 src/tap/\1/\2 may not include tap/\3/\4#p' <<<"$ours" | awk '$2 != "common" && $1 != $2 { print substr($0, length($1 " " $2) + 2) }')
report "no tap includes the folder of another" "$other_taps"

folders=$(for d in */; do [ "$(allowed "${d%/}")" = none ] && echo "src/$d is in no layer"; done)
report "every folder has its place in the table" "$folders"

# tsort finds a cycle among the headers, if there is one.
cycle=$(awk -F: '$1 ~ /\.h$/ { print $1, $3 }' <<<"$ours" | tsort 2>&1 >/dev/null)
report "no include cycle" "$cycle"

# only HEADER-PATTERN FOLDER...: no other folder includes such a header.
only() {
    local pattern=$1 file line header
    shift
    while IFS=: read -r file line header; do
        [[ $header =~ $pattern ]] || continue
        case " $* " in *" ${file%%/*} "*) ;; *) echo "src/$file:$line: <$header> belongs in: $*" ;; esac
    done <<<"$theirs"
}
report "cairo only in surface, api and the tap" "$(only '^cairo' surface api tap)"
report "librsvg, GLib and libxml only in the tap" "$(only '^(librsvg|glib|gio|libxml)' tap)"
report "libpng only in surface and profile" "$(only '^png\.h' surface profile)"
report "no clock, process or signal where the science is" "$(only '^(time|signal|unistd|pthread|sys/.*)\.h' base system input profile surface film api tool tap web)"

[ -f "$BUILD_DIR/libplumbago.a" ] || { fail "the library is built" "no $BUILD_DIR/libplumbago.a"; exit; }

# The compiled library calls only what it may. In its own code it neither prints, exits, reads the environment nor asks the time or a
# locale; _exit is for the child of a fork only. (stdout: "-" as an output file; snprintf and fprintf to a
# file that was passed in are fine.)
banned='printf|__printf_chk|vprintf|__vprintf_chk|puts|putchar|perror|stderr|exit|abort|getenv|secure_getenv|setlocale|newlocale|time|clock|rand|srand|random|srandom|drand48|system|popen|strtod|strtof|strtold|atof|sscanf|__isoc99_sscanf|scanf|__isoc99_scanf|gets|strtok|tmpnam|mktemp|localtime|asctime|ctime'
case $BUILD_DIR in
*asan* | *ubsan* | *tsan* | *cover*) skip "the library calls nothing it must not" "an instrumented build calls what its instruments need" ;;
*)
    called=$(nm -u -A "$BUILD_DIR/libplumbago.a" 2>/dev/null | awk '{ sub(/^[^:]*:/, "", $1); print $1, $NF }' | sed 's/@.*//' | grep -E " ($banned)\$" | sed 's/: / calls /')
    report "the library calls nothing it must not" "$called"
    ;;
esac

# State: nothing writable at file scope. Constant tables of pointers lie in .data.rel.ro, which the loader seals.
state=$(objdump -t "$BUILD_DIR/libplumbago.a" 2>/dev/null | awk '
    /:[[:space:]]+file format/ { object = $1; sub(/:$/, "", object) }
    NF > 3 && object != "pencils.o" && $(NF - 2) ~ /^(\.data|\.bss|\.tdata|\.tbss|\*COM\*)/ && $(NF - 2) !~ /^\.data\.rel\.ro/ && $(NF - 1) ~ /[1-9a-f]/ && $NF !~ /^(\.|__gcov|__asan|__ubsan|__odr_asan|__lsan|__tsan|\.L)/ { print object ": " $NF " in " $(NF - 2) }')
case $BUILD_DIR in
*asan* | *ubsan* | *tsan* | *cover*) skip "the library has no writable state" "an instrumented build has its own" ;;
*) report "the library has no writable state" "$state" ;;
esac

# A file that tests and trials leave behind where they were started has once been committed with a change.
allowed_at_top=' .ci .clang-format .editorconfig .gitignore CONTRIBUTING.md LICENSE Makefile NEWS.md README.md examples man profiles src tests '
others=$(git -C "$ROOT" ls-files 2>/dev/null | sed 's#/.*##' | sort -u | while read -r name; do [[ $allowed_at_top == *" $name "* ]] || echo "$name"; done)
report "nothing else lies at the top" "$others"
