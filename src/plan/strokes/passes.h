/* SPDX-License-Identifier: MIT
 *
 * The passes of the plan that look at all strokes together, once each item has made its own. Each takes the list as the
 * one before left it.
 */
#ifndef PLB_PLAN_STROKES_PASSES_H
#define PLB_PLAN_STROKES_PASSES_H

#include "base/error.h"
#include "list/stroke_list.h"

/* All return false and fill `err` when out of memory; the list is then good for plb_stroke_list_free only. */

/* clearance.c: hatch lines leave room for the lettering painted over them with a pencil `width` mm wide. Before the strokes leave the
 * items' order. */
bool plb_plan_clearance(stroke_list *list, double width, error *err);
/* duplicates.c: where a line lies upon an earlier one of its kind, within `tolerance` mm, it is not drawn again. */
bool plb_plan_duplicates(stroke_list *list, double tolerance, error *err);
/* join.c: lines that go on from one another, end to end within `tolerance` mm, become one. At most
 * `threads` share the work. */
bool plb_plan_join(stroke_list *list, double tolerance, int threads, error *err);
/* smooth.c: points on a straight line are dropped, coarse polylines become the curves that they stand for. */
bool plb_plan_smooth(stroke_list *list, error *err);
/* neighbours.c: a straight line with another beside it must not deviate so far that the two meet: finds each line's max_deviation. At most
 * `threads` share the work. */
bool plb_plan_neighbours(stroke_list *list, int threads, error *err);
/* junctions.c: a line that others end upon deviates little: lessens its max_deviation. */
bool plb_plan_junctions(stroke_list *list, int threads, error *err);
/* order.c: near things together; sets which end starts. */
bool plb_plan_order(stroke_list *list, error *err);
/* identity.c: fills in the identities. */
bool plb_plan_identify(stroke_list *list, error *err);

/* How many members of a team are worth their start for n strokes or ends, of `threads` at most; they take so many at a time. */
#define PASS_BATCH 256
int plb_plan_members(int threads, size_t n);
/* Appends a stroke like `as` with these points; false when out of memory. */
bool plb_plan_append(stroke_list *to, const stroke *as, const point *at, size_t n);
/* `made` takes the place of `list`. */
void plb_plan_replace(stroke_list *list, stroke_list *made);

#endif
