/* SPDX-License-Identifier: MIT
 *
 * See hide.h. A triangle and a piece of line are compared in the picture: the piece is clipped by the three sides, and there
 * by the depth; both are linear along it, so the hidden part is exact. Rounding is met by two tolerances: sides reach out by a little, so that nothing
 * shows through the seam of two triangles; what lies on a surface, or less than a little behind it, is seen. A surface that is seen
 * almost edge-on falls off so steeply that the first tolerance would move it: the second grows with its slope [BH19, §4.2].
 */
#include "tap/model/hidden/hide.h"

#include "base/geometry/interpolate.h"

/* Parts of the model's size on paper. */
#define BEHIND 2e-5
#define BESIDE 1e-7
/* A contour lies inside of triangles, not on their sides, so triangles of its own surface that are nearer than this part of its own
 * triangle's breadth do not hide it (chosen by eye: a smooth surface is as exact as that). */
#define CONTOUR_BEHIND 0.5
/* Shorter gaps within a line are closed and shorter scraps left out, mm (chosen by eye: less than half a pencil's line). */
#define GAP_MM 0.1
#define SCRAP_MM 0.15

typedef struct {
    double from, to; /* of the piece, 0 to 1 */
} span;
#define MAX_SPANS 64

typedef struct {
    const view *v;
    const box_tree *tree;
    double behind, beside;
    /* The piece at work: */
    const line_piece *piece;
    point at, way;
    double z, climb;  /* depth at its beginning, and by how much the end is nearer */
    double breadth;   /* contours: of the own triangle, mm */
    tree_box box;
    int n;            /* hidden spans, in order, apart from each other */
    span spans[MAX_SPANS];
    uint32_t last;    /* the triangle that hid a whole piece last: it often hides the next, too */
} hider;

double plb_hide_tolerance(const view *v)
{
    return BEHIND * v->scale * v->m->size;
}

/* ---- spans ---- */

/* Adds a hidden span and unites it with those that it meets. */
static void add_span(hider *h, double from, double to)
{
    span s = {from, to};
    int first = 0, last;
    while (first < h->n && h->spans[first].to < s.from)
        first++;
    for (last = first; last < h->n && h->spans[last].from <= s.to; last++) {
        s.from = lesser(s.from, h->spans[last].from);
        s.to = greater(s.to, h->spans[last].to);
    }
    int gone = last - first;
    if (gone == 0 && h->n == MAX_SPANS)
        return; /* no line of a drawing is cut up so finely */
    if (gone == 0)
        for (int i = h->n++; i > first; i--)
            h->spans[i] = h->spans[i - 1];
    else if (gone > 1) {
        for (int i = last; i < h->n; i++)
            h->spans[i - gone + 1] = h->spans[i];
        h->n -= gone - 1;
    }
    h->spans[first] = s;
}

static bool is_all_hidden(const hider *h) { return h->n == 1 && h->spans[0].from <= 0 && h->spans[0].to >= 1; }

/* ---- one triangle ---- */

/* Keeps the part of `s` where a value that goes from f0 to f1 along the piece is not below 0. */
static bool clip_span(span *s, double f0, double f1)
{
    if (f0 < 0 && f1 < 0)
        return false;
    if (f0 < 0)
        s->from = greater(s->from, f0 / (f0 - f1));
    else if (f1 < 0)
        s->to = lesser(s->to, f0 / (f0 - f1));
    return s->from < s->to;
}

static bool has_corner_of(const triangle *t, const triangle *own)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            if (t->corner[i] == own->corner[k])
                return true;
    return false;
}

/* Tells whether the triangle is one of those that the piece lies on; `more` gets what it must be nearer than usual. */
static bool is_own(const hider *h, uint32_t t, double *more)
{
    const mesh *m = h->v->m;
    const line_piece *p = h->piece;
    *more = 0;
    if (t == p->own[0] || t == p->own[1])
        return true;
    if (p->edge != NO_TRIANGLE) {
        const edge *e = &m->edges.v[p->edge];
        for (uint32_t k = 0; k < e->n; k++)
            if (m->halves.v[e->first + k].side / 3 == t)
                return true;
    }
    if (p->kind != LINE_CONTOUR || m->patch.v[t] != m->patch.v[p->own[0]])
        return false;
    *more = h->breadth;
    return has_corner_of(&m->triangles.v[t], &m->triangles.v[p->own[0]]);
}

