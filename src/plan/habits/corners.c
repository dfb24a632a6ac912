/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: corners. Two straight lines that meet at about a right angle hardly ever meet exactly: one runs past the other by some tenths of a
 * millimetre, or ends as much before it, or the hand goes round the corner without a stop. (Corners of four writers of hdBPMN: 1 to 8 px of 1/300 inch
 * past or before, some rounded.) Corners of small things, where more lines meet, and sharp or blunt ones stay exact: an arrowhead, a tick and the bend of
 * a curve are what they are.
 * Input: strokes, mm, with their corner ends. Output: the same, some of them longer, shorter or bent at an end.
 */
#include "plan/habits/habits.h"

#include "base/number/random.h"

#include <math.h>
#include <stdlib.h>

/* Lines shorter than this keep their corners, mm; so do those that turn by less or more than these angles (chosen by eye). */
#define SHORTEST_MM 5.0
#define LEAST_TURN_DEGREES 50.0
#define MOST_TURN_DEGREES 130.0
/* Shares of the corners: met exactly, passed, ended before; the rest are rounded (chosen by eye, from the same pages). */
#define EXACT 0.25
#define PASSED 0.67
#define BEFORE 0.82
/* A corner is passed by this, mm, mostly by little; by both lines in so many cases. */
#define PASS_MM 0.12
#define PASS_MORE_MM 0.5
#define PASS_BOTH 0.3
/* A line ends before it by this, mm: less than the line is wide, so that the corner stays closed. */
#define BEFORE_MM 0.08
#define BEFORE_MORE_MM 0.16
/* All of these are at most this part of the line. */
#define OF_LENGTH 0.04
/* Only lines shorter than this go round a corner: longer ones are drawn by themselves, often along a ruler. */
#define ROUND_LONGEST_MM 40.0
/* A rounded corner begins and ends so far from its place, mm; it is so many straight pieces. */
#define ROUND_MM 0.25
#define ROUND_MORE_MM 0.35
#define ROUND_PIECES 5
/* Ends within this are at one place, mm. */
#define SAME_PLACE_MM 0.001

/* An end of a stroke that is a corner. */
typedef struct {
    int64_t x, y; /* its place, in units of SAME_PLACE_MM */
    size_t stroke;
    bool is_last;
} corner_end;
typedef ARRAY(corner_end) corner_ends;

static int compare(const void *a, const void *b)
{
    const corner_end *p = a, *q = b;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    return p->stroke != q->stroke ? (p->stroke > q->stroke) - (p->stroke < q->stroke) : (int)p->is_last - (int)q->is_last;
}

static bool add_end(corner_ends *all, const stroke_list *list, size_t i, bool is_last)
{
    const stroke *s = &list->strokes.v[i];
    point p = list->points.v[s->first + (is_last ? s->n - 1 : 0)];
    corner_end e = {llround(p.x / SAME_PLACE_MM), llround(p.y / SAME_PLACE_MM), i, is_last};
    return array_push(all, e);
}

/* Gives the place of an end, and of the point next to it. */
static point *end_of(const stroke_list *list, const corner_end *e)
{
    const stroke *s = &list->strokes.v[e->stroke];
    return list->points.v + s->first + (e->is_last ? s->n - 1 : 0);
}

static point *next_to(const stroke_list *list, const corner_end *e)
{
    return end_of(list, e) + (e->is_last ? -1 : 1);
}

/* Moves an end by `by` mm outward. The hand stops there, as at any corner, and does not lift the pencil before. */
static void move(stroke_list *list, const corner_end *e, double by)
{
    point *at = end_of(list, e), *next = next_to(list, e);
    double l = plb_point_distance(*at, *next), most = OF_LENGTH * l;
    by = fmax(fmin(by, most), -most);
    *at = point_mix(*next, *at, (l + by) / l);
}

