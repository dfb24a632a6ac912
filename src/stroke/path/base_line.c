/* SPDX-License-Identifier: MIT
 *
 * The base line of a path, and what closes every path: arc lengths and tangents.
 * A base line is what the plan says; a path is what the hand makes of it.
 */
#include "stroke/path/trajectory.h"

#include <math.h>

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

point plb_base_way(const base_line *b)
{
    return point_sub(b->v[b->n - 1], b->v[0]);
}

double plb_base_extent(const base_line *b)
{
    box around = BOX_EMPTY;
    for (size_t i = 0; i < b->n; i++)
        plb_box_add(&around, b->v[i]);
    return plb_point_length((point){around.x1 - around.x0, around.y1 - around.y0});
}

/* A circle's points lie about its centre within this share of its radius (chosen by eye: a rounded square is none), and are at least so many. */
#define ROUND_WITHIN 0.04
#define ROUND_POINTS 8

double plb_base_radius(const base_line *b)
{
    box around = BOX_EMPTY;
    for (size_t i = 0; i < b->n; i++)
        plb_box_add(&around, b->v[i]);
    point centre = {(around.x0 + around.x1) / 2, (around.y0 + around.y1) / 2};
    double radius = (around.x1 - around.x0 + around.y1 - around.y0) / 4;
    bool is_round = b->closed && b->n > ROUND_POINTS;
    for (size_t i = 0; is_round && i < b->n; i++)
        is_round = fabs(plb_point_distance(b->v[i], centre) - radius) <= ROUND_WITHIN * radius;
    return is_round ? radius : 0;
}

/* Gives the direction at a vertex: between its two segments'. */
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

/* Gives the unit vector from a to b, which are `length` apart. */
static point unit_between(point a, point b, double length)
{
    return point_scale(point_sub(b, a), 1 / length);
}

/* Gives the direction between two unit vectors, one of which may be zero: an end. */
static point between(point before, point after)
{
    point sum = point_add(before, after);
    double l = plb_point_length(sum);
    return l < 1e-9 ? (after.x == 0 && after.y == 0 ? before : after) : point_scale(sum, 1 / l);
}

/* Drops samples that coincide with the one before, sums up the way, and leaves the direction from the sample before in
 * `tangent`. */
static void sum_steps(path_samples *out)
{
    size_t n = 1;
    out->v[0].along = 0;
    out->v[0].tangent = (point){0, 0};
    for (size_t i = 1; i < out->n; i++) {
        double step = plb_point_distance(out->v[n - 1].at, out->v[i].at);
        if (step < 1e-6)
            continue;
        out->v[n].at = out->v[i].at;
        out->v[n].along = out->v[n - 1].along + step;
        out->v[n].tangent = unit_between(out->v[n - 1].at, out->v[n].at, step);
        n++;
    }
    out->n = n;
}

void plb_path_measure(path_samples *out, bool closed)
{
    sum_steps(out);
    size_t n = out->n;
    if (n < 2)
        return;
    point first = {0, 0}, last = {0, 0}; /* the steps before the first sample and after the last one */
    if (closed && n > 3) {
        first = unit_between(out->v[n - 2].at, out->v[0].at, plb_point_distance(out->v[n - 2].at, out->v[0].at));
        last = unit_between(out->v[n - 1].at, out->v[1].at, plb_point_distance(out->v[n - 1].at, out->v[1].at));
    }
    out->v[0].tangent = first;
    for (size_t i = 0; i < n; i++)
        out->v[i].tangent = between(out->v[i].tangent, i + 1 < n ? out->v[i + 1].tangent : last);
}
