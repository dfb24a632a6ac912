# SPDX-License-Identifier: MIT
# Each allocation fails once, and once with all that follow.
case $BUILD_DIR in */release) ;; *) echo "skip each allocation fails: once is enough: with the plain release build" && exit ;; esac
LONG=1 . "$ROOT/tests/allocations.sh"
