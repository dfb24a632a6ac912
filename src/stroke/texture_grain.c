/* SPDX-License-Identifier: MIT
 *
 * The graphite model's texture (plumbago(7)).
 * Input: the length of the path in pixels of the profile; the profile's grain. Output: a field of normal scores in the
 * strip frame, and per place the darkness to expect; together they give the darkness of any point beside the path.
 *
 *   1. The line's own depth, width, roughness and correlations are drawn from their captured joint distribution.
 *   2. Its cross-section changes slowly along it: mean section plus six modes, each with a slow random coefficient.
 *   3. Grain: white noise through the captured filter, joined from column to column by a chain whose coefficient is
 *      high in smooth columns and low in broken ones.
 *   4. A point's darkness is the captured quantile, at the point's score, of pixels where so much darkness is expected.
 */
#include "base/interpolate.h"
#include "base/random.h"
#include "stroke/pencil.h"

#include <math.h>
#include <string.h>

/* No graphite farther from the centreline than this, in places of the profile. */
#define REACH 7.0
#define HALF_ROWS_MAX 40
#define TAPS_HALF (GRAIN_TAPS / 2)
/* Rows are worked on in blocks of so many, which the compiler keeps in vector registers. */
#define BLOCK 8
#define ROWS_MAX ((2 * HALF_ROWS_MAX + 1 + BLOCK - 1) / BLOCK * BLOCK)
#define NOISE_MAX (ROWS_MAX + 2 * TAPS_HALF)
/* Scores fade into the plain field where the expected darkness falls through these: they were captured on the line. */
#define TAIL_LOW 0.05
#define TAIL_SPAN 0.25
/* Half a kilometre of pencil, in columns. */
#define COLUMNS_MAX 6000000

/* What one stroke draws once. */
typedef struct {
    double depth, width, roughness, along, across;
    double mode[GRAIN_MODES];
} line_figures;

void plb_grain_free(grain *g)
{
    plb_free(g->score);
    plb_free(g->level);
    plb_free(g->pressure);
    memset(g, 0, sizeof *g);
}

/* ---- room ---- */

static bool make_room(void **v, size_t *room, size_t need)
{
    if (need <= *room)
        return true;
    plb_free(*v);
    *v = plb_new(need, 1);
    *room = *v ? need : 0;
    return *v != NULL;
}

static size_t knots_of(int columns)
{
    return (size_t)columns / GRAIN_KNOT + 2;
}

static bool resize(grain *g, int columns, int rows, error *err)
{
    g->columns = columns;
    g->rows = rows;
    bool ok = make_room((void **)&g->score, &g->score_room, (size_t)columns * (size_t)rows) &&
              make_room((void **)&g->level, &g->level_room, knots_of(columns) * GRAIN_MODE_PLACES) &&
              make_room((void **)&g->pressure, &g->pressure_room, (size_t)columns);
    return ok || plb_fail_memory(err);
}

/* ---- 1: the line ---- */

static double normal_at(const grain_tables *t, uint64_t key, uint64_t index)
{
    return t->normal[random_bits(key, index) >> 52];
}

/* How far lines of one pencil differ is known from few lines, in a graded pencil from two to nine: depth and width keep
 * within what a drawing by one hand shows (chosen by eye). */
#define DEPTH_SPREAD 0.35
#define WIDTH_SPREAD 0.24

static line_figures draw_line(const pencil *p, uint64_t key)
{
    const grain_model *g = &p->profile->grain;
    double x[GRAIN_LINE], n[GRAIN_LINE];
    for (int i = 0; i < GRAIN_LINE; i++) {
        n[i] = normal_at(p->grain, key, (uint64_t)i);
        x[i] = 0;
        for (int j = 0; j <= i; j++)
            x[i] += g->line_factor[i][j] * n[j];
        double spread = i == 0 ? DEPTH_SPREAD : i == 1 ? WIDTH_SPREAD : HUGE_VAL;
        x[i] = g->line_mean[i] + clamp(x[i], -spread, spread);
    }
    line_figures f = {clamp(exp(x[0]), 1, 254), clamp(exp(x[1]), 0.5, 200), x[2], x[3], x[4], {0}};
    for (int i = 0; i < GRAIN_MODES; i++)
        f.mode[i] = g->mode_is_odd[i] ? sqrt(g->mode_between[i]) * normal_at(p->grain, key, (uint64_t)(GRAIN_LINE + i)) : x[5 + i];
    return f;
}

