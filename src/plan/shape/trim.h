/* SPDX-License-Identifier: MIT
 *
 * Cutting tracks: where a rule says that the line is not to be seen, the pencil is lifted.
 */
#ifndef PLB_PLAN_SHAPE_TRIM_H
#define PLB_PLAN_SHAPE_TRIM_H

#include "plan/shape/region.h"
#include "plan/track.h"

/* What decides. Between two neighbouring places that `cross` gives, a segment is seen or not as a whole. */
typedef struct {
    /* Appends the parameters in (0, 1) where the segment may pass from seen to unseen; false when out of memory. */
    bool (*cross)(const void *of, point from, point to, crossings *at);
    bool (*sees)(const void *of, point p);
    const void *of;
} cut_rule;

/* Hands on the parts of `t` that are seen; untouched tracks go on as they are. */
bool plb_plan_cut(const cut_rule *rule, const track *t, track_sink sink, void *closure, error *err);
box plb_track_bounds(const track *t);

#endif
