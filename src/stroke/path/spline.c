/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 2: the control points become a path (001 section 3.1: "control points for a Catmull-Rom
 * interpolating spline").
 * Input: the stroke's base line, a polyline in mm, and its control points. Output: samples of the drawn path.
 *
 * The spline runs in the line's own frame: `along` the base line and `off` it. On a straight base line this is the
 * papers' spline exactly. On a curved one, where they are silent, the deviation rides on the curve's normal.
 */
#include "stroke/path/spline.h"

#include <math.h>

/* Samples lie this close together on curves, and this on straight lines, whose spline bends little (chosen by eye). */
#define STEP_CURVED_MM 0.25
#define STEP_STRAIGHT_MM 0.5
/* A small curve still gets this many. */
#define FEWEST_SAMPLES 16

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

/* Computes the control points with one more at each end, so that the spline reaches the ends: reflected, or on a closed line
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

size_t plb_path_spline_controls(const arm_model *arm, double length, point way, const stroke *s, const stroke_options *o, control c[CONTROLS_MAX])
{
    size_t n = plb_movement_controls(arm, length, way, s->identity, o, c);
    if (s->closed) {
        c[1].off *= JOINT_DEVIATION;
        c[n - 2].off *= JOINT_DEVIATION;
    }
    return n;
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

/* Computes the samples of one spline piece between control points 1 and 2 of c[0..3]. */
static bool sample_piece(base_line *b, const control c[4], double length, size_t wanted, path_samples *out)
{
    double share = fabs(c[2].along - c[1].along) / length;
    size_t n = (size_t)ceil(share * (double)wanted) + 1;
    if (!array_reserve(out, n))
        return false;
    for (size_t i = 1; i <= n; i++) {
        double u = (double)i / (double)n, along = c[1].along + u * (c[2].along - c[1].along);
        out->v[out->n++].at = plb_base_place(b, along, catmull_rom(c, along));
    }
    return true;
}

bool plb_path_spline(base_line *b, const arm_model *arm, const stroke *s, double length, const stroke_options *o, path_samples *out)
{
    control c[CONTROLS_MAX], all[CONTROLS_MAX + 2];
    size_t n = plb_path_spline_controls(arm, length, plb_base_way(b), s, o, c), wanted = count_samples(s, length);
    extend(c, n, s->closed, all);
    path_sample start = {.at = b->v[0]};
    if (!array_push(out, start))
        return false;
    for (size_t k = 0; k + 1 < n; k++)
        if (!sample_piece(b, all + k, length, wanted, out))
            return false;
    plb_path_measure(out, s->closed);
    return true;
}
