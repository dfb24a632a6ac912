/* SPDX-License-Identifier: MIT
 *
 * Measures how far a mistyped word lies from another.
 */
#ifndef PLB_TOOL_OPTIONS_NEAREST_H
#define PLB_TOOL_OPTIONS_NEAREST_H

#include <stddef.h>

#define NEAREST_FAR ((size_t)-1)

/* Gives the number of letters of `text`, of `n` bytes, that must be changed, left out, added or swapped with their
 * neighbour to make `word`. NEAREST_FAR for long words. */
size_t nearest_distance(const char *word, const char *text, size_t n);
/* Gives the largest distance of a word that n letters may have meant. */
size_t nearest_limit(size_t n);

#endif
