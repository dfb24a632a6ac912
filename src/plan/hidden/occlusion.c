/* SPDX-License-Identifier: MIT
 *
 * Plan, step 4: hidden lines. In painter's order an opaque area hides what was painted before it; a person leaves out
 * what is hidden, and lifts the pencil where a line goes under.
 *
 * A fill hides when its paint is opaque, and so does a line much wider than the pencil's; white counts: a program blots
 * out with white. Areas are kept in a tree of boxes (sorted by Morton code and packed bottom up, eight to a node), each
 * node with the latest item below it, so that a question passes by all that lies elsewhere or earlier.
 * An area's region is made when a question first reaches it. Before that a raster of what covers its cells whole
 * (coverage_raster.h) tells most of what is hidden, so that only lines near to what is seen are cut exactly.
 */
#include "plan/hidden/occlusion.h"

#include "plan/shape/trim.h"
#include "plan/hidden/coverage_raster.h"
#include "plan/item/weight.h"
#include "plan/item/wide.h"

#include <math.h>
#include <stdlib.h>

/* Paint more opaque than this hides (chosen by eye: half-transparent tints do not). */
#define OPAQUE 0.95
/* Nearly white paint hides from this opacity on, if each of its channels is at least so light (chosen by eye). */
#define VEIL 0.7
#define VEIL_LIGHT 0.9
/* A line in the paper's colour hides what is at least so many widths of the pencil broad (chosen by eye: less closes up). */
#define GAP_WIDTHS 0.9
/* Lettering in the paper's colour, strokes up to so many mm broad, keeps so much open between the pencil's lines, mm, besides its own
 * breadth at least (chosen by eye: less closes up). */
#define WHITE_STEM_MM 1.2
#define OPEN_MM 0.4
#define HALO_WIDTHS 0.4
/* A node of the tree has so many boxes. */
#define FAN 8
/* One drawing may look at edges so often, which takes some seconds: beyond, nothing more is cut. */
#define MAX_EDGE_LOOKS 2e8

typedef struct {
    box bounds;
    size_t order;    /* the item's number */
    double halo;     /* 0, or the breadth of a band along the outline that stays free, mm: the area is then this band */
    uint32_t code;   /* Morton code of the middle */
    region *region;  /* made when first needed */
    bool is_failed;  /* it could not be made */
} area;

typedef struct {
    box bounds;
    size_t latest; /* the largest order below */
} node;

struct occluders {
    const display_list *list;
    const plan_options *options;
    clipper *clips;
    ARRAY(area) areas;
    ARRAY(node) nodes; /* level after level, the areas' own boxes first */
    size_t level[12], levels; /* where each level starts; FAN to the power of 12 is beyond LIST_MAX_ITEMS */
    coverage_raster *raster; /* NULL where nothing hides */
    bool *hidden;    /* of each item: no need to look at it */
    double work;
    size_t query_item; /* the item that asks */
    bool query_above;  /* what comes after that item counts; else what came before: set by each question */
    track_list seen;   /* by the raster, of the track at work */
    error *err;
};

/* ---- which areas ---- */

/* A veil of paper, as legends lay behind their words, hides as well. */
static bool is_opaque(const display_list *list, const item *it)
{
    const paint *p = &it->paint;
    const gradient *g = plb_item_gradient(list, it);
    if (g)
        return plb_gradient_is_opaque(g, OPAQUE);
    bool is_veil = p->kind == PAINT_SOLID && p->alpha >= VEIL && fmin(p->red, fmin(p->green, p->blue)) >= VEIL_LIGHT;
    return (p->alpha >= OPAQUE || is_veil) && p->kind != PAINT_PATTERN;
}

/* Gives the breadth of the band that the item hides, mm: a wide line hides as much as it covers, a line in the paper's
 * colour at least what shows as a gap between two lines of the pencil. 0: the item is no line, or hides nothing. */
static double hiding_width(const item *it, const plan_options *o)
{
    if (it->kind != ITEM_STROKE || it->dash.n)
        return 0;
    return plb_leaves_mark(it) ? plb_is_wide(it, o) ? it->width : 0 : fmax(it->width, GAP_WIDTHS * o->pencil_width);
}

