# SPDX-License-Identifier: MIT
# The library takes no name from the programs that link it, and the installed header none but plb_ and PLB_.
. "$ROOT/tests/check.sh"
nm -g --defined-only "$BUILD_DIR/libplumbago.a" >names 2>/dev/null
foreign=$(awk 'NF == 3 { print $3 }' names | grep -vE '^(plb_|_binary_|__gcov|__odr_asan|__llvm)' | sort -u)
report "all external symbols begin with plb_" "$foreign"
public=$(grep -c ' T plb_' names)
if [ "$public" -gt 20 ]; then ok "the library has its functions"; else fail "the library has its functions" "only $public"; fi
missing=$(grep -oE '\bplb_[a-z_]+\(' "$ROOT/src/api/plumbago.h" | tr -d '(' | sort -u |
    while read -r name; do grep -q " T $name\$" names || echo "$name is declared but not there"; done)
report "every function of plumbago.h is in the library" "$missing"
macros=$(grep -nE '^[[:space:]]*#[[:space:]]*define' "$ROOT/src/api/plumbago.h" | grep -vE 'define (PLB_|PLUMBAGO_H)')
report "plumbago.h defines no macro of another name" "$macros"
twice=$(awk 'NF == 3 && $2 ~ /[TDBR]/ { print $3 }' names | sort | uniq -d)
report "no name is defined twice" "$twice"
