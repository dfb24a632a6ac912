/* SPDX-License-Identifier: MIT
 *
 * How far a mistyped word lies from another.
 */
#ifndef PLB_TOOL_OPTIONS_NEAREST_H
#define PLB_TOOL_OPTIONS_NEAREST_H

#include <stddef.h>

#define NEAREST_FAR ((size_t)-1)

/* How many letters of `text`, of `n` bytes, must be changed, left out, added or swapped with their neighbour to make `word`.
 * NEAREST_FAR for long words. */
size_t nearest_distance(const char *word, const char *text, size_t n);
/* So far away may a word be that was meant by n letters. */
size_t nearest_limit(size_t n);

#endif
