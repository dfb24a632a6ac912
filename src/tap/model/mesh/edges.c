/* SPDX-License-Identifier: MIT
 *
 * The edges of a mesh: sides of triangles with the same ends. CAD programs and the clipping of ears leave places within the side of a
 * neighbour; there the surface seems to end though it goes on. Such sides are cut at these places.
 */
#include "tap/model/mesh/mesh.h"

#include "base/number/random.h"

#include <stdlib.h>

/* A place lies on a side that is no farther away than this part of the model's size. */
#define ON_SIDE 2e-6
/* A grid has at most so many cells along a side of the model. */
#define GRID_MAX 512

/* ---- grouping ---- */

static int compare_halves(const void *a, const void *b)
{
    const half_edge *x = a, *y = b;
    return x->b != y->b ? (x->b > y->b) - (x->b < y->b) : (x->side > y->side) - (x->side < y->side);
}

/* Sorts the half edges by their places: into lists by the lower one, then each list. */
static bool sort_halves(mesh *m)
{
    size_t n = m->halves.n, places = m->places.n;
    uint32_t *begin = plb_new(places + 2, sizeof *begin);
    half_edge *sorted = plb_new(n + 1, sizeof *sorted);
    if (begin && sorted) {
        for (size_t i = 0; i < n; i++)
            begin[m->halves.v[i].a + 2]++;
        for (size_t i = 2; i < places + 2; i++)
            begin[i] += begin[i - 1];
        for (size_t i = 0; i < n; i++)
            sorted[begin[m->halves.v[i].a + 1]++] = m->halves.v[i];
        for (size_t i = 0; i < places; i++)
            if (begin[i + 1] - begin[i] > 1)
                qsort(sorted + begin[i], begin[i + 1] - begin[i], sizeof *sorted, compare_halves);
        for (size_t i = 0; i < n; i++)
            m->halves.v[i] = sorted[i];
    }
    bool ok = begin && sorted;
    plb_free(begin);
    plb_free(sorted);
    return ok;
}

static bool group_halves(mesh *m)
{
    m->edges.n = 0;
    if (!sort_halves(m))
        return false;
    for (size_t i = 0, next; i < m->halves.n; i = next) {
        half_edge h = m->halves.v[i];
        for (next = i + 1; next < m->halves.n && m->halves.v[next].a == h.a && m->halves.v[next].b == h.b;)
            next++;
        edge e = {h.a, h.b, (uint32_t)i, (uint32_t)(next - i), EDGE_SMOOTH, false};
        if (!array_push(&m->edges, e))
            return false;
    }
    return true;
}

static half_edge half_of(const mesh *m, uint32_t side)
{
    const uint32_t *c = m->triangles.v[side / 3].corner;
    uint32_t a = c[side % 3], b = c[(side % 3 + 1) % 3];
    return a < b ? (half_edge){a, b, side} : (half_edge){b, a, side};
}

/* ---- places within sides ---- */

typedef struct {
    vector low;
    double cell;
    size_t room;     /* lists, a power of two */
    uint32_t *begin; /* of each list in `places` */
    uint32_t *places;
} place_grid;

static size_t list_at(const place_grid *g, int64_t x, int64_t y, int64_t z)
{
    return random_fold(random_mix((uint64_t)z + 1), x, y) & (g->room - 1);
}

typedef struct {
    int64_t low[3], high[3];
} cell_range;

static cell_range cells_around(const place_grid *g, vector p, double reach)
{
    double at[3] = {p.x - g->low.x, p.y - g->low.y, p.z - g->low.z};
    cell_range r;
    for (int k = 0; k < 3; k++) {
        r.low[k] = (int64_t)floor((at[k] - reach) / g->cell);
        r.high[k] = (int64_t)floor((at[k] + reach) / g->cell);
    }
    return r;
}

/* Counts (places NULL) or enters a place in all cells that it lies in or next to. */
static void enter_place(place_grid *g, vector p, double reach, uint32_t number, uint32_t *count)
{
    cell_range r = cells_around(g, p, reach);
    for (int64_t x = r.low[0]; x <= r.high[0]; x++)
        for (int64_t y = r.low[1]; y <= r.high[1]; y++)
            for (int64_t z = r.low[2]; z <= r.high[2]; z++) {
                size_t list = list_at(g, x, y, z);
                if (g->places)
                    g->places[count[list]] = number;
                count[list]++;
            }
}

/* Makes the grid of the places that lie at the surface's border. */
static bool make_grid(const mesh *m, const unsigned char *is_border, size_t borders, place_grid *g)
{
    double along = floor(cbrt((double)borders) * 2), reach = ON_SIDE * m->size;
    *g = (place_grid){.low = {-m->size, -m->size, -m->size}, .room = 64};
    g->cell = greater(m->size / lesser(greater(along, 1), GRID_MAX), 4 * reach);
    while (g->room < 2 * borders)
        g->room *= 2;
    uint32_t *count = plb_new(g->room + 1, sizeof *count);
    g->begin = plb_new(g->room + 1, sizeof *g->begin);
    bool ok = count && g->begin;
    for (size_t i = 0; ok && i < m->places.n; i++)
        if (is_border[i])
            enter_place(g, m->places.v[i], reach, (uint32_t)i, count);
    size_t all = 0;
    for (size_t i = 0; ok && i <= g->room; i++) {
        size_t n = count[i];
        g->begin[i] = count[i] = (uint32_t)all;
        all += n;
    }
    g->places = ok ? plb_new(all + 1, sizeof *g->places) : NULL;
    ok = ok && g->places;
    for (size_t i = 0; ok && i < m->places.n; i++)
        if (is_border[i])
            enter_place(g, m->places.v[i], reach, (uint32_t)i, count);
    plb_free(count);
    return ok;
}

