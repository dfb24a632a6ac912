/* SPDX-License-Identifier: MIT
 *
 * This file gives the graphite model's darkness at points beside the path (plumbago(7)).
 * Input: a stroke's grain; rows of evenly spaced points of the page, each with its place in the strip frame. Output: the
 * darkness of each.
 *
 * A point's expected darkness is that of its exact distance from the path; its score is that of the nearest value of
 * the stroke's field and of the paper's height at its place on the page, each with its share of the variance. Its
 * darkness is the captured quantile, at that score, of pixels where so much is expected. (Interpolated values would lose
 * half the grain's spread.) The points of many short rows are first located, row after row, and then read in one long
 * pass, none of which has a branch or a division.
 */
#include "base/number/random.h"
#include "base/simd_clones.h"
#include "stroke/pencil.h"

#include <math.h>
#include <string.h>

/* A row is located in runs of at most so many points; so many in all are read at once: small enough to stay in the nearest
 * cache. */
#define RUN 32
#define POINTS 256
/* The shares of field and paper are weights of so many bits. */
#define SHARE_BITS 8

/* A run is located in whole blocks of points; what lies beyond the last one is overwritten by the next run. */
#define BLOCK 8

/* Where points are. */
typedef struct {
    int n;
    bool on_paper;                         /* whose heights have a part in it; else they are 0 */
    bool ends;                             /* some lie where the pressure is not the line's … */
    double columns, plain_first, plain_last; /* … but none of columns between these is: of all there are */
    int32_t column[POINTS];                /* of the field … */
    float row[POINTS];                     /* … its whole part is meant */
    float across[POINTS];                  /* px to the right of the centreline */
    int16_t height[POINTS];                /* of the paper */
} points;
_Static_assert(RUN % BLOCK == 0 && RUN <= PAPER_RUN && POINTS >= 2 * RUN, "a run fits");

/* ---- places ---- */

#define PLACE_UNIT (256 / (float)PROFILE_SECTION_STEP)
#define PLACE_LAST ((GRAIN_MODE_PLACES - 1) * 256 - 1)

static inline int32_t within(int32_t v, int32_t high)
{
    v = v < 0 ? 0 : v;
    return v > high ? high : v;
}

/* Gives the whole part of what is cut to 0 … high. */
static inline int32_t whole_within(float v, float high)
{
    v = v > 0 ? v : 0;
    return (int32_t)(v < high ? v : high);
}

/* Whole blocks. */
static inline int padded(int n)
{
    return (n + BLOCK - 1) & -BLOCK;
}

/* Where the first point of a run lies and the way to each next, px: along from column `first` on, and across. */
typedef struct {
    float along, step, across, aside;
    float last, middle; /* columns from `first` to the last one; row of the centreline */
    int32_t first;
} sample_run;

PLB_SIMD_CLONES static void locate(sample_run r, int n, int32_t *restrict column, float *restrict row, float *restrict across)
{
    for (int i = 0; i < n; i++) {
        float u = r.across + (float)i * r.aside;
        across[i] = u;
        row[i] = u + r.middle;
        column[i] = r.first + whole_within(r.along + (float)i * r.step, r.last);
    }
}

