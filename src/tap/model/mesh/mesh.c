/* SPDX-License-Identifier: MIT
 *
 * See mesh.h: faces become triangles; places that lie together become one.
 */
#include "tap/model/mesh/mesh.h"

#include "base/number/random.h"

#include <string.h>

/* Places nearer than this part of the model's size are one: numbers of seven digits, as files have them, are as good as that. */
#define SAME_PLACE 1e-6

void plb_mesh_free(mesh *m)
{
    array_free(&m->places);
    array_free(&m->triangles);
    array_free(&m->normals);
    array_free(&m->halves);
    array_free(&m->edges);
    array_free(&m->side_edge);
    array_free(&m->patch);
    array_free(&m->is_turned);
    array_free(&m->group);
    array_free(&m->smooth);
    array_free(&m->wires);
    array_free(&m->paints);
}

/* ---- from faces to triangles ---- */

/* Turns the model so that z points upwards. */
static vector upright(vector p, up_axis up)
{
    return up == UP_Z ? p : up == UP_Y ? (vector){p.x, -p.z, p.y} : (vector){p.y, p.z, p.x};
}

static bool is_somewhere(const raw_model *from, const uint32_t *corners, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!vector_is_place(from->places.v[corners[i]]))
            return false;
    return true;
}

static bool add_triangles(const raw_model *from, mesh *m, error *err)
{
    number_list cut = {0};
    ARRAY(vector) corners = {0};
    bool ok = true;
    const uint32_t *c = from->corners.v;
    for (size_t i = 0; ok && i < from->faces.n; c += from->faces.v[i++].n) {
        raw_face f = from->faces.v[i];
        if (!is_somewhere(from, c, f.n)) {
            m->lost++;
            continue;
        }
        corners.n = 0;
        ok = array_reserve(&corners, f.n) || plb_fail_memory(err);
        for (size_t k = 0; ok && k < f.n; k++)
            corners.v[corners.n++] = from->places.v[c[k]];
        ok = ok && plb_polygon_triangles(corners.v, f.n, &cut, err);
        for (size_t k = 0; ok && k + 2 < cut.n; k += 3) {
            triangle t = {{c[cut.v[k]], c[cut.v[k + 1]], c[cut.v[k + 2]]}, (uint32_t)i, f.paint};
            ok = array_push(&m->triangles, t) || plb_fail_memory(err);
        }
    }
    array_free(&cut);
    array_free(&corners);
    return ok;
}

static bool add_wires(const raw_model *from, mesh *m)
{
    for (size_t i = 0; i + 1 < from->wires.n; i += 2)
        if (is_somewhere(from, from->wires.v + i, 2) && (!array_push(&m->wires, from->wires.v[i]) || !array_push(&m->wires, from->wires.v[i + 1])))
            return false;
    return true;
}

bool plb_mesh_make(raw_model *from, up_axis up, mesh *m, error *err)
{
    if (!array_reserve(&m->places, from->places.n) || !array_reserve(&m->triangles, from->faces.n) || !array_reserve(&m->paints, from->paints.n))
        return plb_fail_memory(err);
    for (size_t i = 0; i < from->places.n; i++)
        m->places.v[m->places.n++] = upright(from->places.v[i], up);
    for (size_t i = 0; i < from->paints.n; i++)
        m->paints.v[m->paints.n++] = from->paints.v[i];
    return add_triangles(from, m, err) && (add_wires(from, m) || plb_fail_memory(err));
}

/* ---- welding ---- */

typedef struct {
    vector corner; /* of the grid, and the length of its cells */
    double cell;
    size_t room;   /* lists, a power of two */
    uint32_t *head, *next; /* lists of places by cell; the number of a place, or NO_TRIANGLE */
} weld_grid;

static size_t list_of(const weld_grid *g, int64_t x, int64_t y, int64_t z)
{
    return random_fold(random_mix((uint64_t)z), x, y) & (g->room - 1);
}

static uint32_t find_near(const weld_grid *g, const vector *v, vector p, double same, const int64_t cell[3])
{
    for (uint32_t i = g->head[list_of(g, cell[0], cell[1], cell[2])]; i != NO_TRIANGLE; i = g->next[i])
        if (fabs(v[i].x - p.x) <= same && fabs(v[i].y - p.y) <= same && fabs(v[i].z - p.z) <= same)
            return i;
    return NO_TRIANGLE;
}

/* Finds an earlier place that is the same as p: in p's own cell, or in those beside it that are near enough. */
static uint32_t find_same(const weld_grid *g, const vector *v, vector p, double same, int64_t home[3])
{
    double at[3] = {(p.x - g->corner.x) / g->cell, (p.y - g->corner.y) / g->cell, (p.z - g->corner.z) / g->cell};
    double reach = same / g->cell;
    int64_t low[3], high[3];
    for (int k = 0; k < 3; k++) {
        home[k] = (int64_t)floor(at[k]);
        low[k] = (int64_t)floor(at[k] - reach);
        high[k] = (int64_t)floor(at[k] + reach);
    }
    for (int64_t x = low[0]; x <= high[0]; x++)
        for (int64_t y = low[1]; y <= high[1]; y++)
            for (int64_t z = low[2]; z <= high[2]; z++) {
                uint32_t found = find_near(g, v, p, same, (int64_t[3]){x, y, z});
                if (found != NO_TRIANGLE)
                    return found;
            }
    return NO_TRIANGLE;
}

