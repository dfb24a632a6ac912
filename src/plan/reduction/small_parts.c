/* SPDX-License-Identifier: MIT
 *
 * Reduction: small things, put together from subpaths. Holes follow the outline in which they lie, and the strokes of a
 * letter follow one another, so that only the last few parts are looked at.
 */
#include "plan/reduction/needs.h"

#include "base/sort.h"
#include "plan/item/weight.h"

#include <math.h>
#include <stdlib.h>

/* A part has no side longer than this, mm: larger letters and markers need no larger sheet. */
#define LARGEST_MM 16.0
/* A subpath may belong to one of so many parts before it. */
#define LOOK_BACK 4
/* The pieces of one letter follow each other within so many items. */
#define ITEMS_APART 1
/* More parts tell nothing new. */
#define MAX_PARTS 400000u

double plb_low_quantile(double *values, size_t n, double share)
{
    if (n == 0)
        return 0;
    qsort(values, n, sizeof *values, plb_compare_doubles);
    size_t k = (size_t)(share * (double)n);
    return values[k < n ? k : n - 1];
}

double plb_box_size(box b)
{
    return fmax(b.x1 - b.x0, b.y1 - b.y0);
}

static bool lies_in(box inner, box outer)
{
    return inner.x0 >= outer.x0 && inner.y0 >= outer.y0 && inner.x1 <= outer.x1 && inner.y1 <= outer.y1;
}

static bool touch(box a, box b, double margin)
{
    return a.x0 <= b.x1 + margin && b.x0 <= a.x1 + margin && a.y0 <= b.y1 + margin && b.y0 <= a.y1 + margin;
}

/* Contours of one fill belong together when one lies in the other; lines when they touch. */
static bool belongs(const small_part *p, const subpath *s)
{
    if (p->is_fill)
        return s->it->kind == ITEM_FILL && s->number == p->number && (lies_in(s->bounds, p->bounds) || lies_in(p->bounds, s->bounds));
    return s->it->kind == ITEM_STROKE && s->number - p->number <= ITEMS_APART && s->it->width == p->width && touch(p->bounds, s->bounds, p->width / 2);
}

static small_part part_of(const subpath *s)
{
    return (small_part){.bounds = s->bounds, .area = s->area, .perimeter = s->length, .width = s->it->kind == ITEM_STROKE ? s->it->width : 0, .number = s->number,
                        .curves = s->curves, .lines = s->lines, .contours = 1, .is_fill = s->it->kind == ITEM_FILL, .is_open = !s->closed, .is_pale = !plb_leaves_mark(s->it)};
}

static void join(small_part *p, const small_part *q)
{
    plb_box_add(&p->bounds, (point){q->bounds.x0, q->bounds.y0});
    plb_box_add(&p->bounds, (point){q->bounds.x1, q->bounds.y1});
    p->area += q->area;
    p->perimeter += q->perimeter;
    p->number = p->number > q->number ? p->number : q->number;
    p->curves += q->curves;
    p->lines += q->lines;
    p->contours += q->contours;
    p->is_open = p->is_open || q->is_open;
}

bool plb_small_parts_add(small_parts *parts, const subpath *s)
{
    small_part made = part_of(s), *home = NULL;
    if (plb_box_size(s->bounds) > LARGEST_MM || parts->n >= MAX_PARTS)
        return true;
    size_t first = parts->n > LOOK_BACK ? parts->n - LOOK_BACK : 0, kept = first;
    /* The first part to which the subpath belongs takes it in, and with it the other parts that it ties to that one. */
    for (size_t i = first; i < parts->n; i++) {
        small_part p = parts->v[i];
        bool is_tied = belongs(&p, s);
        if (is_tied && home)
            join(home, &p);
        else
            parts->v[kept++] = p;
        if (is_tied && !home)
            home = &parts->v[kept - 1];
    }
    parts->n = kept;
    if (home)
        join(home, &made);
    return home || array_push(parts, made);
}