/* Lets stroke `a` go round the corner, `by` mm on to where `b` then begins. */
static bool go_round(stroke_list *list, const corner_end *a, const corner_end *b, double by)
{
    point corner = *end_of(list, a), from, to, bend[ROUND_PIECES];
    size_t n = list->strokes.v[a->stroke].n, first = list->points.n;
    move(list, a, -by);
    move(list, b, -by);
    from = *end_of(list, a);
    to = *end_of(list, b);
    for (int k = 1; k <= ROUND_PIECES; k++) {
        double t = (double)k / ROUND_PIECES;
        bend[k - 1] = point_mix(point_mix(from, corner, t), point_mix(corner, to, t), t);
    }
    if (!array_reserve(&list->points, n + ROUND_PIECES))
        return false;
    stroke *s = &list->strokes.v[a->stroke];
    point *v = list->points.v + first;
    for (size_t k = 0; k < n; k++)
        v[a->is_last ? k : k + ROUND_PIECES] = list->points.v[s->first + k];
    for (size_t k = 0; k < ROUND_PIECES; k++)
        v[a->is_last ? n + k : ROUND_PIECES - 1 - k] = bend[k];
    s->first = first;
    s->n = n + ROUND_PIECES;
    list->points.n += s->n;
    return true;
}

static bool turns_about_right(const stroke_list *list, const corner_end *a, const corner_end *b)
{
    point in = point_sub(*end_of(list, a), *next_to(list, a)), out = point_sub(*next_to(list, b), *end_of(list, b));
    double turn = fabs(atan2(point_cross(in, out), point_dot(in, out))) * 180 / PLB_PI;
    return turn > LEAST_TURN_DEGREES && turn < MOST_TURN_DEGREES;
}

static bool meet(stroke_list *list, const plan_options *o, const corner_end *a, const corner_end *b)
{
    uint64_t key = random_key(o->seed, random_fold(7, a->x, a->y), PURPOSE_HABIT);
    double what = random_unit(key, 0), much = random_unit(key, 1);
    if (!turns_about_right(list, a, b) || what < EXACT)
        return true;
    if (random_bits(key, 2) & 1) {
        const corner_end *swap = a;
        a = b;
        b = swap;
    }
    double longer = fmax(plb_point_distance(*end_of(list, a), *next_to(list, a)), plb_point_distance(*end_of(list, b), *next_to(list, b)));
    if (what >= BEFORE)
        return longer > ROUND_LONGEST_MM || go_round(list, a, b, ROUND_MM + ROUND_MORE_MM * much);
    move(list, a, what < PASSED ? PASS_MM + PASS_MORE_MM * much * much : -BEFORE_MM - BEFORE_MORE_MM * much);
    if (what < PASSED && random_unit(key, 3) < PASS_BOTH)
        move(list, b, PASS_MM + PASS_MORE_MM * pow(random_unit(key, 4), 2));
    return true;
}

bool plb_plan_meet_corners(stroke_list *list, const plan_options *o, error *err)
{
    corner_ends all = {0};
    bool ok = true;
    for (size_t i = 0; ok && i < list->strokes.n; i++) {
        const stroke *s = &list->strokes.v[i];
        bool is_free = s->style.kind == STROKE_LINE && !s->style.company && !s->closed;
        ok = !is_free || ((!s->corner_first || add_end(&all, list, i, false)) && (!s->corner_last || add_end(&all, list, i, true)));
    }
    if (all.n)
        qsort(all.v, all.n, sizeof *all.v, compare);
    for (size_t i = 0, end; ok && i < all.n; i = end) {
        bool is_long = true;
        for (end = i; end < all.n && all.v[end].x == all.v[i].x && all.v[end].y == all.v[i].y; end++) {
            const corner_end *e = &all.v[end];
            is_long &= plb_point_distance(*end_of(list, e), *next_to(list, e)) >= SHORTEST_MM;
        }
        ok = end - i != 2 || !is_long || all.v[i].stroke == all.v[i + 1].stroke || meet(list, o, &all.v[i], &all.v[i + 1]);
    }
    array_free(&all);
    return ok || plb_fail_memory(err);
}