static bool hides(const display_list *list, const item *it, const plan_options *o)
{
    return (it->kind == ITEM_FILL || hiding_width(it, o) > 0) && is_opaque(list, it);
}

static box intersect(box a, box b)
{
    return (box){fmax(a.x0, b.x0), fmax(a.y0, b.y0), fmin(a.x1, b.x1), fmin(a.y1, b.y1)};
}

/* Gives the box that an item can paint in: its path's, within the page and its clips. */
static box reach_of(const display_list *list, const item *it, const plan_options *o)
{
    box b = plb_path_bounds(&it->path);
    double more = it->kind == ITEM_STROKE ? fmax(it->width, hiding_width(it, o)) : 0; /* half would do but for square caps */
    b = (box){b.x0 - more, b.y0 - more, b.x1 + more, b.y1 + more};
    b = intersect(b, (box){0, 0, list->width, list->height});
    for (int k = it->clip; k != NO_CLIP; k = list->clips.v[k].parent)
        b = intersect(b, plb_path_bounds(&list->clips.v[k].path));
    return b;
}

static uint32_t spread(double unit)
{
    uint32_t x = (uint32_t)(fmin(fmax(unit, 0), 1) * 65535);
    x = (x | x << 8) & 0x00ff00ff;
    x = (x | x << 4) & 0x0f0f0f0f;
    x = (x | x << 2) & 0x33333333;
    return (x | x << 1) & 0x55555555;
}

/* Gives the breadth of the band along the outlines of white letters that must stay free: lines beside the letter and those that end at it
 * reach over by a part of their breadth. 0: it is no white letter,
 * or nothing is hatched. */
static double halo_of(const item *it, const plan_options *o)
{
    double stem = o->fill == FILL_HATCH && it->kind == ITEM_FILL && !plb_leaves_mark(it) ? plb_fill_breadth(&it->path) : INFINITY;
    return stem > WHITE_STEM_MM ? 0 : HALO_WIDTHS * o->shade_width + fmax(OPEN_MM - stem, 0);
}

static bool add_area(occluders *c, size_t i, double halo)
{
    const display_list *list = c->list;
    box b = reach_of(list, &list->items.v[i], c->options);
    b = (box){b.x0 - halo, b.y0 - halo, b.x1 + halo, b.y1 + halo};
    if (b.x1 - b.x0 < 2 * EDGE_MARGIN_MM || b.y1 - b.y0 < 2 * EDGE_MARGIN_MM)
        return true; /* too small for anything to hide in */
    area a = {.bounds = b, .order = i, .halo = halo};
    a.code = spread((b.x0 + b.x1) / 2 / list->width) | spread((b.y0 + b.y1) / 2 / list->height) << 1;
    return array_push(&c->areas, a);
}

/* ---- the tree ---- */

static int compare_areas(const void *a, const void *b)
{
    const area *x = a, *y = b;
    return x->code != y->code ? (x->code < y->code ? -1 : 1) : (x->order > y->order) - (x->order < y->order);
}

static node join(const node *first, size_t n)
{
    node all = {BOX_EMPTY, 0};
    for (size_t i = 0; i < n; i++) {
        plb_box_add(&all.bounds, (point){first[i].bounds.x0, first[i].bounds.y0});
        plb_box_add(&all.bounds, (point){first[i].bounds.x1, first[i].bounds.y1});
        all.latest = first[i].latest > all.latest ? first[i].latest : all.latest;
    }
    return all;
}

static bool build(occluders *c)
{
    if (c->areas.n == 0)
        return true;
    qsort(c->areas.v, c->areas.n, sizeof *c->areas.v, compare_areas);
    if (!array_reserve(&c->nodes, c->areas.n + c->areas.n / (FAN - 1) + 16))
        return false;
    for (size_t i = 0; i < c->areas.n; i++)
        c->nodes.v[c->nodes.n++] = (node){c->areas.v[i].bounds, c->areas.v[i].order};
    for (size_t n = c->areas.n; n > 1; n = (n + FAN - 1) / FAN) {
        size_t below = c->level[c->levels++];
        c->level[c->levels] = c->nodes.n;
        for (size_t k = 0; k < n; k += FAN)
            c->nodes.v[c->nodes.n++] = join(c->nodes.v + below + k, n - k < FAN ? n - k : FAN);
    }
    c->levels++;
    return true;
}

