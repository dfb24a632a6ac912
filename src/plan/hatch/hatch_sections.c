/* SPDX-License-Identifier: MIT
 *
 * Sections of a shape: the scan-line method (Wylie, Romney, Evans & Erdahl 1967) with lines that may tilt a little.
 * Edges are sorted once; each line looks only at the edges it can meet, so the time is linear in the crossings.
 */
#include "plan/hatch/hatch_sections.h"

#include <math.h>
#include <stdlib.h>

frame plb_frame(double radians)
{
    return (frame){cos(radians), sin(radians)};
}

box plb_frame_box(frame f, box b)
{
    box out = BOX_EMPTY;
    plb_box_add(&out, frame_to(f, (point){b.x0, b.y0}));
    plb_box_add(&out, frame_to(f, (point){b.x1, b.y0}));
    plb_box_add(&out, frame_to(f, (point){b.x1, b.y1}));
    plb_box_add(&out, frame_to(f, (point){b.x0, b.y1}));
    return out;
}

static double least_v(const shape_edge *e)
{
    return fmin(e->from.y, e->to.y);
}

static int compare_edges(const void *a, const void *b)
{
    double x = least_v(a), y = least_v(b);
    return (x > y) - (x < y);
}

static int compare_crossings(const void *a, const void *b)
{
    double x = ((const struct crossing *)a)->u, y = ((const struct crossing *)b)->u;
    return (x > y) - (x < y);
}

bool plb_sections_init(sections *k, const shape_edges *edges, bool even_odd, frame f, double tilt, error *err)
{
    *k = (sections){.bounds = BOX_EMPTY, .tilt = tilt, .even_odd = even_odd};
    if (!array_reserve(&k->edges, edges->n))
        return plb_fail_memory(err);
    for (size_t i = 0; i < edges->n; i++) {
        shape_edge e = {frame_to(f, edges->v[i].from), frame_to(f, edges->v[i].to)};
        plb_box_add(&k->bounds, e.from);
        k->edges.v[k->edges.n++] = e;
    }
    if (k->edges.n)
        qsort(k->edges.v, k->edges.n, sizeof *k->edges.v, compare_edges);
    k->pivot = (k->bounds.x0 + k->bounds.x1) / 2;
    return true;
}

void plb_sections_restart(sections *k, double pivot)
{
    k->pivot = pivot;
    k->next = 0;
    k->active.n = 0;
}

void plb_sections_free(sections *k)
{
    array_free(&k->edges);
    array_free(&k->active);
    array_free(&k->crossings);
    array_free(&k->spans);
}

double plb_sections_v(const sections *k, double v, double tilt, double u)
{
    return v + tilt * (u - k->pivot);
}

/* Keeps the edges that this line or a later one may meet. */
static bool update_active(sections *k, double v)
{
    double reach = k->tilt * fmax(k->bounds.x1 - k->pivot, k->pivot - k->bounds.x0);
    size_t kept = 0;
    for (size_t i = 0; i < k->active.n; i++) {
        const shape_edge *e = &k->edges.v[k->active.v[i]];
        if (fmax(e->from.y, e->to.y) >= v - reach)
            k->active.v[kept++] = k->active.v[i];
    }
    k->active.n = kept;
    for (; k->next < k->edges.n && least_v(&k->edges.v[k->next]) <= v + reach; k->next++) {
        const shape_edge *e = &k->edges.v[k->next];
        if (fmax(e->from.y, e->to.y) >= v - reach && !array_push(&k->active, (uint32_t)k->next))
            return false;
    }
    return true;
}

/* Tells how far a place lies beyond the line: its sign tells the side, the same for every edge that ends there. */
static double beyond(const sections *k, double v, double tilt, point p)
{
    return p.y - plb_sections_v(k, v, tilt, p.x);
}

static bool find_crossings(sections *k, double v, double tilt)
{
    k->crossings.n = 0;
    for (size_t i = 0; i < k->active.n; i++) {
        const shape_edge *e = &k->edges.v[k->active.v[i]];
        double a = beyond(k, v, tilt, e->from), b = beyond(k, v, tilt, e->to);
        if ((a > 0) == (b > 0))
            continue;
        struct crossing c = {e->from.x + (e->to.x - e->from.x) * (a / (a - b)), a > 0 ? -1 : 1};
        if (!array_push(&k->crossings, c))
            return false;
    }
    if (k->crossings.n > 1)
        qsort(k->crossings.v, k->crossings.n, sizeof *k->crossings.v, compare_crossings);
    return true;
}

bool plb_sections_at(sections *k, double v, double tilt, error *err)
{
    k->spans.n = 0;
    if (!update_active(k, v) || !find_crossings(k, v, tilt))
        return plb_fail_memory(err);
    int winding = 0;
    for (size_t i = 0; i + 1 < k->crossings.n; i++) {
        winding += k->crossings.v[i].turn;
        span s = {k->crossings.v[i].u, k->crossings.v[i + 1].u};
        if (!(k->even_odd ? i % 2 == 0 : winding != 0) || s.to <= s.from)
            continue;
        if (k->spans.n && s.from <= k->spans.v[k->spans.n - 1].to)
            k->spans.v[k->spans.n - 1].to = s.to;
        else if (!array_push(&k->spans, s))
            return plb_fail_memory(err);
    }
    return true;
}
