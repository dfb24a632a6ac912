/* SPDX-License-Identifier: MIT
 *
 * Which edges are seen, and which smooth surfaces the triangles stand for: neighbours over edges that are not seen belong together.
 */
#include "tap/model/mesh/mesh.h"

/* ---- edges ---- */

static const triangle *owner(const mesh *m, const edge *e, size_t k)
{
    return &m->triangles.v[m->halves.v[e->first + k].side / 3];
}

/* Tells whether the triangle goes through the edge from a to b. */
static bool goes_forward(const mesh *m, const edge *e, size_t k)
{
    uint32_t side = m->halves.v[e->first + k].side;
    vector from = mesh_corner(m, side / 3, (int)(side % 3)), to = mesh_corner(m, side / 3, (int)(side % 3 + 1) % 3);
    return vector_dot(vector_sub(to, from), vector_sub(m->places.v[e->b], m->places.v[e->a])) > 0;
}

/* Gives the direction in the k-th triangle away from the edge, length 1. */
static vector inward(const mesh *m, const edge *e, size_t k)
{
    uint32_t side = m->halves.v[e->first + k].side;
    vector n = m->normals.v[side / 3], d = vector_unit(vector_sub(m->places.v[e->b], m->places.v[e->a]));
    return vector_cross(n, goes_forward(m, e, k) ? d : vector_scale(d, -1));
}

/* Where more than two triangles meet, surfaces do, unless all lie in one plane and go on there on both sides. */
static edge_kind kind_of_many(const mesh *m, const edge *e, double crease)
{
    vector first = inward(m, e, 0);
    bool is_beside = false;
    for (size_t k = 1; k < e->n; k++) {
        vector other = inward(m, e, k);
        double angle = vector_angle(first, other);
        if (angle > crease && angle < acos(-1.) - crease)
            return EDGE_CREASE;
        is_beside = is_beside || vector_dot(first, other) < 0;
    }
    return is_beside ? EDGE_SMOOTH : EDGE_BORDER;
}

static edge_kind kind_of(const mesh *m, const edge *e, double crease)
{
    if (e->n != 2)
        return e->n == 1 ? EDGE_BORDER : kind_of_many(m, e, crease);
    const triangle *t = owner(m, e, 0), *u = owner(m, e, 1);
    double turn = acos(-1.) - vector_angle(inward(m, e, 0), inward(m, e, 1));
    /* Inside of a polygon nothing is seen, even if it is not quite flat. */
    if (turn > (t->face == u->face ? greater(crease, 1) : crease))
        return EDGE_CREASE;
    bool is_other = m->paints.v[t->paint].material != m->paints.v[u->paint].material;
    return is_other ? EDGE_MATERIAL : EDGE_SMOOTH;
}

/* ---- stray creases ---- */

/* A crease that turns by less than this many times the angle from which a turn is sharp is weak; a weak one that ends in the middle of a
 * surface before this part of the model's size is none: coarse meshes of round things have such by accident (chosen by eye). */
#define WEAK 1.6
#define STRAY 0.1

typedef struct {
    uint32_t lines; /* edges that are seen and end here */
    uint32_t edges; /* the sum of their numbers: the other one of two is found by it */
} line_end;

static bool is_weak(const mesh *m, uint32_t i, double crease)
{
    const edge *e = &m->edges.v[i];
    return e->kind == EDGE_CREASE && e->n == 2 && acos(-1.) - vector_angle(inward(m, e, 0), inward(m, e, 1)) < WEAK * crease;
}

/* Follows weak creases from the edge's free end on, as long as there is one way, and gives their length; `drop`: they become smooth. */
static double follow_stray(mesh *m, line_end *at, uint32_t i, uint32_t free_end, double crease, bool drop)
{
    double length = 0;
    uint32_t from = free_end;
    while (is_weak(m, i, crease)) {
        edge *e = &m->edges.v[i];
        uint32_t to = e->a == from ? e->b : e->a, next = at[to].edges - i;
        bool goes_on = at[to].lines == 2;
        length += vector_distance(m->places.v[e->a], m->places.v[e->b]);
        if (drop) {
            e->kind = EDGE_SMOOTH;
            at[from].lines--, at[from].edges -= i;
            at[to].lines--, at[to].edges -= i;
        }
        if (!goes_on || length > m->size)
            break;
        from = to;
        i = next;
    }
    return length;
}

