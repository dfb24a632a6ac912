/* SPDX-License-Identifier: MIT
 *
 * Draws the strokes onto the page, band by band.
 */
#ifndef PLB_API_RENDER_RENDER_H
#define PLB_API_RENDER_RENDER_H

#include "api/pipeline.h"
#include "surface/page.h"

/* Takes each band once its strokes are drawn, from the top down. False, with the error filled, stops the drawing. */
typedef bool (*band_sink)(void *closure, const page *band, error *err);

/* A page_plan says how a page is cut into bands of at most `rows`. */
typedef struct {
    int width, height; /* of the page, pixels; rows from `height` on are not wanted, … */
    int top;           /* … nor those before this one */
    int rows;          /* of a band */
    int planes;        /* of deposits: see page.h */
    int members;       /* threads */
} page_plan;

/* Plans the page of the drawing as one band. False and `err` when the page is too large. */
bool plb_page_plan(const plb_drawing *d, const plb_options *o, page_plan *plan, error *err);
/* Cuts the page where one band would need too much memory: into bands of a multiple of `multiple` rows. */
void plb_page_plan_rows(page_plan *plan, int multiple);

/* Draws the strokes and hands over each band. The pixels are the same whatever `plan->rows` and `plan->members` are. */
bool plb_render(const plb_drawing *d, const plb_options *o, const render_context *t, const page_plan *plan, band_sink sink, void *closure,
                error *err);

#endif
