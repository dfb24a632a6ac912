# SPDX-License-Identifier: MIT
# Every header compiles alone and twice in a row, with gcc and (LONG=1) with clang, without a warning; the public one as C++ too.
. "$ROOT/tests/check.sh"
cd "$ROOT/src" || exit 1
warn="-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror"
libs=$(pkg-config --cflags cairo libpng librsvg-2.0 libxml-2.0)

alone() { # COMPILER LANGUAGE STANDARD HEADER
    # shellcheck disable=SC2086
    printf '#include "%s"\n#include "%s"\n' "$4" "$4" |
        $1 -x "$2" -std="$3" $warn -Wno-unused-function -D_POSIX_C_SOURCE=200809L -DPLB_LIBEXECDIR='""' -I. $libs -fsyntax-only -
}
for compiler in gcc ${LONG:+clang}; do
    command -v $compiler >/dev/null || { skip "headers stand alone, $compiler" "no $compiler here"; continue; }
    bad=
    for header in $(find . -name "*.h"); do
        said=$(alone $compiler c c17 "$header" 2>&1) || bad+="src/$header: $(grep -m 1 -E 'error|warning' <<<"$said")"$'\n'
    done
    report "headers stand alone, $compiler" "${bad%$'\n'}"
done
if command -v g++ >/dev/null; then
    check "plumbago.h is valid C++" alone g++ c++ c++11 api/plumbago.h
else
    skip "plumbago.h is valid C++" "no g++ here"
fi
guards=$(for header in $(find . -name "*.h"); do grep -q '^#ifndef [A-Z0-9_]*_H$' "$header" || echo "src/$header has no guard"; done)
report "headers have guards" "$guards"
