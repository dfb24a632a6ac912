/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 2, the free hand along a curve: one movement through via points that it aims at.
 * Input: the base line, a polyline in mm, and how the hand deviates. Output: samples of the path.
 *
 *     course    the base line, with a spacing for each place: close where it bends, growing slowly away from there
 *     vias      places of that spacing on the course, each off it as the hand deviates
 *     movement  of least jerk through them (via.c), at a speed that goes with the cube root of the radius
 *     samples
 *
 * The speed is the two-thirds power law of drawing movements (Lacquaniti, Terzuolo and Viviani 1983: angular speed goes as
 * curvature^(2/3), and so speed as curvature^(-1/3); Viviani and Flash 1995: least jerk implies it).
 */
#include "base/array.h"
#include "base/number/random.h"
#include "stroke/path/trace.h"
#include "stroke/path/via.h"

#include <math.h>

/* From via to via the course turns by so much, radians: close enough for a circle to be one within 0.2 % (measured). */
#define TURN_OF_STEP 0.5
/* A spacing grows by this share of the distance from a bend: with 1/2 the hand leaves straight lines by 3 % of the
 * radius of a bend between them, with 1 by 10 % (measured). */
#define GROWTH 0.5
/* A corner of a polyline is a bend over at most this length, mm (chosen by eye). */
#define BEND_MM 1.5
/* Longest spacing, share of the length: the hand's last mode has half a wave on an eighth of it. */
#define LONGEST_STEP (1 / 12.0)
/* Shortest: mm, and share of the length; a bound on the work. */
#define SHORTEST_STEP_MM 0.05
#define SHORTEST_STEP (1 / 20000.0)
/* The first and the last piece take twice the time that their length asks for, since the hand starts and ends at rest: with
 * this factor, and only near it, a circle begins as a circle (measured). */
#define REST_FACTOR 2.0

/* Samples keep the straight pieces between them within this distance of the path, and turn by no more than this. */
#define SAMPLE_FLATNESS_MM 0.004
#define SAMPLE_TURN 0.2

/* A closed curve is overdrawn by a share of its length between these, at most so far, mm, and misses its beginning by about
 * such a share of its extent, at most so far, mm; it begins near the top, within such an angle, radians (all by eye). */
#define OVERLAP_MIN 0.02
#define OVERLAP_MAX 0.05
#define OVERLAP_LARGEST_MM 3.0
/* A circle is overdrawn by up to this share, a quarter turn, mostly by little, at most so far, mm. */
#define OVERLAP_ROUND 0.25
#define OVERLAP_ROUND_POWER 2.5
#define OVERLAP_ROUND_MM 8.0
#define MISS 0.012
#define MISS_LARGEST_MM 0.8
#define TOP_WITHIN 0.6

typedef struct {
    point at;
    double along, spacing; /* mm */
} course_place;
typedef ARRAY(course_place) course;
typedef ARRAY(via) vias;

/* ---- the course ---- */

static bool add_place(course *c, point at)
{
    double along = c->n ? c->v[c->n - 1].along + plb_point_distance(c->v[c->n - 1].at, at) : 0;
    course_place p = {at, along, 0};
    return array_push(c, p);
}

/* Finds where a closed base line's drawing begins: its vertex farthest in a direction near that of the page's top. */
static size_t find_beginning(const base_line *b, uint64_t key)
{
    double angle = TOP_WITHIN * (2 * random_unit(key, 0) - 1), best = -1e300;
    point up = {sin(angle), -cos(angle)};
    size_t k = 0;
    for (size_t i = 0; i + 1 < b->n; i++)
        if (point_dot(b->v[i], up) > best) {
            best = point_dot(b->v[i], up);
            k = i;
        }
    return k;
}

