/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: lines beside each other. A free hand strays by a hundredth of a line's length; where another line
 * runs close by it, as the second line of a wall does, a person minds the gap, and the two never cross. Each straight
 * stroke with such a neighbour is told how far it may stray.
 */
#include "system/thread_team.h"
#include "plan/shape/grid.h"
#include "plan/strokes/passes.h"

#include <math.h>

/* Lines this near in direction, radians, are beside each other, if they are over at least this share of the shorter. */
#define PARALLEL 0.06
#define MIN_SIDE_BY_SIDE 0.2
/* Each line may take this share of the gap (by eye: two lines that both do still stay apart). */
#define SHARE_OF_GAP 0.35
/* Nearer than this they are one line or meet at an end. */
#define NEAREST_MM 0.2
/* Farther than this share of the length, and this, no hand strays. */
#define MAX_GAP_OF_LENGTH 0.045
#define MAX_GAP_MM 5.0
/* Strokes shorter than this hardly stray. */
#define MIN_NEIGHBOUR_MM 12.0
#define NEIGHBOUR_CELL_MM 6.0
/* Directions are kept apart on the grid, in so many parts of half a turn. */
#define PARTS 16
/* So many neighbours are looked at: a bound on the work. */
#define MAX_NEIGHBOUR_LOOKS 300

static bool is_candidate(const stroke_list *list, const stroke *s)
{
    const point *v = list->points.v + s->first;
    return s->n == 2 && s->style.kind == STROKE_LINE && plb_point_distance(v[0], v[1]) >= MIN_NEIGHBOUR_MM;
}

/* An asker is the line that asks: its beginning, unit direction and length; what lies `farthest` away or more is no neighbour. */
typedef struct {
    point a, along;
    double length, farthest;
} asker;

/* A candidate, kept where the grid's numbers lead at once. */
typedef struct {
    point a, b;
    size_t stroke;
} straight_line;
typedef ARRAY(straight_line) lines;

/* Tells how far the line from c to d lies beside the one that asks where both are; 0 when they are not beside each other. */
static double gap_to(const asker *q, point c, point d)
{
    point to_c = point_sub(c, q->a), to_d = point_sub(d, q->a);
    double sc = point_dot(to_c, q->along), sd = point_dot(to_d, q->along);
    double from = greater(lesser(sc, sd), 0), to = lesser(greater(sc, sd), q->length);
    if (to < from) /* most of those in a cell: no root for them */
        return 0;
    double hc = point_cross(q->along, to_c), hd = point_cross(q->along, to_d), other = plb_point_distance(c, d);
    if (to - from < MIN_SIDE_BY_SIDE * lesser(q->length, other) || fabs(hd - hc) > PARALLEL * other)
        return 0;
    double slope = (hd - hc) / (sd - sc), h0 = hc + (from - sc) * slope, h1 = hc + (to - sc) * slope;
    if ((h0 > 0) != (h1 > 0))
        return 0;
    double gap = lesser(fabs(h0), fabs(h1));
    return gap < NEAREST_MM ? 0 : gap;
}

static void look(const grid *g, const lines *all, stroke *s, const straight_line *self, const asker *q, int64_t column, int64_t key, size_t *looks)
{
    for (uint32_t k = plb_grid_first(g, column, key); k != GRID_END && *looks < MAX_NEIGHBOUR_LOOKS; k = g->entries.v[k].next) {
        const straight_line *t = &all->v[g->entries.v[k].value];
        if (t == self)
            continue;
        ++*looks;
        double gap = gap_to(q, t->a, t->b);
        if (gap > 0 && gap < q->farthest && (s->max_deviation == 0 || SHARE_OF_GAP * gap < s->max_deviation))
            s->max_deviation = (float)(SHARE_OF_GAP * gap);
    }
}

static void find(const grid *g, const lines *all, const straight_line *self, stroke *s)
{
    point way = point_sub(self->b, self->a);
    double length = plb_point_length(way), turn = plb_grid_turn(way), most = PARALLEL / PLB_PI;
    asker q = {self->a, point_scale(way, 1 / length), length, fmin(MAX_GAP_OF_LENGTH * length + NEAREST_MM, MAX_GAP_MM)};
    int64_t column, row, low = plb_grid_part(turn - most, PARTS), high = plb_grid_part(turn + most, PARTS);
    grid_walk w = plb_grid_walk(g, self->a, self->b, q.farthest);
    size_t looks = 0;
    while (looks < MAX_NEIGHBOUR_LOOKS && plb_grid_step(&w, &column, &row)) {
        look(g, all, s, self, &q, column, row * PARTS + low, &looks);
        if (high != low)
            look(g, all, s, self, &q, column, row * PARTS + high, &looks);
    }
}

static bool put(grid *g, lines *all, const stroke_list *list, size_t i)
{
    const point *v = list->points.v + list->strokes.v[i].first;
    straight_line l = {v[0], v[1], i};
    int64_t column, row, part = plb_grid_part(plb_grid_turn(point_sub(v[1], v[0])), PARTS);
    grid_walk w = plb_grid_walk(g, v[0], v[1], 0);
    while (plb_grid_step(&w, &column, &row))
        if (!plb_grid_put(g, column, row * PARTS + part, (uint32_t)all->n))
            return false;
    return array_push(all, l);
}

/* Works on a batch of the lines; each changes its own stroke only. */
typedef struct {
    const grid *where;
    const lines *all;
    stroke_list *list;
} neighbour_search;

static bool find_batch(void *closure, int member, size_t batch)
{
    const neighbour_search *s = closure;
    (void)member;
    for (size_t i = batch * PASS_BATCH; i < (batch + 1) * PASS_BATCH && i < s->all->n; i++)
        find(s->where, s->all, &s->all->v[i], &s->list->strokes.v[s->all->v[i].stroke]);
    return true;
}

bool plb_plan_neighbours(stroke_list *list, int threads, error *err)
{
    grid g;
    lines all = {0};
    bool ok = plb_grid_init(&g, NEIGHBOUR_CELL_MM, 2 * list->strokes.n);
    for (size_t i = 0; ok && i < list->strokes.n; i++)
        ok = !is_candidate(list, &list->strokes.v[i]) || put(&g, &all, list, i);
    if (ok)
        plb_thread_team_run(plb_plan_members(threads, all.n), (all.n + PASS_BATCH - 1) / PASS_BATCH, find_batch, &(neighbour_search){&g, &all, list});
    plb_grid_free(&g);
    array_free(&all);
    return ok || plb_fail_memory(err);
}
