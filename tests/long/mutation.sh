# SPDX-License-Identifier: MIT
# The whole program on changed drawings of every format (tests/fuzz/whole.py). SECONDS_EACH=N: how long.
files=("$ROOT"/tests/image/*.svg "$ROOT"/tests/image/*.eps "$ROOT"/tests/stage/*.dxf "$ROOT"/tests/stage/*.ps "$ROOT"/tests/stage/*.list)
[ -x /usr/bin/python3 ] || { skip "changed drawings" "no python3 here"; exit 0; }
check "changed drawings of every format" "$ROOT/tests/fuzz/whole.py" "$PLUMBAGO" "${SECONDS_EACH:-600}" 1 "$TMP/mutated" "${files[@]}"
