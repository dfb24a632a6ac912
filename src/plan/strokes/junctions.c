/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: lines that others end upon. A scale with its ticks, a wall with others against it, the rim of a mesh:
 * where lines come to an end on another one a person minds that they meet, and draws that one with care.
 * Input: strokes, mm. Output: how far each may deviate.
 */
#include "system/thread_team.h"
#include "plan/shape/grid.h"
#include "plan/strokes/passes.h"

#include <math.h>

/* An end so near to a line ends upon it, mm; the line then strays by no more than this, mm (both chosen by eye: less than
 * a pencil's line). */
#define NEAR_MM 0.15
#define JUNCTION_DEVIATION_MM 0.25f
/* Ends this near to the line's own are corners, which the hand meets in any case. */
#define CORNER_MM 0.5
/* Shorter lines hardly stray. */
#define MIN_JOINED_MM 10.0
#define JUNCTION_CELL_MM 3.0
/* So many ends are looked at for one line, and for all: bounds on the work. */
#define MAX_JUNCTION_LOOKS 10000
#define MAX_JUNCTION_LOOKS_OF_ALL 1e8

/* Tells whether p lies so near to the segment. Most do not lie so near to its box: no root for them. */
static bool is_near(point p, point a, point b)
{
    if (p.x < lesser(a.x, b.x) - NEAR_MM || p.x > greater(a.x, b.x) + NEAR_MM || p.y < lesser(a.y, b.y) - NEAR_MM || p.y > greater(a.y, b.y) + NEAR_MM)
        return false;
    point d = point_sub(b, a);
    double t = point_dot(point_sub(p, a), d) / point_dot(d, d);
    return plb_point_distance(p, point_mix(a, b, lesser(greater(t, 0), 1))) < NEAR_MM;
}

static bool is_of_drawing(const stroke *s)
{
    return s->style.kind == STROKE_LINE && !s->closed;
}

/* All ends of lines, and where each is found. */
typedef struct {
    grid where;
    ARRAY(point) at;
} line_ends;

static bool is_met(const line_ends *ends, const stroke_list *list, size_t i, size_t *looks)
{
    const stroke *s = &list->strokes.v[i];
    const point *v = list->points.v + s->first;
    int64_t column, row;
    for (size_t k = 1; k < s->n; k++) {
        grid_walk w = plb_grid_walk(&ends->where, v[k - 1], v[k], NEAR_MM);
        while (*looks < MAX_JUNCTION_LOOKS && plb_grid_step(&w, &column, &row)) {
            ++*looks;
            for (uint32_t e = plb_grid_first(&ends->where, column, row); e != GRID_END && *looks < MAX_JUNCTION_LOOKS; e = ends->where.entries.v[e].next) {
                point p = ends->at.v[ends->where.entries.v[e].value];
                ++*looks;
                if (is_near(p, v[k - 1], v[k]) && plb_point_distance(p, v[0]) > CORNER_MM && plb_point_distance(p, v[s->n - 1]) > CORNER_MM)
                    return true;
            }
        }
    }
    return false;
}

static bool is_long(const stroke_list *list, const stroke *s)
{
    const point *v = list->points.v + s->first;
    double length = 0;
    for (size_t k = 1; k < s->n && length < MIN_JOINED_MM; k++)
        length += plb_point_distance(v[k - 1], v[k]);
    return length >= MIN_JOINED_MM;
}

static bool put_end(line_ends *ends, point p)
{
    return plb_grid_put(&ends->where, plb_grid_cell(&ends->where, p.x), plb_grid_cell(&ends->where, p.y), (uint32_t)ends->at.n) &&
           array_push(&ends->at, p);
}

static bool put_ends(line_ends *ends, const stroke_list *list)
{
    for (size_t i = 0; i < list->strokes.n; i++) {
        const stroke *s = &list->strokes.v[i];
        const point *v = list->points.v + s->first;
        if (is_of_drawing(s) && !(put_end(ends, v[0]) && put_end(ends, v[s->n - 1])))
            return false;
    }
    return true;
}

/* Works on some of the strokes, batch by batch; each changes itself only. Between rounds the looks are counted, so that
 * the strokes at which they end do not depend on the threads. */
#define BATCHES_AT_A_TIME 64 /* batches */
typedef struct {
    const line_ends *ends;
    stroke_list *list;
    size_t first;
    double looks[BATCHES_AT_A_TIME];
} junction_search;

static bool look_batch(void *closure, int member, size_t batch)
{
    junction_search *k = closure;
    size_t first = k->first + batch * PASS_BATCH;
    (void)member;
    k->looks[batch] = 0;
    for (size_t i = first; i < first + PASS_BATCH && i < k->list->strokes.n; i++) {
        stroke *s = &k->list->strokes.v[i];
        size_t looks = 0;
        if (is_of_drawing(s) && is_long(k->list, s) && is_met(k->ends, k->list, i, &looks))
            s->max_deviation = s->max_deviation > 0 ? fminf(s->max_deviation, JUNCTION_DEVIATION_MM) : JUNCTION_DEVIATION_MM;
        k->looks[batch] += (double)looks;
    }
    return true;
}

static void look_at_all(const line_ends *ends, stroke_list *list, int threads)
{
    double of_all = 0;
    size_t n = list->strokes.n;
    junction_search k = {.ends = ends, .list = list};
    for (; k.first < n && of_all < MAX_JUNCTION_LOOKS_OF_ALL; k.first += BATCHES_AT_A_TIME * PASS_BATCH) {
        size_t batches = (n - k.first + PASS_BATCH - 1) / PASS_BATCH;
        batches = batches < BATCHES_AT_A_TIME ? batches : BATCHES_AT_A_TIME;
        plb_thread_team_run(plb_plan_members(threads, n), batches, look_batch, &k);
        for (size_t i = 0; i < batches; i++)
            of_all += k.looks[i];
    }
}

bool plb_plan_junctions(stroke_list *list, int threads, error *err)
{
    line_ends ends = {0};
    bool ok = plb_grid_init(&ends.where, JUNCTION_CELL_MM, 2 * list->strokes.n) && put_ends(&ends, list);
    if (ok)
        look_at_all(&ends, list, threads);
    plb_grid_free(&ends.where);
    array_free(&ends.at);
    return ok || plb_fail_memory(err);
}
