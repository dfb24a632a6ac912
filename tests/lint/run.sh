# SPDX-License-Identifier: MIT
# clang-tidy and cppcheck over all C of src, tests and examples (`make lint`): what they look for, and why some of it is
# off, stands in clang-tidy.yaml and cppcheck.txt beside this. LINT_FILES= looks at some files alone.
. "$ROOT/tests/check.sh"
cd "$ROOT" || exit 1
here=tests/lint
mapfile -t ours < <(printf '%s\n' ${LINT_FILES:-$(find src -name "*.c") examples/*.c})
mapfile -t of_tests < <(printf '%s\n' ${LINT_FILES:-tests/*/*.c})
[ -z "${LINT_FILES:-}" ] || of_tests=()
flags=(-std=c17 -D_POSIX_C_SOURCE=200809L '-DPLB_LIBEXECDIR="/"' -Isrc -Isrc/api -Itests -Itests/fuzz)
read -ra libraries < <(pkg-config --cflags librsvg-2.0 cairo cairo-script libxml-2.0 fontconfig libpng zlib)
# Tests may do what the library may not: a check that fails goes on, so the analyzer follows paths on which nothing holds any
# more; bytes of doubles are compared because the same bits are meant; tools end with what they hold; the fuzzer of the
# options includes the tool whole; numbers of a developer's command line and rand() are good enough.
of_tests_off='-clang-analyzer-*,-bugprone-suspicious-memory-comparison,-cert-exp42-c,-cert-flp37-c,-bugprone-suspicious-include,-bugprone-not-null-terminated-result,-bugprone-unused-return-value,-cert-err34-c,-cert-msc30-c,-cert-msc50-cpp,-cert-env33-c'

# tidy NAME CHECKS FILE...: two at a time, four files each
tidy() {
    local name=$1 checks=$2 found
    shift 2
    found=$(printf '%s\0' "$@" | xargs -0 -P2 -n4 bash -c 'checks=$1 n=$2; shift 2; clang-tidy --quiet --config-file=tests/lint/clang-tidy.yaml --checks="$checks" "${@:n+1}" -- "${@:1:n}"' tidy \
        "$checks" $((${#flags[@]} + ${#libraries[@]})) "${flags[@]}" "${libraries[@]}" 2>/dev/null | grep -E '(error|warning): .*\[' | sort -u)
    report "$name" "$found"
}
if command -v clang-tidy >/dev/null; then
    tidy "clang-tidy finds nothing in ${#ours[@]} files of the program" '' "${ours[@]}"
    [ ${#of_tests[@]} -eq 0 ] || tidy "clang-tidy finds nothing in ${#of_tests[@]} files of the tests" "$of_tests_off" "${of_tests[@]}"
    printf 'int f(int *p) { return p ? 0 : *p; }\n' >"$TMP/wrong.c"
    if clang-tidy --quiet --config-file=$here/clang-tidy.yaml "$TMP/wrong.c" -- -std=c17 >"$TMP/out" 2>&1; then fail "clang-tidy finds a null pointer" "it says nothing"; else ok "clang-tidy finds a null pointer"; fi
else
    skip "clang-tidy" "not here (Debian: clang-tidy)"
fi
if command -v cppcheck >/dev/null; then
    check=(cppcheck --std=c11 --enable=warning,portability,performance --quiet --suppressions-list=$here/cppcheck.txt
        --template='{file}:{line}: {message} [{id}]' "${flags[@]:1}")
    report "cppcheck finds nothing" "$("${check[@]}" "${ours[@]}" "${of_tests[@]}" 2>&1 | grep '\[[A-Za-z]*\]$')"
    printf 'int f(void) { int a[2] = {0}; return a[2]; }\n' >"$TMP/wrong.c"
    report_of=$("${check[@]}" "$TMP/wrong.c" 2>&1)
    case $report_of in *arrayIndex*) ok "cppcheck finds an index out of bounds" ;; *) fail "cppcheck finds an index out of bounds" "it says: $report_of" ;; esac
else
    skip "cppcheck" "not here (Debian: cppcheck)"
fi
