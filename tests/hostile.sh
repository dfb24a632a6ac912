# SPDX-License-Identifier: MIT
# Files made to do harm: each is drawn or refused within 10 seconds of processor time and 1 GiB, those of all processes together, with
# one line when refused, and nothing but the output is written. With strace, also: no file is opened but the input, the output and what the system's
# libraries need. Runs over tests/bad and, where it is, the hostile part of the corpus.
. "$ROOT/tests/check.sh"
secret="BAIT-$$-do-not-read"

# Files that a drawing might ask for, beside the input.
bait() {
    rm -rf cage && mkdir cage && cd cage || exit 1
    local bait
    for bait in secret.txt secret.svg secret.png secret.ps data.dat; do echo "$secret" >$bait; done
    cp -r "$1" "$2"
    find . -type f -printf '%P %s %T@\n' | sort >../before
}
unbait() { cd ..; }

# judged NAME INPUT CODE: the result of one run in the cage.
judge() {
    local name=$1 code=$2 changed
    rm -f out.moved && [ -e out.png ] && mv out.png ../out.png
    changed=$(find . -type f -printf '%P %s %T@\n' | sort | diff ../before - | grep '^[<>]')
    if [ "$code" != 0 ] && [ "$code" != 1 ]; then
        fail "$name" "exit status $code: $(head -n 1 "$TMP/err" | cut -c 1-200)"
    elif [ "$code" -eq 1 ] && [ "$(grep -vc ': warning: ' "$TMP/err")" -ne 1 ]; then
        fail "$name" "$(wc -l <"$TMP/err") lines on standard error, not 1: $(head -n 2 "$TMP/err" | tr '\n' '|' | cut -c 1-300)"
    elif [ "$code" -eq 1 ] && ! tail -n 1 "$TMP/err" | grep -q '^plumbago: .'; then
        fail "$name" "the message is: $(head -n 1 "$TMP/err")"
    elif [ "$(wc -l <"$TMP/err")" -gt 5 ]; then
        fail "$name" "$(wc -l <"$TMP/err") lines on standard error"
    elif LC_ALL=C grep -q '[^[:print:][:space:]]' "$TMP/err"; then
        fail "$name" "control bytes in the message"
    elif [ "$code" -eq 1 ] && [ -e ../out.png ]; then
        fail "$name" "refused, yet there is an output"
    elif [ "$code" -eq 0 ] && ! tool png_info ../out.png >/dev/null 2>&1; then
        fail "$name" "drawn, but the output is not a valid PNG"
    elif [ -n "$changed" ]; then
        fail "$name" "files have changed: $(tr '\n' ' ' <<<"$changed")"
    elif ! awk -v s=$seconds '{ exit !($1 == "cpu" && $2 <= s) }' ../cost; then
        fail "$name" "more than $seconds s of processor time: $(cat ../cost)"
    elif [ -n "$limited" ] && ! awk '{ exit !($5 == "peak" && $6 > 0 && $6 <= 1048576) }' ../cost; then
        fail "$name" "more than 1 GiB: $(cat ../cost)"
    else
        ok "$name: $([ "$code" -eq 0 ] && echo drawn || cut -d: -f 2- "$TMP/err" | tail -n 1 | cut -c 1-120)"
    fi
    rm -f ../out.png
}

# These files may be opened: the system's libraries, fonts and settings, Ghostscript's own, the programs themselves.
allowed='^(/lib|/lib64|/usr/lib|/usr/local/lib|/usr/local/share|/usr/share/(matplotlib|fonts|fontconfig|X11|locale|mime|glib-2.0|icu|zoneinfo|ghostscript|poppler|color|xml|icons|themes)|/usr/local/share/fonts|/etc/(matplotlibrc|ld\.so|fonts|ghostscript|paper|localtime|locale|pango|nsswitch|passwd|xml|ssl)|/var/(cache/fontconfig|lib/ghostscript)|/proc/(self|meminfo|cpuinfo|sys|filesystems|[0-9]+/)|/sys/|/dev/(null|urandom|random|tty|shm)|/usr/bin/|/bin/)'
# The calls of ../trace, each with its result: one that another process's call interrupted stands in two parts. Those of the
# first process are the measuring program's.
calls() {
    awk 'NR == 1 { first = $1 }
        $1 == first { next }
        / <unfinished \.\.\.>$/ { sub(/ <unfinished \.\.\.>$/, ""); begun[$1] = $0; next }
        match($0, /<\.\.\. [a-z0-9]+ resumed>/) { print begun[$1] substr($0, RSTART + RLENGTH); delete begun[$1]; next }
        { print }
        END { for (p in begun) print begun[p] " = -1 killed in it" }' ../trace
}
# Lists the files that the run in ../trace has opened with success, besides that and its own input, output and temporary files.
judge_trace() { # NAME INPUT
    local opened
    opened=$(calls | grep -v ' = -1 \|O_PATH' | grep -oE '"[^"]+"' | tr -d '"' | sort -u |
        grep -vE "$allowed" | grep -vE "^($BUILD_DIR/|\./)?(plumbago|tap-svg|tap-plain|tap-ps|tap-model|tap-assimp|tap-dxf)\$" | grep -vE "(^|/)(\.?out\.png[^/]*|$2)\$" |
        grep -vE "^(${HOME:-/root}/\.(cache|config|fonts|local)|(/tmp/)?gs_[A-Za-z0-9]{6}\$|/tmp/(fontconfig|plumbago)|\.\$|/\$|/tmp\$|${PWD}\$)" | grep -vE "^$BUILD_DIR\$")
    calls | grep -q "open.*\"$2\".* = [0-9]" || opened="$opened (and the trace does not show the input opened)"
    report "$1 opens nothing it should not" "$opened"
    if grep -q 'connect(.*AF_INET' ../trace; then fail "$1 stays off the network" "$(grep -m 1 AF_INET ../trace)"; fi
}

# By the clock it may take twelve times as long: the machine may be busy.
attack() {
    local file=$1 name input=${1##*/} code
    name=$(basename "$(dirname "$file")")/$input
    bait "$file" "$input"
    $strace "$BUILD_DIR/tests/tools/measure" --together timeout -k 1 $((12 * seconds)) "$PLUMBAGO" -o out.png "$input" >../cost 2>"$TMP/err"
    code=$(sed -n 's/.* status //p' ../cost)
    judge "$name" $code
    [ -n "$strace" ] && judge_trace "$name" "$input"
    unbait
}

limited=yes strace='' seconds=10
case $BUILD_DIR in */release*) ;; *) seconds=60 ;; esac # a build for diagnosis is slower by as much
case $BUILD_DIR in
*asan* | *tsan*) limited= ;; # it reserves more addresses than that; and its leak check does not work when traced
*)
    command -v strace >/dev/null && strace -f --seccomp-bpf -o /dev/null true 2>/dev/null &&
        strace="strace -f --seccomp-bpf -qq -e trace=open,openat,creat,unlink,unlinkat,rename,renameat,renameat2,symlink,link,connect -o ../trace"
    [ -n "$strace" ] || skip "what is opened" "no strace here, or it may not trace (Debian: strace)"
    ;;
esac
for file in "$ROOT"/tests/bad/*; do [ -e "$file" ] && attack "$file"; done
if [ -d "$SHARED/corpus/hostile" ]; then
    for file in "$SHARED"/corpus/hostile/*; do attack "$file"; done
else
    skip "the hostile part of the corpus" "no corpus here"
fi
