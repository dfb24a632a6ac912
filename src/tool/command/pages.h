/* SPDX-License-Identifier: MIT
 *
 * Pages on the command line: what --page asks for, and what their pictures are called.
 */
#ifndef PLB_TOOL_COMMAND_PAGES_H
#define PLB_TOOL_COMMAND_PAGES_H

#include <limits.h>
#include <stdbool.h>

#define PAGES_TO_THE_END UINT_MAX

typedef struct {
    unsigned first, last; /* last: perhaps PAGES_TO_THE_END */
} page_range;

/* Takes the next part of "2", "2-4", "3-", "all" or a list of these with commas, and moves *list behind it. False at
 * the end or at what is no such part; then *list stands at the end or there. */
bool pages_next(const char **list, page_range *range);
/* Whether the (valid) list is one page. */
bool pages_is_one(const char *list);

/* Whether a name has a place for the page's number: %d or, with zeros in front, %03d. */
bool pages_has_number(const char *name);
/* The name with the number in each of its places, or as it is. The caller frees; NULL: out of memory. */
char *pages_name(const char *name, unsigned page);
/* The input's name with .png, or -%d.png, in place of its suffix. The caller frees; NULL: out of memory. */
char *pages_name_output(const char *input, bool numbered);

#endif
