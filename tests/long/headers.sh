# SPDX-License-Identifier: MIT
# Every header compiles alone with clang, too.
LONG=1 . "$ROOT/tests/rules/headers.sh"