static bool drop_stray_creases(mesh *m, double crease)
{
    line_end *at = plb_new(m->places.n + 1, sizeof *at);
    for (uint32_t i = 0; at && i < m->edges.n; i++) {
        const edge *e = &m->edges.v[i];
        if (e->kind == EDGE_SMOOTH)
            continue;
        at[e->a].lines++, at[e->a].edges += i;
        at[e->b].lines++, at[e->b].edges += i;
    }
    for (uint32_t i = 0; at && i < m->edges.n; i++)
        for (int k = 0; k < 2; k++) {
            uint32_t end = k ? m->edges.v[i].b : m->edges.v[i].a;
            if (m->edges.v[i].kind == EDGE_CREASE && at[end].lines == 1 && follow_stray(m, at, i, end, crease, false) < STRAY * m->size)
                follow_stray(m, at, i, end, crease, true);
        }
    bool ok = at;
    plb_free(at);
    return ok;
}

/* Where facets turn by more than this, degrees, they are seen: the outline is that of the facets, not of a smooth surface between
 * them, which may lie so far behind them that they hide it. Chosen by eye: tubes of twenty sides are round. */
#define COARSE_DEGREES 18.5

bool plb_mesh_classify(mesh *m, double crease, error *err)
{
    for (size_t i = 0; i < m->edges.n; i++)
        m->edges.v[i].kind = kind_of(m, &m->edges.v[i], crease);
    if (!drop_stray_creases(m, crease))
        return plb_fail_memory(err);
    for (size_t i = 0; i < m->edges.n; i++) {
        edge *e = &m->edges.v[i];
        e->is_coarse = e->kind == EDGE_SMOOTH && e->n == 2 && acos(-1.) - vector_angle(inward(m, e, 0), inward(m, e, 1)) > COARSE_DEGREES * acos(-1.) / 180;
    }
    return true;
}

/* ---- patches ---- */

/* Tells whether the surface goes on over the edge, as far as normals are concerned. */
static bool is_smooth(const mesh *m, const edge *e)
{
    uint32_t s = m->halves.v[e->first].side, t = m->halves.v[e->first + e->n - 1].side;
    return e->n == 2 && (e->kind == EDGE_SMOOTH || e->kind == EDGE_MATERIAL) && m->side_edge.v[s] != NO_TRIANGLE && m->side_edge.v[t] != NO_TRIANGLE;
}

/* Gives the triangle beyond the side, or NO_TRIANGLE; `same_way`: both go round the same way. */
static uint32_t beyond(const mesh *m, uint32_t side, bool *same_way)
{
    uint32_t i = m->side_edge.v[side];
    if (i == NO_TRIANGLE || !is_smooth(m, &m->edges.v[i]))
        return NO_TRIANGLE;
    const edge *e = &m->edges.v[i];
    *same_way = goes_forward(m, e, 0) != goes_forward(m, e, 1);
    uint32_t t = m->halves.v[e->first].side / 3;
    return t == side / 3 ? m->halves.v[e->first + 1].side / 3 : t;
}

