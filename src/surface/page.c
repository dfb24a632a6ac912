/* SPDX-License-Identifier: MIT
 *
 * The page: see page.h.
 */
#include "surface/page.h"

#include "base/array.h"
#include "base/simd16.h"

#include <math.h>
#include <string.h>

/* Deposits count natural density in this unit: 65535 of them are a density of 16, which leaves 1e-7 of the light. */
#define DEPOSIT_UNIT (1.0 / 4096)
/* Graphite over graphite gets darker than a single stroke's darkest pixels by so many grey levels at the most: the darkest
 * hundredth of solid patches of one scanned pencil is 63 to 84 where that of its lines is 96 to 116. The limit of many
 * layers lies below what a few come to (chosen by eye within that). */
#define BELOW_DARKEST 40
/* However light the darkest of its pixels were, a soft lead covers: layers of a pencil come to no less than a grey that falls evenly with the grey of
 * its line's centre, from that of HB to that of 8B, the darkest of the eight (chosen by eye). */
#define CENTRE_HB 175.0
#define LAYERS_HB 79.0
#define CENTRE_8B 101.0
#define LAYERS_8B 27.0
/* Graphite shines: it is never black (natural graphite reflects; darkest patch pixels scanned are about 60). */
#define DARKEST_POSSIBLE 24

/* One lock guards so many rows: threads seldom meet, and a patch takes one to three locks. */
#define STRIPE 64

/* So many rows of a patch are laid together. */
#define ROWS_TOGETHER 16

/* Returns the darkest grey from the profile's bounds, not from the darkest pixel ever scanned, which may be a speck of dust. */
static int darkest_of(const profile *p)
{
    int low = p->min_range < p->min_mid ? p->min_range : p->min_mid;
    double soft = (CENTRE_HB - plb_profile_centre(p)) / (CENTRE_HB - CENTRE_8B);
    int darkest = (int)fmin(low - BELOW_DARKEST, LAYERS_HB + (LAYERS_8B - LAYERS_HB) * soft);
    return darkest < DARKEST_POSSIBLE ? DARKEST_POSSIBLE : darkest;
}

static uint8_t grey_of(const graphite *g, double depth, int deposit)
{
    return (uint8_t)floor(g->darkest + depth * exp(-deposit * DEPOSIT_UNIT) + 0.5);
}

/* The greys fall in steps, and a search finds where each one ends. */
static void tabulate_greys(graphite *g, double depth)
{
    for (int d = 0; d < 65536;) {
        int last = d, beyond = 65536; /* `last` has this grey, `beyond` has not */
        uint8_t grey = grey_of(g, depth, d);
        for (int step = 1; last + step < 65536 && beyond == 65536; step *= 2) {
            if (grey_of(g, depth, last + step) == grey)
                last += step;
            else
                beyond = last + step;
        }
        while (beyond - last > 1) {
            int middle = (last + beyond) / 2;
            *(grey_of(g, depth, middle) == grey ? &last : &beyond) = middle;
        }
        memset(g->grey + d, grey, (size_t)(beyond - d));
        d = beyond;
    }
}

void plb_graphite_init(graphite *g, const profile *p)
{
    int darkest = darkest_of(p);
    double depth = 255.0 - darkest;
    g->darkest = darkest;
    for (int v = 0; v < 256; v++) {
        double left = 1 - (255.0 - v) / depth; /* the share of light that still comes back */
        double units = left > 0 ? -log(left) / DEPOSIT_UNIT : 65535;
        g->deposit[v] = (uint16_t)(units > 65535 ? 65535 : floor(units + 0.5));
    }
    tabulate_greys(g, depth);
}

/* Coloured pencils cover better than graphite of the same pressure does (chosen by eye). */
#define COVER 1.35

double plb_pigment_cover(const graphite *g, uint32_t colour, int grey)
{
    double depth = 255.0 - g->darkest;
    return fmin(1, (colour ? COVER : 1) * (255 - grey) / depth);
}

void plb_pigment_init(pigment *p, const graphite *g, uint32_t colour)
{
    double depth = 255.0 - g->darkest;
    p->colour = colour;
    p->is_soft = false;
    for (int k = 0; k < PIGMENT_PLANES; k++) {
        double taken = 255.0 - (colour >> (16 - 8 * k) & 255); /* of this component's light, by full cover */
        for (int v = 0; v < 256; v++) {
            double left = fmax(1 - plb_pigment_cover(g, colour, v) * taken / depth, 0);
            double units = left > 0 ? -log(left) / DEPOSIT_UNIT : 65535;
            p->deposit[k][v] = colour ? (uint16_t)fmin(floor(units + 0.5), 65535) : g->deposit[v];
        }
    }
}

bool plb_page_size(double width_px, double height_px, int *width, int *height, error *err)
{
    double w = floor(width_px + 0.5), h = floor(height_px + 0.5);
    w = w < 1 ? 1 : w;
    h = h < 1 ? 1 : h;
    if (!(w * h <= PAGE_MAX_PIXELS && w < 1e6 && h < 1e6))
        return plb_fail(err, ERROR_LIMIT, "a page of %.0f by %.0f pixels is too large", w, h);
    *width = (int)w;
    *height = (int)h;
    return true;
}

static void begin_band(page *p, int top)
{
    p->top = top;
    p->rows = p->height - top < p->most_rows ? p->height - top : p->most_rows;
    for (int y = 0; y < p->rows; y++)
        p->marked[y] = (row_extent){p->width, 0};
}

