/* SPDX-License-Identifier: MIT
 *
 * Writes a view down as items of the list: tones, lines, hidden lines.
 */
#ifndef PLB_TAP_MODEL_VIEW_ITEMS_H
#define PLB_TAP_MODEL_VIEW_ITEMS_H

#include "tap/model/hidden/hide.h"
#include "tap/model/model.h"

typedef struct {
    list_writer *w;
    error *err;
    item item; /* at work; plb_item_free frees it */
    int clips; /* written so far */
    unsigned gradients;
} item_writer;

/* Finds the lines of a view that are seen and, where `keep_hidden`, those that are not. */
bool plb_view_lines(const view *v, bool keep_hidden, run_list *runs, error *err);

/* Writes the page, mm, and the scale. One that the list's reader would not take, for it is no scale of a thing, stays unsaid. */
void plb_view_write_page(item_writer *w, double width, double height, double scale);

/* Writes a view that is placed on the page. */
bool plb_view_write(item_writer *w, const view *v, hidden_style hidden, light from);

/* Writes a centre line (ISO 128-2, line type 10: long dashes and dots) from a to b, mm. */
bool plb_view_centre_line(item_writer *w, point a, point b);

#endif
