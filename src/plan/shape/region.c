/* SPDX-License-Identifier: MIT
 *
 * Regions: see region.h. An edge is listed in every band that its height touches. A question about a point looks at one band of few
 * edges. A segment would pass many such bands: for it there are broader ones, about as many as the root of the number of edges, whose
 * edges are sorted from left to right, so that only those beside the segment are looked at.
 */
#include "plan/shape/region.h"

#include "plan/shape/flatten.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A region of fewer edges than this has no broad bands: all its edges are looked at (by measurement). */
#define BROAD_MIN_EDGES 12
/* An edge that the segment runs along, no farther from it than this (mm), meets it from one of its ends to the other. */
#define ALONG_MM 0.05
/* A segment looks so far beside itself: ALONG_MM, and more by far than rounding does. */
#define BESIDE_MM (ALONG_MM + 1e-4)

typedef struct {
    point a, b;
} region_edge;

/* An edge in a broad band. */
typedef struct {
    double left, right;
    double reach;  /* the largest `right` up to here in its band */
    uint32_t edge;
} broad_edge;

struct region {
    bool even_odd, is_box;
    box bounds;
    ARRAY(region_edge) edges;
    size_t bands;
    double band_height;
    size_t *first;   /* bands + 1: where each band's edges start in `listed` */
    uint32_t *listed;
    size_t broad_bands; /* 0: the region has none */
    double broad_height;
    size_t *broad_first; /* the same for broad bands */
    broad_edge *broad;
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

/* Gives at most so many bands, but so few that tall edges are listed about eight times only. */
static size_t count_bands(const region *r, double most)
{
    double heights = 0, whole = r->bounds.y1 - r->bounds.y0, n = (double)r->edges.n;
    for (size_t i = 0; i < r->edges.n; i++)
        heights += fabs(r->edges.v[i].a.y - r->edges.v[i].b.y);
    double bands = most;
    if (heights > 0 && bands > 8 * n * whole / heights)
        bands = 8 * n * whole / heights;
    return bands > 4096 ? 4096 : (size_t)bands + 1;
}

static bool sort_into_bands(region *r)
{
    r->bands = count_bands(r, (double)r->edges.n / 4);
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

/* ---- broad bands ---- */

/* Gives the broad band that holds the height, one beyond the first or last where there is none. */
static int64_t broad_band_of(const region *r, double y)
{
    double k = floor((y - r->bounds.y0) / r->broad_height);
    return k < 0 ? -1 : k >= (double)r->broad_bands ? (int64_t)r->broad_bands : (int64_t)k;
}

/* Computes the broad bands of all that lies beside what is between two heights, from *low to *high. */
static void broad_range(const region *r, double top, double bottom, size_t *low, size_t *high)
{
    int64_t first = broad_band_of(r, top - BESIDE_MM), last = broad_band_of(r, bottom + BESIDE_MM), n = (int64_t)r->broad_bands;
    *low = (size_t)(first < 0 ? 0 : first >= n ? n - 1 : first);
    *high = (size_t)(last < 0 ? 0 : last >= n ? n - 1 : last);
}

static int compare_left(const void *a, const void *b)
{
    const broad_edge *p = a, *q = b;
    return p->left != q->left ? (p->left > q->left) - (p->left < q->left) : (p->edge > q->edge) - (p->edge < q->edge);
}

static void sort_broad_band(broad_edge *v, size_t n)
{
    double reach = -INFINITY;
    qsort(v, n, sizeof *v, compare_left);
    for (size_t i = 0; i < n; i++)
        v[i].reach = reach = higher(reach, v[i].right);
}

static bool sort_into_broad_bands(region *r)
{
    if (r->edges.n < BROAD_MIN_EDGES || !(r->bounds.y1 > r->bounds.y0))
        return true;
    size_t low, high, bands = count_bands(r, sqrt((double)r->edges.n)), *first = plb_new(bands + 2, sizeof *first);
    if (!first)
        return false;
    r->broad_first = first;
    r->broad_bands = bands;
    r->broad_height = (r->bounds.y1 - r->bounds.y0) / (double)bands;
    /* Counts of each band lie two on, so that filling moves each start to its place. */
    for (size_t i = 0; i < r->edges.n; i++) {
        region_edge e = r->edges.v[i];
        broad_range(r, lower(e.a.y, e.b.y), higher(e.a.y, e.b.y), &low, &high);
        for (size_t k = low; k <= high; k++)
            first[k + 2]++;
    }
    for (size_t k = 2; k < bands + 2; k++)
        first[k] += first[k - 1];
    r->broad = plb_new(first[bands + 1], sizeof *r->broad);
    if (!r->broad)
        return false;
    for (size_t i = 0; i < r->edges.n; i++) {
        region_edge e = r->edges.v[i];
        broad_range(r, lower(e.a.y, e.b.y), higher(e.a.y, e.b.y), &low, &high);
        for (size_t k = low; k <= high; k++)
            r->broad[first[k + 1]++] = (broad_edge){lower(e.a.x, e.b.x), higher(e.a.x, e.b.x), 0, (uint32_t)i};
    }
    for (size_t k = 0; k < bands; k++)
        sort_broad_band(r->broad + first[k], first[k + 1] - first[k]);
    return true;
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
    if (!find_edges(r, p, err) || !sort_into_bands(r) || !sort_into_broad_bands(r)) {
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
    plb_free(r->broad_first);
    plb_free(r->broad);
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

double plb_region_work(const region *r, point p)
{
    size_t k = band_of(r, p.y);
    return r->edges.n ? 4 + (double)(r->first[k + 1] - r->first[k]) : 1;
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

/* A segment's way through a region, and what it has met. */
typedef struct {
    const region *r;
    point from, to, d;
    size_t first, last; /* the bands between its ends */
    crossings *at;
    double work;
} passage;

/* Adds the places where the segment meets an edge; some maybe more than once. An edge that it runs along counts only if both lie in one band. */
static bool cross_edge(passage *s, region_edge e)
{
    double t;
    size_t low, high;
    if (meets(e, s->from, s->d, &t))
        return array_push(s->at, t) && (!runs_along(e, s->from, s->d) || (add_beside(e.a, s->from, s->d, s->at) && add_beside(e.b, s->from, s->d, s->at)));
    if (!runs_along(e, s->from, s->d))
        return true;
    band_range(s->r, e, &low, &high);
    return low > s->last || high < s->first || (add_beside(e.a, s->from, s->d, s->at) && add_beside(e.b, s->from, s->d, s->at));
}

/* Computes what columns the segment and its sides come to within a broad band. */
static void find_columns(const passage *s, size_t band, double *left, double *right)
{
    double top = s->r->bounds.y0 + (double)band * s->r->broad_height - BESIDE_MM, bottom = top + s->r->broad_height + 2 * BESIDE_MM, x0 = s->from.x, x1 = s->to.x;
    if (fabs(s->d.y) > 1e-9) {
        double t = (top - s->from.y) / s->d.y, u = (bottom - s->from.y) / s->d.y;
        x0 = s->from.x + lower(higher(t, 0), 1) * s->d.x;
        x1 = s->from.x + lower(higher(u, 0), 1) * s->d.x;
    }
    *left = lower(x0, x1) - BESIDE_MM;
    *right = higher(x0, x1) + BESIDE_MM;
}

static bool cross_broad_band(passage *s, size_t band)
{
    const broad_edge *v = s->r->broad;
    size_t low = s->r->broad_first[band], end = s->r->broad_first[band + 1], high = end;
    double left, right;
    find_columns(s, band, &left, &right);
    while (low < high) { /* to the first edge up to which one reaches the segment */
        size_t middle = (low + high) / 2;
        if (v[middle].reach < left)
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < end && v[low].left <= right; low++) {
        s->work++;
        if (v[low].right >= left && !cross_edge(s, s->r->edges.v[v[low].edge]))
            return false;
    }
    s->work++;
    return true;
}

bool plb_region_cross(const region *r, point from, point to, crossings *at, double *work)
{
    double top = lower(from.y, to.y), bottom = higher(from.y, to.y);
    *work += 1;
    if (bottom < r->bounds.y0 || top > r->bounds.y1 || r->edges.n == 0)
        return true;
    passage s = {r, from, to, point_sub(to, from), band_of(r, top), band_of(r, bottom), at, 3};
    bool ok = true;
    size_t low = 0, high = 0;
    if (!r->broad_bands) {
        for (size_t i = 0; ok && i < r->edges.n; i++)
            ok = cross_edge(&s, r->edges.v[i]);
        s.work += (double)r->edges.n;
    } else {
        broad_range(r, top, bottom, &low, &high);
        for (size_t k = low; ok && k <= high; k++)
            ok = cross_broad_band(&s, k);
    }
    *work += s.work;
    return ok;
}
