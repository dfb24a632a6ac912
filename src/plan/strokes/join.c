/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: lines that belong together. Files hold one line in pieces: walls between doors, curves as hundreds
 * of chords. Both papers ask that collinear pieces be drawn as one; so is every chain of lines that goes on smoothly
 * from end to end. Ends that meet at a corner, and with nothing else, are marked: the pencil is not lifted there.
 *
 * At each place where ends meet, pairs that touch join before those with a gap, and among them the pair with the least turn
 * first, then the next among those left.
 */
#include "system/thread_team.h"
#include "plan/shape/grid.h"
#include "plan/strokes/passes.h"

#include <math.h>
#include <stdlib.h>

/* Two ends alone at a place go on in one movement up to the turn that is a corner (track.h); among several, where
 * crossing lines meet, only straighter ones do (chosen by eye). */
#define TURN_ALONE_DEGREES 30.0
#define TURN_AMONG_DEGREES 12.0
/* Lines are of one movement only if their pressures differ by less than this. */
#define PRESSURE_STEP 0.1f
/* At a place where more ends meet (a star's centre) nothing is joined. */
#define MAX_ENDS 24
/* A direction is taken over this length of the line, so that a tiny last segment does not spoil it. */
#define DIRECTION_MM 0.15

/* Ends this near touch: what a file's rounding leaves between the pieces of one line. */
#define TOUCHING_MM 0.001

#define NO_END UINT32_MAX

/* Ends are numbered: 2 i is the start of stroke i, 2 i + 1 its end. */
typedef struct {
    uint32_t a, b;
    bool apart;  /* do not touch */
    double turn; /* radians */
} pair;
typedef ARRAY(pair) pair_list;

typedef struct {
    const stroke_list *list;
    double tolerance;
    grid where;
    point *place;     /* of each end: looked at far more often than what else a stroke has */
    uint32_t *mate;   /* of each end: the end it goes on to, or NO_END */
    uint32_t *only;   /* of each end: the other one, where just one is near; or NO_END */
    pair_list pairs;
    pair_list by_member[THREAD_TEAM_MAX]; /* before they are put together */
} joiner;

static const stroke *stroke_of(const joiner *j, uint32_t end)
{
    return &j->list->strokes.v[end / 2];
}

static point place_of(const joiner *j, uint32_t end)
{
    return j->place[end];
}

/* Gives the direction in which the line leaves its end. */
static point direction_of(const joiner *j, uint32_t end)
{
    const stroke *s = stroke_of(j, end);
    const point *at = j->list->points.v + s->first, here = place_of(j, end);
    point d = {0, 0};
    for (size_t k = 1; k < s->n && plb_point_length(d) < DIRECTION_MM; k++)
        d = point_sub(here, at[end & 1 ? s->n - 1 - k : k]);
    double length = plb_point_length(d);
    return length > 0 ? point_scale(d, 1 / length) : d;
}

static bool may_join(const joiner *j, uint32_t end)
{
    const stroke *s = stroke_of(j, end);
    return !s->closed && (s->style.kind == STROKE_LINE || s->style.kind == STROKE_GUIDE);
}

static bool alike(stroke_style a, stroke_style b)
{
    return a.kind == b.kind && a.colour == b.colour && fabsf(a.pressure - b.pressure) < PRESSURE_STEP;
}

static bool put_ends(joiner *j)
{
    bool ok = true;
    for (uint32_t end = 0; ok && end < 2 * j->list->strokes.n; end++) {
        const stroke *s = stroke_of(j, end);
        point p = j->place[end] = j->list->points.v[s->first + (end & 1 ? s->n - 1 : 0)];
        if (may_join(j, end))
            ok = plb_grid_put(&j->where, plb_grid_cell(&j->where, p.x), plb_grid_cell(&j->where, p.y), end);
    }
    return ok;
}

static bool is_near(point p, point q, double reach)
{
    return fabs(p.x - q.x) <= reach && fabs(p.y - q.y) <= reach && plb_point_distance(p, q) <= reach;
}

