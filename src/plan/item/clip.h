/* SPDX-License-Identifier: MIT
 *
 * Clips: what lies outside the page or outside a clip is cut away.
 */
#ifndef PLB_PLAN_ITEM_CLIP_H
#define PLB_PLAN_ITEM_CLIP_H

#include "list/display_list.h"
#include "plan/shape/region.h"
#include "plan/track.h"

/* The clips of a display list and its page, as regions made when first needed. */
typedef struct clipper clipper;
clipper *plb_clipper_new(const display_list *list, error *err);
void plb_clipper_free(clipper *c);
/* Gives the clip of that index, without its parents; NULL and `err` when out of memory. */
const region *plb_clipper_region(clipper *c, int index, error *err);
/* Appends the parts of the tracks `in` inside a clip, its parents and the page to `out`; `index` is an item's clip or NO_CLIP. False and
 * `err` when out of memory. */
bool plb_plan_clip(clipper *c, int index, const track_list *in, track_list *out, error *err);

#endif
