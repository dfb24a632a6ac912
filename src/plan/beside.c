/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: lines beside each other. A free hand strays by a hundredth of a line's length; where another line
 * runs close by it, as the second line of a wall does, a person minds the gap, and the two never cross. Each straight
 * stroke with such a neighbour is told how far it may stray.
 */
#include "plan/grid.h"
#include "plan/habits.h"

#include <math.h>

/* Lines this near in direction, radians, are beside each other, if they are over at least this share of the shorter. */
#define PARALLEL 0.06
#define TOGETHER 0.2
/* Of the gap each may take so much (by eye: two lines that both do still stay apart). */
#define SHARE_OF_GAP 0.35
/* Nearer than this they are one line or meet at an end. */
#define NEAREST_MM 0.2
/* Farther than this share of the length, and this, no hand strays. */
#define FARTHEST 0.045
#define FARTHEST_MM 5.0
/* Strokes shorter than this hardly stray. */
#define SHORTEST_MM 12.0
#define CELL_MM 6.0
/* Directions are kept apart on the grid, in so many parts of half a turn. */
#define PARTS 16
/* So many neighbours are looked at: a bound on the work. */
#define MOST_LOOKS 300

static bool is_candidate(const stroke_list *list, const stroke *s)
{
    const point *v = list->points.v + s->first;
    return s->n == 2 && s->touch.kind == STROKE_LINE && plb_point_distance(v[0], v[1]) >= SHORTEST_MM;
}

/* The part of half a turn in which a direction lies, once turned by `more` radians. */
static int64_t part_of(point way, double more)
{
    double turn = (atan2(way.y, way.x) + more) / PLB_PI + 2;
    return (int64_t)floor((turn - floor(turn)) * PARTS) % PARTS;
}

/* The line that asks: its beginning, unit direction and length; what lies `farthest` away or more is no neighbour. */
typedef struct {
    point a, along;
    double length, farthest;
} asker;

/* How far the line from c to d lies beside the one that asks where both are; 0 when they are not beside each other. */
static double gap_to(const asker *q, point c, point d)
{
    point to_c = point_sub(c, q->a), to_d = point_sub(d, q->a);
    double sc = point_dot(to_c, q->along), sd = point_dot(to_d, q->along);
    double from = fmax(fmin(sc, sd), 0), to = fmin(fmax(sc, sd), q->length);
    if (to < from) /* most of those in a cell: no root for them */
        return 0;
    double hc = point_cross(q->along, to_c), hd = point_cross(q->along, to_d), other = plb_point_distance(c, d);
    if (to - from < TOGETHER * fmin(q->length, other) || fabs(hd - hc) > PARALLEL * other)
        return 0;
    double slope = (hd - hc) / (sd - sc), h0 = hc + (from - sc) * slope, h1 = hc + (to - sc) * slope;
    if ((h0 > 0) != (h1 > 0))
        return 0;
    double gap = fmin(fabs(h0), fabs(h1));
    return gap < NEAREST_MM ? 0 : gap;
}

static void look(const grid *g, stroke_list *list, size_t i, const asker *q, int64_t column, int64_t key, size_t *looks)
{
    stroke *s = &list->strokes.v[i];
    for (uint32_t k = plb_grid_first(g, column, key); k != GRID_END && *looks < MOST_LOOKS; k = g->entries.v[k].next) {
        const stroke *t = &list->strokes.v[g->entries.v[k].value];
        const point *w = list->points.v + t->first;
        if (t == s)
            continue;
        ++*looks;
        double gap = gap_to(q, w[0], w[1]);
        if (gap > 0 && gap < q->farthest && (s->room == 0 || SHARE_OF_GAP * gap < s->room))
            s->room = (float)(SHARE_OF_GAP * gap);
    }
}

static void find(const grid *g, stroke_list *list, size_t i)
{
    const point *v = list->points.v + list->strokes.v[i].first;
    double length = plb_point_distance(v[0], v[1]);
    point way = point_sub(v[1], v[0]);
    asker q = {v[0], point_scale(way, 1 / length), length, fmin(FARTHEST * length + NEAREST_MM, FARTHEST_MM)};
    int64_t column, row, low = part_of(way, -PARALLEL), high = part_of(way, PARALLEL);
    grid_walk w = plb_grid_walk(g, v[0], v[1], q.farthest);
    size_t looks = 0;
    while (looks < MOST_LOOKS && plb_grid_step(&w, &column, &row)) {
        look(g, list, i, &q, column, row * PARTS + low, &looks);
        if (high != low)
            look(g, list, i, &q, column, row * PARTS + high, &looks);
    }
}

static bool put(grid *g, const stroke_list *list, size_t i)
{
    const point *v = list->points.v + list->strokes.v[i].first;
    int64_t column, row, part = part_of(point_sub(v[1], v[0]), 0);
    grid_walk w = plb_grid_walk(g, v[0], v[1], 0);
    while (plb_grid_step(&w, &column, &row))
        if (!plb_grid_put(g, column, row * PARTS + part, (uint32_t)i))
            return false;
    return true;
}

bool plb_plan_beside(stroke_list *list, error *err)
{
    grid g;
    bool ok = plb_grid_init(&g, CELL_MM, 2 * list->strokes.n);
    for (size_t i = 0; ok && i < list->strokes.n; i++)
        ok = !is_candidate(list, &list->strokes.v[i]) || put(&g, list, i);
    for (size_t i = 0; ok && i < list->strokes.n; i++)
        if (is_candidate(list, &list->strokes.v[i]))
            find(&g, list, i);
    plb_grid_free(&g);
    return ok || plb_fail_memory(err);
}
