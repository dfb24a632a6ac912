/* SPDX-License-Identifier: MIT
 *
 * Occluders: opaque areas painted later hide the lines below them.
 */
#ifndef PLB_PLAN_HIDDEN_OCCLUSION_H
#define PLB_PLAN_HIDDEN_OCCLUSION_H

#include "plan/item/clip.h"
#include "plan/plan.h"

/* All that hides in a drawing, ready to be asked. */
typedef struct occluders occluders;

/* Looks through the list; the clipper stays the caller's and must outlive the result. NULL and `err` on failure. */
occluders *plb_occluders_new(const display_list *list, const plan_options *o, clipper *c, error *err);
void plb_occluders_free(occluders *c);
/* Tells whether item number `i` is hidden as a whole, as far as that is found by a glance: its plan can be left out. */
bool plb_occluders_hide_item(const occluders *c, size_t i);
/* Appends the parts of the tracks `in`, which belong to item number `i`, that no later item hides to `out`, and notes which are parts. False
 * and `err` when out of memory. */
bool plb_plan_hide(occluders *c, size_t i, const track_list *in, track_list *out, error *err);
/* Appends the tracks `in` of the filled item number `i` to `out`, of its outline only the parts that do not lie upon an area of the same
 * paint: shapes of one paint make one shape, and the outline would show an edge that nobody sees. */
bool plb_plan_fuse(occluders *c, size_t i, const track_list *in, track_list *out, error *err);
/* Tells whether the work had a bound and reached it: what came after was not cut. */
bool plb_occluders_are_exhausted(const occluders *c);

#endif
