/* SPDX-License-Identifier: MIT
 *
 * Regions: see region.h. An edge is listed in every band that its height touches, so a question looks at one band
 * (a point) or at those that a segment passes.
 */
#include "plan/shape/region.h"

#include "plan/shape/flatten.h"

#include <math.h>
#include <string.h>

typedef struct {
    point a, b;
} region_edge;

struct region {
    bool even_odd, is_box;
    box bounds;
    ARRAY(region_edge) edges;
    size_t bands;
    double band_height;
    size_t *first;   /* bands + 1: where each band's edges start in `listed` */
    uint32_t *listed;
};

/* Fills and clips close their subpaths. */
static bool add_edges(region *r, const track *t)
{
    if (!array_reserve(&r->edges, t->n))
        return false;
    for (size_t i = 0; i < t->n; i++) {
        region_edge e = {t->v[i].at, t->v[(i + 1) % t->n].at};
        plb_box_add(&r->bounds, e.a);
        if (e.a.y != e.b.y || e.a.x != e.b.x)
            r->edges.v[r->edges.n++] = e;
    }
    return true;
}

static bool find_edges(region *r, const path *p, error *err)
{
    track_list lines = {0};
    bool ok = plb_plan_flatten(p, false, &lines, err);
    for (size_t i = 0; ok && i < lines.tracks.n; i++) {
        track t = plb_track_at(&lines, i);
        ok = add_edges(r, &t);
    }
    plb_tracks_free(&lines);
    return ok;
}

static size_t band_of(const region *r, double y)
{
    double k = (y - r->bounds.y0) / r->band_height;
    return k <= 0 ? 0 : k >= (double)r->bands ? r->bands - 1 : (size_t)k;
}

/* fmin and fmax are calls; these two are not. */
static inline double lower(double a, double b)
{
    return a < b ? a : b;
}

static inline double higher(double a, double b)
{
    return a > b ? a : b;
}

static void band_range(const region *r, region_edge e, size_t *low, size_t *high)
{
    *low = band_of(r, lower(e.a.y, e.b.y));
    *high = band_of(r, higher(e.a.y, e.b.y));
}

/* Gives a band about four edges if they are short, but makes so few bands that tall edges are listed about eight times only. */
static size_t count_bands(const region *r)
{
    double heights = 0, whole = r->bounds.y1 - r->bounds.y0, n = (double)r->edges.n;
    for (size_t i = 0; i < r->edges.n; i++)
        heights += fabs(r->edges.v[i].a.y - r->edges.v[i].b.y);
    double bands = n / 4;
    if (heights > 0 && bands > 8 * n * whole / heights)
        bands = 8 * n * whole / heights;
    return bands > 4096 ? 4096 : (size_t)bands + 1;
}

static bool sort_into_bands(region *r)
{
    r->bands = count_bands(r);
    r->band_height = (r->bounds.y1 - r->bounds.y0) / (double)r->bands;
    if (!(r->band_height > 0))
        r->band_height = 1;
    size_t low, high, *count = plb_new(r->bands + 1, sizeof *count);
    if (!count)
        return false;
    r->first = count;
    for (size_t i = 0; i < r->edges.n; i++) {
        band_range(r, r->edges.v[i], &low, &high);
        for (size_t k = low; k <= high; k++)
            count[k + 1]++;
    }
    for (size_t k = 0; k < r->bands; k++)
        count[k + 1] += count[k];
    r->listed = plb_new(count[r->bands], sizeof *r->listed);
    size_t *fill = plb_new(r->bands, sizeof *fill);
    if (r->listed && fill) {
        memcpy(fill, count, r->bands * sizeof *fill);
        for (size_t i = 0; i < r->edges.n; i++) {
            band_range(r, r->edges.v[i], &low, &high);
            for (size_t k = low; k <= high; k++)
                r->listed[fill[k]++] = (uint32_t)i;
        }
    }
    bool ok = r->listed && fill;
    plb_free(fill);
    return ok;
}

/* Four upright edges are a box. A turned page leaves errors of 1e-5 mm: the slack. */
static bool looks_like_box(const region *r)
{
    double slack = 1e-3;
    if (r->edges.n != 4)
        return false;
    for (size_t i = 0; i < 4; i++) {
        region_edge e = r->edges.v[i];
        bool upright = fabs(e.a.x - e.b.x) < slack, level = fabs(e.a.y - e.b.y) < slack;
        if (upright == level)
            return false;
    }
    return true;
}

region *plb_region_new(const path *p, bool even_odd, error *err)
{
    region *r = plb_new(1, sizeof *r);
    if (!r) {
        plb_fail_memory(err);
        return NULL;
    }
    r->even_odd = even_odd;
    r->bounds = BOX_EMPTY;
    if (!find_edges(r, p, err) || !sort_into_bands(r)) {
        plb_fail_memory(err);
        plb_region_free(r);
        return NULL;
    }
    r->is_box = looks_like_box(r);
    return r;
}

void plb_region_free(region *r)
{
    if (!r)
        return;
    array_free(&r->edges);
    plb_free(r->first);
    plb_free(r->listed);
    plb_free(r);
}

box plb_region_bounds(const region *r)
{
    return r->bounds;
}

bool plb_region_is_box(const region *r)
{
    return r->is_box;
}

/* Tells whether p lies beyond the edge's box by more than the margin. */
static bool is_clear_of(region_edge e, point p, double margin)
{
    double more = margin + 1e-6; /* far above what rounding does */
    return ((e.a.x > p.x + more) & (e.b.x > p.x + more)) | ((e.a.x < p.x - more) & (e.b.x < p.x - more)) |
           ((e.a.y > p.y + more) & (e.b.y > p.y + more)) | ((e.a.y < p.y - more) & (e.b.y < p.y - more));
}

