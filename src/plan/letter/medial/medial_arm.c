/* SPDX-License-Identifier: MIT
 *
 * This file looks at a branch of the medial axis from one of its ends. Within the disc of a joint the axis bends towards its middle, and
 * where two strokes have grown together it is thicker than either; the branch is true only beyond that. There it has
 * a place and a direction from which the joint is made again.
 */
#include "plan/letter/medial/medial.h"

#include <math.h>
#include <stdlib.h>

/* Thicker than the branch's usual radius by this: grown together with another (chosen by eye). */
#define GROWN 1.15
#define TIP 1.6
/* At most this part of a branch is given to the joint at one end. */
#define MOST 0.4
/* A free end whose disc is as broad as this part of the branch has no corner that the axis could run into: there the axis is true from so near to
 * the end on, in radii. Where its last part, so many radii long, turns away from the rest by more than HOOK_DEGREES, the end is a hook, as that of an f,
 * which goes on the way of its last part (chosen by eye, on f, r, J and 7 of twelve families). */
#define BLUNT 0.6
#define BLUNT_NEAR 0.25
#define HOOK_REACH 1.1
#define HOOK_DEGREES 20.0

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Gives the lower third of the radii along the branch: thickness where it is alone. */
static double usual_radius(const medial *m, const medial_branch *b)
{
    double some[33] = {0}; /* a branch of no points has no radius */
    size_t n = b->n < 33 ? b->n : 33;
    for (size_t i = 0; i < n; i++)
        some[i] = m->points.v[b->first + (n > 1 ? i * (b->n - 1) / (n - 1) : 0)].radius;
    qsort(some, n, sizeof *some, compare);
    return fmax(some[n / 2], 0.5);
}

/* At a free end the axis may run into one of its corners, from as far away as 1.4 radii. */
static bool is_influenced(medial_point p, const medial_node *node, double usual)
{
    double distance = plb_point_distance(p.at, node->at);
    if (node->degree == 1)
        return distance < TIP * usual - node->radius / 2;
    return distance < node->radius || p.radius > GROWN * usual + 0.5;
}

/* Gives the first point from `i` on that lies so far from a place; `last` when none does. */
static size_t at_distance(const medial_point *p, size_t i, size_t last, int step, point from, double distance)
{
    while (i != last && plb_point_distance(p[i].at, from) < distance)
        i += (size_t)step;
    return i;
}

/* Makes the arm's place and direction those of its very end where that is a hook. */
static void follow_hook(const medial *m, const medial_node *node, size_t first, size_t last, medial_arm *a)
{
    const medial_point *p = m->points.v;
    if (node->degree != 1 || node->radius < BLUNT * a->radius)
        return;
    size_t near = at_distance(p, first, last, a->step, node->at, BLUNT_NEAR * a->radius);
    size_t far = at_distance(p, near, last, a->step, p[near].at, HOOK_REACH * a->radius);
    point way = point_sub(p[far].at, p[near].at);
    double length = plb_point_length(way);
    if (!(length > 0) || point_dot(way, a->outward) > length * cos(HOOK_DEGREES * PLB_PI / 180))
        return;
    a->cut = near;
    a->anchor = p[near].at;
    a->outward = point_scale(way, 1 / length);
}

medial_arm plb_medial_arm(const medial *m, const medial_branch *b, int end)
{
    const medial_node *node = &m->nodes.v[b->node[end]];
    medial_arm a = {.node = b->node[end], .step = end ? -1 : 1, .radius = usual_radius(m, b)};
    size_t last = end ? b->first : b->first + b->n - 1, first = end ? b->first + b->n - 1 : b->first, i = first;
    const medial_point *p = m->points.v;
    double gone = 0;
    for (; i != last && gone < MOST * b->length && is_influenced(p[i], node, a.radius); i += (size_t)a.step)
        gone += plb_point_distance(p[i].at, p[i + (size_t)a.step].at);
    a.cut = i;
    a.anchor = p[i].at;
    size_t far = i;
    while (far != last && plb_point_distance(p[far].at, a.anchor) < ARM_REACH * a.radius)
        far += (size_t)a.step;
    if (far == i) /* nothing is left of it: from the node */
        a.anchor = node->at, a.outward = point_sub(p[last].at, node->at);
    else
        a.outward = point_sub(p[far].at, a.anchor);
    double length = plb_point_length(a.outward);
    a.outward = length > 0 ? point_scale(a.outward, 1 / length) : (point){1, 0};
    follow_hook(m, node, first, last, &a);
    return a;
}

bool plb_medial_arms_meet(const medial_arm *a, const medial_arm *b, point *at)
{
    double det = point_cross(a->outward, b->outward);
    if (fabs(det) < 0.12) /* 7 degrees */
        return false;
    double t = point_cross(point_sub(b->anchor, a->anchor), b->outward) / det;
    *at = point_add(a->anchor, point_scale(a->outward, t));
    return true;
}

double plb_medial_arms_bend(const medial_arm *a, const medial_arm *b)
{
    point across = point_sub(a->anchor, b->anchor);
    double length = plb_point_length(across), turn = acos(fmax(-1, fmin(1, -point_dot(a->outward, b->outward))));
    if (length < 1)
        return turn;
    double at_a = acos(fmax(-1, fmin(1, point_dot(a->outward, across) / length)));
    double at_b = acos(fmax(-1, fmin(1, -point_dot(b->outward, across) / length)));
    return fmax(fmax(at_a, at_b), turn);
}
