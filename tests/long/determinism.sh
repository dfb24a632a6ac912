# SPDX-License-Identifier: MIT
# The same bytes from every compiler and level, each with every number of threads, locale and time zone; eight drawings.
case $BUILD_DIR in */release) ;; *) echo "skip the long matrix: once is enough: with the plain release build" && exit ;; esac
LONG=1 . "$ROOT/tests/determinism.sh"
