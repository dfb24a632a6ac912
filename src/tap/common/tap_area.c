/* SPDX-License-Identifier: MIT */
#include "tap/common/tap_area.h"

#include <math.h>

/* Points count as on a line up to this distance, in steps of cairo's numbers (1/256). */
#define FLAT (4.0 / 256)

/* Tells whether all points from `from` to `to` lie on one line. */
static bool is_flat(const point *from, const point *to)
{
    point far = {0, 0};
    for (const point *p = from; p < to; p++)
        if (plb_point_length(point_sub(*p, *from)) > plb_point_length(far))
            far = point_sub(*p, *from);
    double length = plb_point_length(far);
    for (const point *p = from; p < to; p++)
        if (fabs(point_cross(far, point_sub(*p, *from))) > FLAT * length)
            return false;
    return true;
}

bool plb_tap_has_no_area(const path *p)
{
    static const size_t points_of[] = {[PATH_MOVE] = 1, [PATH_LINE] = 1, [PATH_CURVE] = 3, [PATH_CLOSE] = 0};
    size_t start = 0, at = 0;
    if (!p->points.n)
        return true;
    for (size_t i = 0; i < p->ops.n; i++) {
        if (p->ops.v[i] == PATH_MOVE) {
            if (!is_flat(p->points.v + start, p->points.v + at))
                return false;
            start = at;
        }
        at += points_of[p->ops.v[i]];
    }
    return is_flat(p->points.v + start, p->points.v + at);
}