static void free_grid(place_grid *g)
{
    plb_free(g->begin);
    plb_free(g->places);
}

typedef struct {
    double t; /* where on the side, 0 to 1 */
    uint32_t place;
} stop;
typedef ARRAY(stop) stop_list;

static int compare_stops(const void *a, const void *b)
{
    const stop *x = a, *y = b;
    return x->t != y->t ? (x->t > y->t) - (x->t < y->t) : (x->place > y->place) - (x->place < y->place);
}

/* Adds the places of a cell that lie within the side from a to b. */
static bool add_stops(const mesh *m, const place_grid *g, size_t list, half_edge h, stop_list *out)
{
    vector a = m->places.v[h.a], d = vector_sub(m->places.v[h.b], a);
    double l2 = vector_dot(d, d), reach = ON_SIDE * m->size;
    for (uint32_t i = g->begin[list]; i < g->begin[list + 1]; i++) {
        uint32_t p = g->places[i];
        vector ap = vector_sub(m->places.v[p], a);
        double t = vector_dot(ap, d) / l2;
        if (p != h.a && p != h.b && t > 0 && t < 1 && vector_distance(ap, vector_scale(d, t)) <= reach && !array_push(out, ((stop){t, p})))
            return false;
    }
    return true;
}

/* Walks through the cells along the side, from each to the one behind the wall that the side meets first. */
static bool find_stops(const mesh *m, const place_grid *g, half_edge h, stop_list *out)
{
    vector a = m->places.v[h.a], d = vector_sub(m->places.v[h.b], a);
    double at[3] = {a.x - g->low.x, a.y - g->low.y, a.z - g->low.z}, way[3] = {d.x, d.y, d.z}, meets[3];
    int64_t cell[3];
    out->n = 0;
    for (int k = 0; k < 3; k++) {
        cell[k] = (int64_t)floor(at[k] / g->cell);
        double wall = (double)(cell[k] + (way[k] > 0)) * g->cell;
        meets[k] = way[k] != 0 ? (wall - at[k]) / way[k] : 2;
    }
    for (;;) {
        if (!add_stops(m, g, list_at(g, cell[0], cell[1], cell[2]), h, out))
            return false;
        int k = meets[0] < meets[1] ? (meets[0] < meets[2] ? 0 : 2) : (meets[1] < meets[2] ? 1 : 2);
        if (meets[k] >= 1)
            break;
        cell[k] += way[k] > 0 ? 1 : -1;
        meets[k] += g->cell / fabs(way[k]);
    }
    if (out->n)
        qsort(out->v, out->n, sizeof *out->v, compare_stops);
    return true;
}

/* Puts the pieces of a half edge in its place: the first instead of it, the rest behind all others. */
static bool cut_half(mesh *m, size_t i, const stop_list *stops)
{
    half_edge h = m->halves.v[i];
    uint32_t from = h.a;
    bool is_first = true;
    for (size_t k = 0; k <= stops->n; k++) {
        uint32_t to = k < stops->n ? stops->v[k].place : h.b;
        half_edge piece = from < to ? (half_edge){from, to, h.side} : (half_edge){to, from, h.side};
        if (from == to) /* found in two cells */
            continue;
        if (is_first)
            m->halves.v[i] = piece;
        else if (!array_push(&m->halves, piece))
            return false;
        is_first = false;
        from = to;
    }
    return true;
}

/* Cuts the sides at the border where other places of the border lie on them; `cuts` counts them. */
static bool cut_sides(mesh *m, size_t *cuts)
{
    unsigned char *is_border = plb_new(m->places.n + 1, 1);
    size_t borders = 0, n = m->edges.n;
    place_grid g = {0};
    stop_list stops = {0};
    bool ok = is_border;
    for (size_t i = 0; ok && i < n; i++)
        if (m->edges.v[i].n == 1) {
            borders += 2;
            is_border[m->edges.v[i].a] = is_border[m->edges.v[i].b] = 1;
        }
    *cuts = 0;
    ok = ok && make_grid(m, is_border, borders, &g);
    for (size_t i = 0; ok && i < n; i++) {
        const edge *e = &m->edges.v[i];
        if (e->n != 1)
            continue;
        ok = find_stops(m, &g, m->halves.v[e->first], &stops) && (!stops.n || cut_half(m, e->first, &stops));
        *cuts += stops.n > 0;
    }
    free_grid(&g);
    array_free(&stops);
    plb_free(is_border);
    return ok;
}

/* ---- all of it ---- */

static bool find_edges(mesh *m)
{
    size_t sides = 3 * m->triangles.n, cuts = 0;
    if (!array_reserve(&m->halves, sides) || !array_reserve(&m->side_edge, sides))
        return false;
    for (size_t i = 0; i < sides; i++)
        m->halves.v[m->halves.n++] = half_of(m, (uint32_t)i);
    if (!group_halves(m) || !cut_sides(m, &cuts) || (cuts && !group_halves(m)))
        return false;
    for (size_t i = 0; i < sides; i++)
        m->side_edge.v[m->side_edge.n++] = NO_TRIANGLE;
    for (size_t i = 0; i < m->edges.n; i++)
        for (size_t k = 0; k < m->edges.v[i].n; k++) {
            half_edge h = m->halves.v[m->edges.v[i].first + k], whole = half_of(m, h.side);
            if (h.a == whole.a && h.b == whole.b)
                m->side_edge.v[h.side] = (uint32_t)i;
        }
    return true;
}

bool plb_mesh_edges(mesh *m, error *err)
{
    return find_edges(m) || plb_fail_memory(err);
}
