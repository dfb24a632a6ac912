# SPDX-License-Identifier: MIT
# `make` makes again what a change touches, and no more: an object depends on its headers, on the compiler and its flags.
. "$ROOT/tests/check.sh"
cd "$ROOT" || exit 1
unset MAKEFLAGS MAKELEVEL MFLAGS BUILD CFLAGS PREFIX VERSION
trap 'rm -rf "$ROOT/build/release-once"' EXIT
one=build/release-once/base/error.o
place=build/release-once/system/process.o

# makes COUNT ARGS...: so many of the two objects are compiled.
makes() {
    local name=$1 count=$2
    shift 2
    is "$name" "$(make SUFFIX=-once CC=gcc "$@" $one $place 2>&1 | grep -c '^  CC ')" "$count"
}
makes "both are compiled" 2
makes "then none" 0
makes "all where flags change" 2 CFLAGS=-DSOMETHING
makes "all where they change back" 2
makes "one where the installed place changes" 1 PREFIX=/usr
makes "one where the installed place changes back" 1
is "a header is a prerequisite" "$(grep -c 'src/base/error.h' ${one%.o}.d | sed 's/[1-9].*/some/')" some
is "the headers are read by make" "$(make SUFFIX=-once CC=gcc -W src/base/error.h $one 2>&1 | grep -c '^  CC ')" 1

# Where a library is missing, the first line to appear says which packages, and how to install them.
said=$(PKG_CONFIG_LIBDIR=/nowhere make SUFFIX=-bare CC=gcc 2>&1)
[ -e build/release-bare/flags ] && fail "without libraries: nothing is built" "build/release-bare/flags is there"
rm -rf build/release-bare
is "without libraries: it says which is missing" "$(grep -c "^Package cairo was not found\|apt-get update && .*apt-get install" <<<"$said")" 1
said=$(tests/packages --say gcc no-such-package)
is "a missing package: status" $? 1
is "a missing package: make demo is named, and the line to run" \
    "$(grep -c 'make demo\|apt-get update && .*apt-get install -y --no-install-recommends no-such-package$' <<<"$said")" 2
