/* SPDX-License-Identifier: MIT
 *
 * The reduction: how much larger than the page the sheet must be on which a pencil draws what is small. Illustrators draw
 * larger than print and reduce; then lettering has room for the hand, lines keep apart and small shapes their corners.
 */
#ifndef PLB_PLAN_REDUCTION_REDUCTION_H
#define PLB_PLAN_REDUCTION_REDUCTION_H

#include "list/display_list.h"
#include "plan/plan.h"

/* No sheet is more than so many times larger than the page. */
#define REDUCTION_MAX 4.0

/* The needs say how many times larger than the page a sheet must be for … */
typedef struct {
    double lettering; /* lower-case letters high enough to be written, … */
    double lines;     /* neighbouring lines far enough apart, … */
    double shapes;    /* small closed shapes, as arrowheads and markers, to be drawn as such; each 0 to REDUCTION_MAX; below 1: with room to spare */
    double factor;    /* the sheet is so many times larger: 1 to REDUCTION_MAX */
} reduction_needs;

/* Measures what a drawing on its page, mm, needs when drawn with a pencil of options->pencil_width. The result depends on the
 * drawing, the pencil's width and what options->text and options->fill say is drawn, and on nothing else. False and `err`
 * when out of memory. */
bool plb_plan_reduction(const display_list *list, const plan_options *options, reduction_needs *out, error *err);

/* enlarge.c: makes a copy of the list with everything on it `factor` times larger, page, lines and dashes included. The
 * caller frees `out` in either case. False and `err` when out of memory. */
bool plb_list_enlarged(display_list *out, const display_list *list, double factor, error *err);

#endif
