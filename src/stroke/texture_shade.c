/* SPDX-License-Identifier: MIT
 *
 * The graphite model's darkness at points beside the path (plumbago(7)).
 * Input: a stroke's grain; evenly spaced points in a row of the page, each with its place in the strip frame. Output: the
 * darkness of each.
 *
 * A point's expected darkness is that of its exact distance from the path; its score is that of the nearest value of
 * the stroke's field and of the paper's height at its place on the page, each with its share of the variance. Its
 * darkness is the captured quantile, at that score, of pixels where so much is expected. (Interpolated values would lose
 * half the grain's spread.) Rows are read in runs, each in a few passes that have no branch and no division.
 */
#include "base/random.h"
#include "stroke/pencil.h"

#include <math.h>
#include <string.h>

#define RUN 32
/* The shares of field and paper are weights of so many bits. */
#define SHARE_BITS 8

/* Vector loops run over whole blocks of points; what lies beyond the last one is never used. */
#define BLOCK 8

/* Where a run's points are. */
typedef struct {
    int n;
    int32_t column[RUN], row[RUN]; /* of the field */
    int32_t place[RUN];            /* of the section, 256 to a step */
} run;

/* ---- places ---- */

#define PLACE_UNIT (256 / (float)PROFILE_SECTION_STEP)
#define PLACE_LAST ((GRAIN_MODE_PLACES - 1) * 256 - 1)

static inline int32_t within(int32_t v, int32_t high)
{
    v = v < 0 ? 0 : v;
    return v > high ? high : v;
}

/* The profile's place of a point `across` px from the centreline. A line's own width stretches the whole section; the width
 * that a pencil was assigned stretches its core only: flanks and the dust beside them stay as steep as scanned. */
static inline int32_t place_of(const grain *g, float across)
{
    float x = fabsf(across) * g->narrow, over = x - g->half_width, ratio = g->half_reference / g->half_width;
    float place = x * ratio + (1 - ratio) * 0.5f * (over + fabsf(over)); /* the last factor: over, where positive */
    return within((int32_t)((copysignf(place, across) + 8) * PLACE_UNIT), PLACE_LAST);
}

/* All points lie beside the line. Nothing here branches. */
static void locate_run(const grain *g, const sample_row *at, int from, run *r)
{
    double low = at->along + from * at->along_step, high = at->along + (from + r->n - 1) * at->along_step;
    int32_t first = (int32_t)(low < high ? low : high), last = g->columns - 1, rows = g->rows - 1;
    float along = (float)(low - first), step = (float)at->along_step, middle = (float)(g->rows / 2) + 0.5f;
    float across = (float)(at->across + from * at->across_step), aside = (float)at->across_step;
    for (int b = 0; b < r->n; b += BLOCK)
        for (int i = b; i < b + BLOCK; i++) {
            float u = across + (float)i * aside;
            r->column[i] = within((int32_t)(along + (float)i * step) + first, last);
            r->row[i] = within((int32_t)(u + middle), rows);
            r->place[i] = place_of(g, u);
        }
}

/* Beyond an end that is a corner the line goes on as a half disc. True when there is something; moves both coordinates. */
static bool enter_cap(const grain *g, double *along, double *across)
{
    double out = *along < 0 ? -*along : *along - g->columns;
    double radius = (double)(*along < 0 ? g->cap_first : g->cap_last);
    bool is_part = *along >= g->columns && out <= 1; /* the last column may be a part of one */
    if (!(out <= radius) && !is_part)
        return false;
    if (out <= radius)
        *across = *across < 0 ? -hypot(*across, out) : hypot(*across, out);
    *along = *along < 0 ? 0 : g->columns - 1;
    return true;
}

/* On a page finer than the field each point looks up to half a pixel beside its own, by a hash of its place: the field's
 * pixels get ragged edges instead of square ones (graphite's grain is finer than 300 dpi shows: neighbours at 600 dpi
 * correlate by about a half). */
static void look_beside(const grain *g, double *along, double *across)
{
    uint64_t h = random_mix((uint64_t)(int64_t)floor(*along * 8) * 0x9e3779b97f4a7c15u ^ (uint64_t)(int64_t)floor(*across * 8));
    *along += (double)g->ragged * ((double)(h & 0xffff) / 32768 - 1);
    *across += (double)g->ragged * ((double)(h >> 16 & 0xffff) / 32768 - 1);
}

/* Points one by one: near the ends, and on fine pages. */
static void locate_one_by_one(const grain *g, const sample_row *at, int from, run *r)
{
    for (int i = 0; i < r->n; i++) {
        double along = at->along + (from + i) * at->along_step, across = at->across + (from + i) * at->across_step;
        bool there = (along >= 0 && along < g->columns) || enter_cap(g, &along, &across);
        double exact = across;
        if (g->ragged > 0 && there)
            look_beside(g, &along, &across);
        along = along < 0 || !there ? 0 : along >= g->columns ? g->columns - 1 : along;
        r->column[i] = (int32_t)along;
        r->row[i] = within((int32_t)floor(across + g->rows / 2 + 0.5), g->rows - 1);
        r->place[i] = there ? place_of(g, (float)exact) : 0; /* 0: where no darkness is ever expected */
    }
}

static bool is_beside_line(const grain *g, const sample_row *at, int from, int n)
{
    double low = at->along + from * at->along_step, high = at->along + (from + n - 1) * at->along_step;
    return low >= 0 && high >= 0 && low < g->columns && high < g->columns && !(g->ragged > 0);
}

/* ---- darkness ---- */

