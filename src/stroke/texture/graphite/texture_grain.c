/* SPDX-License-Identifier: MIT
 *
 * This file makes one stroke's grain from its pencil's tables (plumbago(7)).
 * Input: the length of the path in pixels of 1/300 inch; a prepared pencil. Output: a grain: a field of normal numbers in the
 * strip frame, and per place the darkness to expect. texture_shade.c reads the darkness of points beside the path off them.
 *
 *   1. The line's own depth, width, roughness and correlations are drawn from their captured joint distribution.
 *   2. Its cross-section changes slowly along it: mean section plus six modes, each with a slow random coefficient.
 *   3. Grain: noise filtered beforehand, read at places of the stroke's own, joined from column to column by a chain whose
 *      coefficient is high in smooth columns and low in broken ones.
 *
 * All inner loops are on whole numbers of 16 bits, rows side by side in a register (base/simd16.h).
 */
#include "base/geometry/interpolate.h"
#include "base/simd16.h"
#include "base/simd_clones.h"
#include "base/number/random.h"
#include "stroke/pencil.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#define HALF_ROWS_MAX 40
#define STRIDE_MAX ((2 * HALF_ROWS_MAX + 1 + SIMD16_LANES - 1) / SIMD16_LANES * SIMD16_LANES)
_Static_assert(STRIDE_MAX <= NOISE_PAD, "a stroke's rows must fit into the noise's pad");
/* Half a kilometre of pencil, in columns. */
#define COLUMNS_MAX 6000000

/* The figures that a stroke draws once. */
typedef struct {
    double depth, width, roughness, along, across;
    double mode[GRAIN_MODES];
} line_figures;

void plb_grain_free(grain *g)
{
    plb_free(g->field);
    plb_free(g->level);
    plb_free(g->ends);
    memset(g, 0, sizeof *g);
}

/* ---- pressure ---- */

/* Pressure acts by these powers: on the expected darkness at a place, which in light lines leaves only the peaks; on
 * the darkness of the covered pixels; on the width; on the spread of the scores, as heavy lines fill the valleys. Chosen by
 * eye, so that the twofold range of darkness in one hand's lines (w0002 of hdBPMN: centres of 111 to 175) is that of half
 * to twice the usual pressure. (Sousa & Buchanan 2000 have the same in words.) */
typedef struct {
    double level, depth, width, spread;
} response;
static const response light = {0.5, 0.3, 0.15, -0.2}, heavy = {0.1, 0.4, 0.15, -0.25};
#define PRESSURE_MIN 0.05
#define PRESSURE_MAX 4.0

static double usual_or(double pressure)
{
    return pressure > 0 ? clamp(pressure, PRESSURE_MIN, PRESSURE_MAX) : 1;
}

/* Gives the powers that act on a line as a whole: all but the level's. */
static response respond(double pressure)
{
    const response *r = pressure < 1 ? &light : &heavy;
    return (response){.depth = pow(pressure, r->depth), .width = pow(pressure, r->width), .spread = pow(pressure, r->spread)};
}

/* Gives what the pressure at a place does to the darkness expected there. */
static float level_at(double pressure)
{
    return (float)pow(pressure, pressure < 1 ? light.level : heavy.level);
}

/* ---- buffers ---- */

static bool make_buffer(void **v, size_t *capacity, size_t need)
{
    if (need <= *capacity)
        return true;
    plb_free(*v);
    *v = plb_new(need, 1);
    *capacity = *v ? need : 0;
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
    g->stride = (rows + SIMD16_LANES - 1) / SIMD16_LANES * SIMD16_LANES;
    bool ok = make_buffer((void **)&g->field, &g->field_capacity, (size_t)columns * (size_t)g->stride) &&
              make_buffer((void **)&g->level, &g->level_capacity, knots_of(columns) * GRAIN_PLACES_PADDED) &&
              make_buffer((void **)&g->ends, &g->ends_capacity, (size_t)columns);
    return ok || plb_fail_memory(err);
}