/* Gives, in new_number, the number that each place has among those that are kept; keeps only places that something uses. */
static bool weld_places(mesh *m, const unsigned char *is_used, uint32_t *new_number)
{
    size_t n = m->places.n, kept = 0;
    double same = SAME_PLACE * m->size;
    weld_grid g = {.cell = greater(4 * same, 1e-300), .room = 64};
    while (g.room < n)
        g.room *= 2;
    g.head = plb_new(g.room, sizeof *g.head);
    g.next = plb_new(n + 1, sizeof *g.next);
    bool ok = g.head && g.next;
    if (ok)
        memset(g.head, 0xff, g.room * sizeof *g.head);
    for (size_t i = 0; ok && i < n; i++) {
        int64_t home[3];
        if (!is_used[i])
            continue;
        vector p = m->places.v[i];
        uint32_t same_as = find_same(&g, m->places.v, p, same, home);
        new_number[i] = same_as;
        if (same_as != NO_TRIANGLE)
            continue;
        size_t list = list_of(&g, home[0], home[1], home[2]);
        new_number[i] = (uint32_t)kept;
        m->places.v[kept] = p;
        g.next[kept] = g.head[list];
        g.head[list] = (uint32_t)kept++;
    }
    if (ok)
        m->places.n = kept;
    plb_free(g.head);
    plb_free(g.next);
    return ok;
}

/* Moves the box of all used places to the middle of the coordinates and measures it. */
static void centre(mesh *m, const unsigned char *is_used)
{
    vector low = {1e300, 1e300, 1e300}, high = {-1e300, -1e300, -1e300};
    for (size_t i = 0; i < m->places.n; i++) {
        vector p = m->places.v[i];
        if (!is_used[i])
            continue;
        low = (vector){lesser(low.x, p.x), lesser(low.y, p.y), lesser(low.z, p.z)};
        high = (vector){greater(high.x, p.x), greater(high.y, p.y), greater(high.z, p.z)};
    }
    vector middle = vector_scale(vector_add(low, high), .5);
    for (size_t i = 0; i < m->places.n; i++)
        m->places.v[i] = is_used[i] ? vector_sub(m->places.v[i], middle) : (vector){0, 0, 0};
    m->size = low.x <= high.x ? vector_distance(low, high) : 0;
}

static void sort_three(uint32_t v[3])
{
    for (int i = 0; i < 3; i++)
        for (int k = i + 1; k < 3; k++)
            if (v[k] < v[i]) {
                uint32_t x = v[i];
                v[i] = v[k];
                v[k] = x;
            }
}

/* Keeps triangles that have an area, and the first of those with the same corners; their normals. A triangle whose breadth is that
 * of a place has none. */
static bool keep_triangles(mesh *m)
{
    size_t kept = 0, room = 64;
    while (room < 2 * m->triangles.n)
        room *= 2;
    uint32_t *table = plb_new(room, sizeof *table); /* 1 + the number of a triangle */
    bool ok = table && array_reserve(&m->normals, m->triangles.n);
    double thin = SAME_PLACE * m->size;
    for (size_t i = 0; ok && i < m->triangles.n; i++) {
        triangle t = m->triangles.v[i];
        vector a = m->places.v[t.corner[0]], ab = vector_sub(m->places.v[t.corner[1]], a), ac = vector_sub(m->places.v[t.corner[2]], a);
        vector n = vector_cross(ab, ac);
        double area = vector_length(n), longest = greater(vector_length(ab), greater(vector_length(ac), vector_distance(ab, ac)));
        if (!(area > thin * longest))
            continue;
        uint32_t key[3] = {t.corner[0], t.corner[1], t.corner[2]};
        sort_three(key);
        size_t at = random_fold(key[0], key[1], key[2]) & (room - 1);
        bool is_there = false;
        for (; table[at] && !is_there; at = (at + 1) & (room - 1)) {
            uint32_t other[3];
            memcpy(other, m->triangles.v[table[at] - 1].corner, sizeof other);
            sort_three(other);
            is_there = !memcmp(other, key, sizeof key);
        }
        if (is_there)
            continue;
        m->triangles.v[kept] = t;
        m->normals.v[kept++] = vector_scale(n, 1 / area);
        table[at] = (uint32_t)kept;
    }
    plb_free(table);
    if (ok)
        m->triangles.n = m->normals.n = kept;
    return ok;
}

bool plb_mesh_weld(mesh *m, error *err)
{
    unsigned char *is_used = plb_new(m->places.n + 1, 1);
    uint32_t *new_number = plb_new(m->places.n + 1, sizeof *new_number);
    bool ok = is_used && new_number;
    for (size_t i = 0; ok && i < m->triangles.n; i++)
        for (int k = 0; k < 3; k++)
            is_used[m->triangles.v[i].corner[k]] = 1;
    for (size_t i = 0; ok && i < m->wires.n; i++)
        is_used[m->wires.v[i]] = 1;
    if (ok) {
        centre(m, is_used);
        ok = weld_places(m, is_used, new_number);
    }
    for (size_t i = 0; ok && i < m->triangles.n; i++)
        for (int k = 0; k < 3; k++)
            m->triangles.v[i].corner[k] = new_number[m->triangles.v[i].corner[k]];
    for (size_t i = 0; ok && i < m->wires.n; i++)
        m->wires.v[i] = new_number[m->wires.v[i]];
    ok = ok && keep_triangles(m);
    plb_free(is_used);
    plb_free(new_number);
    return ok || plb_fail_memory(err);
}