/* ---- what is hidden as a whole ---- */

/* Tells whether the item's clips are upright boxes, so that its box within them says all. */
static bool has_box_clips(const occluders *c, const item *it)
{
    for (int k = it->clip; k != NO_CLIP; k = c->list->clips.v[k].parent) {
        const region *r = plb_clipper_region(c->clips, k, c->err);
        if (!r || !plb_region_is_box(r))
            return false;
    }
    return true;
}

static bool look_at_shape(occluders *c, size_t i, box within)
{
    const item *it = &c->list->items.v[i];
    bool covers = hides(c->list, it, c->options) && has_box_clips(c, it);
    if (it->kind == ITEM_FILL)
        return plb_coverage_add(c->raster, &it->path, it->even_odd, within, covers, i, &c->hidden[i], c->err);
    path outline = {0};
    bool ok = !covers || (plb_wide_outline(it, hiding_width(it, c->options), &outline, c->err) && plb_coverage_add(c->raster, &outline, false, within, covers, i, &c->hidden[i], c->err));
    plb_path_free(&outline);
    return ok;
}

/* Looks for hidden items from the last item to the first. */
static bool find_hidden(occluders *c)
{
    const display_list *list = c->list;
    if (c->areas.n == 0)
        return true;
    c->raster = plb_coverage_new(list->width, list->height, c->areas.n);
    c->hidden = plb_new(list->items.n, sizeof *c->hidden);
    bool ok = c->raster && c->hidden;
    for (size_t i = list->items.n; ok && i-- > 0;) {
        box b = reach_of(list, &list->items.v[i], c->options);
        if (b.x0 > b.x1 || b.y0 > b.y1)
            continue; /* beside the page */
        c->hidden[i] = plb_coverage_hides_box(c->raster, b);
        ok = c->hidden[i] || look_at_shape(c, i, b);
    }
    return ok;
}

bool plb_occluders_hide_item(const occluders *c, size_t i)
{
    return c->hidden && c->hidden[i];
}

occluders *plb_occluders_new(const display_list *list, const plan_options *o, clipper *clips, error *err)
{
    occluders *c = plb_new(1, sizeof *c);
    bool ok = c;
    if (ok) {
        c->list = list;
        c->options = o;
        c->clips = clips;
        c->err = err;
    }
    for (size_t i = 0; ok && i < list->items.n; i++)
        ok = !hides(list, &list->items.v[i], o) ||
             (add_area(c, i, 0) && (!(halo_of(&list->items.v[i], o) > 0) || add_area(c, i, halo_of(&list->items.v[i], o))));
    if (ok && build(c) && find_hidden(c))
        return c;
    plb_occluders_free(c);
    plb_fail_memory(err);
    return NULL;
}

void plb_occluders_free(occluders *c)
{
    if (!c)
        return;
    for (size_t i = 0; i < c->areas.n; i++)
        plb_region_free(c->areas.v[i].region);
    array_free(&c->areas);
    array_free(&c->nodes);
    plb_coverage_free(c->raster);
    plb_tracks_free(&c->seen);
    plb_free(c->hidden);
    plb_free(c);
}

bool plb_occluders_are_exhausted(const occluders *c)
{
    return c->work > MAX_EDGE_LOOKS;
}

/* ---- questions ---- */

static region *make_region(occluders *c, const item *it, double halo)
{
    if (it->kind == ITEM_FILL && !(halo > 0))
        return plb_region_new(&it->path, it->even_odd, c->err);
    path outline = {0};
    region *r = plb_wide_outline(it, halo > 0 ? halo : hiding_width(it, c->options), &outline, c->err) ? plb_region_new(&outline, false, c->err) : NULL;
    plb_path_free(&outline);
    return r;
}

