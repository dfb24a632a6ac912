/* SPDX-License-Identifier: MIT
 *
 * Reduction: how large the smallest arrowheads and markers are. A shape keeps its corners and its inside only when it is
 * several pencil lines across; a dot is a dot from hardly more than the pencil's own mark on. Arrowheads and markers come
 * several times in a drawing; shapes that come once, as islands, are details. Cells that adjoin, as those of heat maps
 * and meshes, are no shapes by themselves.
 */
#include "plan/reduction/needs.h"

#include "base/number/random.h"

#include <math.h>
#include <stdlib.h>

/* A shape must have a side of so many pencil widths (chosen by eye: a triangle, a square, a ring and an arrowhead are told apart). */
#define SHAPE_WIDTHS 4.0
/* A full disc must be so many across: the pencil's own dot is twice as large. */
#define DOT_WIDTHS 0.7
/* So small a full square is a dot, too: the full stop of many a font. */
#define SQUARE_DOT_WIDTHS 2.2
/* Shapes smaller than this are specks, which no reduction makes shapes. */
#define SPECK_WIDTHS 0.7
/* The roundness, perimeter^2 / 4 pi area, of discs drawn as polygons of eight sides or more, and of squares: below. */
#define ROUND 1.06
#define SQUARE 1.35
/* A share of the shapes may be smaller. */
#define SMALLER 0.1
/* A shape has so many straight sides at most. */
#define MOST_SIDES 12
/* Shapes are of one kind when neither their outlines nor their areas differ by more than this. */
#define ALIKE 0.02
/* Corners that differ by less, mm, are one. */
#define SAME_PLACE_MM 0.05

typedef struct {
    double size, perimeter, area; /* mm, mm, mm^2 */
    double least;                 /* what `size` must be */
    box bounds;
    bool is_cell;
} small_shape;

typedef struct {
    uint64_t place; /* a hash of it */
    size_t shape;
} shape_corner;

typedef struct {
    ARRAY(small_shape) all;
    ARRAY(shape_corner) corners;
} shape_survey;

static bool is_shape(const small_part *p, double width)
{
    double w = p->bounds.x1 - p->bounds.x0, h = p->bounds.y1 - p->bounds.y0;
    return !p->is_open && p->contours <= 2 && p->lines <= MOST_SIDES && p->lines + p->curves > 2 && fmax(w, h) > SPECK_WIDTHS * width && fmin(w, h) > 0.25 * fmax(w, h);
}

static bool is_dot(const small_part *p, double width)
{
    double roundness = p->perimeter * p->perimeter / (4 * PLB_PI * fmax(fabs(p->area), 1e-9));
    return p->is_fill && (roundness < ROUND || (roundness < SQUARE && plb_box_size(p->bounds) < SQUARE_DOT_WIDTHS * width));
}

static bool collect(shape_survey *s, const small_parts *parts, double width)
{
    for (size_t i = 0; i < parts->n; i++) {
        const small_part *p = &parts->v[i];
        if (p->is_lettering || p->is_pale || !is_shape(p, width))
            continue;
        small_shape shape = {plb_box_size(p->bounds), p->perimeter, fabs(p->area), width * (is_dot(p, width) ? DOT_WIDTHS : SHAPE_WIDTHS), p->bounds, false};
        if (!array_push(&s->all, shape))
            return false;
    }
    return true;
}

/* ---- cells ---- */

static int compare_corners(const void *a, const void *b)
{
    const shape_corner *p = a, *q = b;
    return p->place != q->place ? (p->place > q->place) - (p->place < q->place) : (p->shape > q->shape) - (p->shape < q->shape);
}

static bool is_same_box(box a, box b)
{
    return fmax(fmax(fabs(a.x0 - b.x0), fabs(a.x1 - b.x1)), fmax(fabs(a.y0 - b.y0), fabs(a.y1 - b.y1))) < SAME_PLACE_MM;
}

/* Finds the shapes whose bounds have a corner in common with another's: cells. */
static bool find_cells(shape_survey *s)
{
    for (size_t i = 0; i < s->all.n; i++)
        for (int k = 0; k < 4; k++) {
            box b = s->all.v[i].bounds;
            shape_corner c = {random_fold(0, llround((k & 1 ? b.x1 : b.x0) / SAME_PLACE_MM), llround((k & 2 ? b.y1 : b.y0) / SAME_PLACE_MM)), i};
            if (!array_push(&s->corners, c))
                return false;
        }
    if (s->corners.n)
        qsort(s->corners.v, s->corners.n, sizeof *s->corners.v, compare_corners);
    for (size_t k = 1; k < s->corners.n; k++) {
        const shape_corner *a = &s->corners.v[k - 1], *b = &s->corners.v[k];
        if (a->place == b->place && !is_same_box(s->all.v[a->shape].bounds, s->all.v[b->shape].bounds))
            s->all.v[a->shape].is_cell = s->all.v[b->shape].is_cell = true;
    }
    return true;
}

/* ---- kinds ---- */

static int compare_kinds(const void *a, const void *b)
{
    const small_shape *p = a, *q = b;
    if (p->is_cell != q->is_cell)
        return p->is_cell - q->is_cell;
    return p->perimeter != q->perimeter ? (p->perimeter > q->perimeter) - (p->perimeter < q->perimeter) : (p->area > q->area) - (p->area < q->area);
}

static bool are_alike(const small_shape *a, const small_shape *b)
{
    return fabs(a->perimeter - b->perimeter) < ALIKE * a->perimeter && fabs(a->area - b->area) < ALIKE * a->area + 1e-9;
}

bool plb_shapes_need(const small_parts *parts, double width, double *need)
{
    shape_survey s = {0};
    ARRAY(double) across = {0}; /* of each shape, as a share of what it must be */
    bool ok = collect(&s, parts, width) && find_cells(&s) && array_reserve(&across, s.all.n);
    /* Shapes of one kind follow each other once they are sorted. */
    if (ok && s.all.n)
        qsort(s.all.v, s.all.n, sizeof *s.all.v, compare_kinds);
    for (size_t i = 0; ok && i < s.all.n && !s.all.v[i].is_cell; i++) {
        const small_shape *a = &s.all.v[i];
        bool has_twin = (i > 0 && are_alike(a, a - 1)) || (i + 1 < s.all.n && !a[1].is_cell && are_alike(a, a + 1));
        if (has_twin)
            across.v[across.n++] = a->size / a->least;
    }
    double least = ok ? plb_low_quantile(across.v, across.n, SMALLER) : 0;
    *need = least > 0 ? 1 / least : 0;
    array_free(&s.all);
    array_free(&s.corners);
    array_free(&across);
    return ok;
}
