/* SPDX-License-Identifier: MIT
 *
 * Medial axis, step 6: between corners a stroke is straight when it nearly is, else smooth: resampled at even steps
 * and averaged over about half the stem's thickness, its ends held.
 */
#include "plan/letter/medial/medial.h"

#include <math.h>
#include <string.h>

/* In stem thicknesses, chosen by eye. */
#define STRAIGHT 0.16 /* a piece that keeps within this of its chord is straight */
#define POINT_STEP 0.3      /* between points */
#define SIGMA 0.55    /* of the average */

typedef ARRAY(point) polyline;

static double off_chord(point a, point b, point p)
{
    point d = point_sub(b, a), v = point_sub(p, a);
    double l = plb_point_length(d);
    return l > 0 ? fabs(point_cross(d, v)) / l : plb_point_length(v);
}

static bool is_straight(const pen_point *p, size_t n, double slack)
{
    for (size_t i = 1; i + 1 < n; i++)
        if (off_chord(p[0].at, p[n - 1].at, p[i].at) > slack)
            return false;
    return plb_point_distance(p[0].at, p[n - 1].at) > 2 * slack;
}

/* Gives points at even steps of about `step` along p, both ends included. */
static bool resample(const pen_point *p, size_t n, double step, polyline *out)
{
    double length = 0, gone = 0;
    for (size_t i = 1; i < n; i++)
        length += plb_point_distance(p[i - 1].at, p[i].at);
    size_t steps = (size_t)fmax(ceil(length / step), 4), i = 1;
    if (!array_reserve(out, steps + 1))
        return false;
    for (size_t k = 0; k <= steps; k++) {
        double want = length * (double)k / (double)steps;
        double piece = plb_point_distance(p[i - 1].at, p[i].at);
        while (i + 1 < n && gone + piece < want) {
            gone += piece;
            i++;
            piece = plb_point_distance(p[i - 1].at, p[i].at);
        }
        out->v[out->n++] = point_mix(p[i - 1].at, p[i].at, piece > 0 ? fmin(1, (want - gone) / piece) : 0);
    }
    return true;
}

/* Does passes of (1 2 1)/4: each adds 1/2 to the variance, in steps squared. `ring`: the ends are one point like any. */
static void average(polyline *q, bool ring)
{
    int passes = (int)lround(2 * (SIGMA / POINT_STEP) * (SIGMA / POINT_STEP));
    size_t n = q->n;
    for (int pass = 0; pass < passes; pass++) {
        point before = ring ? q->v[n - 2] : q->v[0];
        for (size_t i = ring ? 0 : 1; i + 1 < n; i++) {
            point here = q->v[i];
            q->v[i] = point_mix(point_mix(before, q->v[i + 1], 0.5), here, 0.5);
            before = here;
        }
        if (ring)
            q->v[n - 1] = q->v[0];
    }
}

/* Smooths one piece, corner to corner. */
static bool smooth_piece(const pen_point *p, size_t n, bool ring, double stem, polyline *q)
{
    q->n = 0;
    if (!ring && is_straight(p, n, STRAIGHT * stem))
        return array_push(q, p[0].at) && array_push(q, p[n - 1].at);
    if (!resample(p, n, POINT_STEP * stem, q))
        return false;
    average(q, ring);
    return true;
}

static bool append(pen *to, const polyline *q, bool corner_first, bool corner_last)
{
    size_t skip = to->points.n > to->strokes.v[to->strokes.n - 1].first; /* a piece starts where the last one ended */
    if (!array_reserve(&to->points, q->n))
        return false;
    for (size_t i = skip; i < q->n; i++)
        to->points.v[to->points.n++] = (pen_point){q->v[i], i == 0 ? corner_first : i + 1 == q->n && corner_last};
    return true;
}

static bool smooth_stroke(const pen *p, const pen_stroke *s, double stem, pen *to, polyline *q)
{
    pen_stroke made = {to->points.n, 0, s->closed};
    const pen_point *v = p->points.v + s->first;
    if (!array_push(&to->strokes, made))
        return false;
    for (size_t from = 0, i = 1; i < s->n; i++) {
        if (!v[i].corner && i + 1 < s->n)
            continue;
        bool ring = s->closed && from == 0 && i + 1 == s->n && !v[0].corner;
        if (!smooth_piece(v + from, i + 1 - from, ring, stem, q) || !append(to, q, v[from].corner, v[i].corner))
            return false;
        from = i;
    }
    if (s->n == 1 && !array_push(&to->points, v[0]))
        return false;
    to->strokes.v[to->strokes.n - 1].n = to->points.n - made.first;
    return true;
}

bool plb_pen_smooth(pen *p, double stem, error *err)
{
    pen smooth = {0};
    polyline q = {0};
    bool ok = true;
    for (size_t i = 0; ok && i < p->strokes.n; i++)
        ok = smooth_stroke(p, &p->strokes.v[i], stem, &smooth, &q);
    array_free(&q);
    plb_pen_free(ok ? p : &smooth);
    if (ok)
        *p = smooth;
    return ok || plb_fail_memory(err);
}
