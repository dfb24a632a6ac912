/* SPDX-License-Identifier: MIT
 *
 * From strokes to the page, band by band.
 */
#ifndef PLB_API_RENDER_RENDER_H
#define PLB_API_RENDER_RENDER_H

#include "api/pipeline.h"
#include "surface/page.h"

/* What is done with each band once its strokes are drawn, from the top down. False, with the error filled, stops. */
typedef bool (*band_sink)(void *closure, const page *band, error *err);

/* How a page is cut: into bands of at most `rows`. */
typedef struct {
    int width, height; /* of the page, pixels; rows from `height` on are not wanted, … */
    int top;           /* … nor those before this one */
    int rows;          /* of a band */
    int planes;        /* of deposits: see page.h */
    int members;       /* threads */
} page_plan;

/* The page of the drawing, in one band. False and `err` when it is too large. */
bool plb_page_plan(const plb_drawing *d, const plb_options *o, page_plan *plan, error *err);
/* Cuts it where it needs more memory than it should: bands of a multiple of `multiple` rows. */
void plb_page_plan_rows(page_plan *plan, int multiple);

/* Draws the strokes and hands over each band. The same pixels whatever `plan->rows` and `plan->members` are. */
bool plb_render(const plb_drawing *d, const plb_options *o, const render_context *t, const page_plan *plan, band_sink sink, void *closure,
                error *err);

#endif
