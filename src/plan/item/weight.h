/* SPDX-License-Identifier: MIT
 *
 * Weight and tone: how hard the pencil is pressed for a line of some width and colour.
 */
#ifndef PLB_PLAN_ITEM_WEIGHT_H
#define PLB_PLAN_ITEM_WEIGHT_H

#include "plan/plan.h"

/* Tells whether the paint is dark enough to leave a mark on white paper. */
bool plb_leaves_mark(const item *it);
/* A line this wide is an area to the pencil: it is drawn by passes side by side, and hides what is below it. */
bool plb_is_wide(const item *it, const plan_options *o);
/* Computes the width of most of the drawing's lines, mm: the median, each line counted by its length. `o->pencil_width` where
 * there are no lines but wide ones. False and `err` when out of memory. */
bool plb_usual_width(const display_list *list, const plan_options *o, double *width, error *err);
/* Gives the style of the lines of `it` in a drawing whose lines are `usual` mm wide. */
stroke_style plb_style_of(const item *it, const plan_options *o, double usual);

/* Gives how broad a fill is about, mm: twice the area over the perimeter of its control polygon, the width of a stroke's outline. */
double plb_fill_breadth(const path *p);

#endif