/* Goes once around and `overlap` mm farther. */
static bool go_round(course *c, const base_line *b, size_t from, double length, double overlap)
{
    size_t n = b->n - 1;
    for (size_t i = 0; i <= 2 * n; i++) {
        if (!add_place(c, b->v[(from + i) % n]))
            return false;
        course_place *last = &c->v[c->n - 1];
        if (last->along >= length + overlap) {
            double t = (length + overlap - last[-1].along) / (last->along - last[-1].along);
            last->at = point_mix(last[-1].at, last->at, t);
            last->along = length + overlap;
            break;
        }
    }
    return true;
}

/* Gives the spacing that the bend at an inner place asks for. */
static double spacing_at(const course_place *p)
{
    point in = point_sub(p->at, p[-1].at), out = point_sub(p[1].at, p->at);
    double bend = fmin((p[1].along - p[-1].along) / 2, BEND_MM);
    double turn = fabs(atan2(point_cross(in, out), point_dot(in, out)));
    return turn > 1e-6 ? TURN_OF_STEP * bend / turn : 1e300;
}

static void space(course *c)
{
    double length = c->v[c->n - 1].along, longest = LONGEST_STEP * length;
    double shortest = fmin(fmax(SHORTEST_STEP_MM, SHORTEST_STEP * length), longest);
    for (size_t i = 0; i < c->n; i++) {
        double spacing = i > 0 && i + 1 < c->n ? spacing_at(c->v + i) : longest;
        c->v[i].spacing = fmax(fmin(spacing, longest), shortest);
    }
    for (size_t i = 1; i < c->n; i++)
        c->v[i].spacing = fmin(c->v[i].spacing, c->v[i - 1].spacing + GROWTH * (c->v[i].along - c->v[i - 1].along));
    for (size_t i = c->n - 1; i > 0; i--)
        c->v[i - 1].spacing = fmin(c->v[i - 1].spacing, c->v[i].spacing + GROWTH * (c->v[i].along - c->v[i - 1].along));
}

/* ---- vias ---- */

/* Gives a place on the course; the cursor *at goes with `along`, which grows. */
static course_place on_course(const course *c, size_t *at, double along)
{
    while (*at + 2 < c->n && along > c->v[*at + 1].along)
        (*at)++;
    const course_place *p = c->v + *at;
    double before = along - p->along, after = p[1].along - along, t = before / (p[1].along - p->along);
    double spacing = fmin(p->spacing + GROWTH * before, p[1].spacing + GROWTH * after);
    return (course_place){point_mix(p->at, p[1].at, t), along, spacing};
}

/* Finds the distances along the course, each one spacing from the one before, stretched to end at its end. */
static bool walk(const course *c, vias *v)
{
    size_t at = 0;
    double along = 0, end = c->v[c->n - 1].along;
    via first = {.duration = 0};
    bool ok = array_push(v, first);
    while (ok && along < end) {
        double step = on_course(c, &at, along).spacing;
        size_t ahead = at;
        step = fmin(step, on_course(c, &ahead, fmin(along + step, end)).spacing);
        along += step;
        via next = {.duration = along}; /* for now */
        ok = array_push(v, next);
    }
    return ok;
}

/* Puts the vias on the course and off it by `off`, and gives them their times. */
static void put(const course *c, vias *v, const hand *h, double round, double miss)
{
    double end = c->v[c->n - 1].along, stretch = end / v->v[v->n - 1].duration, before = 0, spacing = c->v[0].spacing;
    size_t at = 0;
    for (size_t i = 0; i < v->n; i++) {
        double along = fmin(v->v[i].duration * stretch, end);
        course_place p = on_course(c, &at, along);
        point way = point_sub(c->v[at + 1].at, c->v[at].at);
        double l = plb_point_length(way), off = plb_hand_off(h, along);
        if (round > 0)
            off += miss * (along / round - 0.5);
        v->v[i].at = (point){p.at.x + off * way.y / l, p.at.y - off * way.x / l};
        if (i > 0)
            v->v[i - 1].duration = (along - before) / cbrt((spacing + p.spacing) / 2);
        before = along;
        spacing = p.spacing;
    }
    v->v[0].duration *= REST_FACTOR;
    v->v[v->n - 2].duration *= REST_FACTOR;
}