/* The expected levels and the values of the stroke's field. */
static void gather(const grain *g, const run *r, int16_t level[RUN], int16_t field[RUN])
{
    const size_t stride = (size_t)g->stride;
    for (int i = 0; i < r->n; i++) {
        size_t column = (size_t)r->column[i], place = (size_t)r->place[i];
        const uint8_t *l = g->level + (column + GRAIN_KNOT / 2) / GRAIN_KNOT * GRAIN_PLACES_PADDED + (place >> 8);
        int w = (int)(place & 255);
        level[i] = (int16_t)((l[0] * 256 + (l[1] - l[0]) * w + 128) >> 8);
        field[i] = g->field[column * stride + (size_t)r->row[i]];
    }
}

/* On a coarse page: what is expected is the mean over the pixel, across the line. */
static void gather_coarse(const grain *g, const run *r, int16_t level[RUN], int16_t field[RUN])
{
    for (int i = 0; i < r->n; i++) {
        size_t column = (size_t)r->column[i];
        const uint8_t *l = g->level + (column + GRAIN_KNOT / 2) / GRAIN_KNOT * GRAIN_PLACES_PADDED;
        int sum = 0;
        for (int k = -1; k <= 1; k++) {
            int place = within(r->place[i] + k * g->foot, PLACE_LAST), w = place & 255;
            sum += l[place >> 8] * 256 + (l[(place >> 8) + 1] - l[place >> 8]) * w;
        }
        level[i] = (int16_t)((sum * 85 + (1 << 15)) >> 16); /* a third of a 256th */
        field[i] = g->field[column * (size_t)g->stride + (size_t)r->row[i]];
    }
}

static void press(const grain *g, const run *r, int16_t level[RUN])
{
    for (int i = 0; i < r->n; i++)
        level[i] = (int16_t)((level[i] * (g->ends[r->column[i]] + 1) + 128) >> 8);
}

/* The scores: the stroke's share and the paper's. */
static void lay_on_paper(const grain *g, const sample_row *at, int from, int n, int16_t field[RUN])
{
    const paper *p = &g->pencil->grain->paper;
    int16_t height[RUN];
    if (p->share > 0)
        plb_paper_row(p, &g->sheet, at->x + from * at->step, at->y, at->step, n, height);
    else
        memset(height, 0, sizeof height);
    for (int i = n; i % BLOCK; i++)
        field[i] = height[i] = 0; /* the last block is computed whole */
    for (int b = 0; b < n; b += BLOCK)
        for (int i = b; i < b + BLOCK; i++)
            field[i] = (int16_t)((field[i] * g->weight_field + height[i] * g->weight_paper + (1 << (SHARE_BITS - 1))) >> SHARE_BITS);
}

static void write_darkness(const grain *g, int n, const int16_t level[RUN], const int16_t field[RUN], uint8_t *out)
{
    const grain_tables *t = g->pencil->grain;
    const int8_t *bend = g->bend + 128;
    const uint16_t(*darkness)[128] = (const uint16_t(*)[128])g->darkness;
    const uint32_t depth = g->depth;
    for (int i = 0; i < n; i++) {
        int m = level[i], f = field[i] + 128;
        f = within(f, 255) - 128;
        int z = within(f + ((bend[f] * t->at_level[m].share) >> 8) + 128, 255);
        uint32_t d = (depth * darkness[t->at_level[m].row][z >> 1] + (1u << 19)) >> 20;
        out[i] = (uint8_t)(d > 255 ? 255 : d);
    }
}
_Static_assert(GRAIN_RELATIVE_UNIT == 1 << 12, "depth has 8 fractional bits, darkness 12");

static void shade_run(const grain *g, const sample_row *at, int from, int n, uint8_t *out)
{
    run r;
    int16_t level[RUN], field[RUN];
    r.n = n;
    if (is_beside_line(g, at, from, n))
        locate_run(g, at, from, &r);
    else
        locate_one_by_one(g, at, from, &r);
    if (g->foot > 0)
        gather_coarse(g, &r, level, field);
    else
        gather(g, &r, level, field);
    if (r.column[0] < g->plain_first || r.column[0] > g->plain_last || r.column[n - 1] < g->plain_first || r.column[n - 1] > g->plain_last)
        press(g, &r, level);
    lay_on_paper(g, at, from, n, field);
    write_darkness(g, n, level, field, out);
}

static void shade(const void *texture, const sample_row *at, uint8_t *out)
{
    for (int i = 0; i < at->n; i += RUN)
        shade_run(texture, at, i, at->n - i < RUN ? at->n - i : RUN, out + i);
}

/* A page between COARSEST and COARSE: a sample stands for a pixel. */
static double pixels_of(double dpi, double page_dpi)
{
    return page_dpi <= GRAIN_COARSE_DPI && page_dpi >= GRAIN_COARSEST_DPI ? dpi / page_dpi : 0;
}

shading plb_grain_shading(grain *g, double dpi, double page_dpi)
{
    double side = pixels_of(dpi, page_dpi), beyond = (double)(g->cap_first > g->cap_last ? g->cap_first : g->cap_last);
    int scale = side > 0 ? within((int)(side + 0.5), DARKNESS_SCALES) - 1 : 0;
    g->ragged = page_dpi > GRAIN_RAGGED_DPI ? 0.5f : 0;
    g->foot = (int32_t)(side / 3 * (double)(g->narrow * PLACE_UNIT));
    g->darkness = g->pencil->grain->darkness[scale];
    shading r = {g, shade, false, g->rows / 2 + 0.5 + side / 2, beyond, dpi, side > 0};
    return r;
}
