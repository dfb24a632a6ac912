/* SPDX-License-Identifier: MIT */
#include "base/geometry/path.h"

#include <math.h>
#include <string.h>

static const unsigned points_of_op[] = {1, 1, 3, 0};

static bool append(path *p, path_op op, const point *points)
{
    unsigned n = points_of_op[op];
    if (!array_reserve(&p->ops, 1) || !array_reserve(&p->points, n))
        return false;
    p->ops.v[p->ops.n++] = (uint8_t)op;
    for (unsigned i = 0; i < n; i++)
        p->points.v[p->points.n++] = points[i];
    return true;
}

bool plb_path_move(path *p, point to)
{
    if (p->ops.n && p->ops.v[p->ops.n - 1] == PATH_MOVE) { /* a move after a move replaces it */
        p->points.v[p->points.n - 1] = to;
        return true;
    }
    return append(p, PATH_MOVE, &to);
}

bool plb_path_line(path *p, point to)
{
    return append(p, p->ops.n ? PATH_LINE : PATH_MOVE, &to);
}

bool plb_path_curve(path *p, point c1, point c2, point to)
{
    point all[3] = {c1, c2, to};
    if (!p->ops.n && !append(p, PATH_MOVE, &c1))
        return false;
    return append(p, PATH_CURVE, all);
}

bool plb_path_close(path *p)
{
    if (!p->ops.n || p->ops.v[p->ops.n - 1] == PATH_CLOSE)
        return true;
    return append(p, PATH_CLOSE, NULL);
}

/* Appends a Bézier curve for each quarter turn or less, with controls at 4/3 tan(angle/4) of the radius: the standard
 * approximation (Goldapp 1991), whose radial error at a quarter turn is 2.7e-4. */
bool plb_path_arc(path *p, point centre, double radius, double from, double to, bool clockwise, matrix ctm)
{
    double turn = to - from, full = 2 * PLB_PI;
    if (!isfinite(turn) || !isfinite(radius))
        return true;
    if (!clockwise && turn < 0)
        turn = full - fmod(-turn, full);
    if (clockwise && turn > 0)
        turn = -(full - fmod(turn, full));
    if (fabs(turn) > full)
        turn = turn > 0 ? full : -full;
    int pieces = (int)ceil(fabs(turn) / (PLB_PI / 2) - 1e-9);
    if (pieces < 1)
        pieces = 1;
    double step = turn / pieces, k = 4.0 / 3.0 * tan(step / 4) * radius;
    for (int i = 0; i <= pieces; i++) {
        double a = from + step * i, c = cos(a), s = sin(a);
        point at = {centre.x + radius * c, centre.y + radius * s};
        if (i == 0) {
            if (!plb_path_line(p, plb_matrix_apply(ctm, at)))
                return false;
            continue;
        }
        double b = a - step, cb = cos(b), sb = sin(b);
        point c1 = {centre.x + radius * cb - k * sb, centre.y + radius * sb + k * cb};
        point c2 = {at.x + k * s, at.y - k * c};
        if (!plb_path_curve(p, plb_matrix_apply(ctm, c1), plb_matrix_apply(ctm, c2), plb_matrix_apply(ctm, at)))
            return false;
    }
    return true;
}

bool plb_path_append(path *to, const path *from, matrix m)
{
    if (!array_reserve(&to->ops, from->ops.n) || !array_reserve(&to->points, from->points.n))
        return false;
    for (size_t i = 0; i < from->ops.n; i++)
        to->ops.v[to->ops.n++] = from->ops.v[i];
    for (size_t i = 0; i < from->points.n; i++)
        to->points.v[to->points.n++] = plb_matrix_apply(m, from->points.v[i]);
    return true;
}

void plb_path_clear(path *p)
{
    p->ops.n = p->points.n = 0;
}

void plb_path_free(path *p)
{
    array_free(&p->ops);
    array_free(&p->points);
}

bool plb_path_equal(const path *a, const path *b)
{
    if (a->ops.n != b->ops.n || a->points.n != b->points.n)
        return false;
    if (a->ops.n && memcmp(a->ops.v, b->ops.v, a->ops.n))
        return false;
    for (size_t i = 0; i < a->points.n; i++)
        if (a->points.v[i].x != b->points.v[i].x || a->points.v[i].y != b->points.v[i].y)
            return false;
    return true;
}

bool plb_path_is_empty(const path *p)
{
    return p->ops.n == 0;
}

bool plb_path_current(const path *p, point *at)
{
    if (!p->ops.n)
        return false;
    if (p->ops.v[p->ops.n - 1] != PATH_CLOSE) {
        *at = p->points.v[p->points.n - 1];
        return true;
    }
    size_t k = p->points.n;
    for (size_t i = p->ops.n; i-- > 0;) {
        k -= points_of_op[p->ops.v[i]];
        if (p->ops.v[i] == PATH_MOVE)
            break;
    }
    *at = p->points.v[k];
    return true;
}

void plb_path_transform(path *p, matrix m)
{
    for (size_t i = 0; i < p->points.n; i++)
        p->points.v[i] = plb_matrix_apply(m, p->points.v[i]);
}

box plb_path_bounds(const path *p)
{
    box b = BOX_EMPTY;
    for (size_t i = 0; i < p->points.n; i++)
        plb_box_add(&b, p->points.v[i]);
    return b;
}
