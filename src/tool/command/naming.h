/* SPDX-License-Identifier: MIT
 *
 * Names the results when one call draws several files.
 */
#ifndef PLB_TOOL_COMMAND_NAMING_H
#define PLB_TOOL_COMMAND_NAMING_H

#include <stdbool.h>
#include <stddef.h>

/* Tells whether a pattern has a place, %s, for the drawing's own name. */
bool naming_has_place(const char *pattern);
/* Puts the input's name, without folder and suffix, into each such place of the pattern ("standard-input" for "-"). The
 * caller frees; NULL: out of memory. */
char *naming_of(const char *pattern, const char *input);
/* Sorts the n names; gives the first that is there twice, or NULL. */
const char *naming_repeated(char **names, size_t n);

/* Gives the pattern for results in the folder `name`, which exists or ends in a slash: "out/%s.png", or "out/%s-%d.png"
 * for several pages. The caller frees; NULL when `name` is no folder, or when out of memory. */
char *naming_in_folder(const char *name, const char *suffix, bool several);

#endif