static void hide_by(hider *h, uint32_t t)
{
    double more;
    if (is_own(h, t, &more))
        return;
    vector c[3];
    for (int k = 0; k < 3; k++)
        c[k] = view_corner(h->v, t, k);
    vector n = vector_cross(vector_sub(c[1], c[0]), vector_sub(c[2], c[0]));
    double longest = greater(fabs(c[1].x - c[0].x) + fabs(c[1].y - c[0].y), fabs(c[2].x - c[0].x) + fabs(c[2].y - c[0].y));
    if (!(fabs(n.z) > h->beside * longest))
        return; /* edge-on: it covers nothing */
    /* The sides: distances of the piece's ends from each, inwards positive. */
    span s = {0, 1};
    for (int k = 0; k < 3; k++) {
        point a = {c[k].x, c[k].y}, d = {c[(k + 1) % 3].x - a.x, c[(k + 1) % 3].y - a.y};
        double l = plb_point_length(d) * (n.z < 0 ? -1 : 1), f = point_cross(d, point_sub(h->at, a)) / l, g = point_cross(d, h->way) / l;
        if (!clip_span(&s, f + h->beside, f + g + h->beside))
            return;
    }
    /* The depth: how far the triangle's plane is nearer than the piece. */
    point slope = {-n.x / n.z, -n.y / n.z};
    double near = c[0].z + slope.x * (h->at.x - c[0].x) + slope.y * (h->at.y - c[0].y) - h->z;
    double grows = point_dot(slope, h->way) - h->climb, enough = h->behind + more + plb_point_length(slope) * h->beside;
    if (clip_span(&s, near - enough, near + grows - enough))
        add_span(h, s.from, s.to);
}

/* ---- one piece ---- */

/* Tells whether the piece's line passes the box in the picture. */
static bool passes(const hider *h, const tree_box *b)
{
    double x = ((double)b->low[0] + (double)b->high[0]) / 2 - h->at.x, y = ((double)b->low[1] + (double)b->high[1]) / 2 - h->at.y;
    double rx = ((double)b->high[0] - (double)b->low[0]) / 2 + h->beside, ry = ((double)b->high[1] - (double)b->low[1]) / 2 + h->beside;
    return fabs(x * h->way.y - y * h->way.x) <= rx * fabs(h->way.y) + ry * fabs(h->way.x);
}

static void set_piece(hider *h, const line_piece *p)
{
    double low[3] = {lesser(p->from.x, p->to.x), lesser(p->from.y, p->to.y), lesser(p->from.z, p->to.z)};
    double high[2] = {greater(p->from.x, p->to.x), greater(p->from.y, p->to.y)};
    h->piece = p;
    h->at = (point){p->from.x, p->from.y};
    h->way = (point){p->to.x - p->from.x, p->to.y - p->from.y};
    h->z = p->from.z;
    h->climb = p->to.z - p->from.z;
    h->n = 0;
    /* Surfaces farther away than all of the piece cannot hide it. */
    for (int k = 0; k < 3; k++) {
        double slack = fabs(low[k]) * 2e-7 + h->beside;
        h->box.low[k] = (float)(low[k] - slack);
        h->box.high[k] = k < 2 ? (float)(high[k] + fabs(high[k]) * 2e-7 + h->beside) : 1e30f;
    }
    h->breadth = 0;
    if (p->kind == LINE_CONTOUR) {
        vector a = view_corner(h->v, p->own[0], 0), b = view_corner(h->v, p->own[0], 1), c = view_corner(h->v, p->own[0], 2);
        h->breadth = CONTOUR_BEHIND * sqrt(vector_length(vector_cross(vector_sub(b, a), vector_sub(c, a))) / 2);
    }
}

/* Finds all hidden spans of the piece. */
static void hide_piece(hider *h, const line_piece *p)
{
    const box_tree *t = h->tree;
    size_t todo[64], n = 0; /* as deep as a tree of 2^32 leaves */
    set_piece(h, p);
    if (h->last != NO_TRIANGLE)
        hide_by(h, h->last);
    if (!is_all_hidden(h) && t->n)
        todo[n++] = 1;
    while (n) {
        size_t k = todo[--n];
        if (!tree_boxes_meet(&t->nodes[k], &h->box) || !passes(h, &t->nodes[k]))
            continue;
        if (k < t->leaves) {
            /* The nearer half first: it hides more. */
            bool right_first = t->nodes[2 * k + 1].high[2] > t->nodes[2 * k].high[2];
            todo[n++] = 2 * k + !right_first;
            todo[n++] = 2 * k + right_first;
            continue;
        }
        size_t end = (k - t->leaves + 1) * TREE_LEAF;
        for (size_t i = (k - t->leaves) * TREE_LEAF; i < end && i < t->n; i++) {
            if (!tree_boxes_meet(&t->boxes[i], &h->box))
                continue;
            hide_by(h, t->order[i]);
            if (is_all_hidden(h)) {
                h->last = t->order[i];
                return;
            }
        }
    }
}

/* ---- runs ---- */

typedef struct {
    run_list *out;
    line_kind kind;
    bool keep_hidden, is_open, is_hidden;
    size_t first;         /* points of the run at work */
} run_maker;

static double run_length(const run_list *l, size_t first)
{
    double length = 0;
    for (size_t i = first + 1; i < l->points.n; i++)
        length += plb_point_distance(l->points.v[i - 1], l->points.v[i]);
    return length;
}

