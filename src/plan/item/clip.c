/* SPDX-License-Identifier: MIT
 *
 * Plan, step 2: what lies outside the page or outside a clip is cut away.
 */
#include "plan/item/clip.h"

#include "plan/shape/trim.h"

/* A line that runs along the edge of a clip or of the page is half visible: it is kept, and so is what lies no
 * farther outside than this. */
#define EDGE_MARGIN_MM 0.05

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

const region *plb_clipper_region(clipper *c, int index, error *err)
{
    if (!c->regions[index]) {
        const clip *from = &c->list->clips.v[index];
        c->regions[index] = plb_region_new(&from->path, from->even_odd, err);
    }
    return c->regions[index];
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

static bool cross(const void *of, point from, point to, crossings *at)
{
    return plb_region_cross(of, from, to, at);
}

static bool sees(const void *of, point p)
{
    return plb_region_contains(of, p, EDGE_MARGIN_MM);
}

static bool cut_by(const region *r, const track *t, track_sink sink, void *closure, error *err)
{
    cut_rule rule = {cross, sees, r};
    switch (side_of(r, plb_track_bounds(t))) {
    case ALL_OUTSIDE: return true;
    case ALL_INSIDE: return sink(closure, t);
    default: return plb_plan_cut(&rule, t, sink, closure, err);
    }
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
    const region *r = plb_clipper_region(k->c, k->index, k->err);
    chain outer = {k->c, k->c->list->clips.v[k->index].parent, k->sink, k->closure, k->err};
    return r && cut_by(r, t, cut_by_chain, &outer, k->err);
}

bool plb_plan_clip(clipper *c, int index, const track *t, track_sink sink, void *closure, error *err)
{
    chain k = {c, index, sink, closure, err};
    return cut_by_chain(&k, t);
}
