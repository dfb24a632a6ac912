# SPDX-License-Identifier: MIT
# All eight pencils, captured again from their scans, are those of the library.
LONG=1 . "$ROOT/tests/cli/profile.sh"
