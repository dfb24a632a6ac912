/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: hatching keeps clear of lettering. A person who shades an area that has words in it goes round the
 * words: lines across the letters would make them unreadable. Hatching is interrupted for inscriptions [ISO 128-3]: not only along the
 * letters' strokes, but between letters and inside them, too, so that a word stands on paper of its own.
 * Input: the strokes in the order of the items, mm. Output: hatch lines cut where lettering that was painted later is near.
 */
#include "base/number/random.h"
#include "plan/shape/grid.h"
#include "plan/strokes/passes.h"

#include <math.h>
#include <stdlib.h>

/* The paper that is left between a letter's line and the hatching, mm; of a line cut so no shorter piece is drawn than so
 * many widths of the pencil (chosen by eye). */
#define CLEAR_MM 0.25
#define SHORTEST_WIDTHS 2.5
/* Hatch lines end nearer to a word than they should, or farther from it, by this part of the distance (chosen by eye: an even edge looks cut out). */
#define UNEVEN 0.22
/* Nothing is drawn between two places that letters keep free where there is less room than so many times what they ask for: a space between words. */
#define SPACE_ROOMS 2.0
#define CLEARANCE_CELL_MM 2.0
/* These bound the work: looks at letters for one line, and for all. Beyond, lines are left as they are. */
#define MAX_CLEARANCE_LOOKS 20000
#define MAX_CLEARANCE_LOOKS_OF_ALL 2e8

typedef struct {
    double from, to; /* parameters along the line, 0 to 1 */
    double clear;    /* mm of paper that the letters ask for there */
} blocked_span;

typedef struct {
    point a, b;
    size_t stroke;
} letter_line;

typedef struct {
    const stroke_list *list;
    stroke_list made;
    double reach, farthest, shortest; /* mm: at least so far from a letter's middle line, from that which is given most room; of what is drawn */
    double width;  /* of the pencil, mm */
    double uneven; /* of the line at work: times the distance that its ends keep */
    double looks;
    grid where;
    ARRAY(letter_line) lines;
    ARRAY(blocked_span) runs; /* of the hatch line at work, that are too near */
} clearing;

static void widen(blocked_span *r, double t)
{
    r->from = fmin(r->from, t);
    r->to = fmax(r->to, t);
}

/* Finds where the line from a, `d` long, passes through the disc about c. */
static void cross_disc(point a, point d, point c, double radius, blocked_span *r)
{
    point m = point_sub(a, c);
    double dd = point_dot(d, d), half = point_dot(m, d), root = half * half - dd * (point_dot(m, m) - radius * radius);
    if (root <= 0)
        return;
    widen(r, (-half - sqrt(root)) / dd);
    widen(r, (-half + sqrt(root)) / dd);
}

/* … and through the band of `radius` to both sides of the segment. */
static void cross_band(point a, point d, const letter_line *l, double radius, blocked_span *r)
{
    point e = point_sub(l->b, l->a), m = point_sub(a, l->a);
    double length = plb_point_length(e), from = -INFINITY, to = INFINITY;
    point along = point_scale(e, 1 / length);
    double at[2] = {point_dot(along, m), point_cross(along, m)}, step[2] = {point_dot(along, d), point_cross(along, d)};
    double low[2] = {0, -radius}, high[2] = {length, radius};
    for (int k = 0; k < 2; k++) {
        if (fabs(step[k]) < 1e-12) {
            if (at[k] < low[k] || at[k] > high[k])
                return;
            continue;
        }
        double t0 = (low[k] - at[k]) / step[k], t1 = (high[k] - at[k]) / step[k];
        from = fmax(from, fmin(t0, t1));
        to = fmin(to, fmax(t0, t1));
    }
    if (from < to) {
        widen(r, from);
        widen(r, to);
    }
}

static bool put_letter(clearing *c, size_t i)
{
    const stroke *s = &c->list->strokes.v[i];
    const point *v = c->list->points.v + s->first;
    for (size_t k = 1; k < s->n; k++) {
        letter_line l = {v[k - 1], v[k], i};
        int64_t column, row;
        if (!array_push(&c->lines, l))
            return false;
        grid_walk w = plb_grid_walk(&c->where, l.a, l.b, 0);
        while (plb_grid_step(&w, &column, &row))
            if (!plb_grid_put(&c->where, column, row, (uint32_t)(c->lines.n - 1)))
                return false;
    }
    return true;
}

/* Gives how far the line at work keeps from the middle of the letter's, mm. */
static double reach_of(const clearing *c, const letter_line *l)
{
    return fmax(c->reach, c->uneven * (c->width + (double)c->list->strokes.v[l->stroke].style.clear));
}