/* Gives the ends that lie within `reach` mm of `end`, itself not; how many, more than MAX_ENDS being too many. */
static size_t neighbours(const joiner *j, uint32_t end, double reach, uint32_t found[MAX_ENDS])
{
    point p = place_of(j, end);
    grid_walk w = plb_grid_walk(&j->where, p, p, reach);
    int64_t column, row;
    size_t n = 0;
    while (plb_grid_step(&w, &column, &row))
        for (uint32_t k = plb_grid_first(&j->where, column, row); k != GRID_END; k = j->where.entries.v[k].next) {
            uint32_t other = j->where.entries.v[k].value;
            point q = place_of(j, other);
            if (other == end || !is_near(p, q, reach) || plb_grid_cell(&j->where, q.x) != column || plb_grid_cell(&j->where, q.y) != row)
                continue;
            if (n == MAX_ENDS)
                return n + 1;
            found[n++] = other;
        }
    return n;
}

/* Tells whether both are the ends of one straight piece: it cannot go on to itself. */
static bool is_one_piece(const joiner *j, uint32_t a, uint32_t b)
{
    return a / 2 == b / 2 && stroke_of(j, a)->n == 2;
}

/* Finds the pairs of `end` with ends of higher number. Where pieces are shorter than the tolerance, many ends lie near: then
 * only those that touch count. */
static bool find_pairs(joiner *j, uint32_t end, pair_list *pairs)
{
    uint32_t found[MAX_ENDS];
    size_t n = neighbours(j, end, j->tolerance, found);
    j->only[end] = n == 1 ? found[0] : NO_END;
    if (n > MAX_ENDS)
        n = neighbours(j, end, TOUCHING_MM, found);
    if (n > MAX_ENDS)
        return true;
    point out = direction_of(j, end);
    double most = (n == 1 ? TURN_ALONE_DEGREES : TURN_AMONG_DEGREES) * PLB_PI / 180;
    for (size_t i = 0; i < n; i++) {
        point in = direction_of(j, found[i]);
        bool apart = plb_point_distance(place_of(j, end), place_of(j, found[i])) > TOUCHING_MM;
        pair p = {end, found[i], apart, atan2(fabs(point_cross(out, in)), -point_dot(out, in))};
        if (found[i] > end && p.turn < most && !is_one_piece(j, end, found[i]) && alike(stroke_of(j, end)->style, stroke_of(j, found[i])->style) && !array_push(pairs, p))
            return false;
    }
    return true;
}

static int compare_pairs(const void *a, const void *b)
{
    const pair *x = a, *y = b;
    if (x->apart != y->apart)
        return x->apart - y->apart;
    double dx = floor(x->turn * 1e6), dy = floor(y->turn * 1e6); /* rounding noise decides nothing */
    return dx != dy ? (dx > dy) - (dx < dy) : x->a != y->a ? (x->a > y->a) - (x->a < y->a) : (x->b > y->b) - (x->b < y->b);
}

static bool find_batch(void *closure, int member, size_t batch)
{
    joiner *j = closure;
    bool ok = true;
    size_t end = batch * PASS_BATCH, last = end + PASS_BATCH, n = 2 * j->list->strokes.n;
    for (; ok && end < last && end < n; end++)
        ok = !may_join(j, (uint32_t)end) || find_pairs(j, (uint32_t)end, &j->by_member[member]);
    return ok;
}

/* Sorts all pairs, whichever order they are in: no two are equal. */
static bool find_all_pairs(joiner *j, int threads)
{
    size_t n = 2 * j->list->strokes.n;
    bool ok = plb_thread_team_run(plb_plan_members(threads, n), (n + PASS_BATCH - 1) / PASS_BATCH, find_batch, j);
    for (int k = 0; k < THREAD_TEAM_MAX; k++) {
        pair_list *p = &j->by_member[k];
        ok = ok && array_reserve(&j->pairs, p->n);
        for (size_t i = 0; ok && i < p->n; i++)
            j->pairs.v[j->pairs.n++] = p->v[i];
        array_free(p);
    }
    return ok;
}

static bool mate_ends(joiner *j, int threads)
{
    size_t n = 2 * j->list->strokes.n;
    for (uint32_t end = 0; end < n; end++)
        j->mate[end] = j->only[end] = NO_END;
    bool ok = find_all_pairs(j, threads);
    if (ok && j->pairs.n)
        qsort(j->pairs.v, j->pairs.n, sizeof *j->pairs.v, compare_pairs);
    for (size_t i = 0; ok && i < j->pairs.n; i++) {
        pair p = j->pairs.v[i];
        if (j->mate[p.a] == NO_END && j->mate[p.b] == NO_END) {
            j->mate[p.a] = p.b;
            j->mate[p.b] = p.a;
        }
    }
    return ok;
}