/* Spreads from triangle to triangle; the corners' sense is carried along. */
static bool find_patches(mesh *m)
{
    size_t n = m->triangles.n;
    ARRAY(uint32_t) todo = {0};
    bool ok = array_reserve(&m->patch, n) && array_reserve(&m->is_turned, n);
    m->patches = 0;
    for (size_t i = 0; ok && i < n; i++)
        m->patch.v[i] = NO_TRIANGLE;
    for (uint32_t i = 0; ok && i < n; i++) {
        if (m->patch.v[i] != NO_TRIANGLE)
            continue;
        m->patch.v[i] = m->patches;
        m->is_turned.v[i] = 0;
        ok = array_push(&todo, i);
        while (ok && todo.n) {
            uint32_t t = todo.v[--todo.n];
            for (uint32_t k = 0; ok && k < 3; k++) {
                bool same_way;
                uint32_t u = beyond(m, 3 * t + k, &same_way);
                if (u == NO_TRIANGLE || m->patch.v[u] != NO_TRIANGLE)
                    continue;
                m->patch.v[u] = m->patches;
                m->is_turned.v[u] = m->is_turned.v[t] ^ !same_way;
                ok = array_push(&todo, u);
            }
        }
        m->patches++;
    }
    m->patch.n = m->is_turned.n = ok ? n : 0;
    array_free(&todo);
    return ok;
}

/* ---- normals ---- */

static uint32_t root(uint32_t *up, uint32_t i)
{
    while (up[i] != i)
        i = up[i] = up[up[i]];
    return i;
}

static void unite(uint32_t *up, uint32_t i, uint32_t k)
{
    i = root(up, i);
    k = root(up, k);
    if (i < k)
        up[k] = i;
    else
        up[i] = k;
}

/* Gives the number 3 * triangle + k of the triangle's corner at the place. */
static uint32_t corner_at(const mesh *m, uint32_t t, uint32_t place)
{
    const uint32_t *c = m->triangles.v[t].corner;
    return 3 * t + (c[0] == place ? 0 : c[1] == place ? 1 : 2);
}

/* Corners at one place belong together when smooth edges lead from one triangle to the next. */
static void unite_corners(const mesh *m, uint32_t *up)
{
    for (uint32_t i = 0; i < 3 * m->triangles.n; i++)
        up[i] = i;
    for (size_t i = 0; i < m->edges.n; i++) {
        const edge *e = &m->edges.v[i];
        if (!is_smooth(m, e))
            continue;
        uint32_t t = m->halves.v[e->first].side / 3, u = m->halves.v[e->first + 1].side / 3;
        unite(up, corner_at(m, t, e->a), corner_at(m, u, e->a));
        unite(up, corner_at(m, t, e->b), corner_at(m, u, e->b));
    }
}

/* The normal of a place is the mean of those around it, weighted by their angles there and their areas: large flat faces beside small
 * ones of a rounding stay flat. */
static bool find_normals(mesh *m)
{
    size_t n = 3 * m->triangles.n;
    uint32_t *up = plb_new(n + 1, sizeof *up);
    bool ok = up && array_reserve(&m->group, n);
    if (ok) {
        unite_corners(m, up);
        m->group.n = n;
    }
    for (uint32_t i = 0; ok && i < n; i++)
        if (root(up, i) == i) {
            m->group.v[i] = (uint32_t)m->smooth.n;
            ok = array_push(&m->smooth, ((vector){0, 0, 0}));
        }
    for (uint32_t i = 0; ok && i < n; i++) {
        uint32_t t = i / 3, k = i % 3;
        m->group.v[i] = m->group.v[root(up, i)];
        vector a = mesh_corner(m, t, (int)k), ab = vector_sub(mesh_corner(m, t, (int)(k + 1) % 3), a), ac = vector_sub(mesh_corner(m, t, (int)(k + 2) % 3), a);
        double weight = vector_angle(ab, ac) * vector_length(vector_cross(ab, ac));
        vector *sum = &m->smooth.v[m->group.v[i]];
        *sum = vector_add(*sum, vector_scale(m->normals.v[t], m->is_turned.v[t] ? -weight : weight));
    }
    for (size_t i = 0; ok && i < m->smooth.n; i++)
        m->smooth.v[i] = vector_unit(m->smooth.v[i]);
    plb_free(up);
    return ok;
}

bool plb_mesh_smooth(mesh *m, error *err)
{
    return (find_patches(m) && find_normals(m)) || plb_fail_memory(err);
}
