/* SPDX-License-Identifier: MIT
 *
 * Plan, step 2: what lies outside the page or outside a clip is cut away.
 */
#include "plan/item/clip.h"

#include "plan/shape/trim.h"


struct clipper {
    const display_list *list;
    region *page;
    region **regions; /* one per clip of the list, made when first needed */
    track_list left[2]; /* what the clips so far have left, and what the next one leaves */
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
    plb_tracks_free(&c->left[0]);
    plb_tracks_free(&c->left[1]);
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
    double work = 0; /* nobody asks */
    return plb_region_cross(of, from, to, at, &work);
}

static bool sees(const void *of, point p)
{
    return plb_region_contains(of, p, EDGE_MARGIN_MM);
}

static bool cut_all(const region *r, const track_list *in, track_list *out, error *err)
{
    trim_rule rule = {cross, sees, r};
    bool ok = true, is_part;
    for (size_t i = 0; ok && i < in->tracks.n; i++) {
        track t = plb_track_at(in, i);
        switch (side_of(r, plb_track_bounds(&t))) {
        case ALL_OUTSIDE: break;
        case ALL_INSIDE: ok = plb_track_copy(out, &t) || plb_fail_memory(err); break;
        default: ok = plb_plan_trim(&rule, &t, out, &is_part, err); break;
        }
    }
    return ok;
}

/* Each clip cuts what the one inside it has left, the page comes last. */
bool plb_plan_clip(clipper *c, int index, const track_list *in, track_list *out, error *err)
{
    for (int turn = 0; index != NO_CLIP; index = c->list->clips.v[index].parent, turn = !turn) {
        const region *r = plb_clipper_region(c, index, err);
        plb_tracks_clear(&c->left[turn]);
        if (!r || !cut_all(r, in, &c->left[turn], err))
            return false;
        in = &c->left[turn];
    }
    return cut_all(c->page, in, out, err);
}