/* ---- places ---- */

/* The profile's place, px, of a point `across` px from the centreline. A line's own width stretches the whole section; the
 * width that a pencil was assigned stretches its core only: flanks and the dust beside them stay as steep as scanned. */
static double place_of(const grain *g, double across)
{
    double x = fabs(across) * (double)g->narrow, core = (double)g->half_width;
    double place = x <= core ? x * (double)g->half_reference / core : (double)g->half_reference + x - core;
    return across < 0 ? -place : place;
}

static int rows_of(const grain *g)
{
    double reach = REACH > (double)g->half_reference ? (double)g->half_width + REACH - (double)g->half_reference : (double)g->half_width;
    int half = (int)ceil(reach / (double)g->narrow);
    return 2 * (half < 1 ? 1 : half > HALF_ROWS_MAX ? HALF_ROWS_MAX : half) + 1;
}

/* ---- 2: the section along the line ---- */

/* A mode's coefficient at the knots, into out[0 .. n): a stationary process from knot to knot, smoothed. */
static void slow_process(const grain_tables *t, int mode, uint64_t key, size_t n, float *raw, float *out)
{
    float keep = t->knot_keep[mode], fresh = sqrtf(1 - keep * keep);
    uint64_t base = (uint64_t)mode << 32;
    size_t all = n + 2 * GRAIN_SMOOTH_KNOTS;
    for (size_t k = 0; k < all; k++) {
        float e = (float)normal_at(t, key, base + k);
        raw[k] = k ? keep * raw[k - 1] + fresh * e : e;
    }
    for (size_t k = 0; k < n; k++) {
        float sum = 0;
        for (int i = 0; i <= 2 * GRAIN_SMOOTH_KNOTS; i++)
            sum += t->smooth[i] * raw[k + (size_t)i];
        out[k] = sum * t->knot_scale[mode];
    }
}

static void fill_levels(grain *g, const line_figures *f, const float *coefficient, size_t knots)
{
    const grain_tables *t = g->pencil->grain;
    for (size_t k = 0; k < knots; k++) {
        float m[GRAIN_PLACES_PADDED];
        memcpy(m, t->section, sizeof m);
        for (int i = 0; i < GRAIN_MODES; i++) {
            float a = (float)f->mode[i] + coefficient[(size_t)i * knots + k];
            for (int j = 0; j < GRAIN_PLACES_PADDED; j++)
                m[j] += a * t->mode[i][j];
        }
        for (int j = 0; j < GRAIN_MODE_PLACES; j++) {
            float v = m[j] * GRAIN_LEVEL_UNIT + 0.5f;
            g->level[k * GRAIN_MODE_PLACES + (size_t)j] = (uint8_t)(v < 0 ? 0 : v > 255 ? 255 : v);
        }
    }
}

static bool make_section(grain *g, const line_figures *f, uint64_t key, error *err)
{
    size_t knots = knots_of(g->columns), raw = knots + 2 * GRAIN_SMOOTH_KNOTS;
    float *room = plb_new(knots * GRAIN_MODES + raw, sizeof *room);
    if (!room)
        return plb_fail_memory(err);
    for (int i = 0; i < GRAIN_MODES; i++)
        slow_process(g->pencil->grain, i, key, knots, room + knots * GRAIN_MODES, room + knots * (size_t)i);
    fill_levels(g, f, room, knots);
    plb_free(room);
    return true;
}

/* ---- 3: the grain ---- */

/* What the rows share: how far they are from the centreline decides how scores are taken there. */
typedef struct {
    float place_scale[ROWS_MAX], share[ROWS_MAX]; /* share: of the score, the rest of the plain field */
} row_figures;

static row_figures figures_of_rows(const grain *g)
{
    const grain_model *m = &g->pencil->profile->grain;
    row_figures r;
    for (int k = 0; k < g->rows; k++) {
        double place = fabs(place_of(g, k - g->rows / 2));
        float f = (float)plb_interpolate(m->section, GRAIN_SECTION, PROFILE_SECTION_STEP / 2, PROFILE_SECTION_STEP, place);
        float tz = (float)plb_interpolate(m->place_scale, GRAIN_PLACES, 0.25, 0.5, place);
        r.place_scale[k] = (float)((1 + ((double)tz - 1) * clamp((f - 0.4) / 0.4, 0, 1)) * GRAIN_SCORE_UNIT);
        r.share[k] = (float)clamp((f - TAIL_LOW) / TAIL_SPAN, 0, 1);
    }
    return r;
}