/* All points lie beside the line. Nothing here branches. */
static void locate_run(const grain *g, const sample_row *at, int from, int n, points *p)
{
    double begin = at->along + from * at->along_step, end = at->along + (from + n - 1) * at->along_step;
    int32_t first = (int32_t)(begin < end ? begin : end);
    sample_run r = {.first = first, .along = (float)(begin - first), .step = (float)at->along_step};
    r.across = (float)(at->across + from * at->across_step);
    r.aside = (float)at->across_step;
    r.last = (float)(g->columns - 1 - first);
    r.middle = (float)(g->rows / 2) + 0.5f;
    locate(r, padded(n), p->column + p->n, p->row + p->n, p->across + p->n);
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

static inline int32_t floor_of(double v)
{
    int32_t whole = (int32_t)v;
    return whole - (v < whole);
}

/* ---- as look_beside has it, where all points lie beside the line: in passes without a branch ---- */

/* A run of a row: the place of its point number i is along + (from + i) step, and so across. */
typedef struct {
    double along, step, across, aside;
    int from, n;
} fine_run;

/* The eighths of a pixel in which points lie. */
PLB_SIMD_CLONES static void find_eighths(fine_run r, int32_t *restrict x, int32_t *restrict y)
{
    for (int i = 0; i < r.n; i++) {
        x[i] = floor_of((r.along + (r.from + i) * r.step) * 8);
        y[i] = floor_of((r.across + (r.from + i) * r.aside) * 8);
    }
}

/* Two numbers of 16 bits from them, in their place. */
PLB_SIMD_CLONES static void mix(int n, int32_t *restrict x, int32_t *restrict y)
{
    for (int i = 0; i < n; i++) {
        uint64_t h = random_mix((uint64_t)(int64_t)x[i] * 0x9e3779b97f4a7c15u ^ (uint64_t)(int64_t)y[i]);
        x[i] = (int32_t)(h & 0xffff);
        y[i] = (int32_t)(h >> 16 & 0xffff);
    }
}

/* Tells how far beside its own place a point looks, `ragged` at most. */
static inline double beside(double ragged, int32_t bits)
{
    return ragged * (bits * (1.0 / 32768) - 1);
}

PLB_SIMD_CLONES static void look_about(fine_run r, const grain *g, const int32_t *restrict x, const int32_t *restrict y, int32_t *restrict column,
                                float *restrict row, float *restrict exact)
{
    const double ragged = (double)g->ragged, half = g->rows / 2;
    const int32_t last = g->columns - 1;
    for (int i = 0; i < r.n; i++) {
        double across = r.across + (r.from + i) * r.aside, seen = across + beside(ragged, y[i]) + half + 0.5;
        exact[i] = (float)across;
        column[i] = within((int32_t)(r.along + (r.from + i) * r.step + beside(ragged, x[i])), last); /* below 0: the first */
        row[i] = (float)(int32_t)seen; /* what is beyond the field is cut off later */
    }
}

static void locate_ragged(const grain *g, const sample_row *at, int from, int n, points *p)
{
    fine_run r = {at->along, at->along_step, at->across, at->across_step, from, padded(n)};
    int32_t x[RUN], y[RUN];
    find_eighths(r, x, y);
    mix(r.n, x, y);
    look_about(r, g, x, y, p->column + p->n, p->row + p->n, p->across + p->n);
}

/* ---- */

/* A place where no darkness is ever expected, px across. */
#define NOWHERE (-1000.0f)

/* Points one by one: near the ends. */
static void locate_one_by_one(const grain *g, const sample_row *at, int from, int n, points *p)
{
    for (int i = 0; i < n; i++) {
        double along = at->along + (from + i) * at->along_step, across = at->across + (from + i) * at->across_step;
        bool there = (along >= 0 && along < g->columns) || enter_cap(g, &along, &across);
        p->across[p->n + i] = there ? (float)across : NOWHERE;
        if (g->ragged > 0 && there)
            look_beside(g, &along, &across);
        along = along < 0 || !there ? 0 : along >= g->columns ? g->columns - 1 : along;
        p->column[p->n + i] = (int32_t)along;
        p->row[p->n + i] = (float)within((int32_t)floor(across + g->rows / 2 + 0.5), g->rows - 1);
    }
}

/* Computes the points `from` to from + n of the row, at most a run. */
static void add_run(const grain *g, const sample_row *at, int from, int n, points *p)
{
    double begin = at->along + from * at->along_step, end = at->along + (from + n - 1) * at->along_step;
    double low = begin < end ? begin : end, high = begin < end ? end : begin;
    bool beside_line = low >= 0 && high < p->columns;
    if (!beside_line)
        locate_one_by_one(g, at, from, n, p);
    else if (g->ragged > 0)
        locate_ragged(g, at, from, n, p);
    else
        locate_run(g, at, from, n, p);
    if (p->on_paper)
        plb_paper_row(&g->pencil->grain->paper, &g->sheet, at->x + from * at->step, at->y, at->step, n, p->height + p->n);
    p->ends |= !beside_line || low < p->plain_first || high >= p->plain_last;
    p->n += n;
}

/* ---- darkness ---- */

/* The values of each point, filled in by one loop after the other. */
typedef struct {
    int32_t cell[POINTS];                /* of the field */
    int32_t place[POINTS];               /* of the section, 256 to a step */
    int32_t at[POINTS];                  /* of the place before it, among the levels of its column's knot */
    uint16_t levels[POINTS];             /* of the places before it and behind it: low and high byte */
    int16_t level[POINTS], own[POINTS];  /* what is expected; the stroke's own field */
    int16_t score[POINTS], correction[POINTS]; /* with the paper's; what its table adds to it */
    uint16_t at_level[POINTS];           /* how much of that, and the row of the table of darkness: low and high byte */
    uint16_t entry[POINTS];              /* of that table */
    uint16_t relative[POINTS];           /* darkness */
} reading;

/* Two bytes in one load. */
static inline uint16_t pair_of(const uint8_t *at)
{
    return (uint16_t)(at[0] | at[1] << 8);
}

/* The profile's places of points. A line's own width stretches the whole section; the width that a pencil was assigned
 * stretches its core only: flanks and the dust beside them stay as steep as scanned. */
PLB_SIMD_CLONES static void find_places(const grain *g, const points *p, reading *r)
{
    const float narrow = g->narrow, half_width = g->half_width, ratio = g->half_reference / g->half_width;
    for (int i = 0; i < p->n; i++) {
        float x = fabsf(p->across[i]) * narrow, over = x - half_width;
        float place = x * ratio + (1 - ratio) * 0.5f * (over + fabsf(over)); /* the last factor: over, where positive */
        r->place[i] = whole_within((copysignf(place, p->across[i]) + 8) * PLACE_UNIT, PLACE_LAST);
    }
}

PLB_SIMD_CLONES static void find_cells(const grain *g, const points *p, reading *r)
{
    const float last = (float)(g->rows - 1);
    const int32_t stride = g->stride;
    for (int i = 0; i < p->n; i++) {
        r->cell[i] = p->column[i] * stride + whole_within(p->row[i], last);
        r->at[i] = (int32_t)((uint32_t)(p->column[i] + GRAIN_KNOT / 2) / GRAIN_KNOT * GRAIN_PLACES_PADDED) + (r->place[i] >> 8);
    }
}

static void look_up_field(const grain *g, int n, reading *r)
{
    const int8_t *field = g->field;
    const uint8_t *level = g->level;
    for (int i = 0; i < n; i++) {
        r->own[i] = field[r->cell[i]];
        r->levels[i] = pair_of(level + r->at[i]);
    }
}

/* Between two places: first + (second - first) w / 256, rounded, by the two halves of a product of 16 bits. */
PLB_SIMD_CLONES static void find_levels(int n, reading *r)
{
    for (int i = 0; i < n; i++) {
        int16_t first = (int16_t)(r->levels[i] & 255), way = (int16_t)(((r->levels[i] >> 8) - first) * 128);
        int16_t w = (int16_t)((r->place[i] & 255) * 2);
        uint16_t rest = (uint16_t)(way * w);
        r->level[i] = (int16_t)(first + ((way * w) >> 16) + (rest >> 15));
    }
}

/* On a coarse page: the mean over the pixel, across the line. */
static void find_coarse_levels(const grain *g, int n, reading *r)
{
    for (int i = 0; i < n; i++) {
        const uint8_t *levels = g->level + r->at[i] - (r->place[i] >> 8);
        int sum = 0;
        for (int k = -1; k <= 1; k++) {
            int at = within(r->place[i] + k * g->sample_step, PLACE_LAST), w = at & 255;
            const uint8_t *l = levels + (at >> 8);
            sum += l[0] * 256 + (l[1] - l[0]) * w;
        }
        r->level[i] = (int16_t)((sum * 85 + (1 << 15)) >> 16); /* a third of a 256th */
    }
}

static void press(const grain *g, const points *p, reading *r)
{
    for (int i = 0; i < p->n; i++)
        r->level[i] = (int16_t)((r->level[i] * (g->ends[p->column[i]] + 1) + 128) >> 8);
}

static inline int16_t byte_of(int16_t v)
{
    v = v > 0 ? v : 0;
    return v < 255 ? v : 255;
}

/* The scores: the stroke's share and the paper's; as numbers of the table of bends. */
PLB_SIMD_CLONES static void find_scores(const grain *g, const points *p, reading *r)
{
    const int16_t own = (int16_t)g->weight_field, sheet = (int16_t)g->weight_paper;
    for (int i = 0; i < p->n; i++) {
        int both = r->own[i] * own + p->height[i] * sheet + (1 << (SHARE_BITS - 1));
        r->score[i] = byte_of((int16_t)((both >> SHARE_BITS) + 128));
    }
}

static void look_up_bends(const grain *g, int n, reading *r)
{
    const grain_tables *t = g->pencil->grain;
    const int8_t *correction = g->score_correction;
    for (int i = 0; i < n; i++) {
        r->correction[i] = correction[r->score[i]];
        r->at_level[i] = (uint16_t)(t->at_level[r->level[i]].share | t->at_level[r->level[i]].row << 8);
    }
}

PLB_SIMD_CLONES static void find_entries(int n, reading *r)
{
    for (int i = 0; i < n; i++) {
        int16_t bent = (int16_t)((r->correction[i] * (int16_t)(r->at_level[i] & 255)) >> 8);
        r->entry[i] = (uint16_t)((r->at_level[i] >> 8 << 7) + (byte_of((int16_t)(r->score[i] + bent)) >> 1));
    }
}

static void look_up_darkness(const grain *g, int n, reading *r)
{
    const uint16_t *darkness = g->darkness;
    for (int i = 0; i < n; i++)
        r->relative[i] = darkness[r->entry[i]];
}

/* Times the line's own depth: 8 fractional bits and the table's 12, of which a whole product's upper half has 4. */
PLB_SIMD_CLONES static void find_darkness(const grain *g, int n, const reading *r, uint8_t *restrict out)
{
    const uint16_t depth = (uint16_t)g->depth;
    for (int i = 0; i < n; i++) {
        uint16_t d = (uint16_t)((uint16_t)(((uint32_t)r->relative[i] * depth >> 16) + 8) >> 4);
        out[i] = (uint8_t)(d < 255 ? d : 255);
    }
}
_Static_assert(GRAIN_RELATIVE_UNIT == 1 << 12, "depth has 8 fractional bits, darkness 12");

/* Returns how many there were, and forgets them. */
static int finish(const grain *g, points *p, uint8_t *out)
{
    reading r; /* large: only what is used is set */
    const int n = p->n;
    find_places(g, p, &r);
    find_cells(g, p, &r);
    look_up_field(g, n, &r);
    if (g->sample_step > 0)
        find_coarse_levels(g, n, &r);
    else
        find_levels(n, &r);
    if (p->ends)
        press(g, p, &r);
    find_scores(g, p, &r);
    look_up_bends(g, n, &r);
    find_entries(n, &r);
    look_up_darkness(g, n, &r);
    find_darkness(g, n, &r, out);
    p->n = 0;
    p->ends = false;
    return n;
}

static void shade(const void *texture, const sample_row *rows, int n, uint8_t *out)
{
    const grain *g = texture;
    points p; /* large: not all of it is set here */
    p.n = 0;
    p.ends = false;
    p.columns = g->columns;
    p.plain_first = g->plain_first + (double)g->ragged;
    p.plain_last = g->plain_last - (double)g->ragged;
    p.on_paper = g->pencil->grain->paper.share > 0;
    if (!p.on_paper)
        memset(p.height, 0, sizeof p.height);
    for (const sample_row *at = rows; at < rows + n; at++)
        for (int i = 0; i < at->n; i += RUN) {
            if (p.n + RUN > POINTS)
                out += finish(g, &p, out);
            add_run(g, at, i, at->n - i < RUN ? at->n - i : RUN, &p);
        }
    finish(g, &p, out);
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
    g->sample_step = (int32_t)(side / 3 * (double)(g->narrow * PLACE_UNIT));
    g->darkness = g->pencil->grain->darkness[scale];
    shading r = {g, shade, false, g->rows / 2 + 0.5 + side / 2, beyond, dpi, side > 0};
    return r;
}
