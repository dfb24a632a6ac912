/* SPDX-License-Identifier: MIT
 *
 * The base line of a path, and what closes every path: arc lengths and tangents.
 * A base line is what the plan says; a path is what the hand makes of it.
 */
#include "stroke/path.h"

base_line plb_base_line(const stroke_list *list, const stroke *s)
{
    return (base_line){list->points.v + s->first, s->n, 0, 0, s->closed};
}

double plb_base_length(const base_line *b)
{
    double sum = 0;
    for (size_t i = 1; i < b->n; i++)
        sum += plb_point_distance(b->v[i - 1], b->v[i]);
    return sum;
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

point plb_base_place(base_line *b, double along, double off)
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

void plb_path_measure(path_samples *out, bool closed)
{
    size_t n = 1;
    out->v[0].along = 0;
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