/* ---- samples ---- */

static double turn_of(const via v[2])
{
    double dot = point_dot(v->velocity, v[1].velocity), cross = point_cross(v->velocity, v[1].velocity);
    return dot == 0 && cross == 0 ? 0 : fabs(atan2(cross, dot));
}

static bool sample_piece(const via *v, double turn, path_samples *out)
{
    double chord = plb_point_distance(v->at, v[1].at);
    double n = ceil(fmax(sqrt(chord * turn / (8 * SAMPLE_FLATNESS_MM)), turn / SAMPLE_TURN));
    int pieces = n < 1 ? 1 : n > 64 ? 64 : (int)n;
    via_piece p = plb_via_piece(v);
    if (!array_reserve(out, (size_t)pieces))
        return false;
    for (int k = 1; k <= pieces; k++)
        out->v[out->n++].at = plb_via_at(&p, (double)k / pieces);
    return true;
}

static bool sample(const vias *v, path_samples *out)
{
    path_sample start = {.at = v->v[0].at};
    bool ok = array_push(out, start);
    for (size_t i = 0; ok && i + 1 < v->n; i++) {
        bool rests = i == 0 || i + 2 == v->n; /* an end has no direction: as much of a turn as next to it, and unevenly */
        double turn = turn_of(v->v + i);
        if (rests && v->n > 3)
            turn = 3 * turn_of(v->v + (i == 0 ? 1 : i - 1));
        ok = sample_piece(v->v + i, turn, out);
    }
    return ok;
}

/* ---- all of it ---- */

static bool draw_course(course *c, const hand *h, double round, double miss, path_samples *out)
{
    if (c->n == 0) /* a base line of no points: nothing to draw */
        return true;
    vias v = {0};
    space(c);
    bool ok = walk(c, &v);
    if (ok) {
        put(c, &v, h, round, miss);
        plb_via_solve(v.v, v.n);
        ok = sample(&v, out);
    }
    array_free(&v);
    if (ok)
        plb_path_measure(out, false);
    return ok;
}

static bool trace_closed(const base_line *b, double length, const hand *h, uint64_t key, course *c, path_samples *out)
{
    double share = OVERLAP_MIN + (OVERLAP_MAX - OVERLAP_MIN) * random_unit(key, 1);
    double overlap = fmin(share * length, OVERLAP_LARGEST_MM);
    if (plb_base_radius(b) > 0 && !h->limit)
        overlap = fmin((OVERLAP_MIN + (OVERLAP_ROUND - OVERLAP_MIN) * pow(random_unit(key, 1), OVERLAP_ROUND_POWER)) * length, OVERLAP_ROUND_MM);
    double miss = fmin(MISS * plb_base_extent(b) * (0.3 + 1.4 * random_unit(key, 2)), MISS_LARGEST_MM);
    if (h->limit > 0)
        miss = fmin(miss, h->limit);
    out->closed = false;
    return go_round(c, b, find_beginning(b, key), length, overlap) &&
           draw_course(c, h, length, h->strength * (random_bits(key, 3) & 1 ? miss : -miss), out);
}

bool plb_trace_curve(const base_line *b, double length, const hand *h, uint64_t identity, const stroke_options *o, path_samples *out)
{
    course c = {0};
    bool ok = true;
    if (b->closed)
        ok = trace_closed(b, length, h, random_key(o->seed, identity, PURPOSE_CLOSING), &c, out);
    for (size_t i = 0; ok && !b->closed && i < b->n; i++)
        ok = add_place(&c, b->v[i]);
    ok = ok && (b->closed || draw_course(&c, h, 0, 0, out));
    array_free(&c);
    return ok;
}
