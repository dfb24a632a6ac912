/* SPDX-License-Identifier: MIT
 *
 * See fit_curves.h. Schneider's method (An algorithm for automatically fitting digitized curves, Graphics Gems, 1990), with
 * the tangents known: one curve by least squares; where it strays too far, two, joined at a sample where it strays most.
 */
#include "base/geometry/fit_curves.h"

#include <math.h>

/* No curve is tried for more samples than this: their number bounds the time for each. */
#define MAX_SAMPLES 256
/* How often the samples' places on a curve are looked for before it is divided. */
#define ROUNDS 4
/* A curve that strays farther than so many times what it may is divided at once. */
#define HOPELESS 6

typedef struct {
    point p[4];
} cubic;

static point at(const cubic *c, double t)
{
    double s = 1 - t, b0 = s * s * s, b1 = 3 * s * s * t, b2 = 3 * s * t * t, b3 = t * t * t;
    return (point){b0 * c->p[0].x + b1 * c->p[1].x + b2 * c->p[2].x + b3 * c->p[3].x, b0 * c->p[0].y + b1 * c->p[1].y + b2 * c->p[2].y + b3 * c->p[3].y};
}

static double dot(point a, point b) { return a.x * b.x + a.y * b.y; }

/* The curve with the end points and tangents of the samples that lies nearest to them, in the sense of least squares, where
 * sample i has parameter t[i]: two lengths of tangents, by Cramer's rule. */
static cubic best_cubic(const fit_sample *v, size_t n, const double *t)
{
    point first = v[0].at, last = v[n - 1].at, into = v[0].tangent, back = point_scale(v[n - 1].tangent, -1);
    double c00 = 0, c01 = 0, c11 = 0, x0 = 0, x1 = 0, chord = plb_point_distance(first, last);
    for (size_t i = 0; i < n; i++) {
        double u = t[i], s = 1 - u, b1 = 3 * s * s * u, b2 = 3 * s * u * u, b0 = s * s * s + b1, b3 = u * u * u + b2;
        point a0 = point_scale(into, b1), a1 = point_scale(back, b2);
        point rest = {v[i].at.x - b0 * first.x - b3 * last.x, v[i].at.y - b0 * first.y - b3 * last.y};
        c00 += dot(a0, a0);
        c01 += dot(a0, a1);
        c11 += dot(a1, a1);
        x0 += dot(a0, rest);
        x1 += dot(a1, rest);
    }
    double det = c00 * c11 - c01 * c01, reach0 = chord / 3, reach1 = chord / 3;
    if (fabs(det) > 1e-12 * c00 * c11) {
        reach0 = (x0 * c11 - x1 * c01) / det;
        reach1 = (c00 * x1 - c01 * x0) / det;
    }
    if (!(reach0 > 1e-3 * chord && reach1 > 1e-3 * chord && reach0 < 10 * chord && reach1 < 10 * chord))
        reach0 = reach1 = chord / 3;
    return (cubic){{first, point_add(first, point_scale(into, reach0)), point_add(last, point_scale(back, reach1)), last}};
}

/* A step of Newton's method towards the place on the curve that is nearest to `to`. */
static double nearer(const cubic *c, point to, double t)
{
    double s = 1 - t;
    point d[3], e[2];
    for (int k = 0; k < 3; k++)
        d[k] = point_scale(point_sub(c->p[k + 1], c->p[k]), 3);
    for (int k = 0; k < 2; k++)
        e[k] = point_scale(point_sub(d[k + 1], d[k]), 2);
    point off = point_sub(at(c, t), to);
    point d1 = point_add(point_add(point_scale(d[0], s * s), point_scale(d[1], 2 * s * t)), point_scale(d[2], t * t));
    point d2 = point_add(point_scale(e[0], s), point_scale(e[1], t));
    double slope = dot(d1, d1) + dot(off, d2);
    double moved = slope > 0 ? t - dot(off, d1) / slope : t;
    return moved < 0 ? 0 : moved > 1 ? 1 : moved;
}

/* The largest distance of a sample from its place on the curve, and which sample has it. */
static double worst_error(const cubic *c, const fit_sample *v, size_t n, const double *t, size_t *which)
{
    double worst = 0;
    for (size_t i = 1; i + 1 < n; i++) {
        double d = plb_point_distance(at(c, t[i]), v[i].at);
        if (d > worst) {
            worst = d;
            *which = i;
        }
    }
    return worst;
}

static bool is_straight(const fit_sample *v, size_t n, double max_error)
{
    point from = v[0].at, way = point_sub(v[n - 1].at, from);
    double length = plb_point_length(way);
    for (size_t i = 1; i + 1 < n; i++) {
        point to = point_sub(v[i].at, from);
        double on = length > 0 ? dot(to, way) / length : -1;
        if (on < 0 || on > length || fabs(to.x * way.y - to.y * way.x) > max_error * length)
            return false;
    }
    return true;
}

/* One line or curve for all samples; false, and where to divide them, when none is near enough. */
static bool fit_one(const fit_sample *v, size_t n, double max_error, cubic *c, size_t *divide)
{
    double t[MAX_SAMPLES];
    double length = v[n - 1].along - v[0].along;
    for (size_t i = 0; i < n; i++)
        t[i] = (v[i].along - v[0].along) / length;
    *divide = n / 2;
    for (int round = 0; round < ROUNDS; round++) {
        *c = best_cubic(v, n, t);
        double error = worst_error(c, v, n, t, divide);
        if (error <= max_error)
            return true;
        if (error > HOPELESS * max_error)
            return false;
        for (size_t i = 1; i + 1 < n; i++)
            t[i] = nearer(c, v[i].at, t[i]);
    }
    return false;
}

/* Not near an end, so that the depth of recursion is a logarithm of their number. */
static size_t keep_inside(size_t divide, size_t n)
{
    size_t least = n / 8 > 0 ? n / 8 : 1, most = n - 1 - least;
    return divide < least ? least : divide > most ? most : divide;
}

static bool fit(const fit_sample *v, size_t n, double max_error, path *out)
{
    cubic c;
    size_t divide = n / 2;
    if (n == 2 || (n <= MAX_SAMPLES && is_straight(v, n, max_error)))
        return plb_path_line(out, v[n - 1].at);
    if (n <= MAX_SAMPLES && fit_one(v, n, max_error, &c, &divide))
        return plb_path_curve(out, c.p[1], c.p[2], c.p[3]);
    divide = keep_inside(divide, n);
    return fit(v, divide + 1, max_error, out) && fit(v + divide, n - divide, max_error, out);
}

bool plb_fit_curves(const fit_sample *v, size_t n, double max_error, path *out)
{
    return plb_path_move(out, v[0].at) && fit(v, n, max_error, out);
}
