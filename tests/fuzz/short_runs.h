/* SPDX-License-Identifier: MIT
 *
 * What the fuzzers' build allows a PostScript program: many short runs find more than few long ones.
 */
#define PS_MAX_STEPS 200000u
#define PS_MAX_MEMORY ((size_t)32 << 20)
#define PS_MAX_LIST_BYTES ((size_t)64 << 20)
