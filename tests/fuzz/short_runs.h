/* SPDX-License-Identifier: MIT
 *
 * Limits a PostScript program, and the raster of a solid model's tones, in the fuzzers' build: many short runs find more than few long
 * ones. Each limit of a program can still be met, by one of a few lines.
 */
#define MODEL_MAX_CELLS 2e4
#define PS_MAX_STEPS 20000u
#define PS_MAX_STEPS_AFTER 2000u
#define PS_MAX_MEMORY ((size_t)4 << 20)
#define PS_MAX_LIST_BYTES ((size_t)1 << 20)
#define PS_MAX_OPERANDS 600u
#define PS_MAX_FRAMES 250u
#define PS_MAX_DICTS 20u
#define PS_MAX_STATES 50u
#define PS_MAX_ARRAY 4096u
#define PS_MAX_STRING 65536u
#define PS_MAX_PATH_POINTS ((size_t)20000)