/* ---- chains ---- */

typedef struct {
    const joiner *j;
    bool *taken; /* of each stroke */
    ARRAY(point) points;
    stroke_list *made;
} linker;

/* Tells whether the line goes on round a corner at this end: as it did in the item, or where the line meets one other end. */
static bool is_corner(const joiner *j, uint32_t end)
{
    const stroke *s = stroke_of(j, end);
    if (end & 1 ? s->corner_last : s->corner_first)
        return true;
    uint32_t other = j->only[end];
    return j->mate[end] == NO_END && other != NO_END && j->mate[other] == NO_END && other / 2 != end / 2 && alike(stroke_of(j, other)->style, s->style);
}

/* Appends the points of the stroke entered by `end`, but for one where the chain already is. */
static bool add_points(linker *l, uint32_t end)
{
    const stroke *s = stroke_of(l->j, end);
    const point *at = l->j->list->points.v + s->first;
    bool ok = true;
    for (size_t k = 0; ok && k < s->n; k++) {
        point p = at[end & 1 ? s->n - 1 - k : k];
        bool same = l->points.n && plb_point_distance(l->points.v[l->points.n - 1], p) <= (k == 0 ? l->j->tolerance : 0);
        ok = same || array_push(&l->points, p);
    }
    return ok;
}

/* Gives the first end of the chain that stroke i belongs to; of a closed one, i's own start. */
static uint32_t find_first(const joiner *j, uint32_t i)
{
    uint32_t end = 2 * i;
    while (j->mate[end] != NO_END) {
        end = j->mate[end] ^ 1;
        if (end == 2 * i)
            break;
    }
    return end;
}

static bool link_chain(linker *l, uint32_t i)
{
    const joiner *j = l->j;
    uint32_t first = find_first(j, i), end = first, last;
    bool ok = true;
    l->points.n = 0;
    do {
        l->taken[end / 2] = true;
        ok = add_points(l, end);
        last = end ^ 1;
        end = j->mate[last];
    } while (ok && end != NO_END && end != first);
    stroke s = *stroke_of(j, first);
    s.closed = end == first && end != NO_END && l->points.n > 2;
    if (s.closed)
        l->points.v[l->points.n - 1] = l->points.v[0];
    s.corner_first = !s.closed && is_corner(j, first);
    s.corner_last = !s.closed && is_corner(j, last);
    return ok && (l->points.n < 2 || plb_plan_append(l->made, &s, l->points.v, l->points.n));
}

static bool link_chains(const joiner *j, stroke_list *made)
{
    const stroke_list *list = j->list;
    linker l = {.j = j, .taken = plb_new(list->strokes.n, sizeof(bool)), .made = made};
    bool ok = l.taken;
    for (size_t i = 0; ok && i < list->strokes.n; i++) {
        const stroke *s = &list->strokes.v[i];
        if (!may_join(j, (uint32_t)(2 * i)))
            ok = plb_plan_append(made, s, list->points.v + s->first, s->n);
        else if (!l.taken[i])
            ok = link_chain(&l, (uint32_t)i);
    }
    plb_free(l.taken);
    array_free(&l.points);
    return ok;
}

bool plb_plan_join(stroke_list *list, double tolerance, int threads, error *err)
{
    stroke_list made = {.width = list->width, .height = list->height};
    size_t n = 2 * list->strokes.n;
    joiner j = {.list = list, .tolerance = tolerance, .mate = plb_new(n, sizeof *j.mate), .place = plb_new(n, sizeof *j.place), .only = plb_new(n, sizeof *j.only)};
    bool ok = plb_grid_init(&j.where, 4 * tolerance, n) && j.place && j.only && j.mate && put_ends(&j) && mate_ends(&j, threads) && link_chains(&j, &made);
    plb_grid_free(&j.where);
    plb_free(j.place);
    plb_free(j.only);
    plb_free(j.mate);
    array_free(&j.pairs);
    plb_plan_replace(list, &made);
    return ok || plb_fail_memory(err);
}
