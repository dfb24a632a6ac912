/* SPDX-License-Identifier: MIT
 *
 * The passes over all strokes share these helpers.
 */
#include "plan/strokes/passes.h"

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

/* A pass takes some milliseconds, the start of a thread some 20 µs: so many strokes are worth one member. */
#define PER_MEMBER 2000

int plb_plan_members(int threads, size_t n)
{
    size_t useful = 1 + n / PER_MEMBER;
    return threads < 1 ? 1 : (size_t)threads < useful ? threads : (int)useful;
}
