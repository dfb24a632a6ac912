/* SPDX-License-Identifier: MIT
 *
 * What the passes over all strokes share.
 */
#include "plan/pass.h"

bool plb_plan_append(stroke_list *to, const stroke *as, const point *at, size_t n)
{
    stroke s = *as;
    s.first = to->points.n;
    s.n = n;
    if (!array_reserve(&to->points, n) || !array_push(&to->strokes, s))
        return false;
    for (size_t i = 0; i < n; i++)
        to->points.v[to->points.n++] = at[i];
    return true;
}

void plb_plan_replace(stroke_list *list, stroke_list *made)
{
    plb_stroke_list_free(list);
    *list = *made;
}