static const region *region_of(occluders *c, area *a)
{
    if (!a->region && !a->is_failed) {
        a->region = make_region(c, &c->list->items.v[a->order], a->halo);
        a->is_failed = !a->region;
    }
    return a->region;
}

/* Visits an area: true goes on to the next. */
typedef bool (*area_visit)(occluders *c, area *a, void *closure);

/* Tells whether something below the node may matter: a box that meets `b`, later than the one that asks, or any. */
static bool concerns(occluders *c, const node *at, const box *b)
{
    c->work++;
    bool apart = (at->bounds.x0 > b->x1) | (at->bounds.x1 < b->x0) | (at->bounds.y0 > b->y1) | (at->bounds.y1 < b->y0);
    return !(apart | (c->query_above & (at->latest <= c->query_item)) | plb_occluders_are_exhausted(c));
}

/* Visits every such area below a node; false when a visit said so. */
static bool visit(occluders *c, size_t level, size_t k, const box *b, area_visit see, void *closure)
{
    if (level == 0)
        return see(c, &c->areas.v[k], closure);
    const node *below = c->nodes.v + c->level[level - 1];
    size_t n = c->level[level] - c->level[level - 1];
    for (size_t i = k * FAN; i < n && i < (k + 1) * FAN; i++)
        if (concerns(c, &below[i], b) && !visit(c, level - 1, i, b, see, closure))
            return false;
    return true;
}

static bool visit_all(occluders *c, box b, area_visit see, void *closure)
{
    return c->areas.n == 0 || !concerns(c, &c->nodes.v[c->nodes.n - 1], &b) || visit(c, c->levels - 1, 0, &b, see, closure);
}

typedef struct {
    point from, to;
    crossings *at;
} cross_question;

static bool cross_area(occluders *c, area *a, void *closure)
{
    cross_question *q = closure;
    if ((a->order > c->query_item) != c->query_above)
        return true;
    const region *r = region_of(c, a);
    if (!r || !plb_region_cross(r, q->from, q->to, q->at, &c->work))
        return false;
    for (int k = c->list->items.v[a->order].clip; k != NO_CLIP; k = c->list->clips.v[k].parent) {
        const region *within = plb_clipper_region(c->clips, k, c->err);
        if (!within || !plb_region_cross(within, q->from, q->to, q->at, &c->work))
            return false;
    }
    return true;
}

static bool cross(occluders *c, bool above, point from, point to, crossings *at)
{
    c->query_above = above;
    if (plb_occluders_are_exhausted(c))
        return true;
    box b = BOX_EMPTY;
    plb_box_add(&b, from);
    plb_box_add(&b, to);
    return visit_all(c, b, cross_area, &(cross_question){from, to, at});
}

static bool covers(occluders *c, area *a, point p)
{
    const region *r = region_of(c, a);
    if (!r)
        return false;
    c->work += plb_region_work(r, p);
    if (!plb_region_covers(r, p, EDGE_MARGIN_MM))
        return false;
    for (int k = c->list->items.v[a->order].clip; k != NO_CLIP; k = c->list->clips.v[k].parent) {
        const region *within = plb_clipper_region(c->clips, k, c->err);
        if (!within || !plb_region_covers(within, p, EDGE_MARGIN_MM))
            return false;
    }
    return true;
}

/* Asks on while the point is not covered. */
static bool leaves_open(occluders *c, area *a, void *closure)
{
    return !covers(c, a, *(const point *)closure);
}

static bool sees(const void *of, point p)
{
    occluders *c = (occluders *)of;
    c->query_above = true;
    return plb_occluders_are_exhausted(c) || visit_all(c, (box){p.x, p.y, p.x, p.y}, leaves_open, &p);
}

static bool cross_above(const void *of, point from, point to, crossings *at)
{
    return cross((occluders *)of, true, from, to, at);
}

static bool cross_below(const void *of, point from, point to, crossings *at)
{
    return cross((occluders *)of, false, from, to, at);
}

/* Asks for the area that lies on top below the item that asks. */
typedef struct {
    point at;
    size_t next; /* one more than the order of the latest area found; 0: none */
} ground_question;