/* ---- 1: the line ---- */

static double normal_at(const grain_tables *t, uint64_t key, uint64_t index)
{
    return t->normal[random_bits(key, index) >> 52];
}

/* How far lines of one pencil differ. From few lines, in a graded pencil two to nine, it is hardly known: then depth, width
 * and roughness keep within what a drawing by one hand shows (chosen by eye). From more it is as captured, but for outliers: beyond two
 * standard deviations and more of a hand that was measured (.20 of either; w0054 of hdBPMN). */
#define FEW_LINES 10
#define DEPTH_SPREAD_OF_FEW 0.35
#define WIDTH_SPREAD_OF_FEW 0.2
#define ROUGHNESS_SPREAD_OF_FEW 0.2
#define DEPTH_SPREAD 0.5
#define WIDTH_SPREAD 0.4

/* Tells how far figure number i of a line is off its mean, where the profile has it `x` off: of few lines softly bounded, for many lines
 * at the bound would look alike. */
static double within_spread(const profile *p, int figure, double x)
{
    static const double of_few[] = {DEPTH_SPREAD_OF_FEW, WIDTH_SPREAD_OF_FEW, ROUGHNESS_SPREAD_OF_FEW}, of_many[] = {DEPTH_SPREAD, WIDTH_SPREAD};
    if (p->lines < FEW_LINES)
        return figure < 3 ? of_few[figure] * tanh(x / of_few[figure]) : x;
    return figure < 2 ? clamp(x, -of_many[figure], of_many[figure]) : x;
}

/* Who letters takes care, and who shades keeps an even tone: strokes are more alike (by eye). */
#define CAREFUL_SPREAD 0.4
/* A fine point bears the same load on less paper: the depth goes with this power of the breadth (by eye: .72 as broad, 1.12 as dark). */
#define FINE_DEPTH (-0.35)

/* `breadth`: of the lead, times the captured line's. */
static line_figures draw_line(const pencil *p, bool careful, double breadth, uint64_t key)
{
    const grain_model *g = &p->profile->grain;
    double x[GRAIN_LINE], n[GRAIN_LINE];
    for (int i = 0; i < GRAIN_LINE; i++) {
        n[i] = normal_at(p->grain, key, (uint64_t)i);
        x[i] = 0;
        for (int j = 0; j <= i; j++)
            x[i] += g->line_factor[i][j] * n[j];
        x[i] = g->line_mean[i] + within_spread(p->profile, i, x[i]) * (careful ? CAREFUL_SPREAD : 1);
    }
    line_figures f = {clamp(exp(x[0]), 1, 254), clamp(exp(x[1]), 0.5, 200), x[2], x[3], x[4], {0}};
    f.depth = fmin(f.depth * pow(breadth, FINE_DEPTH), 254);
    f.width *= breadth;
    for (int i = 0; i < GRAIN_MODES; i++)
        f.mode[i] = g->mode_is_odd[i] ? sqrt(g->mode_between[i]) * normal_at(p->grain, key, (uint64_t)(GRAIN_LINE + i)) : x[5 + i];
    return f;
}

static int rows_of(const grain *g)
{
    double beyond = g->pencil->grain->reach - (double)g->half_reference;
    double reach = (double)g->half_width + (beyond > 0 ? beyond : 0);
    int half = (int)ceil(reach / (double)g->narrow);
    return 2 * (half < 1 ? 1 : half > HALF_ROWS_MAX ? HALF_ROWS_MAX : half) + 1;
}

/* ---- 2: the section along the line ---- */

/* The largest coefficient of a mode: section and six modes then stay within 16 bits. */
#define COEFFICIENT_MAX 3.0

static int clamp_int(int v, int low, int high)
{
    return v < low ? low : v > high ? high : v;
}

/* One knot: the square of root plus modes, times what pressure does, as levels. Roots are worked on in eighths of their unit. */
#define ROOT_MAX (2 * ROOT_UNIT)
#define GAIN_UNIT (65536.0F * GRAIN_LEVEL_UNIT / (64.0F * ROOT_UNIT * ROOT_UNIT / 65536))
_Static_assert(8 * ROOT_MAX <= INT16_MAX, "roots stay within 16 bits");

