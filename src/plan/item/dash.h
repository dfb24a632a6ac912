/* SPDX-License-Identifier: MIT
 *
 * Dashes as a hand makes them.
 */
#ifndef PLB_PLAN_ITEM_DASH_H
#define PLB_PLAN_ITEM_DASH_H

#include "plan/plan.h"
#include "plan/track.h"

/* The dashes of the track `t` of item `it`; the track itself when there are none, or too many. */
bool plb_plan_dash(const item *it, const track *t, const plan_options *o, track_sink sink, void *closure, error *err);

#endif