static bool find_ground(occluders *c, area *a, void *closure)
{
    ground_question *q = closure;
    if (a->order < c->query_item && a->order >= q->next && covers(c, a, q->at))
        q->next = a->order + 1;
    return true;
}

static bool is_same_paint(const paint *a, const paint *b)
{
    return a->kind == PAINT_SOLID && b->kind == PAINT_SOLID && a->red == b->red && a->green == b->green && a->blue == b->blue;
}

static bool stands_out(const void *of, point p)
{
    occluders *c = (occluders *)of;
    ground_question q = {p, 0};
    c->query_above = false;
    visit_all(c, (box){p.x, p.y, p.x, p.y}, find_ground, &q);
    return plb_occluders_are_exhausted(c) || q.next == 0 || !is_same_paint(&c->list->items.v[q.next - 1].paint, &c->list->items.v[c->query_item].paint);
}

static bool stop(occluders *c, area *a, void *closure)
{
    (void)c, (void)a, (void)closure;
    return false;
}

/* ---- cutting: first by the raster, what is left exactly ---- */

static bool cross_raster(const void *of, point from, point to, crossings *at)
{
    const occluders *c = of;
    return plb_coverage_cross(c->raster, c->query_item, from, to, at);
}

static bool is_open(const void *of, point p)
{
    const occluders *c = of;
    return !plb_coverage_is_over(c->raster, c->query_item, p);
}

/* Computes the parts of a track that the exact rule sees. */
static bool cut(occluders *c, const trim_rule *exact, const track *t, track_list *out, bool *is_part)
{
    if (!c->raster)
        return plb_plan_trim(exact, t, out, is_part, c->err);
    trim_rule rough = {cross_raster, is_open, c};
    plb_tracks_clear(&c->seen);
    bool ok = plb_plan_trim(&rough, t, &c->seen, is_part, c->err);
    for (size_t i = 0; ok && i < c->seen.tracks.n; i++) {
        track seen = plb_track_at(&c->seen, i);
        ok = plb_plan_trim(exact, &seen, out, is_part, c->err);
    }
    return ok;
}

/* Tells whether an end is not that of the whole track. */
static bool is_new_end(point end, point of_whole)
{
    return plb_point_distance(end, of_whole) > SAME_POINT_MM;
}

static void note_parts(track_list *out, size_t from, const track *whole)
{
    for (size_t i = from; i < out->tracks.n; i++) {
        track *part = &out->tracks.v[i];
        const track_point *v = out->points.v + part->first;
        part->is_part = true;
        part->hidden_first = is_new_end(v[0].at, whole->v[0].at);
        part->hidden_last = is_new_end(v[part->n - 1].at, whole->v[whole->n - 1].at);
    }
}

static bool hide(occluders *c, const track *t, track_list *out)
{
    trim_rule exact = {cross_above, sees, c};
    size_t from = out->tracks.n;
    bool is_part = false;
    c->query_above = true;
    if (visit_all(c, plb_track_bounds(t), stop, NULL)) /* nothing near */
        return plb_track_copy(out, t) || plb_fail_memory(c->err);
    if (!cut(c, &exact, t, out, &is_part))
        return false;
    if (is_part)
        note_parts(out, from, t);
    return true;
}

bool plb_plan_hide(occluders *c, size_t i, const track_list *in, track_list *out, error *err)
{
    bool ok = true;
    c->query_item = i;
    c->err = err;
    for (size_t k = 0; ok && k < in->tracks.n; k++) {
        track t = plb_track_at(in, k);
        ok = hide(c, &t, out);
    }
    return ok;
}

bool plb_plan_fuse(occluders *c, size_t i, const track_list *in, track_list *out, error *err)
{
    trim_rule exact = {cross_below, stands_out, c};
    bool ok = true, is_part, fuses = is_opaque(c->list, &c->list->items.v[i]);
    c->query_item = i;
    c->err = err;
    for (size_t k = 0; ok && k < in->tracks.n; k++) {
        track t = plb_track_at(in, k);
        if (t.n > 1)
            ok = fuses && t.is_outline ? cut(c, &exact, &t, out, &is_part) : plb_track_copy(out, &t) || plb_fail_memory(err);
    }
    return ok;
}