/* A column of white noise: five numbers of 12 bits from each draw. */
static void fill_noise(const grain_tables *t, uint64_t key, uint64_t column, int n, float *out)
{
    for (int r = 0; r < n; r += 5) {
        uint64_t bits = random_bits(key, column * 32 + (uint64_t)(r / 5));
        for (int k = r; k < r + 5 && k < n; k++, bits >>= 12)
            out[k] = t->normal[bits & (GRAIN_NORMALS - 1)];
    }
}

/* The chain's coefficient in each column, two states; written over by the reader column by column. */
static double next_coefficient(const grain_model *g, const line_figures *f, bool *high, double u, bool first)
{
    double p = g->chain_share, rho = g->chain_correlation;
    *high = u < (first ? p : *high ? p + rho * (1 - p) : p * (1 - rho));
    return clamp((*high ? g->chain_high : g->chain_low) + f->along - g->line_mean[3], -0.3, 0.95);
}

/* Rows up to the next whole block: what lies beyond the strip's is never looked at. */
static void filter_column(const float (*tap)[GRAIN_TAPS], float *const noise[GRAIN_TAPS], int rows, float *out)
{
    for (int b = 0; b < rows; b += BLOCK) {
        float sum[BLOCK] = {0};
        for (int i = 0; i < GRAIN_TAPS; i++)
            for (int j = 0; j < GRAIN_TAPS; j++) {
                const float *e = noise[i] + b + j;
                for (int r = 0; r < BLOCK; r++)
                    sum[r] += tap[i][j] * e[r];
            }
        memcpy(out + b, sum, sizeof sum);
    }
}

/* The next column of the chain. */
static void join_column(float *field, const float *white, float keep, float fresh, int rows)
{
    for (int b = 0; b < rows; b += BLOCK)
        for (int r = b; r < b + BLOCK; r++)
            field[r] = keep * field[r] + fresh * white[r];
}

static void write_scores(const grain *g, const row_figures *rows, const float *field, float rough, int8_t *out)
{
    const int8_t *score = g->pencil->grain->score;
    for (int r = 0; r < g->rows; r++) {
        float x = field[r] * rough * ((GRAIN_MAP - 1) / 16.0f) + GRAIN_MAP / 2 + 0.5f;
        int k = x < 0 ? 0 : x > GRAIN_MAP - 1 ? GRAIN_MAP - 1 : (int)x;
        float z = (float)score[k] * (1.0f / GRAIN_SCORE_UNIT) * rows->share[r] + field[r] * (1 - rows->share[r]);
        z *= rows->place_scale[r];
        out[r] = (int8_t)(z > 127 ? 127 : z < -127 ? -127 : z < 0 ? z - 0.5f : z + 0.5f);
    }
}

static void make_grain(grain *g, const line_figures *f, uint64_t noise_key, uint64_t chain_key)
{
    const grain_model *m = &g->pencil->profile->grain;
    const grain_tables *t = g->pencil->grain;
    const float(*tap)[GRAIN_TAPS] = m->filter[(int)clamp(floor(f->across * 10 + 0.5), 0, GRAIN_CLASSES - 1)];
    float room[GRAIN_TAPS][NOISE_MAX] = {{0}}, *noise[GRAIN_TAPS], white[ROWS_MAX], field[ROWS_MAX] = {0};
    row_figures rows = figures_of_rows(g);
    float rough = (float)exp(f->roughness);
    bool high = false;
    for (int i = 0; i < GRAIN_TAPS; i++) {
        noise[i] = room[i];
        fill_noise(t, noise_key, (uint64_t)i, g->rows + 2 * TAPS_HALF, noise[i]);
    }
    for (int s = 0; s < g->columns; s++) {
        filter_column(tap, noise, g->rows, white);
        double a = next_coefficient(m, f, &high, random_unit(chain_key, (uint64_t)s), s == 0);
        float keep = s ? (float)a : 0, fresh = sqrtf(1 - keep * keep);
        join_column(field, white, keep, fresh, g->rows);
        write_scores(g, &rows, field, rough, g->score + (size_t)s * (size_t)g->rows);
        float *oldest = noise[0];
        memmove(noise, noise + 1, (GRAIN_TAPS - 1) * sizeof *noise);
        noise[GRAIN_TAPS - 1] = oldest;
        fill_noise(t, noise_key, (uint64_t)(s + GRAIN_TAPS), g->rows + 2 * TAPS_HALF, oldest);
    }
}

