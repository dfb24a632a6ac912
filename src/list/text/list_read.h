/* SPDX-License-Identifier: MIT
 *
 * Reads the text form of the display list, plumbago-list(5), as it arrives. All foreign drawings come in by this door, so it
 * trusts nothing: each number is finite and in its range, each index is of something earlier, all is within the limits of
 * display_list.h.
 */
#ifndef PLB_LIST_TEXT_LIST_READ_H
#define PLB_LIST_TEXT_LIST_READ_H

#include "list/display_list.h"

typedef struct {
    /* Gives the next bytes, which live until the next call; false at the end. */
    bool (*refill)(void *closure, const char **data, size_t *size);
    void *closure;
    const char *name; /* of the drawing, as messages show it */
    log_sink say;     /* takes its warnings and details, "NAME: text" */
    /* The reader fills the rest. */
    unsigned long pages; /* that the document has; 0: it does not say */
    unsigned long line;  /* where it stopped, from 1 */
    bool complete;       /* the whole text is read and good */
} list_source;

#define LIST_MAX_MESSAGES 1000u

/* Adds what the text holds to `list`, which is as plb_list_init leaves it. False and `err`, without the line, when the text is
 * wrong or passes a limit; the list is then to be freed. */
bool plb_list_read(list_source *from, display_list *list, error *err);

#endif
