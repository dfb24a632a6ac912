/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: polylines become curves again. Points on a straight line are dropped: what is straight is one
 * straight stroke. Where a program has flattened a curve coarsely, so that the line turns a little at every vertex,
 * the curve through the vertices is put back (Hermite pieces, tangents along the neighbours' chord).
 */
#include "plan/strokes/passes.h"

#include "plan/shape/flatten.h"

#include <math.h>

/* A point this close to the line of its neighbours says nothing. */
#define STRAIGHT_MM 0.01
/* A curve is put back where it lies no farther than this from the chord: beyond, the line is meant to have a bend, or
 * the guess could be wrong (chosen by eye; half a pencil's line). */
#define MAX_BULGE_MM 0.25
/* Where it lies closer than this it is as good as there. */
#define MIN_BULGE_MM 0.02
/* Neighbouring chords of one curve are of about the same length. */
#define MAX_CHORD_RATIO 3.0

typedef ARRAY(point) points;

/* ---- straight runs ---- */

/* A sleeve holds the directions from the anchor that keep all points since within tolerance: an angle about the first of them. */
typedef struct {
    point anchor;
    double first, low, high;
    bool is_open; /* nothing is known yet */
    double reach; /* the farthest point's distance: turning back is no straight run */
} sleeve;

static bool takes(sleeve *s, point p)
{
    point d = point_sub(p, s->anchor);
    double r = plb_point_length(d), a = atan2(d.y, d.x), half = r > STRAIGHT_MM ? asin(STRAIGHT_MM / r) : PLB_PI / 2;
    if (s->is_open) {
        *s = (sleeve){s->anchor, a, -half, half, false, r};
        return true;
    }
    double turn = remainder(a - s->first, 2 * PLB_PI);
    if (turn < s->low || turn > s->high || r < s->reach)
        return false;
    s->low = fmax(s->low, turn - half);
    s->high = fmin(s->high, turn + half);
    s->reach = r;
    return true;
}

static bool thin(const point *at, size_t n, points *out)
{
    sleeve s = {.anchor = at[0], .is_open = true};
    out->n = 0;
    bool ok = array_push(out, at[0]);
    for (size_t i = 1; ok && i < n; i++)
        if (!takes(&s, at[i])) {
            ok = array_push(out, at[i - 1]);
            s = (sleeve){.anchor = at[i - 1], .is_open = true};
            takes(&s, at[i]);
        }
    return ok && array_push(out, at[n - 1]);
}

/* ---- curves ---- */

/* Gives the unit tangent at vertex `k` if the line is part of a curve there, else zero. */
static point tangent_at(const point *v, size_t n, bool closed, size_t k)
{
    bool end = k == 0 || k + 1 == n;
    if (end && !closed)
        return (point){0, 0};
    point before = v[k == 0 ? n - 2 : k - 1], after = v[k + 1 == n ? 1 : k + 1];
    point in = point_sub(v[k], before), out = point_sub(after, v[k]);
    double a = plb_point_length(in), b = plb_point_length(out);
    if (!(a > 0 && b > 0) || a > MAX_CHORD_RATIO * b || b > MAX_CHORD_RATIO * a || point_dot(in, out) < cos(CORNER_DEGREES * PLB_PI / 180) * a * b)
        return (point){0, 0};
    point along = point_add(point_scale(in, b / a), point_scale(out, a / b)); /* the circle's tangent through the three */
    double length = plb_point_length(along);
    return length > 0 ? point_scale(along, 1 / length) : (point){0, 0};
}

static double turn_between(point a, point b)
{
    return fabs(atan2(point_cross(a, b), point_dot(a, b)));
}

/* Appends the curve from a to b, b included, with these tangents; a zero one is along the chord. */
static bool add_piece(points *out, point a, point b, point ta, point tb)
{
    point chord = point_sub(b, a);
    double length = plb_point_length(chord);
    bool has_a = ta.x != 0 || ta.y != 0, has_b = tb.x != 0 || tb.y != 0;
    double turn_a = has_a ? turn_between(ta, chord) : 0, turn_b = has_b ? turn_between(chord, tb) : 0;
    double bulge = length / 8 * (turn_a + turn_b);
    if (!(bulge > MIN_BULGE_MM && bulge < MAX_BULGE_MM))
        return array_push(out, b);
    point pull_a = has_a ? point_scale(ta, length) : chord, pull_b = has_b ? point_scale(tb, length) : chord;
    double steps = ceil(fmax((turn_a + turn_b) / (FLAT_TURN_DEGREES * PLB_PI / 180), sqrt(bulge / FLATNESS_MM)));
    bool ok = true;
    for (int i = 1; ok && i < (int)steps; i++) {
        double t = i / steps, u = 1 - t;
        double h0 = (1 + 2 * t) * u * u, h1 = t * u * u, h2 = t * t * (3 - 2 * t), h3 = -t * t * u;
        point p = {h0 * a.x + h1 * pull_a.x + h2 * b.x + h3 * pull_b.x, h0 * a.y + h1 * pull_a.y + h2 * b.y + h3 * pull_b.y};
        ok = array_push(out, p);
    }
    return ok && array_push(out, b);
}

static bool bend(const point *v, size_t n, bool closed, points *out)
{
    out->n = 0;
    bool ok = array_push(out, v[0]);
    point before = tangent_at(v, n, closed, 0);
    for (size_t k = 1; ok && k < n; k++) {
        point here = tangent_at(v, n, closed, k);
        ok = add_piece(out, v[k - 1], v[k], before, here);
        before = here;
    }
    return ok;
}

bool plb_plan_smooth(stroke_list *list, error *err)
{
    stroke_list made = {.width = list->width, .height = list->height};
    points thinned = {0}, bent = {0};
    bool ok = true;
    for (size_t i = 0; ok && i < list->strokes.n; i++) {
        const stroke *s = &list->strokes.v[i];
        ok = thin(list->points.v + s->first, s->n, &thinned) && bend(thinned.v, thinned.n, s->closed, &bent);
        ok = ok && plb_plan_append(&made, s, bent.v, bent.n);
    }
    array_free(&thinned);
    array_free(&bent);
    plb_plan_replace(list, &made);
    return ok || plb_fail_memory(err);
}
