/* SPDX-License-Identifier: MIT
 *
 * Lines of a view that the mesh has as edges, and the contours of its smooth surfaces.
 */
#include "tap/model/line/line.h"

bool plb_line_edges(const view *v, line_pieces *out, error *err)
{
    const mesh *m = v->m;
    for (size_t i = 0; i < m->edges.n; i++) {
        const edge *e = &m->edges.v[i];
        if (e->kind == EDGE_SMOOTH)
            continue;
        line_piece p = {v->at.v[e->a], v->at.v[e->b], e->a, e->b, (uint32_t)i, {NO_TRIANGLE, NO_TRIANGLE}, e->kind == EDGE_MATERIAL ? LINE_MATERIAL : LINE_EDGE};
        if (!array_push(out, p))
            return plb_fail_memory(err);
    }
    for (size_t i = 0; i + 1 < m->wires.n; i += 2) {
        uint32_t a = m->wires.v[i], b = m->wires.v[i + 1];
        line_piece p = {v->at.v[a], v->at.v[b], a, b, NO_TRIANGLE, {NO_TRIANGLE, NO_TRIANGLE}, LINE_WIRE};
        if (a != b && !array_push(out, p))
            return plb_fail_memory(err);
    }
    return true;
}

/* ---- contours ---- */

/* How far the smooth surface is turned towards the eye at each group of corners. A flat face has the same everywhere, up to
 * rounding: what is as good as zero counts as turned away, all alike. */
static double *facing_of_groups(const view *v)
{
    const mesh *m = v->m;
    double *g = plb_new(m->smooth.n + 1, sizeof *g);
    for (size_t i = 0; g && i < m->group.n; i++) {
        double f = vector_dot(m->smooth.v[m->group.v[i]], plb_view_to_eye(v, mesh_corner(m, i / 3, (int)(i % 3))));
        g[m->group.v[i]] = f > 1e-7 ? f : f < -1e-7 ? f : -1e-7;
    }
    return g;
}

typedef struct {
    vector at;
    uint64_t node;
} crossing;

/* The contour crosses two sides of a triangle, or none. */
static int find_crossings(const view *v, const double *facing, uint32_t t, crossing out[3])
{
    const mesh *m = v->m;
    int n = 0;
    for (uint32_t k = 0; k < 3; k++) {
        uint32_t l = (k + 1) % 3;
        double a = facing[m->group.v[3 * t + k]], b = facing[m->group.v[3 * t + l]];
        if ((a > 0) == (b > 0))
            continue;
        /* From the lower place to the higher one, so that both neighbours find the same. */
        uint32_t p = m->triangles.v[t].corner[k], q = m->triangles.v[t].corner[l];
        double s = p < q ? a / (a - b) : b / (b - a);
        vector from = v->at.v[p < q ? p : q], to = v->at.v[p < q ? q : p];
        uint32_t e = m->side_edge.v[3 * t + k];
        bool goes_on = e != NO_TRIANGLE && m->edges.v[e].n == 2;
        out[n++] = (crossing){vector_mix(from, to, s), goes_on ? m->places.n + e : m->places.n + m->edges.n + 3 * (uint64_t)t + k};
    }
    return n;
}

/* Tells whether the triangle is a facet that is seen as one, for a side of it turns far. */
static bool is_facet(const mesh *m, uint32_t t)
{
    for (uint32_t k = 0; k < 3; k++) {
        uint32_t e = m->side_edge.v[3 * t + k];
        if (e != NO_TRIANGLE && m->edges.v[e].is_coarse)
            return true;
    }
    return false;
}

/* Tells whether one of the edge's two triangles faces the eye and the other does not, and one of them is a facet. */
static bool is_outline_of_facets(const view *v, const edge *e)
{
    const mesh *m = v->m;
    if (e->kind != EDGE_SMOOTH || e->n != 2)
        return false;
    uint32_t t = m->halves.v[e->first].side / 3, u = m->halves.v[e->first + 1].side / 3;
    bool is_t_toward = v->is_front.v[t] != m->is_turned.v[t], is_u_toward = v->is_front.v[u] != m->is_turned.v[u];
    return is_t_toward != is_u_toward && (is_facet(m, t) || is_facet(m, u));
}

/* Smooth surfaces have their contour between the corners' normals, coarse ones along their edges. */
bool plb_line_contours(const view *v, line_pieces *out, error *err)
{
    const mesh *m = v->m;
    double *facing = facing_of_groups(v);
    bool ok = facing;
    for (uint32_t t = 0; ok && t < m->triangles.n; t++) {
        crossing c[3];
        if (is_facet(m, t) || find_crossings(v, facing, t, c) != 2)
            continue;
        line_piece p = {c[0].at, c[1].at, c[0].node, c[1].node, NO_TRIANGLE, {t, NO_TRIANGLE}, LINE_CONTOUR};
        ok = array_push(out, p);
    }
    for (uint32_t i = 0; ok && i < m->edges.n; i++) {
        const edge *e = &m->edges.v[i];
        line_piece p = {v->at.v[e->a], v->at.v[e->b], e->a, e->b, i, {NO_TRIANGLE, NO_TRIANGLE}, LINE_EDGE};
        ok = !is_outline_of_facets(v, e) || array_push(out, p);
    }
    plb_free(facing);
    return ok || plb_fail_memory(err);
}
