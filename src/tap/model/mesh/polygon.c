/* SPDX-License-Identifier: MIT
 *
 * A polygon becomes triangles by clipping ears [Mei75]: a corner whose triangle holds no other corner is cut off, until three are left.
 * A fan would put false faces over dents and over holes.
 */
#include "tap/model/mesh/mesh.h"

#include "base/geometry/geom.h"

typedef struct {
    const point *at; /* the corners in the polygon's plane, counter-clockwise */
    uint32_t *next, *before;
    unsigned char *is_dent;
    double flat; /* twice the area below which a triangle has none */
} outline;

/* Gives twice the area vector of the polygon [Newell's method]. */
static vector area_vector(const vector *v, size_t n)
{
    vector sum = {0, 0, 0};
    for (size_t i = 1; i + 1 < n; i++)
        sum = vector_add(sum, vector_cross(vector_sub(v[i], v[0]), vector_sub(v[i + 1], v[0])));
    return sum;
}

/* Drops the axis that the normal follows most; the sense of rotation stays. */
static void flatten(const vector *v, size_t n, vector normal, point *out)
{
    double x = fabs(normal.x), y = fabs(normal.y), z = fabs(normal.z);
    vector o = v[0];
    for (size_t i = 0; i < n; i++) {
        vector p = vector_sub(v[i], o);
        point q = z >= x && z >= y ? (point){p.x, p.y} : y >= x ? (point){p.z, p.x} : (point){p.y, p.z};
        bool is_mirrored = z >= x && z >= y ? normal.z < 0 : y >= x ? normal.y < 0 : normal.x < 0;
        out[i] = is_mirrored ? (point){q.y, q.x} : q;
    }
}

static double turn(point a, point b, point c) { return point_cross(point_sub(b, a), point_sub(c, b)); }

static bool is_at(point a, point b) { return a.x == b.x && a.y == b.y; }

/* Tells whether p lies in the triangle or on its rim; a corner of the triangle does not count. */
static bool is_inside(point a, point b, point c, point p)
{
    if (is_at(p, a) || is_at(p, b) || is_at(p, c))
        return false;
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

static void measure(outline *o, uint32_t i)
{
    o->is_dent[i] = turn(o->at[o->before[i]], o->at[i], o->at[o->next[i]]) <= o->flat;
}

static bool is_ear(const outline *o, uint32_t i)
{
    point a = o->at[o->before[i]], b = o->at[i], c = o->at[o->next[i]];
    if (o->is_dent[i])
        return false;
    double x0 = lesser(a.x, lesser(b.x, c.x)), x1 = greater(a.x, greater(b.x, c.x));
    double y0 = lesser(a.y, lesser(b.y, c.y)), y1 = greater(a.y, greater(b.y, c.y));
    for (uint32_t k = o->next[o->next[i]]; k != o->before[i]; k = o->next[k]) {
        point p = o->at[k];
        if (o->is_dent[k] && p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1 && is_inside(a, b, c, p))
            return false;
    }
    return true;
}

static bool cut(outline *o, uint32_t i, number_list *out)
{
    uint32_t a = o->before[i], c = o->next[i];
    o->next[a] = c;
    o->before[c] = a;
    measure(o, a);
    measure(o, c);
    return array_push(out, a) && array_push(out, i) && array_push(out, c);
}

/* Cuts ears as long as there are corners; a polygon that crosses itself has none at some point, and any corner then goes. */
static bool cut_all(outline *o, size_t n, number_list *out)
{
    uint32_t i = 0;
    size_t left = n, tried = 0;
    while (left > 3) {
        if (is_ear(o, i) || tried > left) {
            uint32_t after = o->next[i];
            if (!cut(o, i, out))
                return false;
            /* The one after the next: ears from all around make rounder triangles than a fan. */
            i = o->next[after];
            left--;
            tried = 0;
        } else {
            i = o->next[i];
            tried++;
        }
    }
    return array_push(out, o->before[i]) && array_push(out, i) && array_push(out, o->next[i]);
}

bool plb_polygon_triangles(const vector *corners, size_t n, number_list *out, error *err)
{
    out->n = 0;
    if (n == 3)
        return (array_push(out, 0) && array_push(out, 1) && array_push(out, 2)) || plb_fail_memory(err);
    point *at = plb_new(n, sizeof *at);
    uint32_t *links = plb_new(2 * n, sizeof *links);
    unsigned char *is_dent = plb_new(n, 1);
    bool ok = at && links && is_dent;
    if (ok) {
        vector normal = area_vector(corners, n);
        flatten(corners, n, normal, at);
        outline o = {at, links, links + n, is_dent, 1e-12 * vector_length(normal)};
        for (uint32_t i = 0; i < n; i++) {
            o.next[i] = i + 1 < n ? i + 1 : 0;
            o.before[i] = i ? i - 1 : (uint32_t)n - 1;
        }
        for (uint32_t i = 0; i < n; i++)
            measure(&o, i);
        ok = cut_all(&o, n, out);
    }
    plb_free(at);
    plb_free(links);
    plb_free(is_dent);
    return ok || plb_fail_memory(err);
}
