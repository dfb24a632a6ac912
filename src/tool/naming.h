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
/* Whether two of the inputs would be given the same name; `first` and `second` tell which. */
bool naming_collides(const char *pattern, char *const inputs[], size_t n, size_t *first, size_t *second);

#endif
