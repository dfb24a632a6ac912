/* SPDX-License-Identifier: MIT
 *
 * Reads the pages that --page asks for, and names their pictures.
 */
#ifndef PLB_TOOL_COMMAND_PAGES_H
#define PLB_TOOL_COMMAND_PAGES_H

#include <limits.h>
#include <stdbool.h>

#define PAGES_TO_THE_END UINT_MAX

typedef struct {
    unsigned first, last; /* last: perhaps PAGES_TO_THE_END */
} page_range;

/* Takes the next part of "2", "2-4", "3-", "all" or a list of these with commas, and moves *list behind the part. False
 * at the end or where no such part follows; *list then stays there. */
bool pages_next(const char **list, page_range *range);
/* Tells whether the (valid) list is one page. */
bool pages_is_one(const char *list);

/* Tells whether a name has a place for the page's number: %d or, with zeros in front, %03d. */
bool pages_has_number(const char *name);
/* Puts the number into each such place of the name. The caller frees; NULL: out of memory. */
char *pages_name(const char *name, unsigned page);
/* Gives the input's name with .png, or -%d.png, in place of its suffix. The caller frees; NULL: out of memory. */
char *pages_name_output(const char *input, bool numbered);

#endif
