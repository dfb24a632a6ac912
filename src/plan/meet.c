/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: lines that others end upon. A scale with its ticks, a wall with others against it, the rim of a mesh:
 * where lines come to an end on another one a person minds that they meet, and draws that one with care.
 * Input: strokes, mm. Output: their room.
 */
#include "plan/grid.h"
#include "plan/habits.h"

#include <math.h>

/* An end so near to a line ends upon it, mm; the line then strays by no more than this, mm (both chosen by eye: less than
 * a pencil's line). */
#define NEAR_MM 0.15
#define ROOM_MM 0.25f
/* Ends this near to the line's own are corners, which the hand meets in any case. */
#define CORNER_MM 0.5
/* Shorter lines hardly stray. */
#define SHORTEST_MM 10.0
#define CELL_MM 3.0
/* So many ends are looked at for one line, and for all: bounds on the work. */
#define MOST_LOOKS 10000
#define MOST_LOOKS_OF_ALL 1e8

static double distance_to(point p, point a, point b)
{
    point d = point_sub(b, a);
    double t = point_dot(point_sub(p, a), d) / point_dot(d, d);
    return plb_point_distance(p, point_mix(a, b, fmin(fmax(t, 0), 1)));
}

static bool is_of_drawing(const stroke *s)
{
    return s->touch.kind == STROKE_LINE && !s->closed;
}

/* Ends are numbered: 2 i is the start of stroke i, 2 i + 1 its end. */
static point end_of(const stroke_list *list, uint32_t end)
{
    const stroke *s = &list->strokes.v[end / 2];
    return list->points.v[s->first + (end & 1 ? s->n - 1 : 0)];
}

static bool is_met(const grid *g, const stroke_list *list, size_t i, size_t *looks)
{
    const stroke *s = &list->strokes.v[i];
    const point *v = list->points.v + s->first;
    int64_t column, row;
    for (size_t k = 1; k < s->n; k++) {
        grid_walk w = plb_grid_walk(g, v[k - 1], v[k], NEAR_MM);
        while (*looks < MOST_LOOKS && plb_grid_step(&w, &column, &row)) {
            ++*looks;
            for (uint32_t e = plb_grid_first(g, column, row); e != GRID_END && *looks < MOST_LOOKS; e = g->entries.v[e].next) {
                point p = end_of(list, g->entries.v[e].value);
                ++*looks;
                if (distance_to(p, v[k - 1], v[k]) < NEAR_MM && plb_point_distance(p, v[0]) > CORNER_MM && plb_point_distance(p, v[s->n - 1]) > CORNER_MM)
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
    for (size_t k = 1; k < s->n && length < SHORTEST_MM; k++)
        length += plb_point_distance(v[k - 1], v[k]);
    return length >= SHORTEST_MM;
}

static bool put_ends(grid *g, const stroke_list *list, size_t i)
{
    for (uint32_t e = (uint32_t)(2 * i); e < 2 * i + 2; e++) {
        point p = end_of(list, e);
        if (!plb_grid_put(g, plb_grid_cell(g, p.x), plb_grid_cell(g, p.y), e))
            return false;
    }
    return true;
}

bool plb_plan_meet(stroke_list *list, error *err)
{
    grid g;
    double of_all = 0;
    bool ok = plb_grid_init(&g, CELL_MM, 2 * list->strokes.n);
    for (size_t i = 0; ok && i < list->strokes.n; i++)
        ok = !is_of_drawing(&list->strokes.v[i]) || put_ends(&g, list, i);
    for (size_t i = 0; ok && i < list->strokes.n && of_all < MOST_LOOKS_OF_ALL; i++) {
        stroke *s = &list->strokes.v[i];
        size_t looks = 0;
        if (is_of_drawing(s) && is_long(list, s) && is_met(&g, list, i, &looks))
            s->room = s->room > 0 ? fminf(s->room, ROOM_MM) : ROOM_MM;
        of_all += (double)looks;
    }
    plb_grid_free(&g);
    return ok || plb_fail_memory(err);
}
