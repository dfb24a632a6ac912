/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: lines beside lettering. A number stands a millimetre off the axis, a dimension just above its line: a hand that
 * strays from the line must not run into either, for a minus sign that touches a frame is lost, and a one becomes a four.
 * Input: strokes, mm. Output: how far each line may deviate.
 *
 * Two straight pieces that do not cross are nearest to each other at an end of one of them, and the ends of a line do not stray: so the
 * corners of the letters' strokes are all that a line is compared with.
 */
#include "base/geometry/interpolate.h"
#include "system/thread_team.h"
#include "plan/shape/grid.h"
#include "plan/strokes/passes.h"

#include <math.h>

/* A line may take this share of the paper between it and a letter, and is never held stiffer than to so many mm, less than which is not seen
 * (chosen by eye). */
#define SHARE_OF_PAPER 0.5
#define STIFFEST_MM 0.05f
/* Shorter lines hardly stray; a line strays by no more than this share of its length, and never farther than this, mm. */
#define MIN_BESIDE_MM 6.0
#define MAX_PAPER_OF_LENGTH 0.045
#define MAX_PAPER_MM 4.0
#define BESIDE_CELL_MM 3.0
/* So many corners are looked at for one line: a bound on the work. */
#define MAX_BESIDE_LOOKS 20000

typedef struct {
    grid where;
    ARRAY(point) corners; /* of all letters */
    stroke_list *list;
    double width; /* of the pencil, mm */
} beside_search;

static double distance_to(point p, point a, point b)
{
    point d = point_sub(b, a);
    double dd = point_dot(d, d), t = dd > 0 ? point_dot(point_sub(p, a), d) / dd : 0;
    return plb_point_distance(p, point_mix(a, b, clamp(t, 0, 1)));
}

/* Gives how near a letter comes to the line, mm; `farthest` when none is as near as that. */
static double nearest_letter(const beside_search *s, const stroke *line, double farthest)
{
    const point *v = s->list->points.v + line->first;
    double nearest = farthest;
    int64_t column, row;
    size_t looks = 0;
    for (size_t k = 1; k < line->n; k++) {
        grid_walk w = plb_grid_walk(&s->where, v[k - 1], v[k], farthest);
        while (looks < MAX_BESIDE_LOOKS && plb_grid_step(&w, &column, &row))
            for (uint32_t e = plb_grid_first(&s->where, column, row); e != GRID_END && looks < MAX_BESIDE_LOOKS; e = s->where.entries.v[e].next) {
                looks++;
                nearest = fmin(nearest, distance_to(s->corners.v[s->where.entries.v[e].value], v[k - 1], v[k]));
            }
    }
    return nearest;
}

static bool hold_batch(void *closure, int member, size_t batch)
{
    const beside_search *s = closure;
    (void)member;
    for (size_t i = batch * PASS_BATCH; i < (batch + 1) * PASS_BATCH && i < s->list->strokes.n; i++) {
        stroke *line = &s->list->strokes.v[i];
        double length = line->style.kind == STROKE_LINE ? plb_stroke_length(s->list, line) : 0;
        if (length < MIN_BESIDE_MM)
            continue;
        double farthest = fmin(MAX_PAPER_OF_LENGTH * length, MAX_PAPER_MM) + s->width, nearest = nearest_letter(s, line, farthest);
        float most = fmaxf((float)(SHARE_OF_PAPER * (nearest - s->width)), STIFFEST_MM);
        if (nearest < farthest && (line->max_deviation <= 0 || most < line->max_deviation))
            line->max_deviation = most;
    }
    return true;
}

static bool put_corners(beside_search *s)
{
    const stroke_list *list = s->list;
    for (size_t i = 0; i < list->strokes.n; i++) {
        const stroke *letter = &list->strokes.v[i];
        for (size_t k = letter->first; letter->style.kind == STROKE_LETTER && k < letter->first + letter->n; k++) {
            point p = list->points.v[k];
            if (!plb_grid_put(&s->where, plb_grid_cell(&s->where, p.x), plb_grid_cell(&s->where, p.y), (uint32_t)s->corners.n) || !array_push(&s->corners, p))
                return false;
        }
    }
    return true;
}

bool plb_plan_beside_letters(stroke_list *list, double width, int threads, error *err)
{
    beside_search s = {.list = list, .width = width};
    bool ok = plb_grid_init(&s.where, BESIDE_CELL_MM, list->points.n) && put_corners(&s);
    if (ok && s.corners.n)
        plb_thread_team_run(plb_plan_members(threads, list->strokes.n), (list->strokes.n + PASS_BATCH - 1) / PASS_BATCH, hold_batch, &s);
    plb_grid_free(&s.where);
    array_free(&s.corners);
    return ok || plb_fail_memory(err);
}
