/* SPDX-License-Identifier: MIT
 *
 * This scanner gives the words of the list's text form one after the other, as the text arrives; list_read.c reads from it.
 */
#ifndef PLB_LIST_TEXT_LIST_SCAN_H
#define PLB_LIST_TEXT_LIST_SCAN_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

/* A longer word is an error; all digits of the longest double fit in. */
#define LIST_MAX_WORD 1200

typedef struct {
    bool (*refill)(void *closure, const char **data, size_t *size);
    void *closure;
    error *err;          /* what went wrong; nothing moves on after that */
    const char *at, *end; /* bytes at hand that are not looked at yet */
    bool is_over;        /* nothing more arrives */
    unsigned long line;  /* from 1 */
    const char *word;    /* the present word, not zero-terminated */
    size_t length;       /* 0: the line (or the text) ends here */
    char buffer[LIST_MAX_WORD]; /* holds a word whose bytes did not arrive at once */
} list_scan;

/* Goes on to the next word of the line. False when an error came up. */
bool plb_list_next_word(list_scan *s);
/* Goes on to the first word of the next line that has one; at the end of the text `length` is 0. The present line must be at
 * its end. */
bool plb_list_next_line(list_scan *s);
/* Goes on to the end of the line and gives its bytes as a text of at most `room` - 1 bytes; the blanks about it are left out,
 * the rest of a longer text as well. What is not ASCII becomes a question mark. */
bool plb_list_take_text(list_scan *s, char *text, size_t size);
bool plb_list_is_word(const list_scan *s, const char *word);

#endif
