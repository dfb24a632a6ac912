/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 2: the control points become a path (001 section 3.1: "control points for a Catmull-Rom
 * interpolating spline").
 * Input: the stroke's base line, a polyline in mm, and its control points. Output: samples of the drawn path.
 *
 * The spline runs in the line's own frame: `along` the base line and `off` it. On a straight base line this is the
 * papers' spline exactly. On a curved one, where they are silent, the deviation rides on the curve's normal.
 */
#include "base/units.h"
#include "stroke/stroke.h"

#include <math.h>

/* Samples lie this close together on curves, and this on straight lines, whose spline bends little (chosen by eye). */
#define STEP_CURVED_MM 0.25
#define STEP_STRAIGHT_MM 0.5
/* A small curve still gets this many. */
#define FEWEST_SAMPLES 16
/* A stroke longer than this is not a drawing's: half a kilometre of pencil. */
#define LONGEST_MM 5e5

/* A base line with a cursor, since it is read from start to end. */
typedef struct {
    const point *v;
    size_t n, at;    /* the segment from at to at + 1 … */
    double passed;   /* … begins at this arc length */
    bool closed;
} base_line;

static double length_of(const point *v, size_t n)
{
    double sum = 0;
    for (size_t i = 1; i < n; i++)
        sum += plb_point_distance(v[i - 1], v[i]);
    return sum;
}

/* Catmull-Rom (Catmull & Rom 1974) from b to c at `along`, knots at the control points' distances along the line. The
 * papers do not say how the spline is parametrised; with evenly spaced knots it would run past the end and back, since
 * equation 1 crowds the control points there. */
static double catmull_rom(const control k[4], double along)
{
    double before = k[1].along - k[0].along, h = k[2].along - k[1].along, after = k[3].along - k[2].along;
    double slope = (k[2].off - k[1].off) / h, u = (along - k[1].along) / h;
    double slope1 = ((k[1].off - k[0].off) / before * h + slope * before) / (before + h);
    double slope2 = (slope * after + (k[3].off - k[2].off) / after * h) / (h + after);
    double v = 1 - u;
    return k[1].off * v * v * (1 + 2 * u) + k[2].off * u * u * (3 - 2 * u) + h * u * v * (slope1 * v - slope2 * u);
}

/* The control points with one more at each end, so that the spline reaches the ends: reflected, or on a closed line
 * those from the other side of the joint, so that it runs on smoothly. */
static void extend(const control *c, size_t n, bool closed, control out[CONTROLS_MAX + 2])
{
    for (size_t i = 0; i < n; i++)
        out[i + 1] = c[i];
    double length = c[n - 1].along;
    if (closed) {
        out[0] = (control){c[n - 2].along - length, c[n - 2].off};
        out[n + 1] = (control){c[1].along + length, c[1].off};
        return;
    }
    out[0] = (control){2 * c[0].along - c[1].along, 2 * c[0].off - c[1].off};
    out[n + 1] = (control){2 * c[n - 1].along - c[n - 2].along, 2 * c[n - 1].off - c[n - 2].off};
}

/* A closed line has no ends: what deviates close to its joint would be a kink there (chosen by eye). */
#define JOINT_DEVIATION 0.25

static size_t controls_of(double length, const stroke *s, const stroke_options *o, control c[CONTROLS_MAX])
{
    size_t n = plb_path_controls(length, s->identity, o, c);
    if (s->closed) {
        c[1].off *= JOINT_DEVIATION;
        c[n - 2].off *= JOINT_DEVIATION;
    }
    return n;
}

/* The direction at a vertex: between its two segments'. */
static point vertex_tangent(const base_line *b, size_t i)
{
    point before = {0, 0}, after = {0, 0};
    if (i > 0 || b->closed)
        before = point_sub(b->v[i], b->v[i > 0 ? i - 1 : b->n - 2]);
    if (i + 1 < b->n || b->closed)
        after = point_sub(b->v[i + 1 < b->n ? i + 1 : 1], b->v[i]);
    double lb = plb_point_length(before), la = plb_point_length(after);
    point sum = {0, 0};
    if (lb > 0)
        sum = point_add(sum, point_scale(before, 1 / lb));
    if (la > 0)
        sum = point_add(sum, point_scale(after, 1 / la));
    double l = plb_point_length(sum);
    if (l < 1e-9) /* a full turn back */
        return la > 0 ? point_scale(after, 1 / la) : point_scale(before, 1 / lb);
    return point_scale(sum, 1 / l);
}

/* The place `along` mm from the start and `off` mm to the left of the direction there; moves the cursor. */
static point place(base_line *b, double along, double off)
{
    double length = plb_point_distance(b->v[b->at], b->v[b->at + 1]);
    while (along > b->passed + length && b->at + 2 < b->n) {
        b->passed += length;
        b->at++;
        length = plb_point_distance(b->v[b->at], b->v[b->at + 1]);
    }
    while (along < b->passed && b->at > 0) {
        b->at--;
        length = plb_point_distance(b->v[b->at], b->v[b->at + 1]);
        b->passed -= length;
    }
    double t = (along - b->passed) / length;
    point on = point_mix(b->v[b->at], b->v[b->at + 1], t);
    double clamped = t < 0 ? 0 : t > 1 ? 1 : t;
    point tangent = point_mix(vertex_tangent(b, b->at), vertex_tangent(b, b->at + 1), clamped);
    double l = plb_point_length(tangent);
    if (off == 0 || l < 1e-9)
        return on;
    return (point){on.x + off * tangent.y / l, on.y - off * tangent.x / l};
}

/* Arc lengths and tangents of samples whose places are known; samples that coincide with the one before are dropped. */
static void measure(path_samples *out, bool closed)
{
    size_t n = 1;
    for (size_t i = 1; i < out->n; i++) {
        double step = plb_point_distance(out->v[n - 1].at, out->v[i].at);
        if (step < 1e-6)
            continue;
        out->v[n] = out->v[i];
        out->v[n].along = out->v[n - 1].along + step;
        n++;
    }
    out->n = n;
    base_line b = {.n = n, .closed = closed && n > 3};
    for (size_t i = 0; n > 1 && i < n; i++) {
        point around[3] = {i > 0 ? out->v[i - 1].at : b.closed ? out->v[n - 2].at : out->v[0].at, out->v[i].at,
                           i + 1 < n ? out->v[i + 1].at : b.closed ? out->v[1].at : out->v[n - 1].at};
        base_line local = {around, 3, 0, 0, false};
        out->v[i].tangent = vertex_tangent(&local, 1);
    }
}

static bool is_straight(const stroke *s)
{
    return s->n == 2;
}

static size_t count_samples(const stroke *s, double length)
{
    double step = is_straight(s) ? STEP_STRAIGHT_MM : STEP_CURVED_MM;
    double n = ceil(length / step);
    return n < FEWEST_SAMPLES ? FEWEST_SAMPLES : (size_t)n;
}

/* The samples of one spline piece between control points 1 and 2 of c[0..3]. */
static bool sample_piece(base_line *b, const control c[4], double length, size_t wanted, path_samples *out)
{
    double share = fabs(c[2].along - c[1].along) / length;
    size_t n = (size_t)ceil(share * (double)wanted) + 1;
    if (!array_reserve(out, n))
        return false;
    for (size_t i = 1; i <= n; i++) {
        double u = (double)i / (double)n, along = c[1].along + u * (c[2].along - c[1].along);
        out->v[out->n++].at = place(b, along, catmull_rom(c, along));
    }
    return true;
}

/* The papers' path: a spline through the control points. */
static bool sample_spline(base_line *b, const stroke *s, double length, const stroke_options *o, path_samples *out)
{
    control c[CONTROLS_MAX], all[CONTROLS_MAX + 2];
    size_t n = controls_of(length, s, o, c), wanted = count_samples(s, length);
    extend(c, n, s->closed, all);
    path_sample start = {.at = b->v[0]};
    if (!array_push(out, start))
        return false;
    for (size_t k = 0; k + 1 < n; k++)
        if (!sample_piece(b, all + k, length, wanted, out))
            return false;
    return true;
}

/* The free hand's path: its modes. */
static bool sample_hand(base_line *b, const stroke *s, double length, const stroke_options *o, path_samples *out)
{
    hand h = plb_hand(length, s->closed, s->identity, o);
    size_t n = count_samples(s, length);
    if (!array_reserve(out, n + 1))
        return false;
    for (size_t i = 0; i <= n; i++) {
        double along = length * (double)i / (double)n;
        out->v[out->n++].at = place(b, along, plb_hand_off(&h, along));
    }
    return true;
}

bool plb_path_sample(const stroke_list *list, const stroke *s, const stroke_options *o, path_samples *out, error *err)
{
    base_line b = {list->points.v + s->first, s->n, 0, 0, s->closed};
    double length = length_of(b.v, b.n);
    out->n = 0;
    if (!(length <= LONGEST_MM))
        return plb_fail(err, ERROR_LIMIT, "a stroke is longer than %g m", LONGEST_MM / 1000);
    bool ok = o->arm == ARM_HAND ? sample_hand(&b, s, length, o, out) : sample_spline(&b, s, length, o, out);
    if (!ok)
        return plb_fail_memory(err);
    out->v[0].along = 0;
    measure(out, s->closed);
    return true;
}

size_t plb_path_control_points(const stroke_list *list, const stroke *s, const stroke_options *o, point out[CONTROLS_MAX])
{
    base_line b = {list->points.v + s->first, s->n, 0, 0, s->closed};
    control c[CONTROLS_MAX];
    double length = length_of(b.v, b.n);
    size_t n = controls_of(length, s, o, c);
    hand h = plb_hand(length, s->closed, s->identity, o);
    for (size_t k = 0; k < n; k++)
        out[k] = place(&b, c[k].along, o->arm == ARM_HAND ? plb_hand_off(&h, c[k].along) : c[k].off);
    return n;
}