/* Ends the run at work; a scrap goes. */
static bool end_run(run_maker *k)
{
    run_list *l = k->out;
    if (!k->is_open)
        return true;
    k->is_open = false;
    run r = {k->first, l->points.n - k->first, k->kind, k->is_hidden, false};
    if ((r.is_hidden && !k->keep_hidden) || r.n < 2 || run_length(l, r.first) < SCRAP_MM) {
        l->points.n = r.first;
        return true;
    }
    return array_push(&l->runs, r);
}

/* Goes on to `to`, seen or not, from `from`, where the line is now. */
static bool add_part(run_maker *k, point from, point to, bool is_hidden)
{
    run_list *l = k->out;
    if (k->is_open && k->is_hidden != is_hidden && !end_run(k))
        return false;
    if (!k->is_open) {
        k->is_open = true;
        k->is_hidden = is_hidden;
        k->first = l->points.n;
        if (!array_push(&l->points, from))
            return false;
    }
    point last = l->points.v[l->points.n - 1];
    return (last.x == to.x && last.y == to.y) || array_push(&l->points, to);
}

/* A part of a chain: seen or hidden, from one length along the chain to the next. */
typedef struct {
    point from, to;
    double length;
    bool is_hidden;
} part;
typedef ARRAY(part) part_list;

/* Appends the parts of a piece in the direction of the chain. */
static bool add_parts(const hider *h, bool is_backward, part_list *out)
{
    double at = 0, length = plb_point_length(h->way);
    size_t first = out->n;
    for (int i = 0; i <= h->n; i++) {
        double from = i < h->n ? clamp(h->spans[i].from, 0, 1) : 1, to = i < h->n ? clamp(h->spans[i].to, 0, 1) : 1;
        double stops[3] = {at, from, to};
        for (int k = 0; k < 2; k++)
            if (stops[k + 1] > stops[k] && !array_push(out, ((part){point_add(h->at, point_scale(h->way, stops[k])), point_add(h->at, point_scale(h->way, stops[k + 1])), (stops[k + 1] - stops[k]) * length, k == 1})))
                return false;
        at = to;
    }
    for (size_t i = first, k = out->n; is_backward && i < k--; i++) {
        part x = out->v[i], y = out->v[k];
        out->v[i] = (part){y.to, y.from, y.length, y.is_hidden};
        out->v[k] = (part){x.to, x.from, x.length, x.is_hidden};
    }
    return true;
}

/* Turns stretches of parts that are too short for a hand into what lies around them. */
static void close_gaps(part_list *l)
{
    for (size_t i = 0, next; i < l->n; i = next) {
        double length = 0;
        for (next = i; next < l->n && l->v[next].is_hidden == l->v[i].is_hidden; next++)
            length += l->v[next].length;
        bool is_within = i > 0 && next < l->n;
        if (is_within && length < GAP_MM)
            for (size_t k = i; k < next; k++)
                l->v[k].is_hidden = l->v[i - 1].is_hidden;
    }
}

/* A closed chain begins where its visibility changes, so that no run is cut at an arbitrary place. */
static size_t beginning_of(const part_list *l, bool is_closed)
{
    for (size_t i = 1; is_closed && i < l->n; i++)
        if (l->v[i].is_hidden != l->v[i - 1].is_hidden)
            return i;
    return 0;
}

static bool add_runs(part_list *l, const chain *c, line_kind kind, bool keep_hidden, run_list *out)
{
    run_maker k = {.out = out, .kind = kind, .keep_hidden = keep_hidden};
    size_t begin, runs = out->runs.n;
    bool ok = true;
    close_gaps(l);
    begin = beginning_of(l, c->is_closed);
    for (size_t i = 0; ok && i < l->n; i++) {
        const part *p = &l->v[(begin + i) % l->n];
        ok = add_part(&k, p->from, p->to, p->is_hidden);
    }
    ok = ok && end_run(&k);
    if (ok && c->is_closed && begin == 0 && out->runs.n == runs + 1)
        out->runs.v[runs].is_closed = true;
    return ok;
}

bool plb_hide(const view *v, const box_tree *tree, const line_pieces *pieces, const chain_list *chains, bool keep_hidden, run_list *out, error *err)
{
    double size = v->scale * v->m->size;
    hider h = {.v = v, .tree = tree, .behind = BEHIND * size, .beside = BESIDE * size, .last = NO_TRIANGLE};
    part_list parts = {0};
    bool ok = true;
    for (size_t i = 0; ok && i < chains->chains.n; i++) {
        const chain *c = &chains->chains.v[i];
        line_kind kind = pieces->v[chains->links.v[c->first].piece].kind;
        parts.n = 0;
        for (size_t k = c->first; ok && k < c->first + c->n; k++) {
            chain_link link = chains->links.v[k];
            hide_piece(&h, &pieces->v[link.piece]);
            ok = add_parts(&h, link.is_backward, &parts);
        }
        ok = ok && add_runs(&parts, c, kind, keep_hidden, out);
    }
    array_free(&parts);
    return ok || plb_fail_memory(err);
}

void plb_run_list_free(run_list *l)
{
    array_free(&l->points);
    array_free(&l->runs);
}