/* Returns the upper half of a product. */
static inline int16_t high_of(int16_t a, int16_t b)
{
    return (int16_t)((a * b) >> 16);
}

/* Step by step, each of which is a few instructions for all places that fit into a register. */
PLB_SIMD_CLONES static void fill_levels(const grain_tables *t, const int16_t coefficient[GRAIN_MODES], int16_t gain, uint8_t out[restrict GRAIN_PLACES_PADDED])
{
    int16_t v[GRAIN_MODE_PLACES - 1];
    for (int j = 0; j < GRAIN_MODE_PLACES - 1; j++) {
        v[j] = t->root[j];
        for (int i = 0; i < GRAIN_MODES; i++)
            v[j] = (int16_t)(v[j] + high_of(coefficient[i], t->mode[i][j]));
    }
    for (int j = 0; j < GRAIN_MODE_PLACES - 1; j++)
        v[j] = v[j] > 0 ? v[j] : 0;
    for (int j = 0; j < GRAIN_MODE_PLACES - 1; j++)
        v[j] = v[j] < ROOT_MAX ? v[j] : ROOT_MAX;
    for (int j = 0; j < GRAIN_MODE_PLACES - 1; j++)
        v[j] = (int16_t)(v[j] * 8);
    for (int j = 0; j < GRAIN_MODE_PLACES - 1; j++)
        v[j] = high_of(v[j], v[j]);
    for (int j = 0; j < GRAIN_MODE_PLACES - 1; j++)
        v[j] = (int16_t)((int16_t)(high_of(v[j], gain) + 1) >> 1);
    for (int j = 0; j < GRAIN_MODE_PLACES - 1; j++)
        v[j] = v[j] > 0 ? v[j] : 0;
    for (int j = 0; j < GRAIN_MODE_PLACES - 1; j++)
        v[j] = v[j] < 255 ? v[j] : 255;
    for (int j = 0; j < GRAIN_MODE_PLACES - 1; j++)
        out[j] = (uint8_t)v[j];
    out[0] = out[GRAIN_MODE_PLACES - 1] = 0; /* beyond, there is nothing */
}

/* Each mode's coefficient goes along its ring of slow numbers from a place of the stroke's own, in a sense of its own. */
static void make_section(grain *g, const line_figures *f, const grain_ends *ends, uint64_t key)
{
    const grain_tables *t = g->pencil->grain;
    int mean[GRAIN_MODES], sign[GRAIN_MODES];
    size_t at[GRAIN_MODES], knots = knots_of(g->columns);
    const int most = (int)(COEFFICIENT_MAX * COEFFICIENT_UNIT);
    for (int i = 0; i < GRAIN_MODES; i++) {
        uint64_t bits = random_bits(key, (uint64_t)i);
        mean[i] = (int)floor(clamp(f->mode[i], -COEFFICIENT_MAX, COEFFICIENT_MAX) * COEFFICIENT_UNIT + 0.5);
        sign[i] = bits & 1 ? 1 : -1;
        at[i] = (size_t)(bits >> 32);
    }
    float gain = level_at(usual_or((double)ends->pressure_first)) * GAIN_UNIT * 2;
    float rise = (level_at(usual_or((double)ends->pressure_last)) * GAIN_UNIT * 2 - gain) / (float)knots;
    for (size_t k = 0; k < knots; k++) {
        int16_t a[GRAIN_MODES];
        for (int i = 0; i < GRAIN_MODES; i++)
            a[i] = (int16_t)clamp_int(mean[i] + sign[i] * t->slow[i][(at[i] + k) & (SLOW_LENGTH - 1)], -most, most);
        fill_levels(t, a, (int16_t)(gain + rise * (float)k), g->level + k * GRAIN_PLACES_PADDED);
    }
}

/* ---- 3: the grain ---- */

