/* SPDX-License-Identifier: MIT
 *
 * Cutting tracks: where a rule says that the line is not to be seen, the pencil is lifted.
 */
#ifndef PLB_PLAN_SHAPE_TRIM_H
#define PLB_PLAN_SHAPE_TRIM_H

#include "plan/shape/region.h"
#include "plan/track.h"

/* A rule decides which parts of a line are seen. Between two neighbouring places that `cross` gives, a segment is seen or not as a whole. */
typedef struct {
    /* Appends the parameters in (0, 1) where the segment may pass from seen to unseen; false when out of memory. */
    bool (*cross)(const void *of, point from, point to, crossings *at);
    bool (*sees)(const void *of, point p);
    const void *of;
} trim_rule;

/* Appends the parts of `t` that are seen to `out`: `t` itself, all its ends as they were, when all is seen; else *is_part becomes true.
 * False and `err` when out of memory. */
bool plb_plan_trim(const trim_rule *rule, const track *t, track_list *out, bool *is_part, error *err);

#endif
