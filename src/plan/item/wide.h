/* SPDX-License-Identifier: MIT
 *
 * Lines wider than the pencil's: the area that they cover, and the passes by which the pencil covers it.
 */
#ifndef PLB_PLAN_ITEM_WIDE_H
#define PLB_PLAN_ITEM_WIDE_H

#include "plan/plan.h"
#include "plan/track.h"

/* Appends the area of the line `it` as one of `width` mm, its caps counted, its dashes not, to `out`: by the nonzero rule. False
 * and `err` when out of memory. */
bool plb_wide_outline(const item *it, double width, path *out, error *err);

/* parallel_strokes.c: appends the passes of the track `t` of the wide line `it` to `out`: side by side, closer the darker its paint is.
 * False and `err` when out of memory. */
bool plb_plan_passes(const item *it, const track *t, const plan_options *o, track_list *out, error *err);

#endif