/* The rows of a stroke differ by these figures: 16 bits each, of a unit that the loops below know. For each state of the chain (low, high,
 * first column): how much of the column before stays, how much is new, of 32768. */
enum { CHAIN_FIRST = 2, CHAIN_STATES };
typedef struct {
    int16_t keep[CHAIN_STATES][STRIDE_MAX], fresh[CHAIN_STATES][STRIDE_MAX];
    int16_t spread[STRIDE_MAX]; /* of the grain there, of 16384 */
    int16_t outer[STRIDE_MAX];  /* how far the outer rows' correlation across holds, of 32767 */
    bool has_outer[STRIDE_MAX / SIMD16_LANES]; /* whether it does in any of so many rows */
} grain_rows;

#define SPREAD_UNIT 16384

/* The chance that the next column's state is high, of 2^32: after a low and a high one. */
typedef struct {
    uint64_t next[2], first;
} chain;

static uint64_t chance(double p)
{
    return (uint64_t)(clamp(p, 0, 1) * 4294967296.0);
}

static chain chain_of(const grain_model *m)
{
    double p = m->chain_share, rho = m->chain_correlation;
    return (chain){.next = {chance(p * (1 - rho)), chance(p + rho * (1 - p))}, .first = chance(p)};
}

/* Index of the tables by place of row r. */
static int place_of_row(const grain *g, int r)
{
    float place = fabsf((float)(r - g->rows / 2)) * g->narrow * (float)(1 / ROW_PLACE_STEP);
    return place < ROW_PLACES - 1 ? (int)(place + 0.5f) : ROW_PLACES - 1;
}

/* Fills in row r: the first column's state keeps nothing of a column before. */
static void make_row(const grain_tables *t, int at, double own, int r, grain_rows *rows)
{
    rows->spread[r] = t->row_spread[at];
    rows->outer[r] = t->row_outer[at];
    for (int i = 0; i < CHAIN_FIRST; i++) {
        double a = clamp((double)((i ? t->chain_high : t->chain_low) + t->row_along[at]) + own, -0.3, 0.95);
        rows->keep[i][r] = (int16_t)floor(a * 32767 + 0.5);
        rows->fresh[i][r] = (int16_t)floor(sqrt(1 - a * a) * 32767 + 0.5);
    }
    rows->keep[CHAIN_FIRST][r] = 0;
    rows->fresh[CHAIN_FIRST][r] = INT16_MAX;
}

static void copy_row(grain_rows *rows, int from, int to)
{
    rows->spread[to] = rows->spread[from];
    rows->outer[to] = rows->outer[from];
    for (int i = 0; i < CHAIN_STATES; i++) {
        rows->keep[i][to] = rows->keep[i][from];
        rows->fresh[i][to] = rows->fresh[i][from];
    }
}

static void make_rows(const grain *g, const line_figures *f, grain_rows *rows)
{
    double own = f->along - (double)g->pencil->profile->grain.line_mean[3];
    const int middle = g->rows / 2;
    memset(rows->has_outer, 0, sizeof rows->has_outer);
    /* The section is symmetric: a row on the other side is the same. */
    for (int r = middle; r < g->stride; r++) {
        make_row(g->pencil->grain, place_of_row(g, r), own, r, rows);
        if (r > middle && r <= 2 * middle)
            copy_row(rows, r, 2 * middle - r);
    }
    for (int r = 0; r < g->stride; r++)
        rows->has_outer[r / SIMD16_LANES] |= rows->outer[r] > 0;
}

/* Innovations: what the white noise of the columns about them comes to after the filter. `from`: the columns' places in the
 * noise, the oldest one's first. */
static inline lanes noise_at(const int16_t *const from[GRAIN_TAPS], ptrdiff_t at)
{
    return simd16_at(from[0] + at) + simd16_at(from[1] + at) + simd16_at(from[2] + at) + simd16_at(from[3] + at) + simd16_at(from[4] + at);
}

