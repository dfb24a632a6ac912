/* SPDX-License-Identifier: MIT
 *
 * See timing.h.
 */
#include "film/timing.h"

#include "base/geometry/interpolate.h"
#include "stroke/arm/arm.h"

#include <math.h>

/* Time grows by this power of the length: speed grows with length, so that strokes take nearly as long as each other (Viviani and Flash 1995, who call that isochrony, find
 * that speed grows by about the power of 0.6; here by 0.5, so that long lines are seen to be drawn: chosen by eye). */
#define TIME_POWER 0.5
/* Two thirds of a power law: speed falls with the cube root of the curvature (Lacquaniti, Terzuolo and Viviani 1983). */
#define BEND_POWER (1.0 / 3)
/* Straight parts count as if they bent this much, 1/mm: else all speed would be theirs (chosen by eye). */
#define LEAST_BEND 0.05

double plb_film_time(double mm)
{
    return mm > 0 ? pow(mm, TIME_POWER) : 0;
}

bool plb_film_clock_set(stroke_clock *c, const path_samples *path)
{
    c->effort.n = 0;
    if (!array_reserve(&c->effort, path->n + 1))
        return false;
    double sum = 0;
    for (size_t i = 0; i < path->n; i++) {
        if (i > 0) {
            point a = path->v[i - 1].tangent, b = path->v[i].tangent;
            double step = path->v[i].along - path->v[i - 1].along;
            double turn = fabs(atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
            sum += step > 0 ? step * pow(turn / step + LEAST_BEND, BEND_POWER) : 0;
        }
        c->effort.v[c->effort.n++] = sum;
    }
    return true;
}

double plb_film_clock_along(const stroke_clock *c, const path_samples *path, double tau)
{
    size_t n = c->effort.n, low = 0, high = n - 1;
    double meant = plb_minimum_jerk(0, clamp(tau, 0, 1)) * c->effort.v[n - 1];
    /* A hand that starts at the last sample does that part's effort first. */
    if (path->backward)
        meant = c->effort.v[n - 1] - meant;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        *(c->effort.v[middle] <= meant ? &low : &high) = middle;
    }
    double part = c->effort.v[high] - c->effort.v[low], share = part > 0 ? clamp((meant - c->effort.v[low]) / part, 0, 1) : 0;
    double along = path->v[low].along + share * (path->v[high].along - path->v[low].along);
    return path->backward ? path->v[n - 1].along - along : along;
}
