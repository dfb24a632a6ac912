/* SPDX-License-Identifier: MIT */
#include "base/geometry/geom.h"

#include <math.h>

matrix plb_matrix_multiply(matrix a, matrix b)
{
    return (matrix){
        a.xx * b.xx + a.yx * b.xy,        a.xx * b.yx + a.yx * b.yy,
        a.xy * b.xx + a.yy * b.xy,        a.xy * b.yx + a.yy * b.yy,
        a.x0 * b.xx + a.y0 * b.xy + b.x0, a.x0 * b.yx + a.y0 * b.yy + b.y0,
    };
}

matrix plb_matrix_scale(double sx, double sy)
{
    return (matrix){sx, 0, 0, sy, 0, 0};
}

matrix plb_matrix_rotate(double radians)
{
    double c = cos(radians), s = sin(radians);
    return (matrix){c, s, -s, c, 0, 0};
}

double plb_matrix_determinant(matrix m)
{
    return m.xx * m.yy - m.xy * m.yx;
}

bool plb_matrix_invert(matrix m, matrix *out)
{
    double det = plb_matrix_determinant(m);
    if (!isfinite(det) || fabs(det) < 1e-300 || !isfinite(m.x0) || !isfinite(m.y0))
        return false;
    matrix r = {m.yy / det, -m.yx / det, -m.xy / det, m.xx / det, 0, 0};
    r.x0 = -(m.x0 * r.xx + m.y0 * r.xy);
    r.y0 = -(m.x0 * r.yx + m.y0 * r.yy);
    *out = r;
    return true;
}

double plb_matrix_expansion(matrix m)
{
    return sqrt(fabs(plb_matrix_determinant(m)));
}

double plb_matrix_turn(matrix m, double degrees)
{
    double a = degrees * PLB_PI / 180;
    point along = plb_matrix_apply_vector(m, (point){cos(a), sin(a)});
    double turned = atan2(along.y, along.x) * 180 / PLB_PI;
    return plb_point_length(along) > 0 && isfinite(turned) ? turned : degrees;
}

bool plb_point_is_steep(point way)
{
    return fabs(way.y) > 1.7320508 * fabs(way.x);
}

void plb_box_add(box *b, point p)
{
    if (p.x < b->x0) b->x0 = p.x;
    if (p.y < b->y0) b->y0 = p.y;
    if (p.x > b->x1) b->x1 = p.x;
    if (p.y > b->y1) b->y1 = p.y;
}

bool plb_box_is_empty(box b)
{
    return b.x1 < b.x0 || b.y1 < b.y0;
}
