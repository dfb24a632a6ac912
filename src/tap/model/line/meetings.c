/* SPDX-License-Identifier: MIT
 *
 * Where surfaces run through each other, there is a line, though no edge: triangles that cut each other, found in pairs by the tree of
 * boxes. Triangles that only touch have none: their edges are lines already.
 */
#include "tap/model/hidden/tree.h"
#include "tap/model/line/line.h"

#include "base/number/random.h"

/* So far must corners lie on both sides of the other's plane, as a part of the model's size. */
#define THROUGH 2e-5

/* A plane has the places p with n p = d. */
typedef struct {
    vector n; /* length 1 */
    double d;
} plane;

typedef struct {
    const view *v;
    double through;
    plane *planes; /* of the triangles, on paper */
    line_pieces *out;
} meeting_finder;

/* A cut is where the other's plane crosses a triangle: two places on its sides, by their numbers along the line of both planes. */
typedef struct {
    double from, to; /* along the line */
    vector at_from, at_to;
    uint32_t side_from, side_to; /* 3 * triangle + side */
} cut;

static bool cut_by_plane(const view *v, uint32_t t, const double side[3], vector way, cut *out)
{
    int n = 0;
    for (uint32_t k = 0; k < 3 && n < 2; k++) {
        uint32_t l = (k + 1) % 3;
        if ((side[k] > 0) == (side[l] > 0))
            continue;
        vector at = vector_mix(view_corner(v, t, (int)k), view_corner(v, t, (int)l), side[k] / (side[k] - side[l]));
        double along = vector_dot(at, way);
        if (n == 0)
            *out = (cut){along, along, at, at, 3 * t + k, 3 * t + k};
        else if (along < out->from)
            out->from = along, out->at_from = at, out->side_from = 3 * t + k;
        else
            out->to = along, out->at_to = at, out->side_to = 3 * t + k;
        n++;
    }
    return n == 2;
}

static bool lies_on_both_sides(const meeting_finder *f, const plane *p, uint32_t other, double side[3])
{
    double most = 0, least = 0;
    for (int k = 0; k < 3; k++) {
        side[k] = vector_dot(p->n, view_corner(f->v, other, k)) - p->d;
        most = greater(most, side[k]);
        least = lesser(least, side[k]);
    }
    return most > f->through && least < -f->through;
}

static bool are_neighbours(const mesh *m, uint32_t t, uint32_t u)
{
    const uint32_t *a = m->triangles.v[t].corner, *b = m->triangles.v[u].corner;
    for (int i = 0; i < 3; i++)
        if (a[i] == b[0] || a[i] == b[1] || a[i] == b[2])
            return true;
    return false;
}

/* A line ends where a side of one triangle goes through the other. */
static uint64_t node_of(const mesh *m, uint32_t side, uint32_t other)
{
    uint32_t e = m->side_edge.v[side];
    uint64_t known = e != NO_TRIANGLE ? e : (uint64_t)m->edges.n + side;
    return random_fold(0x6d656574u, (int64_t)known, other) | (uint64_t)1 << 63; /* no other node has this bit */
}

static bool meet(meeting_finder *f, uint32_t t, uint32_t u)
{
    const view *v = f->v;
    double side_u[3], side_t[3];
    cut p, q;
    if (!lies_on_both_sides(f, &f->planes[t], u, side_u) || !lies_on_both_sides(f, &f->planes[u], t, side_t) || are_neighbours(v->m, t, u))
        return true; /* neighbours meet in their common corner or edge */
    vector way = vector_unit(vector_cross(f->planes[t].n, f->planes[u].n));
    if (!cut_by_plane(v, t, side_t, way, &p) || !cut_by_plane(v, u, side_u, way, &q))
        return true;
    bool starts_in_t = p.from > q.from, ends_in_t = p.to < q.to; /* whose side ends the line */
    double from = starts_in_t ? p.from : q.from, to = ends_in_t ? p.to : q.to;
    if (!(to - from > f->through))
        return true;
    line_piece piece = {
        starts_in_t ? p.at_from : q.at_from, ends_in_t ? p.at_to : q.at_to,
        starts_in_t ? node_of(v->m, p.side_from, u) : node_of(v->m, q.side_from, t), ends_in_t ? node_of(v->m, p.side_to, u) : node_of(v->m, q.side_to, t),
        NO_TRIANGLE, {t, u}, LINE_MEETING};
    return array_push(f->out, piece);
}

/* Gives the place in the tree's order of the last triangle below the node. */
static size_t last_below(const box_tree *t, size_t node)
{
    size_t row = 1; /* nodes in its row */
    while (2 * row <= node)
        row *= 2;
    size_t leaf = (node + 1) * (t->leaves / row) - 1;
    return (leaf - t->leaves + 1) * TREE_LEAF - 1;
}

/* Compares the triangle with those behind it in the tree's order. */
static bool meet_all(meeting_finder *f, const box_tree *t, size_t i)
{
    size_t todo[64], n = 0;
    tree_box own = t->boxes[i];
    /* Boxes that only touch hold triangles that only touch; a flat box must be gone through. */
    for (int k = 0; k < 3; k++) {
        own.low[k] += (float)(f->through / 2);
        own.high[k] -= (float)(f->through / 2);
    }
    todo[n++] = 1;
    while (n) {
        size_t k = todo[--n];
        if (!tree_boxes_meet(&t->nodes[k], &own))
            continue;
        if (last_below(t, k) <= i)
            continue;
        if (k < t->leaves) {
            todo[n++] = 2 * k;
            todo[n++] = 2 * k + 1;
            continue;
        }
        for (size_t j = (k - t->leaves) * TREE_LEAF; j < (k - t->leaves + 1) * TREE_LEAF && j < t->n; j++)
            if (j > i && tree_boxes_meet(&own, &t->boxes[j]) && !meet(f, t->order[i], t->order[j]))
                return false;
    }
    return true;
}

static plane *planes_of(const view *v)
{
    plane *planes = plb_new(v->m->triangles.n + 1, sizeof *planes);
    for (size_t i = 0; planes && i < v->m->triangles.n; i++) {
        vector a = view_corner(v, i, 0);
        planes[i].n = vector_unit(vector_cross(vector_sub(view_corner(v, i, 1), a), vector_sub(view_corner(v, i, 2), a)));
        planes[i].d = vector_dot(planes[i].n, a);
    }
    return planes;
}

bool plb_line_meetings(const view *v, line_pieces *out, error *err)
{
    meeting_finder f = {v, THROUGH * v->scale * v->m->size, planes_of(v), out};
    box_tree t = {0};
    bool ok = f.planes && plb_tree_build(&t, v, false, err);
    for (size_t i = 0; ok && i < t.n; i++)
        ok = meet_all(&f, &t, i);
    plb_tree_free(&t);
    plb_free(f.planes);
    return ok || plb_fail_memory(err);
}
