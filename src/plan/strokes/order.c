/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: the order of drawing. A person draws what lies together together, the next line from near where
 * the last one ended, lines before their hatching, and pulls a line from left to right or from the top down.
 *
 * Strokes are sorted along a Hilbert curve by where they start and cut into groups; within a group the nearest comes
 * next. How a stroke looks does not depend on its place in the order: the end it starts from is its own affair, so that
 * a line added elsewhere changes nothing about it.
 */
#include "plan/strokes/passes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A group has so many strokes (chosen by measurement: more cost time and change little). */
#define GROUP 48
/* Cells of the Hilbert curve along a side: 2 to the power of this. */
#define HILBERT_LEVELS 10
/* A kind that comes later costs this, mm: more than any way on the page. */
#define KIND_MM 1e7

typedef struct {
    uint32_t place;  /* along the curve */
    uint32_t number; /* in the list */
} entry;

static point start_of(const stroke_list *list, const stroke *s)
{
    return list->points.v[s->first];
}

static point end_of(const stroke_list *list, const stroke *s)
{
    return list->points.v[s->first + s->n - 1];
}

static void reverse(stroke_list *list, stroke *s)
{
    point *v = list->points.v + s->first;
    for (size_t a = 0, b = s->n - 1; a < b; a++, b--) {
        point p = v[a];
        v[a] = v[b];
        v[b] = p;
    }
    bool corner = s->corner_first;
    s->corner_first = s->corner_last;
    s->corner_last = corner;
}

/* Tells whether a hand pulls a line this way: left to right; steep lines from the top down. */
static bool is_pulled(point from, point to)
{
    point way = point_sub(to, from);
    return plb_point_is_steep(way) ? way.y > 0 : way.x > 0;
}

/* Lines and guides start at their natural end. Curves that come back near where they began are drawn as they are. */
static void face(stroke_list *list)
{
    for (size_t i = 0; i < list->strokes.n; i++) {
        stroke *s = &list->strokes.v[i];
        point a = start_of(list, s), b = end_of(list, s);
        if (!s->closed && (a.x != b.x || a.y != b.y) && !is_pulled(a, b))
            reverse(list, s);
    }
}

/* Gives the place of a cell along the Hilbert curve of that many levels (Hamilton & Rau-Chaplin's turning frame). */
static uint32_t hilbert(uint32_t x, uint32_t y)
{
    uint32_t place = 0;
    for (uint32_t side = 1u << (HILBERT_LEVELS - 1); side; side /= 2) {
        uint32_t rx = (x & side) > 0, ry = (y & side) > 0, keep;
        place += side * side * ((3 * rx) ^ ry);
        if (ry == 0) {
            if (rx == 1) {
                x = (side - 1) - (x & (side - 1));
                y = (side - 1) - (y & (side - 1));
            }
            keep = x;
            x = y;
            y = keep;
        }
    }
    return place;
}

static uint32_t cell_of(double at, double whole)
{
    double k = at / whole * (1 << HILBERT_LEVELS);
    return k <= 0 ? 0 : k >= (1 << HILBERT_LEVELS) ? (1 << HILBERT_LEVELS) - 1 : (uint32_t)k;
}

static int compare_entries(const void *a, const void *b)
{
    const entry *x = a, *y = b;
    return x->place != y->place ? (x->place < y->place ? -1 : 1) : (x->number > y->number) - (x->number < y->number);
}

/* Sorts guides before all others, then along the curve. */
static void sort(const stroke_list *list, entry *order)
{
    double whole = fmax(list->width, list->height);
    for (size_t i = 0; i < list->strokes.n; i++) {
        point p = start_of(list, &list->strokes.v[i]);
        uint32_t place = hilbert(cell_of(p.x, whole), cell_of(p.y, whole)) + 1;
        order[i] = (entry){list->strokes.v[i].style.kind == STROKE_GUIDE ? 0 : place, (uint32_t)i};
    }
    if (list->strokes.n)
        qsort(order, list->strokes.n, sizeof *order, compare_entries);
}

/* Gives the place of a kind in the order: guides, lines, hatching, lettering. */
static int rank(stroke_kind kind)
{
    static const int ranks[] = {[STROKE_GUIDE] = 0, [STROKE_LINE] = 1, [STROKE_HATCH] = 2, [STROKE_LETTER] = 3};
    return ranks[kind];
}

/* Tells how far the pencil has to go to draw `s` next. */
static double way_to(const stroke_list *list, const stroke *s, point pen)
{
    return plb_point_distance(pen, start_of(list, s)) + rank(s->style.kind) * KIND_MM;
}

/* Puts the group in order, nearest next; `pen` is where the last stroke ended. */
static void chain(const stroke_list *list, entry *group, size_t n, point *pen)
{
    for (size_t i = 0; i < n; i++) {
        size_t best = i;
        double least = INFINITY;
        for (size_t k = i; k < n; k++) {
            double way = way_to(list, &list->strokes.v[group[k].number], *pen);
            if (way < least) {
                least = way;
                best = k;
            }
        }
        entry next = group[best];
        memmove(group + i + 1, group + i, (best - i) * sizeof *group); /* the others keep their order */
        group[i] = next;
        *pen = end_of(list, &list->strokes.v[next.number]);
    }
}

bool plb_plan_order(stroke_list *list, error *err)
{
    size_t n = list->strokes.n;
    entry *order = plb_new(n, sizeof *order);
    stroke_list made = {.width = list->width, .height = list->height};
    bool ok = order && array_reserve(&made.strokes, n);
    point pen = {0, 0};
    if (ok) {
        face(list);
        sort(list, order);
    }
    for (size_t i = 0; ok && i < n; i += GROUP)
        chain(list, order + i, n - i < GROUP ? n - i : GROUP, &pen);
    for (size_t i = 0; ok && i < n; i++)
        made.strokes.v[made.strokes.n++] = list->strokes.v[order[i].number];
    if (ok) {
        array_free(&list->strokes);
        list->strokes.v = made.strokes.v;
        list->strokes.n = made.strokes.n;
        list->strokes.capacity = made.strokes.capacity;
    }
    plb_free(order);
    return ok || plb_fail_memory(err);
}
