/* SPDX-License-Identifier: MIT
 *
 * Where a gradient in units of its shape's box lies, for the CairoScript reader.
 *
 * librsvg takes that box from the shape's box in the recording's units. Where those are turned against the page (tap_svg.c)
 * it gets the upright box about a turned box, too large. A gradient that fills just such a box, exactly, is brought back to
 * the shape's own; one with a transform of its own cannot be told and stays.
 */
#include "tap/svg/cairoscript_state.h"

/* So many points of a curve give its bounds. */
#define CURVE_POINTS 16
/* A gradient's box counts as the unit square up to this distance, in the box's own units. */
#define BOX_SLACK 0.02

static point on_curve(const point p[4], double t)
{
    double s = 1 - t, w0 = s * s * s, w1 = 3 * s * s * t, w2 = 3 * s * t * t, w3 = t * t * t;
    return (point){w0 * p[0].x + w1 * p[1].x + w2 * p[2].x + w3 * p[3].x, w0 * p[0].y + w1 * p[1].y + w2 * p[2].y + w3 * p[3].y};
}

/* Gives the box of the path itself, mapped by m, not of its control points. */
static box drawn_bounds(const path *p, matrix m)
{
    box b = BOX_EMPTY;
    const point *at = p->points.v;
    for (size_t i = 0; i < p->ops.n; i++)
        if (p->ops.v[i] == PATH_CURVE) {
            for (int k = 1; k <= CURVE_POINTS; k++)
                plb_box_add(&b, plb_matrix_apply(m, on_curve(at - 1, (double)k / CURVE_POINTS)));
            at += 3;
        } else if (p->ops.v[i] != PATH_CLOSE) {
            plb_box_add(&b, plb_matrix_apply(m, *at++));
        }
    return b;
}

static box box_about(box b, matrix m)
{
    box out = BOX_EMPTY;
    plb_box_add(&out, plb_matrix_apply(m, (point){b.x0, b.y0}));
    plb_box_add(&out, plb_matrix_apply(m, (point){b.x1, b.y0}));
    plb_box_add(&out, plb_matrix_apply(m, (point){b.x1, b.y1}));
    plb_box_add(&out, plb_matrix_apply(m, (point){b.x0, b.y1}));
    return out;
}

static bool is_at(matrix m, double x, double y, point expected)
{
    return plb_point_distance(plb_matrix_apply(m, (point){x, y}), expected) < BOX_SLACK;
}

matrix plb_script_gradient_matrix(const script_state *s, const script_pattern *p, const path *fills)
{
    matrix upright = s->to_page, back;
    upright.x0 = upright.y0 = 0;
    if (!plb_matrix_invert(upright, &back) || !fills->points.n)
        return p->matrix;
    matrix m = plb_matrix_multiply(back, p->matrix);
    box taken = box_about(drawn_bounds(fills, MATRIX_IDENTITY), upright), own = drawn_bounds(fills, upright);
    double w = own.x1 - own.x0, h = own.y1 - own.y0;
    bool is_box = is_at(m, taken.x0, taken.y0, (point){0, 0}) && is_at(m, taken.x1, taken.y0, (point){1, 0}) && is_at(m, taken.x0, taken.y1, (point){0, 1});
    if (!is_box || !(w > 0 && h > 0))
        return p->matrix;
    return plb_matrix_multiply(upright, (matrix){1 / w, 0, 0, 1 / h, -own.x0 / w, -own.y0 / h});
}