/* ---- pressure at the ends ---- */

/* Darkness summed across the stroke by distance from its end, px at 300 dpi, as a share of its middle: the end where the
 * hand starts and the end where it lifts (medians of 75 short strokes of one writer, w0054 of hdBPMN). */
static const double where_px[] = {0, 1, 2, 3, 4, 6, 8, 10, 12};
static const double starting[] = {.17, .59, .88, .91, .99, 1, 1, 1, 1};
static const double leaving[] = {.17, .39, .52, .66, .70, .78, .86, .94, 1};
/* Those strokes were about 40 px long; shorter ones set down and lift over proportionally shorter ways. */
#define MEASURED_PX 40.0

static double end_share(const double *table, double px)
{
    int n = (int)(sizeof where_px / sizeof *where_px), i = 0;
    if (px >= where_px[n - 1])
        return 1;
    while (px >= where_px[i + 1])
        i++;
    double w = (px - where_px[i]) / (where_px[i + 1] - where_px[i]);
    return table[i] + w * (table[i + 1] - table[i]);
}

static double share_of(grain_end end, double px)
{
    return end == GRAIN_START ? end_share(starting, px) : end == GRAIN_LEAVE ? end_share(leaving, px) : 1;
}

static void make_pressure(grain *g, grain_ends ends)
{
    double stretch = g->columns < MEASURED_PX ? MEASURED_PX / g->columns : 1, faded = where_px[8];
    memset(g->pressure, 255, (size_t)g->columns);
    for (int s = 0; s < g->columns; s++) {
        double from_first = (s + 0.5) * stretch, from_last = (g->columns - s - 0.5) * stretch;
        if (from_first < faded || from_last < faded)
            g->pressure[s] = (uint8_t)floor(255 * share_of(ends.first, from_first) * share_of(ends.last, from_last) + 0.5);
    }
}

/* ---- the joint of closed strokes ---- */

/* So many columns, a whole number of knots, go over into those before the beginning. */
static int fold_of(int columns, grain_ends ends)
{
    int fold = columns / 2 / GRAIN_KNOT * GRAIN_KNOT;
    return ends.first != GRAIN_JOINT ? 0 : fold < 64 ? fold : 64;
}

/* `g` was made `fold` columns too long. Its first ones lead up to the beginning; its last ones fade over into them: scores
 * with weights whose squares sum to 1, levels with weights that do. */
static void fold_joint(grain *g, int fold)
{
    size_t rows = (size_t)g->rows, n = (size_t)(g->columns - fold), places = GRAIN_MODE_PLACES;
    for (size_t i = 0; i < (size_t)fold; i++) {
        double w = ((double)i + 0.5) / fold, keep = sqrt(1 - w), join = sqrt(w);
        int8_t *late = g->score + (n + i) * rows, *early = g->score + i * rows;
        for (size_t r = 0; r < rows; r++)
            late[r] = (int8_t)floor(clamp(keep * late[r] + join * early[r], -127, 127) + 0.5);
    }
    memmove(g->score, g->score + (size_t)fold * rows, n * rows);
    size_t folded = (size_t)fold / GRAIN_KNOT, knots = n / GRAIN_KNOT;
    for (size_t j = 0; j < folded; j++) {
        double w = ((double)j + 0.5) / (double)folded;
        uint8_t *late = g->level + (knots + j) * places, *early = g->level + j * places;
        for (size_t k = 0; k < places; k++)
            late[k] = (uint8_t)floor((1 - w) * late[k] + w * early[k] + 0.5);
    }
    memmove(g->level, g->level + folded * places, knots * places);
    for (size_t j = knots; j < knots_of((int)n); j++)
        memcpy(g->level + j * places, g->level, places);
    g->columns = (int)n;
}

