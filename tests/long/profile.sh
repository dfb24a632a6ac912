# SPDX-License-Identifier: MIT
# All eight pencils, captured anew from their scans, are those of the library.
LONG=1 . "$ROOT/tests/cli/profile.sh"