static double distance_to_edge(region_edge e, point p)
{
    point d = point_sub(e.b, e.a);
    double t = point_dot(point_sub(p, e.a), d) / point_dot(d, d);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return plb_point_distance(point_mix(e.a, e.b, t), p);
}

/* Tells whether the edge crosses the level of p to its right. Most lie so far aside that no division tells more; the slack is far
 * above what rounding does. */
static bool is_right_of(region_edge e, point p)
{
    const double slack = 1e-6;
    if (e.a.x > p.x + slack && e.b.x > p.x + slack)
        return true;
    if (e.a.x < p.x - slack && e.b.x < p.x - slack)
        return false;
    return e.a.x + (p.y - e.a.y) / (e.b.y - e.a.y) * (e.b.x - e.a.x) > p.x;
}

static bool is_inside(const region *r, point p)
{
    if (p.y < r->bounds.y0 || p.y > r->bounds.y1 || p.x < r->bounds.x0 || p.x > r->bounds.x1)
        return false;
    int winding = 0, crossed = 0;
    size_t k = band_of(r, p.y);
    for (size_t i = r->first[k]; i < r->first[k + 1]; i++) {
        region_edge e = r->edges.v[r->listed[i]];
        if ((e.a.y <= p.y) == (e.b.y <= p.y))
            continue;
        if (is_right_of(e, p)) {
            crossed++;
            winding += e.a.y < e.b.y ? 1 : -1;
        }
    }
    return r->even_odd ? crossed & 1 : winding != 0;
}

static bool is_near_edge(const region *r, point p, double margin)
{
    if (r->edges.n == 0)
        return false;
    for (size_t k = band_of(r, p.y - margin), last = band_of(r, p.y + margin); k <= last; k++)
        for (size_t i = r->first[k]; i < r->first[k + 1]; i++) {
            region_edge e = r->edges.v[r->listed[i]];
            if (!is_clear_of(e, p, margin) && distance_to_edge(e, p) <= margin)
                return true;
        }
    return false;
}

bool plb_region_contains(const region *r, point p, double margin)
{
    return is_inside(r, p) || is_near_edge(r, p, margin);
}

/* Tells whether all that lies `margin` from p is inside. Edges between parts that overlap bound nothing: they do not count. */
static bool is_surrounded(const region *r, point p, double margin)
{
    static const point ways[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {.7071, .7071}, {-.7071, .7071}, {-.7071, -.7071}, {.7071, -.7071}};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++)
        if (!is_inside(r, point_add(p, point_scale(ways[i], margin))))
            return false;
    return true;
}

bool plb_region_covers(const region *r, point p, double margin)
{
    return is_inside(r, p) && (!is_near_edge(r, p, margin) || is_surrounded(r, p, margin));
}

double plb_region_work(const region *r, point from, point to)
{
    size_t low = band_of(r, lower(from.y, to.y)), high = band_of(r, higher(from.y, to.y));
    return r->edges.n ? 4 + (double)(r->first[high + 1] - r->first[low]) : 1;
}

/* Finds where edge and segment meet, if they do: signs and sizes tell it before anything is divided. */
static bool meets(region_edge e, point from, point d, double *at)
{
    point s = point_sub(e.b, e.a), w = point_sub(e.a, from);
    double det = point_cross(d, s), t = point_cross(w, s), u = point_cross(w, d), size = fabs(det);
    double t_size = det < 0 ? -t : t, u_size = det < 0 ? -u : u;
    if (!((t_size > 0) & (t_size < size) & (u_size >= 0) & (u_size <= size)))
        return false;
    *at = t / det;
    return true;
}

/* An edge that the segment runs along, no farther from it than this (mm), meets it from one of its ends to the other. */
#define ALONG_MM 0.05

static bool runs_along(region_edge e, point from, point d)
{
    double reach = ALONG_MM * plb_point_length(d);
    return fabs(point_cross(point_sub(e.a, from), d)) <= reach && fabs(point_cross(point_sub(e.b, from), d)) <= reach;
}

/* Adds the parameter of the place nearest to `p`, where that lies within the segment. */
static bool add_beside(point p, point from, point d, crossings *at)
{
    double t = point_dot(point_sub(p, from), d) / point_dot(d, d);
    return !(t > 0 && t < 1) || array_push(at, t);
}

/* An edge is listed in several bands: it counts in the first that the segment passes, too. */
static bool is_first_band(const region *r, region_edge e, size_t segment_low, size_t k)
{
    size_t low, high;
    band_range(r, e, &low, &high);
    return k == (low > segment_low ? low : segment_low);
}

bool plb_region_cross(const region *r, point from, point to, crossings *at)
{
    point d = point_sub(to, from);
    double low = lower(from.y, to.y), high = higher(from.y, to.y), t;
    if (high < r->bounds.y0 || low > r->bounds.y1 || r->edges.n == 0)
        return true;
    size_t first = band_of(r, low), last = band_of(r, high);
    for (size_t k = first; k <= last; k++)
        for (size_t i = r->first[k]; i < r->first[k + 1]; i++) {
            region_edge e = r->edges.v[r->listed[i]];
            if (meets(e, from, d, &t) && is_first_band(r, e, first, k) && !array_push(at, t))
                return false;
            if (runs_along(e, from, d) && is_first_band(r, e, first, k) && !(add_beside(e.a, from, d, at) && add_beside(e.b, from, d, at)))
                return false;
        }
    return true;
}
