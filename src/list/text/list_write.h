/* SPDX-License-Identifier: MIT
 *
 * Writes the text form of the display list, plumbago-list(5): statement by statement, as a tap does, or a whole list.
 *
 *     list_writer w;
 *     plb_list_writer_init(&w, put, closure);     // the version line
 *     plb_list_writer_page(&w, 210, 297);
 *     plb_list_writer_item(&w, &it);              // as many as there are
 *     if (!plb_list_writer_end(&w)) …             // a put failed
 */
#ifndef PLB_LIST_TEXT_LIST_WRITE_H
#define PLB_LIST_TEXT_LIST_WRITE_H

#include "list/display_list.h"

#include <stdio.h>

#define LIST_WRITER_BYTES 16384

/* Takes n bytes; false when they cannot be written, and is then not called again. */
typedef bool (*list_put)(void *closure, const char *data, size_t n);

typedef struct {
    list_put put;
    void *closure;
    bool failed;
    size_t n;
    char buffer[LIST_WRITER_BYTES]; /* the last bytes, not yet put */
} list_writer;

void plb_list_writer_init(list_writer *w, list_put put, void *closure);
/* Writes the size of the page, mm; it comes before the first clip, gradient or item. */
void plb_list_writer_page(list_writer *w, double width, double height);
/* Writes how many pages the document has, of which this is one. */
void plb_list_writer_pages(list_writer *w, unsigned long pages);
/* Writes the scale, mm on paper per mm of the thing drawn. */
void plb_list_writer_scale(list_writer *w, double scale);
/* Paths and gradients that follow are in the coordinates that m maps to mm on the page; it takes the place of the one before. */
void plb_list_writer_matrix(list_writer *w, matrix m);
/* n things of a kind were left out; advice may be NULL or "". */
void plb_list_writer_omission(list_writer *w, omission_kind kind, unsigned long n, const char *advice);
/* Passes a line of text on to the user. */
void plb_list_writer_message(list_writer *w, message_level level, const char *text);
/* The first gradient written has the number 0, the first clip as well. */
void plb_list_writer_gradient(list_writer *w, const gradient *g);
void plb_list_writer_clip(list_writer *w, const clip *c);
void plb_list_writer_item(list_writer *w, const item *it);
/* Writes the last statement and gives everything to `put`. False when some of it could not be written. */
bool plb_list_writer_end(list_writer *w);

/* Writes all of a list. False when some of it could not be written. */
bool plb_list_write(const display_list *list, list_put put, void *closure);
/* Writes all of a list to a file. */
bool plb_list_print(const display_list *list, FILE *to);

#endif
