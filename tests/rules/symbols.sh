# SPDX-License-Identifier: MIT
# The library takes no name from the programs that link it, and the installed header none but plb_ and PLB_.
. "$ROOT/tests/check.sh"
foreign=$(nm -g --defined-only "$BUILD_DIR/libplumbago.a" 2>/dev/null | awk 'NF == 3 { print $3 }' | grep -vE '^(plb_|_binary_|__gcov|__odr_asan|__llvm)' | sort -u)
report "all external symbols begin with plb_" "$foreign"
public=$(nm -g --defined-only "$BUILD_DIR/libplumbago.a" 2>/dev/null | grep -c ' T plb_')
if [ "$public" -gt 20 ]; then ok "the library has its functions"; else fail "the library has its functions" "only $public"; fi
missing=$(grep -oE '\bplb_[a-z_]+\(' "$ROOT/src/api/plumbago.h" | tr -d '(' | sort -u |
    while read -r name; do nm -g --defined-only "$BUILD_DIR/libplumbago.a" 2>/dev/null | grep -q " T $name\$" || echo "$name is declared but not there"; done)
report "every function of plumbago.h is in the library" "$missing"
macros=$(grep -nE '^[[:space:]]*#[[:space:]]*define' "$ROOT/src/api/plumbago.h" | grep -vE 'define (PLB_|PLUMBAGO_H)')
report "plumbago.h defines no macro of another name" "$macros"
twice=$(nm -g --defined-only "$BUILD_DIR/libplumbago.a" 2>/dev/null | awk 'NF == 3 && $2 ~ /[TDBR]/ { print $3 }' | sort | uniq -d)
report "no name is defined twice" "$twice"
