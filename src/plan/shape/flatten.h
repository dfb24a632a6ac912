/* SPDX-License-Identifier: MIT
 *
 * Paths become polylines.
 */
#ifndef PLB_PLAN_SHAPE_FLATTEN_H
#define PLB_PLAN_SHAPE_FLATTEN_H

#include "base/geometry/path.h"
#include "plan/track.h"

/* Curves become polylines that keep within this distance of them: half the 0.05 mm that is asked for. */
#define FLATNESS_MM 0.025
/* No vertex inside a flattened curve turns by more than about this, whatever its size. */
#define FLAT_TURN_DEGREES 12.0

/* Appends the subpaths of `p` to `out` as tracks, with corners marked; `close` closes open ones, as a fill does. A subpath without
 * length becomes a track of one point. False and `err` when out of memory. */
bool plb_plan_flatten(const path *p, bool close, track_list *out, error *err);

#endif
