/* SPDX-License-Identifier: MIT
 *
 * This header compiles loops for broad vectors. A function marked PLB_SIMD_CLONES is compiled twice, for the processor that every machine
 * of its kind has and for one with AVX2, and the program takes the one that fits when it starts. Both give the same bits:
 * whole numbers and plain floating point (no contraction, no reordering), so results do not depend on the machine.
 * Debug and sanitiser builds have the plain one only; comparing their output with that of a release build compares both.
 *
 * Loops that look up tables gain nothing: gathered loads are slower than single ones on many processors.
 */
#ifndef PLB_BASE_SIMD_CLONES_H
#define PLB_BASE_SIMD_CLONES_H

#include <stdint.h> /* and with it, whether this is glibc, whose loader chooses */

#if defined __x86_64__ && defined __GLIBC__ && defined NDEBUG
#define PLB_SIMD_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define PLB_SIMD_CLONES
#endif

#endif
