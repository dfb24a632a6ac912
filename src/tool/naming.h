/* SPDX-License-Identifier: MIT
 *
 * What results are called when one call draws several files.
 */
#ifndef PLB_TOOL_NAMING_H
#define PLB_TOOL_NAMING_H

#include <stdbool.h>
#include <stddef.h>

/* Whether a pattern has a place, %s, for the drawing's own name. */
bool naming_has_place(const char *pattern);
/* The pattern with the input's name, without folder and suffix, in each such place ("standard-input" for "-"). The caller
 * frees; NULL: out of memory. */
char *naming_of(const char *pattern, const char *input);
/* Sorts the n names; the first that is there twice, or NULL. */
const char *naming_repeated(char **names, size_t n);

#endif
