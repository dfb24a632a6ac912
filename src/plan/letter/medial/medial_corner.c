/* SPDX-License-Identifier: MIT
 *
 * Medial axis, step 4b: where a stroke turns a corner (L, V, Z) the axis itself is rounded off. What gives a corner away is
 * the shape across the turn: it is thicker there, 1.41 times at a right angle, while around a bend it is as thick as
 * anywhere. The branch is parted there.
 */
#include "plan/letter/medial/medial.h"

#include <math.h>

#define MIN_TURN_DEGREES 50.0
#define THICKER 1.22 /* chosen by eye; 1.15 at a turn of 60 degrees, and a pixel in eight is noise */
#define SHARP_DEGREES 120.0
#define THICKER_SHARP 1.1 /* the flat top of an A leaves no more */
/* The directions before and after are taken between these distances, in radii. */
#define NEAR 1.2
#define FAR 3.5

/* The course of a branch on one side of a point. */
typedef struct {
    point near, middle, far;
    double thickest; /* radius between the two */
    bool whole;      /* false: the branch ends before the far point */
} side;

static side look(const medial *m, const medial_branch *b, size_t i, int step)
{
    const medial_point *p = m->points.v + b->first;
    double r = p[i].radius, gone = 0;
    side s = {.near = p[i].at, .middle = p[i].at};
    while (gone < FAR * r && (step > 0 ? i + 1 < b->n : i > 0)) {
        size_t next = step > 0 ? i + 1 : i - 1;
        gone += plb_point_distance(p[i].at, p[next].at);
        i = next;
        if (gone < (NEAR + FAR) / 2 * r)
            s.middle = p[i].at;
        if (gone < NEAR * r)
            s.near = p[i].at;
        else
            s.thickest = fmax(s.thickest, p[i].radius);
    }
    s.far = p[i].at;
    s.whole = gone >= FAR * r;
    return s;
}

/* Tells how much the side itself bends from its nearer half to its farther one, radians, to the right of its way outward. */
static double bend_of(const side *s)
{
    point a = point_sub(s->middle, s->near), b = point_sub(s->far, s->middle);
    return atan2(point_cross(a, b), point_dot(a, b));
}

/* Gives the turn between the sides of a point less what they bend themselves, as around a bowl, radians, and the unit vector out of it. Too near to an end there is none; to a
 * joint or another corner, sooner. */
static double turn_at(const medial *m, const medial_branch *b, double r, const side *before, const side *after, point *out)
{
    point in = point_sub(before->far, before->near), on = point_sub(after->far, after->near);
    double l = plb_point_length(in), k = plb_point_length(on);
    bool first_free = m->nodes.v[b->node[0]].degree == 1, last_free = m->nodes.v[b->node[1]].degree == 1;
    if (l < r || k < r || (!before->whole && !first_free) || (!after->whole && !last_free))
        return 0;
    in = point_scale(in, 1 / l);
    on = point_scale(on, 1 / k);
    *out = point_scale(point_add(in, on), -1);
    double length = plb_point_length(*out);
    *out = length > 1e-6 ? point_scale(*out, 1 / length) : (point){in.y, -in.x};
    double turn = atan2(point_cross(point_scale(in, -1), on), -point_dot(in, on));
    double bends = bend_of(after) - bend_of(before); /* going through the point from before to after */
    return fmax(0, turn > 0 ? turn - fmax(0, bends) : -turn - fmax(0, -bends));
}

static double reach(const raster *r, point from, point along)
{
    double gone = 0;
    while (raster_inside(r, point_add(from, point_scale(along, gone + 0.25))))
        gone += 0.25;
    return gone;
}

static double thickness(const raster *r, point at, point across)
{
    return reach(r, at, across) + reach(r, at, point_scale(across, -1));
}

/* Tells at little cost whether the chords to both sides bend at all. */
static bool may_turn(const medial *m, const medial_branch *b, size_t i)
{
    const medial_point *p = m->points.v + b->first;
    size_t reach = (size_t)fmax(2 * p[i].radius, 2), first = i > reach ? i - reach : 0, last = i + reach < b->n ? i + reach : b->n - 1;
    point in = point_sub(p[i].at, p[first].at), on = point_sub(p[last].at, p[i].at);
    double along = point_dot(in, on);
    return along <= 0 || along * along < 0.85 * point_dot(in, in) * point_dot(on, on); /* 23 degrees */
}

/* Gives the sharpest corner of the branch, or 0. */
static size_t find_corner(const medial *m, const medial_branch *b, const raster *r)
{
    size_t found = 0;
    double most = THICKER;
    for (size_t i = 2; i + 2 < b->n; i++) {
        if (!may_turn(m, b, i))
            continue;
        medial_point p = m->points.v[b->first + i];
        side before = look(m, b, i, -1), after = look(m, b, i, 1);
        point out = {0, 0};
        double turn = turn_at(m, b, p.radius, &before, &after, &out) * 180 / PLB_PI;
        if (turn < MIN_TURN_DEGREES)
            continue;
        double usual = 2 * fmax(before.thickest, after.thickest) + 0.5; /* an axis between two pixels is off by half of one */
        double thicker = thickness(r, p.at, out) / usual + (THICKER - THICKER_SHARP) * fmin(1, (turn - MIN_TURN_DEGREES) / (SHARP_DEGREES - MIN_TURN_DEGREES));
        if (thicker > most) {
            most = thicker;
            found = i;
        }
    }
    return found;
}

static bool part(medial *m, size_t branch, size_t i)
{
    medial_branch *b = &m->branches.v[branch];
    medial_point p = m->points.v[b->first + i];
    medial_node node = {.at = p.at, .radius = p.radius, .degree = 2};
    medial_branch second = {.node = {(int)m->nodes.n, b->node[1]}, .first = b->first + i, .n = b->n - i, .spur = -1};
    for (size_t k = 1; k < second.n; k++)
        second.length += plb_point_distance(m->points.v[second.first + k - 1].at, m->points.v[second.first + k].at);
    b->node[1] = (int)m->nodes.n;
    b->n = i + 1;
    b->length -= second.length;
    return array_push(&m->nodes, node) && array_push(&m->branches, second);
}

bool plb_medial_corners(medial *m, const raster *r, error *err)
{
    for (size_t k = 0; k < m->branches.n; k++) {
        size_t i;
        while (!m->branches.v[k].gone && (i = find_corner(m, &m->branches.v[k], r)) > 0)
            if (!part(m, k, i))
                return plb_fail_memory(err);
    }
    return true;
}
