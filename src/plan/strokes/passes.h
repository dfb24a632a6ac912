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

/* clearance.c cuts hatch lines so that a pencil `width` mm wide leaves the lettering painted over them free. It comes
 * before the strokes leave the items' order. */
bool plb_plan_clearance(stroke_list *list, double width, error *err);
/* duplicates.c drops a line that lies upon an earlier one of its kind, within `tolerance` mm. */
bool plb_plan_duplicates(stroke_list *list, double tolerance, error *err);
/* join.c makes one line of lines that go on from one another, end to end within `tolerance` mm. At most `threads` share the work. */
bool plb_plan_join(stroke_list *list, double tolerance, int threads, error *err);
/* smooth.c drops points on a straight line, and turns coarse polylines into the curves that they stand for. */
bool plb_plan_smooth(stroke_list *list, error *err);
/* neighbours.c finds each line's max_deviation: a straight line with another beside it must not deviate so far that the
 * two meet. At most `threads` share the work. */
bool plb_plan_neighbours(stroke_list *list, int threads, error *err);
/* nested.c does the same for closed lines inside each other. */
bool plb_plan_nested(stroke_list *list, error *err);
/* junctions.c lessens the max_deviation of a line that others end upon. */
bool plb_plan_junctions(stroke_list *list, int threads, error *err);
/* beside_letters.c finds it for lines beside lettering: a line drawn with a pencil `width` mm wide must not run into it. */
bool plb_plan_beside_letters(stroke_list *list, double width, int threads, error *err);
/* order.c puts near strokes together and sets which end starts. */
bool plb_plan_order(stroke_list *list, error *err);
/* identity.c fills in the identities. */
bool plb_plan_identify(stroke_list *list, error *err);

/* How many members of a team are worth their start for n strokes or ends, of `threads` at most; they take so many at a time. */
#define PASS_BATCH 256
int plb_plan_members(int threads, size_t n);
/* Appends a stroke like `as` with these points; false when out of memory. */
bool plb_plan_append(stroke_list *to, const stroke *as, const point *at, size_t n);
/* Puts `made` in the place of `list`. */
void plb_plan_replace(stroke_list *list, stroke_list *made);

#endif
