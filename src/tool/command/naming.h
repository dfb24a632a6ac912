/* SPDX-License-Identifier: MIT
 *
 * What results are called when one call draws several files.
 */
#ifndef PLB_TOOL_COMMAND_NAMING_H
#define PLB_TOOL_COMMAND_NAMING_H

#include <stdbool.h>
#include <stddef.h>

/* Whether a pattern has a place, %s, for the drawing's own name. */
bool naming_has_place(const char *pattern);
/* The pattern with the input's name, without folder and suffix, in each such place ("standard-input" for "-"). The caller
 * frees; NULL: out of memory. */
char *naming_of(const char *pattern, const char *input);
/* Sorts the n names; the first that is there twice, or NULL. */
const char *naming_repeated(char **names, size_t n);

/* The pattern for results in the folder `name`, one that is there or whose name ends in a slash: "out/%s.png", or "out/%s-%d.png" for
 * several pages. The caller frees; NULL when `name` is no folder, or when out of memory. */
char *naming_in_folder(const char *name, const char *suffix, bool several);

#endif
