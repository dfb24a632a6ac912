/* SPDX-License-Identifier: MIT
 *
 * The files of this folder share these steps of a drawing's way through the stages.
 */
#ifndef PLB_API_PIPELINE_H
#define PLB_API_PIPELINE_H

#include "api/api_internal.h"
#include "input/input.h"
#include "plan/plan.h"
#include "stroke/stroke.h"
#include "surface/page.h"

/* Makes an empty drawing with a copy of the options; NULL and `err` when out of memory. */
plb_drawing *plb_api_drawing_new(const char *name, const plb_options *o, error *err);
/* Makes the strokes of d->list. Messages go to `say` with the drawing's name. */
bool plb_api_plan(plb_drawing *d, const log_sink *say, error *err);
/* Gives the caller's options or, in `own`, new ones, which are freed after the call; NULL and `err` when the settings
 * contradict each other. */
const plb_options *plb_api_options_checked(const plb_options *given, plb_options **own, error *err);

/* Loads the drawing in a file; NULL and `err` on failure. */
plb_drawing *plb_api_draw(const input_source *in, const plb_options *o, error *err);

/* Gives the options of the plan that follow from `o`, which has been checked. */
plan_options plb_api_plan_options(const plb_options *o);
/* Gives how broad a sharpened point is, times the line of the pencil as captured; 1: the point stays as it was. */
double plb_api_point(const plb_options *o);

/* A render_context is the pencil of a call, borrowed from the options and ready to draw. */
typedef struct {
    const plb_profile *profile;
    const pencil *pencil; /* the profile's */
    graphite ink;
    stroke_options stroke;
} render_context;

/* Gives the options of a call that draws, in `out`, which borrows from them: `given`, or those of loading where `given`
 * is NULL, with the resolution that these ask for. NULL and `err` when the options contradict those of loading. */
const plb_options *plb_api_options_for(const plb_drawing *d, const plb_options *given, plb_options *out, error *err);

bool plb_api_context_init(render_context *t, const plb_options *o, error *err);
/* Makes the same ready for the strokes of a drawing, which lie on its sheet: the page's pixels are larger there. */
bool plb_api_context_for(render_context *t, const plb_drawing *d, const plb_options *o, error *err);

/* drawing/reduce.c: plans the strokes of d->list, whose page is as large as it will be, with `options`, on the sheet that
 * the setting `reduction` asks for. Fills d->reduction, d->strokes and d->page_points. False and `err` on failure. */
bool plb_api_plan_reduced(plb_drawing *d, const plan_options *options, const log_sink *say, error *err);
/* Gives the strokes as they lie on the page; all that this holds is borrowed from the drawing. */
stroke_list plb_api_strokes_on_page(const plb_drawing *d);

#endif
