/* SPDX-License-Identifier: MIT
 *
 * Crowds of dots and the lines over them: see crowd.h. Dots are small shapes about as high as wide, of one paint and size; they lie in a grid,
 * which each line painted later walks along. A line that has its dots at its own corners is one with markers and no line over a crowd.
 */
#include "plan/tone/crowd.h"

#include "plan/item/weight.h"
#include "plan/shape/grid.h"

#include <math.h>

/* A dot reaches over so many widths of the pencil, at least and at most, and is so much longer than wide at most. */
#define DOT_LEAST_WIDTHS 1.0
#define DOT_MOST_WIDTHS 12.0
#define DOT_SLENDER 1.4
/* A line over so many dots of one paint, all of one size but for this part, lies over a crowd (chosen by eye: a grid line in a plot of few points
 * does not). */
#define LEAST_CROSSED 8u
#define LIKE_SIZE 0.1
/* A dot so near to a corner of the line, mm, is its marker; lines have fewer of those than this part of the dots that they cross. */
#define MARKER_MM 0.06
#define MARKER_SHARE 0.4
/* A line is so many dots long at least, and so dark: no grid. */
#define LINE_DOTS 8.0
#define LINE_DARKNESS 0.45
/* So many dots are looked at for all lines: a bound on the work. */
#define MAX_CROWD_LOOKS 2e7

typedef struct {
    size_t item;
    point at;
    double size; /* mm */
    size_t seen; /* by the line with this number, one more */
} dot;

typedef struct {
    const display_list *list;
    ARRAY(dot) dots;
    grid where;
    double looks;
} crowd_search;

/* A crossing counts the dots that a line has met. */
typedef struct {
    size_t crossed, markers;
    const dot *first;
} crossing;

static bool is_dot(const item *it, const plan_options *o, dot *d)
{
    box b = plb_path_bounds(&it->path);
    double w = b.x1 - b.x0, h = b.y1 - b.y0;
    d->at = (point){(b.x0 + b.x1) / 2, (b.y0 + b.y1) / 2};
    d->size = fmax(w, h);
    return plb_leaves_mark(it) && !it->text && fmin(w, h) > DOT_LEAST_WIDTHS * o->pencil_width && d->size < DOT_MOST_WIDTHS * o->pencil_width && d->size < DOT_SLENDER * fmin(w, h);
}

static bool find_dots(crowd_search *s, const plan_options *o)
{
    bool ok = true;
    for (size_t i = 0; ok && i < s->list->items.n; i++) {
        dot d = {.item = i};
        ok = !is_dot(&s->list->items.v[i], o, &d) || array_push(&s->dots, d);
    }
    ok = ok && plb_grid_init(&s->where, DOT_MOST_WIDTHS * o->pencil_width, s->dots.n);
    for (size_t k = 0; ok && k < s->dots.n; k++)
        ok = plb_grid_put(&s->where, plb_grid_cell(&s->where, s->dots.v[k].at.x), plb_grid_cell(&s->where, s->dots.v[k].at.y), (uint32_t)k);
    return ok;
}

static bool is_same_paint(paint a, paint b)
{
    return a.kind == b.kind && a.red == b.red && a.green == b.green && a.blue == b.blue && a.alpha == b.alpha;
}

static bool is_like(const crowd_search *s, const dot *a, const dot *b)
{
    return fabs(a->size - b->size) < LIKE_SIZE * b->size && is_same_paint(s->list->items.v[a->item].paint, s->list->items.v[b->item].paint);
}

static double distance_to(point p, point a, point b)
{
    point d = point_sub(b, a);
    double dd = point_dot(d, d), t = dd > 0 ? point_dot(point_sub(p, a), d) / dd : 0;
    return plb_point_distance(p, point_mix(a, b, fmin(fmax(t, 0), 1)));
}

/* Counts the dots below line number `i` that the piece from a to b crosses. */
static void cross_piece(crowd_search *s, size_t i, point a, point b, crossing *c)
{
    int64_t column, row;
    grid_walk w = plb_grid_walk(&s->where, a, b, s->where.cell / 2);
    while (s->looks < MAX_CROWD_LOOKS && plb_grid_step(&w, &column, &row)) {
        s->looks++;
        for (uint32_t e = plb_grid_first(&s->where, column, row); e != GRID_END && s->looks < MAX_CROWD_LOOKS; e = s->where.entries.v[e].next) {
            dot *d = &s->dots.v[s->where.entries.v[e].value];
            s->looks++;
            if (d->item >= i || d->seen == i + 1 || distance_to(d->at, a, b) > d->size / 2 || (c->first && !is_like(s, d, c->first)))
                continue;
            d->seen = i + 1;
            c->first = c->first ? c->first : d;
            c->crossed++;
            c->markers += plb_point_distance(d->at, a) < MARKER_MM || plb_point_distance(d->at, b) < MARKER_MM;
        }
    }
}

/* Looks along a line, and marks it and all dots that are like those below where it lies over a crowd. */
static void look_along(crowd_search *s, size_t i, crowd_part *part)
{
    const path *p = &s->list->items.v[i].path;
    crossing c = {0};
    size_t at = 0;
    for (size_t k = 0; k < p->ops.n; k++)
        for (int n = p->ops.v[k] == PATH_CURVE ? 3 : p->ops.v[k] != PATH_CLOSE; n > 0; n--, at++)
            if (p->ops.v[k] != PATH_MOVE)
                cross_piece(s, i, p->points.v[at - 1], p->points.v[at], &c);
    if (c.crossed < LEAST_CROSSED || (double)c.markers > MARKER_SHARE * (double)c.crossed)
        return;
    part[i] = CROWD_LINE;
    for (size_t k = 0; k < s->dots.n; k++)
        if (s->dots.v[k].item < i && is_like(s, &s->dots.v[k], c.first))
            part[s->dots.v[k].item] = CROWD_DOT;
}

bool plb_crowds_find(const display_list *list, const plan_options *o, crowd_part *part, error *err)
{
    crowd_search s = {.list = list};
    bool ok = find_dots(&s, o);
    for (size_t i = 0; i < list->items.n; i++) {
        const item *it = &list->items.v[i];
        box b = plb_path_bounds(&it->path);
        bool is_line = it->kind == ITEM_STROKE && !plb_is_wide(it, o) && 1 - plb_paint_lightness(it->paint) > LINE_DARKNESS;
        if (ok && is_line && s.dots.n >= LEAST_CROSSED && fmax(b.x1 - b.x0, b.y1 - b.y0) > LINE_DOTS * s.dots.v[0].size)
            look_along(&s, i, part);
    }
    array_free(&s.dots);
    plb_grid_free(&s.where);
    return ok || plb_fail_memory(err);
}
