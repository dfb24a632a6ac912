# SPDX-License-Identifier: MIT
# The inputs that fuzzers were started from, and those that once broke something, through the same harnesses.
. "$ROOT/tests/check.sh"
for harness in "$ROOT"/tests/fuzz/fuzz_*.c; do
    name=${harness##*/fuzz_} && name=${name%.c}
    files=("$ROOT/tests/fuzz/corpus-$name"/*)
    [ "$name" = profile ] && files+=("$ROOT/profiles/6B.pencil")
    for file in "${files[@]}"; do
        if timeout 60 "$BUILD_DIR/tests/fuzz/fuzz_$name" "$file" >"$TMP/out" 2>"$TMP/err"; then
            ok "$name: ${file##*/}"
        else
            fail "$name: ${file##*/}" "exit status $?: $(grep -m 1 -E 'ERROR|runtime error|Abort' "$TMP/err" | cut -c 1-200)"
        fi
    done
done
# DXF is read by a Python program, so its fuzzer is one.
if /usr/bin/python3 -c 'import ezdxf' 2>/dev/null; then
    "$ROOT/tests/fuzz/fuzz_dxf.py" "$ROOT/src/tap/dxf/tap_dxf.py" replay "$ROOT"/tests/fuzz/corpus-dxf/* "$ROOT"/tests/stage/*.dxf
else
    skip "dxf" "no python3-ezdxf here"
fi
