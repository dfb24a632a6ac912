/* SPDX-License-Identifier: MIT
 *
 * The stages from an item's marks to its strokes, but for clips (clip.h) and what is hidden (hidden/occlusion.h). Each takes tracks and
 * appends what becomes of them to `out`.
 */
#ifndef PLB_PLAN_ITEM_STAGES_H
#define PLB_PLAN_ITEM_STAGES_H

#include "plan/plan.h"
#include "plan/track.h"

/* All return false and fill `err` when out of memory. */

/* dash.c: the dashes of the tracks of item `it` as a hand makes them; a track itself when the item has none, or too many. A point that
 * is painted by the cap of a thin line becomes a dot. */
bool plb_plan_dash(const item *it, const track_list *in, const plan_options *o, track_list *out, error *err);
/* scraps.c: of hatching no scraps are left where something hides the rest. */
bool plb_plan_drop_scraps(const track_list *in, const plan_options *o, track_list *out, error *err);
/* simplify.c: the drawing's own lines without wiggles finer than the pencil's line of `width` mm; hatching and lettering, which have been
 * made for the pencil, as they are. */
bool plb_plan_simplify(const track_list *in, double width, track_list *out, error *err);
/* corner.c: tracks cut at their corners; a closed one is first turned to start at a corner. */
bool plb_plan_corners(const track_list *in, track_list *out, error *err);

#endif
