/* SPDX-License-Identifier: MIT
 *
 * Medial axis, step 1: a shape becomes pixels, each with the distance to the shape's edge. A pixel is inside when its
 * centre is. The distance transform is exact: columns first, then the lower envelope along rows by a search that the
 * best distance so far bounds (Saito & Toriwaki 1994); letters are thin, so it is short.
 */
#include "plan/letter/medial/medial.h"

#include <math.h>
#include <string.h>

/* The shape has so many empty pixels around it: thinning looks at all eight neighbours. */
#define RIM 2

void plb_contour_set_free(contour_set *o)
{
    array_free(&o->points);
    array_free(&o->starts);
}

void plb_raster_free(raster *r)
{
    plb_free(r->radius);
    plb_free(r->on);
    r->radius = NULL;
    r->on = NULL;
    r->width = r->height = 0;
}

/* The winding number changes by `by` right of where an edge crosses the middle of a row. */
static void count_edge(const raster *r, int16_t *change, point a, point b)
{
    int by = a.y < b.y ? 1 : -1;
    point low = by > 0 ? a : b, high = by > 0 ? b : a;
    int first = (int)ceil(low.y - 0.5), last = (int)ceil(high.y - 0.5);
    if (first >= last)
        return;
    double slope = (high.x - low.x) / (high.y - low.y);
    for (int y = first; y < last; y++) {
        int x = (int)ceil(low.x + (y + 0.5 - low.y) * slope - 0.5);
        change[y * r->width + x] = (int16_t)(change[y * r->width + x] + by);
    }
}

static point to_pixels(const raster *r, point p)
{
    return (point){(p.x - r->origin.x) / r->pixel, (p.y - r->origin.y) / r->pixel};
}

static void count_contours(const raster *r, const contour_set *o, int16_t *change)
{
    for (size_t k = 0; k < o->starts.n; k++) {
        size_t first = o->starts.v[k], end = k + 1 < o->starts.n ? o->starts.v[k + 1] : o->points.n;
        for (size_t i = first; i < end; i++)
            count_edge(r, change, to_pixels(r, o->points.v[i]), to_pixels(r, o->points.v[i + 1 < end ? i + 1 : first]));
    }
}

static void mark_inside(raster *r, const contour_set *o, const int16_t *change)
{
    int mask = o->even_odd ? 1 : -1, area = 0;
    for (int y = 0; y < r->height; y++)
        for (int i = y * r->width, end = i + r->width, winding = 0; i < end; i++) {
            winding += change[i];
            r->on[i] = (winding & mask) != 0;
            area += r->on[i];
        }
    r->area = (size_t)area;
}

/* Fills `up` with the number of pixels up or down to the nearest one outside. */
static void measure_columns(const raster *r, int16_t *up)
{
    int w = r->width, h = r->height;
    for (int y = 1; y < h; y++)
        for (int x = 0; x < w; x++)
            up[y * w + x] = r->on[y * w + x] ? (int16_t)(up[(y - 1) * w + x] + 1) : 0;
    for (int y = h - 2; y >= 0; y--)
        for (int x = 0; x < w; x++)
            if (up[y * w + x] > up[(y + 1) * w + x] + 1)
                up[y * w + x] = (int16_t)(up[(y + 1) * w + x] + 1);
}

/* Gives the largest distance, squared. */
static int measure_row(const raster *r, const int16_t *up, float *radius)
{
    int most = 0;
    for (int x = 0; x < r->width; x++) {
        int best = up[x] * up[x];
        for (int d = 1; d * d < best; d++) { /* outside the row's ends `up` is 0: the search stops in time */
            int left = d * d + up[x - d] * up[x - d], right = d * d + up[x + d] * up[x + d];
            best = left < best ? left : best;
            best = right < best ? right : best;
        }
        radius[x] = best ? sqrtf((float)best) - 0.5f : 0;
        most = best > most ? best : most;
    }
    return most;
}

static double contour_length(const contour_set *o)
{
    double length = 0;
    for (size_t k = 0; k < o->starts.n; k++) {
        size_t first = o->starts.v[k], end = k + 1 < o->starts.n ? o->starts.v[k + 1] : o->points.n;
        for (size_t i = first; i < end; i++)
            length += plb_point_distance(o->points.v[i], o->points.v[i + 1 < end ? i + 1 : first]);
    }
    return length;
}

static bool is_affordable(const contour_set *o, double w, double h, double pixel)
{
    if (!(w * h <= RASTER_MAX_PIXELS) || w > 16000 || h > 16000)
        return false;
    return w * h <= RASTER_USUAL_PIXELS || RASTER_SPARSE * contour_length(o) / pixel > w * h;
}

bool plb_raster_fill(raster *r, const contour_set *o, double pixel, error *err)
{
    memset(r, 0, sizeof *r);
    box b = BOX_EMPTY;
    for (size_t i = 0; i < o->points.n; i++)
        plb_box_add(&b, o->points.v[i]);
    double w = (b.x1 - b.x0) / pixel + 2 * RIM + 2, h = (b.y1 - b.y0) / pixel + 2 * RIM + 2;
    if (plb_box_is_empty(b) || !is_affordable(o, w, h, pixel))
        return true;
    r->width = (int)w;
    r->height = (int)h;
    r->pixel = pixel;
    r->origin = (point){b.x0 - RIM * pixel, b.y0 - RIM * pixel};
    size_t n = (size_t)r->width * (size_t)r->height;
    int16_t *work = plb_new(n, sizeof *work); /* changes of the winding number, then columns */
    r->on = plb_new(n, sizeof *r->on);
    r->radius = plb_new(n, sizeof *r->radius);
    bool ok = work && r->on && r->radius;
    double most = 0;
    if (ok) {
        count_contours(r, o, work);
        mark_inside(r, o, work);
        memset(work, 0, n * sizeof *work);
        measure_columns(r, work);
        for (int y = 0; y < r->height; y++)
            most = fmax(most, measure_row(r, work + y * r->width, r->radius + y * r->width));
        r->largest = most > 0 ? sqrt(most) - 0.5 : 0;
    } else {
        plb_raster_free(r);
    }
    plb_free(work);
    return ok || plb_fail_memory(err);
}
