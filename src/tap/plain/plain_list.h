/* SPDX-License-Identifier: MIT
 *
 * Writes paths that are filled and stroked as items of a display list's text, kept in memory until the text is whole.
 * Every number has the value that it would have had on the way through librsvg and cairo's script surface.
 */
#ifndef PLB_TAP_PLAIN_PLAIN_LIST_H
#define PLB_TAP_PLAIN_PLAIN_LIST_H

#include "base/array.h"
#include "list/text/list_write.h"
#include "tap/common/tap_page.h"
#include "tap/plain/plain_path.h"
#include "tap/plain/plain_style.h"

typedef struct {
    plain_path path;       /* to be made, then drawn */
    list_writer out;
    ARRAY(char) text;      /* written so far */
    matrix to_page;        /* from the surface's units to mm */
    double shares[256];    /* of colours and opacities */
    path drawn;            /* `path` in the numbers of the list */
    plain_pen pen;         /* of the last line, */
    matrix pen_matrix;     /* and its matrix: */
    item line;             /* width, cap and dashes that follow from these, on paper */
    bool has_pen;
} plain_list;

/* Starts the list with the page. */
void plb_plain_list_begin(plain_list *s, const tap_page *p);
/* Fills and strokes s->path as the style says. False: the item is beyond limits, or cairo draws it in ways of its own. */
bool plb_plain_draw(plain_list *s, const plain_style *style);
/* Ends the list; false: the text grew too long. */
bool plb_plain_list_end(plain_list *s);
void plb_plain_list_free(plain_list *s);

#endif