/* Collects the parts that are too near to later letters. */
static bool find_runs(clearing *c, size_t i, point a, point b)
{
    point d = point_sub(b, a);
    int64_t column, row;
    grid_walk w = plb_grid_walk(&c->where, a, b, c->farthest);
    size_t looks = 0;
    while (looks < MAX_CLEARANCE_LOOKS && plb_grid_step(&w, &column, &row))
        for (uint32_t k = plb_grid_first(&c->where, column, row); k != GRID_END && looks < MAX_CLEARANCE_LOOKS; k = c->where.entries.v[k].next) {
            const letter_line *l = &c->lines.v[c->where.entries.v[k].value];
            blocked_span r = {INFINITY, -INFINITY, (double)c->list->strokes.v[l->stroke].style.clear};
            looks++;
            if (l->stroke < i)
                continue;
            double reach = reach_of(c, l);
            cross_disc(a, d, l->a, reach, &r);
            cross_disc(a, d, l->b, reach, &r);
            cross_band(a, d, l, reach, &r);
            if (r.from < 1 && r.to > 0 && !array_push(&c->runs, r))
                return false;
        }
    c->looks += (double)looks;
    return true;
}

static int compare_runs(const void *a, const void *b)
{
    const blocked_span *x = a, *y = b;
    return (x->from > y->from) - (x->from < y->from);
}

/* Adds the parts that are left between the runs. */
static bool send_pieces(clearing *c, const stroke *s, point a, point b)
{
    double length = plb_point_distance(a, b), at = 0, clear = 0;
    qsort(c->runs.v, c->runs.n, sizeof *c->runs.v, compare_runs);
    for (size_t k = 0; k <= c->runs.n; k++) {
        double to = k < c->runs.n ? c->runs.v[k].from : 1;
        point ends[2] = {point_mix(a, b, at), point_mix(a, b, fmin(to, 1))};
        double room = k < c->runs.n ? SPACE_ROOMS * fmin(clear, c->runs.v[k].clear) : 0;
        if ((to - at) * length >= fmax(c->shortest, room) && !plb_plan_append(&c->made, s, ends, 2))
            return false;
        clear = k < c->runs.n && c->runs.v[k].to > at ? c->runs.v[k].clear : clear;
        at = k < c->runs.n ? fmax(at, c->runs.v[k].to) : 1;
    }
    return true;
}

/* A touch of the point, as dots are made of: a stop or the dot of an i stands beside letters and stays. */
static bool is_touch(const stroke *s)
{
    return s->corner_first && s->corner_last;
}

static bool clear_stroke(clearing *c, size_t i)
{
    const stroke *s = &c->list->strokes.v[i];
    const point *v = c->list->points.v + s->first;
    c->runs.n = 0;
    c->uneven = 1 + UNEVEN * (2 * random_unit(random_fold(random_fold(0, llround(v[0].x * 1000), llround(v[0].y * 1000)), PURPOSE_HATCH, 0), 0) - 1);
    if (s->style.kind == STROKE_HATCH && s->n == 2 && !is_touch(s) && c->looks < MAX_CLEARANCE_LOOKS_OF_ALL && !find_runs(c, i, v[0], v[1]))
        return false;
    return c->runs.n ? send_pieces(c, s, v[0], v[1]) : plb_plan_append(&c->made, s, v, s->n);
}

bool plb_plan_clearance(stroke_list *list, double width, error *err)
{
    size_t hatches = 0, letters = 0;
    double most = 0;
    for (size_t i = 0; i < list->strokes.n; i++) {
        letters += list->strokes.v[i].style.kind == STROKE_LETTER && hatches > 0;
        hatches += list->strokes.v[i].style.kind == STROKE_HATCH;
        most = fmax(most, (double)list->strokes.v[i].style.clear);
    }
    if (letters == 0)
        return true;
    clearing c = {.list = list, .made = {.width = list->width, .height = list->height}, .reach = width + CLEAR_MM, .shortest = SHORTEST_WIDTHS * width, .width = width};
    c.farthest = fmax(c.reach, (1 + UNEVEN) * (width + most));
    bool ok = plb_grid_init(&c.where, CLEARANCE_CELL_MM, 8 * letters);
    for (size_t i = 0; ok && i < list->strokes.n; i++)
        ok = list->strokes.v[i].style.kind != STROKE_LETTER || put_letter(&c, i);
    for (size_t i = 0; ok && i < list->strokes.n; i++)
        ok = clear_stroke(&c, i);
    plb_grid_free(&c.where);
    array_free(&c.lines);
    array_free(&c.runs);
    plb_plan_replace(list, &c.made);
    return ok || plb_fail_memory(err);
}
