# SPDX-License-Identifier: MIT
# The programs in the EXAMPLES of plumbago(3) are compiled as they stand; the one that draws a file gives the program's picture, byte for
# byte, and the one that draws lines is examples/line.c.
. "$ROOT/tests/check.sh"

# The n-th literal block of the section, as a reader sees it.
block() {
    sed -nE '/^\.Sh EXAMPLES/,/^\.Sh [^E]/p' "$ROOT/man/plumbago.3" |
        awk -v n="$1" '/^\.Bd -literal/ { k++; inside = 1; next } /^\.Ed/ { inside = 0 } inside && k == n' | sed 's/\\en/\\n/g; s/\\&//g; s/\\-/-/g'
}
compile() { # NAME: NAME.c with the library
    # shellcheck disable=SC2046,SC2086
    ${CC:-cc} -std=c17 -Wall -Wextra -Werror -I"$ROOT/src/api" $(pkg-config --cflags cairo) "$1.c" "$BUILD_DIR/libplumbago.a" $libraries -o "$1"
}
case $BUILD_DIR in
*asan* | *ubsan* | *tsan* | *cover* | *clang*) skip "the examples of plumbago(3)" "the library of this build needs what its instruments need"; exit ;;
esac
libraries="$(pkg-config --libs cairo libpng zlib libseccomp; for p in libjpeg libwebp libwebpmux libtiff-4; do pkg-config --exists $p && pkg-config --libs $p; done | tr "\n" " ") -lm -pthread"

block 1 >line.c
check "the first example is a program" compile line
if [ -x line ] && ./line; then ok "it draws its lines"; else fail "it draws its lines" "exit status $?"; fi
"$BUILD_DIR/examples/line" && mv line.png twice.png && ./line
same "its lines are those of examples/line.c" line.png twice.png

{
    printf '#include <plumbago.h>\n'
    block 2
    printf 'int main(int argc, char **argv)\n{\n    return argc != 3 || !draw(argv[1], argv[2]);\n}\n'
} >file.c
cp "$BUILD_DIR"/tap-* . # which are looked for beside the program that runs
check "the second example is a program" compile file
for drawing in "$ROOT/examples/plan.svg" "$ROOT/examples/barn.ps" "$ROOT/examples/hatching.svg"; do
    name=${drawing##*/}
    if ./file "$drawing" ours.png 2>err.txt; then ok "it draws $name"; else fail "it draws $name" "$(head -n 1 err.txt)"; fi
    plumbago -q -o program.png "$drawing"
    same "it draws $name as plumbago does" ours.png program.png
done