/* ---- 4: the darkness of a point ---- */

/* Beyond an end that is a corner the line goes on as a half disc. True when there is something; moves both coordinates. */
static bool enter_cap(const grain *g, double *along, double *across)
{
    double out = *along < 0 ? -*along : *along - g->columns;
    double radius = (double)(*along < 0 ? g->cap_first : g->cap_last);
    if (out > radius)
        return *along >= g->columns && out <= 1; /* the last column may be a part of one */
    *across = *across < 0 ? -hypot(*across, out) : hypot(*across, out);
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

static inline int darkness(const grain *g, double along, double across)
{
    if ((along < 0 || along >= g->columns) && !enter_cap(g, &along, &across))
        return 0;
    double exact = across;
    if (g->ragged > 0)
        look_beside(g, &along, &across);
    double row = floor(across + 0.5) + g->rows / 2, place = (place_of(g, exact) + 8) / PROFILE_SECTION_STEP;
    if (!(row >= 0 && row < g->rows && place >= 0 && place < GRAIN_MODE_PLACES - 1))
        return 0;
    int s = along < 0 ? 0 : along >= g->columns ? g->columns - 1 : (int)along, k = (int)place, w = (int)((place - k) * 256);
    const uint8_t *level = g->level + (size_t)((s + GRAIN_KNOT / 2) / GRAIN_KNOT) * GRAIN_MODE_PLACES + k;
    int m = ((level[0] * (256 - w) + level[1] * w) * (g->pressure[s] + 1) + (1 << 15)) >> 16;
    int score = g->score[(size_t)s * (size_t)g->rows + (size_t)row];
    float d = g->depth * g->pencil->grain->darkness[m > 255 ? 255 : m][(score + 128) >> 1];
    return d > 255 ? 255 : (int)(d + 0.5f);
}

static void darkness_of_row(const void *texture, const sample_row *at, uint8_t *out)
{
    for (int i = 0; i < at->n; i++)
        out[i] = (uint8_t)darkness(texture, at->along + i * at->along_step, at->across + i * at->across_step);
}

/* The line's own figures, and what follows from them for its places. */
static void set_line(grain *g, const line_figures *f, grain_ends ends)
{
    const grain_model *m = &g->pencil->profile->grain;
    double mean_width = clamp(exp(m->line_mean[1]), 0.5, 200);
    g->depth = (float)(f->depth / GRAIN_RELATIVE_UNIT);
    g->narrow = (float)(mean_width / f->width);
    g->half_width = (float)(mean_width / 2);
    g->half_reference = m->reference_width / 2;
    g->cap_first = ends.first == GRAIN_CORNER ? (float)(f->width / 2) : 0;
    g->cap_last = ends.last == GRAIN_CORNER ? (float)(f->width / 2) : 0;
}

bool plb_grain_make(grain *g, double length_px, grain_ends ends, const pencil *p, uint64_t seed, uint64_t identity, error *err)
{
    if (!p->grain)
        return plb_fail(err, ERROR_ARGUMENT, "the pencil '%s' was captured without its grain; --model hla draws with it", p->profile->name);
    if (!(length_px <= COLUMNS_MAX))
        return plb_fail(err, ERROR_LIMIT, "a stroke is too long");
    line_figures f = draw_line(p, random_key(seed, identity, PURPOSE_LINE));
    g->pencil = p;
    set_line(g, &f, ends);
    int columns = length_px < 1 ? 1 : (int)floor(length_px + 0.5), fold = fold_of(columns, ends);
    if (!resize(g, columns + fold, rows_of(g), err) || !make_section(g, &f, random_key(seed, identity, PURPOSE_SLOW), err))
        return false;
    make_grain(g, &f, random_key(seed, identity, PURPOSE_GRAIN), random_key(seed, identity, PURPOSE_CHAIN));
    if (fold)
        fold_joint(g, fold);
    make_pressure(g, ends);
    return true;
}

shading plb_grain_shading(grain *g, double dpi, double page_dpi)
{
    g->ragged = page_dpi > GRAIN_RAGGED_DPI ? 0.5f : 0;
    double beyond = (double)(g->cap_first > g->cap_last ? g->cap_first : g->cap_last);
    shading r = {g, darkness_of_row, false, g->rows / 2 + 0.5, beyond, dpi};
    return r;
}