bool plb_page_init(page *p, int width, int height, int rows, bool colour, const graphite *ink, const graphite *soft, error *err)
{
    memset(p, 0, sizeof *p);
    rows = rows > height ? height : rows;
    *p = (page){.width = width, .height = height, .most_rows = rows, .planes = colour ? PIGMENT_PLANES : soft ? 2 : 1, .ink = ink, .soft = colour ? NULL : soft};
    p->stride = (size_t)width + PAGE_ROW_PAD;
    p->plane = p->stride * (size_t)rows;
    p->deposit = plb_new_large(p->plane, (size_t)p->planes * sizeof *p->deposit);
    p->marked = plb_new((size_t)rows, sizeof *p->marked);
    p->lock = plb_new((size_t)(rows / STRIPE + 1), sizeof *p->lock);
    if (!p->deposit || !p->marked || !p->lock)
        return plb_fail(err, ERROR_MEMORY, "out of memory for a page of %d by %d pixels", width, height);
    while (p->locks < rows / STRIPE + 1)
        if (pthread_mutex_init(&p->lock[p->locks++], NULL) != 0)
            return plb_fail_memory(err);
    begin_band(p, 0);
    return true;
}

void plb_page_start_at(page *p, int top)
{
    begin_band(p, top);
}

void plb_page_free(page *p)
{
    for (int k = 0; k < p->locks; k++)
        pthread_mutex_destroy(&p->lock[k]);
    plb_free(p->lock);
    plb_free(p->deposit);
    plb_free(p->marked);
    memset(p, 0, sizeof *p);
}

bool plb_page_next_band(page *p)
{
    if (p->top + p->rows >= p->height)
        return false;
    for (int y = p->top; y < p->top + p->rows; y++) {
        row_extent e = p->marked[y - p->top];
        for (int k = 0; e.from < e.to && k < p->planes; k++)
            memset(plb_page_deposits(p, k, y) + e.from, 0, (size_t)(e.to - e.from) * sizeof *p->deposit);
    }
    begin_band(p, p->top + p->rows);
    return true;
}

/* A patch_row is a row of a patch on its way to the page. */
typedef struct {
    const uint8_t *grey;
    size_t at; /* of the page's plane */
    int n;
} laid_row;

/* Lays rows y0 to y1 of the page, those that the patch marks. Each row lies far from the one before in memory, so both its ends are
 * asked for before they are needed. */
static int find_rows(page *p, const patch *from, int y0, int y1, laid_row out[ROWS_TOGETHER])
{
    int n = 0;
    for (int y = y0; y < y1; y++) {
        int x0 = from->x + from->from[y - from->y], x1 = from->x + from->to[y - from->y];
        x0 = x0 < 0 ? 0 : x0;
        x1 = x1 > p->width ? p->width : x1;
        if (x0 >= x1)
            continue;
        row_extent *e = &p->marked[y - p->top];
        e->from = x0 < e->from ? x0 : e->from;
        e->to = x1 > e->to ? x1 : e->to;
        size_t at = (size_t)(y - p->top) * p->stride + (size_t)x0;
        for (int k = 0; k < p->planes; k++) {
            const uint16_t *to = p->deposit + (size_t)k * p->plane + at;
            __builtin_prefetch(to, 1);
            __builtin_prefetch(to + (x1 - x0), 1);
        }
        out[n++] = (laid_row){from->grey + (y - from->y) * from->width + (x0 - from->x), at, x1 - x0};
    }
    return n;
}

/* Looks up the deposits of some rows, then adds them: SIMD16_LANES sums at a time, the last of which add nothing. */
static void lay_plane(uint16_t *plane, const uint16_t deposit[256], const laid_row *rows, int n)
{
    uint16_t more[ROWS_TOGETHER][PATCH_SIDE + SIMD16_LANES];
    for (int k = 0; k < n; k++) {
        const uint8_t *grey = rows[k].grey;
        for (int x = 0; x < rows[k].n; x++)
            more[k][x] = deposit[grey[x]];
        memset(more[k] + rows[k].n, 0, SIMD16_LANES * sizeof more[k][0]);
    }
    for (int k = 0; k < n; k++)
        for (int x = 0; x < rows[k].n; x += SIMD16_LANES)
            simd16_add_within(plane + rows[k].at + x, more[k] + x);
}
_Static_assert(PAGE_ROW_PAD >= SIMD16_LANES, "the last sums of a row stay within it");

/* Lays rows y0 to y1 of the page, all in one stripe. */
static void lay_rows(page *p, const patch *from, const pigment *with, int y0, int y1)
{
    for (int y = y0; y < y1; y += ROWS_TOGETHER) {
        laid_row rows[ROWS_TOGETHER];
        int n = find_rows(p, from, y, y + ROWS_TOGETHER < y1 ? y + ROWS_TOGETHER : y1, rows);
        if (p->planes < PIGMENT_PLANES)
            lay_plane(p->deposit + (p->soft && with->is_soft ? p->plane : 0), p->soft && with->is_soft ? p->soft->deposit : p->ink->deposit, rows, n);
        for (int k = 0; p->planes == PIGMENT_PLANES && k < PIGMENT_PLANES; k++)
            lay_plane(p->deposit + (size_t)k * p->plane, with->deposit[k], rows, n);
    }
}

void plb_page_lay(page *p, const patch *from, const pigment *with)
{
    int bottom = p->top + p->rows, y1 = from->y + from->height < bottom ? from->y + from->height : bottom;
    for (int y = from->y < p->top ? p->top : from->y; y < y1;) {
        int stripe = (y - p->top) / STRIPE, end = p->top + (stripe + 1) * STRIPE;
        end = end < y1 ? end : y1;
        pthread_mutex_lock(&p->lock[stripe]);
        lay_rows(p, from, with, y, end);
        pthread_mutex_unlock(&p->lock[stripe]);
        y = end;
    }
}

