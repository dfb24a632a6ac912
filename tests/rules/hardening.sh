# SPDX-License-Identifier: MIT
# Release programs are position-independent, resolve everything before they run and make it read-only, have no code on
# the stack, guard the stack and check the bounds of what the C library copies.
. "$ROOT/tests/check.sh"
case $BUILD_DIR in */release*) ;; *) skip "hardening" "not a release build" && exit ;; esac
for program in plumbago plumbago-profile tap-svg tap-plain tap-ps tap-model; do
    file=$BUILD_DIR/$program
    has() { if readelf $3 "$file" 2>/dev/null | grep -qE "$2"; then ok "$program: $1"; else fail "$program: $1" "readelf $3 shows no $2"; fi; }
    has "position-independent" 'Type: *DYN' -hW
    has "a program, not a library" 'FLAGS_1.*PIE' -dW
    has "resolved at the start" 'FLAGS.*(BIND_)?NOW' -dW
    has "read-only afterwards" 'GNU_RELRO' -lW
    has "no code on the stack" 'GNU_STACK.* RW +0x' -lW
    has "guards the stack" '__stack_chk_fail' -sW
    has "checks what is copied" '__(memcpy|snprintf|vsnprintf|fprintf|printf|vfprintf|read)_chk' -sW
done