/* Computes the next column of the chain, into `field`, and the same as bytes, with its place's and its patch's spread, into `out`. Outer
 * rows' innovations go over into the same noise through another filter, which lies `to_outer` beyond the inner one's. */
static void make_column(const grain_rows *w, int state, int rows, const int16_t *const from[GRAIN_TAPS], ptrdiff_t to_outer,
                        const int8_t *amplitude, int16_t *field, int8_t *out)
{
    for (int r = 0; r < rows; r += SIMD16_LANES) {
        lanes fresh = noise_at(from, r);
        if (w->has_outer[r / SIMD16_LANES])
            fresh += simd16_high(noise_at(from, r + to_outer) - fresh, simd16_at(w->outer + r)) * 2;
        lanes v = (simd16_high(simd16_at(field + r), simd16_at(w->keep[state] + r)) + simd16_high(fresh, simd16_at(w->fresh[state] + r))) * 2;
        simd16_put(field + r, v);
        v = (simd16_high(simd16_high(v, simd16_at(w->spread + r)), simd16_of_bytes(amplitude + r)) + 2) >> 2;
        simd16_put_bytes(out + r, simd16_within(v, -127, 127));
    }
}
_Static_assert(NOISE_UNIT / FIELD_UNIT == 1 << 6 && SPREAD_UNIT == 1 << 14 && AMPLITUDE_UNIT == 1 << 6 && GRAIN_TAPS == 5,
               "the loops above shift by these");

static int class_of(double across)
{
    return (int)clamp(floor(across * 10 + 0.5), 0, GRAIN_CLASSES - 1);
}

