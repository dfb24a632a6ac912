# SPDX-License-Identifier: MIT
# Writing fails at every byte of the result.
LONG=1 . "$ROOT/tests/cli/writes.sh"
