/* SPDX-License-Identifier: MIT
 *
 * Plan, step 2: what lies outside the page or outside a clip is cut away.
 */
#include "plan/region.h"
#include "plan/track.h"

#include <math.h>
#include <stdlib.h>

/* A line that runs along the edge of a clip or of the page is half visible: it is kept, and so is what lies no
 * farther outside than this. */
#define EDGE_MARGIN_MM 0.05
/* Pieces shorter than this that the cut leaves are dropped. */
#define SHORTEST_PIECE_MM 0.02

struct clipper {
    const display_list *list;
    region *page;
    region **regions; /* one per clip of the list, made when first needed */
};

clipper *plb_clipper_new(const display_list *list, error *err)
{
    clipper *c = plb_new(1, sizeof *c);
    path page = {0};
    double w = list->width, h = list->height;
    bool ok = c && plb_path_move(&page, (point){0, 0}) && plb_path_line(&page, (point){w, 0}) && plb_path_line(&page, (point){w, h}) &&
              plb_path_line(&page, (point){0, h}) && plb_path_close(&page);
    if (ok) {
        c->list = list;
        c->regions = plb_new(list->clips.n, sizeof *c->regions);
        c->page = plb_region_new(&page, false, err);
        ok = c->regions && c->page;
    }
    plb_path_free(&page);
    if (ok)
        return c;
    plb_fail_memory(err);
    plb_clipper_free(c);
    return NULL;
}

void plb_clipper_free(clipper *c)
{
    if (!c)
        return;
    for (size_t i = 0; c->regions && i < c->list->clips.n; i++)
        plb_region_free(c->regions[i]);
    plb_free(c->regions);
    plb_region_free(c->page);
    plb_free(c);
}

/* The clip of that index as a region; NULL and `err` on failure. */
static region *region_of(clipper *c, int index, error *err)
{
    if (!c->regions[index]) {
        const clip *from = &c->list->clips.v[index];
        c->regions[index] = plb_region_new(&from->path, from->even_odd, err);
    }
    return c->regions[index];
}

static box bounds_of(const track *t)
{
    box b = BOX_EMPTY;
    for (size_t i = 0; i < t->points.n; i++)
        plb_box_add(&b, t->points.v[i].at);
    return b;
}

typedef enum { ALL_INSIDE, ALL_OUTSIDE, MIXED } side;

static side side_of(const region *r, box b)
{
    box in = plb_region_bounds(r);
    double m = EDGE_MARGIN_MM;
    if (plb_box_is_empty(in) || b.x1 < in.x0 - m || b.x0 > in.x1 + m || b.y1 < in.y0 - m || b.y0 > in.y1 + m)
        return ALL_OUTSIDE;
    bool within = b.x0 >= in.x0 - m && b.x1 <= in.x1 + m && b.y0 >= in.y0 - m && b.y1 <= in.y1 + m;
    return within && plb_region_is_box(r) ? ALL_INSIDE : MIXED;
}

static int compare_numbers(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* What is being cut: the piece under construction and where it goes. */
typedef struct {
    track piece;
    double at; /* arc length reached, mm */
    track_sink sink;
    void *closure;
    error *err;
} cutter;

static bool flush(cutter *k)
{
    size_t n = k->piece.points.n;
    bool ok = true;
    if (n > 1 && (n > 2 || plb_point_distance(k->piece.points.v[0].at, k->piece.points.v[1].at) >= SHORTEST_PIECE_MM)) {
        k->piece.points.v[n - 1].corner = false;
        ok = k->sink(k->closure, &k->piece);
    }
    k->piece.points.n = 0;
    return ok;
}

static bool push(cutter *k, point at, bool corner)
{
    size_t n = k->piece.points.n;
    if (n && plb_point_distance(k->piece.points.v[n - 1].at, at) < SAME_POINT_MM)
        return true;
    track_point p = {at, corner && n > 0};
    if (n == 0)
        k->piece.start = k->at;
    return array_push(&k->piece.points, p) || plb_fail_memory(k->err);
}

/* Cuts one straight segment at the crossings found and keeps the parts inside. */
static bool cut_segment(cutter *k, const region *r, track_point from, track_point to, crossings *at)
{
    at->n = 0;
    if (!plb_region_cross(r, from.at, to.at, at) || !array_push(at, 1.0))
        return plb_fail_memory(k->err);
    qsort(at->v, at->n, sizeof *at->v, compare_numbers);
    double length = plb_point_distance(from.at, to.at), before = 0, start = k->at;
    for (size_t i = 0; i < at->n; i++) {
        double t = at->v[i];
        bool last = i + 1 == at->n;
        if ((t - before) * length < SAME_POINT_MM && !last)
            continue;
        bool inside = plb_region_contains(r, point_mix(from.at, to.at, (before + t) / 2), EDGE_MARGIN_MM);
        if (inside && k->piece.points.n == 0 && !push(k, point_mix(from.at, to.at, before), false))
            return false;
        k->at = start + t * length;
        if (inside && !push(k, last ? to.at : point_mix(from.at, to.at, t), last && to.corner))
            return false;
        if (!inside && !flush(k))
            return false;
        before = t;
    }
    return true;
}

static bool cut_by(const region *r, const track *t, track_sink sink, void *closure, error *err)
{
    side where = side_of(r, bounds_of(t));
    if (where == ALL_OUTSIDE)
        return true;
    if (where == ALL_INSIDE)
        return sink(closure, t);
    if (t->points.n == 1)
        return !plb_region_contains(r, t->points.v[0].at, EDGE_MARGIN_MM) || sink(closure, t);
    cutter k = {.piece.touch = t->touch, .at = t->start, .sink = sink, .closure = closure, .err = err};
    crossings at = {0}; /* of this clip alone: the sink may cut further */
    bool ok = true, whole = true;
    for (size_t i = 1; ok && i < t->points.n; i++) {
        ok = cut_segment(&k, r, t->points.v[i - 1], t->points.v[i], &at);
        whole = whole && k.piece.points.n == i + 1;
    }
    if (ok && whole) /* untouched: it stays closed if it was */
        k.piece.closed = t->closed;
    ok = ok && flush(&k);
    array_free(&at);
    array_free(&k.piece.points);
    return ok;
}

/* The chain of clips, outermost last, each cutting what the one before left. */
typedef struct {
    clipper *c;
    int index;
    track_sink sink;
    void *closure;
    error *err;
} chain;

static bool cut_by_chain(void *closure, const track *t)
{
    const chain *k = closure;
    if (k->index == NO_CLIP)
        return cut_by(k->c->page, t, k->sink, k->closure, k->err);
    region *r = region_of(k->c, k->index, k->err);
    chain outer = {k->c, k->c->list->clips.v[k->index].parent, k->sink, k->closure, k->err};
    return r && cut_by(r, t, cut_by_chain, &outer, k->err);
}

bool plb_plan_clip(clipper *c, int index, const track *t, track_sink sink, void *closure, error *err)
{
    chain k = {c, index, sink, closure, err};
    return cut_by_chain(&k, t);
}