static void make_grain(grain *g, const line_figures *f, uint64_t key)
{
    const grain_tables *t = g->pencil->grain;
    const int16_t(*inner)[NOISE_LENGTH + NOISE_PAD] = t->noise[class_of(f->across)];
    const int16_t(*outer)[NOISE_LENGTH + NOISE_PAD] = t->noise[class_of(f->across + (double)t->outer_across)];
    chain c = chain_of(&g->pencil->profile->grain);
    grain_rows rows;
    int16_t state[STRIDE_MAX] = {0};
    size_t at[GRAIN_TAPS]; /* places in the noise, the oldest column's first */
    make_rows(g, f, &rows);
    for (int i = 1; i < GRAIN_TAPS; i++)
        at[i] = random_bits(key, (uint64_t)(i - 1)) & (NOISE_LENGTH - 1);
    uint64_t threshold = c.first, region = random_bits(key, (uint64_t)g->columns + GRAIN_TAPS);
    size_t column = (size_t)(region & (AMPLITUDE_LENGTH - 1)), row = (size_t)((region >> 32) % NOISE_PAD);
    for (int s = 0; s < g->columns; s++) {
        uint64_t bits = random_bits(key, (uint64_t)(s + GRAIN_TAPS - 1));
        int high = bits >> 32 < threshold;
        const int16_t *from[GRAIN_TAPS];
        threshold = c.next[high];
        for (int i = 0; i + 1 < GRAIN_TAPS; i++)
            at[i] = at[i + 1];
        at[GRAIN_TAPS - 1] = bits & (NOISE_LENGTH - 1);
        for (int i = 0; i < GRAIN_TAPS; i++)
            from[i] = inner[i] + at[i];
        make_column(&rows, s ? high : CHAIN_FIRST, g->rows, from, outer[0] - inner[0],
                    t->amplitude[(column + (size_t)s) & (AMPLITUDE_LENGTH - 1)] + row, state, g->field + (size_t)s * (size_t)g->stride);
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

static void make_ends(grain *g, grain_ends ends)
{
    double stretch = g->columns < MEASURED_PX ? MEASURED_PX / g->columns : 1;
    int n = g->columns, faded = (int)ceil(where_px[8] / stretch);
    memset(g->ends, 255, (size_t)n);
    g->plain_first = ends.first == GRAIN_START || ends.first == GRAIN_LEAVE ? faded : 0;
    g->plain_last = n - 1 - (ends.last == GRAIN_START || ends.last == GRAIN_LEAVE ? faded : 0);
    for (int s = 0; s < n; s = s == g->plain_first - 1 && s < g->plain_last ? g->plain_last + 1 : s + 1) {
        double from_first = (s + 0.5) * stretch, from_last = (n - s - 0.5) * stretch;
        g->ends[s] = (uint8_t)floor(255 * share_of(ends.first, from_first) * share_of(ends.last, from_last) + 0.5);
    }
}

/* ---- the joint of closed strokes ---- */

/* So many columns, a whole number of knots, go over into those before the beginning. */
static int fold_of(int columns, grain_ends ends)
{
    int fold = columns / 2 / GRAIN_KNOT * GRAIN_KNOT;
    return ends.first != GRAIN_JOINT ? 0 : fold < 64 ? fold : 64;
}

/* `g` was made `fold` columns too long. Its first ones lead up to the beginning; its last ones fade over into them: the field
 * with weights whose squares sum to 1, levels with weights that do. */
static void fold_joint(grain *g, int fold)
{
    size_t rows = (size_t)g->stride, n = (size_t)(g->columns - fold), places = GRAIN_PLACES_PADDED;
    for (size_t i = 0; i < (size_t)fold; i++) {
        double w = ((double)i + 0.5) / fold, keep = sqrt(1 - w), join = sqrt(w);
        int8_t *late = g->field + (n + i) * rows, *early = g->field + i * rows;
        for (size_t r = 0; r < rows; r++)
            late[r] = (int8_t)floor(clamp(keep * late[r] + join * early[r], -127, 127) + 0.5);
    }
    memmove(g->field, g->field + (size_t)fold * rows, n * rows);
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

/* ---- all of it ---- */

/* Applies the stroke's mean pressure to the line as a whole. No line is deeper than the darkest hundredth of the pencil's usual
 * ones: then its valleys still show. */
static void press(grain *g, line_figures *f, double pressure)
{
    const paper *on = &g->pencil->grain->paper;
    response r = respond(pressure);
    double deepest = fmax(f->depth, 255 - g->pencil->profile->min_mid);
    f->depth = clamp(f->depth * r.depth, 1, deepest < 254 ? deepest : 254);
    f->width = clamp(f->width * r.width, 0.5, 200);
    g->weight_field = (int)floor(sqrt(1 - on->share) * r.spread * 256 + 0.5);
    g->weight_paper = (int)floor(sqrt(on->share) * r.spread * 256 + 0.5);
}

/* Computes the line's own figures, and what follows from them for its places. */
static void set_line(grain *g, const line_figures *f, grain_ends ends)
{
    const grain_model *m = &g->pencil->profile->grain;
    double mean_width = clamp(exp(m->line_mean[1]), 0.5, 200);
    int rough = (int)floor(f->roughness / ROUGH_LOG_STEP + 0.5) + ROUGH_CLASSES / 2;
    g->score_correction = g->pencil->grain->score_correction[clamp_int(rough, 0, ROUGH_CLASSES - 1)];
    g->depth = (uint32_t)(f->depth * 256);
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
    line_figures f = draw_line(p, ends.careful, ends.breadth > 0 ? (double)ends.breadth : 1, random_key(seed, identity, PURPOSE_LINE));
    g->pencil = p;
    press(g, &f, sqrt(usual_or((double)ends.pressure_first) * usual_or((double)ends.pressure_last)));
    set_line(g, &f, ends);
    int columns = length_px < 1 ? 1 : (int)floor(length_px + 0.5), fold = fold_of(columns, ends);
    if (!resize(g, columns + fold, rows_of(g), err))
        return false;
    g->sheet = plb_paper_sheet(seed);
    make_section(g, &f, &ends, random_key(seed, identity, PURPOSE_SLOW));
    make_grain(g, &f, random_key(seed, identity, PURPOSE_GRAIN));
    if (fold)
        fold_joint(g, fold);
    make_ends(g, ends);
    return true;
}
