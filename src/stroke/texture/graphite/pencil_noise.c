/* SPDX-License-Identifier: MIT
 *
 * This file prepares noise once for all strokes of a pencil. A stroke reads it at random addresses of its own.
 * Input: the profile's filters, chain and slow modes; the paper. Output: grain_tables.noise, .slow.
 *
 * The grain's innovations are white noise through a filter of GRAIN_TAPS columns. A column of white noise is a window of one
 * long sequence, at a random place; so what it adds to each of the columns about it is a window, at the same place, of
 * that sequence filtered by one column of the filter. Filtering once per pencil instead of once per stroke leaves
 * a few additions a column. A window of some twenty numbers at one of 2048 places, five such summed in each column: no
 * section of a stroke ever comes again.
 */
#include "base/array.h"
#include "base/geometry/interpolate.h"
#include "base/number/random.h"
#include "profile/grain/grain.h"
#include "stroke/pencil.h"

#include <math.h>

/* ---- the sequence ---- */

/* By chance a sequence of this length correlates with itself by some .02, and all strokes would show it across. Of the first
 * thousand orders this has the least: below .0073 at 1 to 6 numbers apart, its squares below .03. */
#define ORDER 405

/* Every other normal number once, in random order: mean and variance are exact. */
static void shuffle(const grain_tables *t, float out[NOISE_LENGTH])
{
    uint64_t key = random_key(0, ORDER, PURPOSE_GRAIN);
    for (int k = 0; k < NOISE_LENGTH; k++)
        out[k] = t->normal[k * (GRAIN_NORMALS / NOISE_LENGTH) + k % 2]; /* alternately, so that no side is preferred */
    for (int k = NOISE_LENGTH - 1; k > 0; k--) {
        int other = (int)((random_bits(key, (uint64_t)k) >> 32) * (uint64_t)(k + 1) >> 32);
        float v = out[k];
        out[k] = out[other];
        out[other] = v;
    }
}

static int16_t fixed(float v)
{
    return (int16_t)floorf((v > 32767 ? 32767 : v < -32767 ? -32767 : v) + 0.5f);
}

static void filter_sequence(const float white[NOISE_LENGTH], const float tap[GRAIN_TAPS], int16_t out[NOISE_LENGTH + NOISE_PAD])
{
    float row[NOISE_LENGTH + GRAIN_TAPS];
    for (int k = 0; k < NOISE_LENGTH + GRAIN_TAPS; k++)
        row[k] = white[k & (NOISE_LENGTH - 1)] * NOISE_UNIT;
    for (int k = 0; k < NOISE_LENGTH; k++) {
        float sum = 0;
        for (int j = 0; j < GRAIN_TAPS; j++)
            sum += tap[j] * row[k + j];
        out[k] = fixed(sum);
    }
    for (int k = 0; k < NOISE_PAD; k++)
        out[NOISE_LENGTH + k] = out[k];
}

/* ---- the filters ---- */

#define CHAIN_MAX 0.93 /* as in the capture */

/* Computes the correlation that a filter of the profile and the chain give together. */
static void correlation_of(const float tap[GRAIN_TAPS][GRAIN_TAPS], double response[GRAIN_LAGS][GRAIN_LAGS], double out[GRAIN_LAGS][GRAIN_ASIDE])
{
    double own[GRAIN_LAGS][GRAIN_ASIDE] = {{0}};
    for (int e = 0; e < GRAIN_LAGS; e++)
        for (int c = 0; c < GRAIN_ASIDE; c++)
            for (int i = 0; i + e < GRAIN_TAPS; i++)
                for (int j = 0; j + c < GRAIN_TAPS; j++)
                    own[e][c] += (double)tap[i][j] * tap[i + e][j + c];
    for (int d = 0; d < GRAIN_LAGS; d++)
        for (int c = 0; c < GRAIN_ASIDE; c++) {
            out[d][c] = 0;
            for (int e = 0; e < GRAIN_LAGS; e++)
                out[d][c] += response[d][e] * own[e][c];
        }
}

static double of_paper(const paper *p, int d, int c)
{
    return d < PAPER_LAGS && c < PAPER_LAGS ? p->correlation[d] * p->correlation[c] : 0;
}

/* Leaves the stroke's own grain the correlation beyond the paper's share: both together correlate as captured. */
static void without_paper(const paper *p, double correlation[GRAIN_LAGS][GRAIN_ASIDE])
{
    for (int d = 0; d < GRAIN_LAGS; d++)
        for (int c = 0; c < GRAIN_ASIDE; c++)
            correlation[d][c] = (correlation[d][c] - p->share * of_paper(p, d, c)) / (1 - p->share);
}

/* The strokes' own grain is by turns smoother and more broken than both together are. */
static void spread_chain(grain_tables *t, const grain_model *g)
{
    double p = g->chain_share, mean = p * g->chain_high + (1 - p) * g->chain_low, more = 1 / (1 - t->paper.share);
    double high = fmin(mean + (g->chain_high - mean) * more, fmax(g->chain_high, CHAIN_MAX));
    t->chain_high = (float)high;
    t->chain_low = (float)fmax(p < 1 ? (mean - p * high) / (1 - p) : mean, -CHAIN_MAX);
}

void plb_pencil_tabulate_noise(grain_tables *t, const grain_model *g)
{
    float white[NOISE_LENGTH];
    double response[GRAIN_LAGS][GRAIN_LAGS], own_response[GRAIN_LAGS][GRAIN_LAGS], wanted[GRAIN_LAGS][GRAIN_ASIDE];
    grain_model own_chain = {.chain_share = g->chain_share, .chain_correlation = g->chain_correlation};
    shuffle(t, white);
    spread_chain(t, g);
    own_chain.chain_high = t->chain_high;
    own_chain.chain_low = t->chain_low;
    plb_grain_chain_response(g, response);
    plb_grain_chain_response(&own_chain, own_response);
    for (int class = 0; class < GRAIN_CLASSES; class++) {
        float own[GRAIN_TAPS][GRAIN_TAPS];
        const float(*tap)[GRAIN_TAPS] = g->filter[class];
        if (t->paper.share > 0) {
            correlation_of(g->filter[class], response, wanted);
            without_paper(&t->paper, wanted);
            plb_grain_solve_filter(own_response, wanted, own);
            tap = (const float(*)[GRAIN_TAPS])own;
        }
        for (int i = 0; i < GRAIN_TAPS; i++)
            filter_sequence(white, tap[i], t->noise[class][i]);
    }
}

/* ---- amplitudes ---- */

/* Patches of a line are rough, others smooth: over so many columns the logarithm of the grain's amplitude keeps 1/e of its
 * deviation (w0054 of hdBPMN; w0028 8). */
#define PATCH_COLUMNS 7.0
#define MAX_NOISE_ACROSS 0.7 /* by three rows neighbours cannot correlate by more than the root of a half */

/* Gives the weight of the outer two of the three rows that make a row of amplitudes, so that neighbours correlate by r. */
static double weight_beside(double r)
{
    return (1 - sqrt(1 - 2 * r * r)) / (2 * r);
}

#define AMPLITUDE_ROWS (2 * NOISE_PAD)

static void step_amplitudes(double state[AMPLITUDE_ROWS], double keep, const float normal[AMPLITUDE_ROWS])
{
    double fresh = sqrt(1 - keep * keep);
    for (int r = 0; r < AMPLITUDE_ROWS; r++)
        state[r] = keep * state[r] + fresh * (double)normal[r];
}

/* Two rounds of the ring, as of the slow changes below; both take the same numbers. */
bool plb_pencil_tabulate_amplitude(grain_tables *t, const grain_model *g)
{
    enum { ROWS = AMPLITUDE_ROWS };
    double keep = exp(-1 / PATCH_COLUMNS), k = weight_beside(clamp((double)g->volatility_across, 0.01, MAX_NOISE_ACROSS));
    double state[ROWS] = {0}, unit = (double)g->volatility / sqrt(1 + 2 * k * k);
    float(*normal)[ROWS] = plb_new(AMPLITUDE_LENGTH, sizeof *normal);
    uint64_t key = random_key(0, 0, PURPOSE_CHAIN);
    if (!normal)
        return false;
    for (int column = 0; column < AMPLITUDE_LENGTH; column++) {
        for (int r = 0; r < ROWS; r++)
            normal[column][r] = t->normal[random_bits(key, (uint64_t)(column * ROWS + r)) >> 52];
        step_amplitudes(state, keep, normal[column]);
    }
    for (int column = 0; column < AMPLITUDE_LENGTH; column++) {
        step_amplitudes(state, keep, normal[column]);
        for (int r = 0; r < ROWS; r++) {
            double v = exp(unit * (state[r] + k * (state[r > 0 ? r - 1 : ROWS - 1] + state[r + 1 < ROWS ? r + 1 : 0]))) * AMPLITUDE_UNIT + 0.5;
            t->amplitude[column][r] = (int8_t)(v < 128 ? v : 127);
        }
    }
    plb_free(normal);
    return true;
}

/* ---- slow changes ---- */

/* An Ornstein-Uhlenbeck process on a ring: a first round finds the state in which the second begins. */
static void ring_process(const grain_tables *t, uint64_t key, double keep, float out[SLOW_LENGTH])
{
    float state = 0, k1 = (float)keep, k2 = (float)sqrt(1 - keep * keep);
    for (int k = 0; k < 2 * SLOW_LENGTH; k++) {
        state = k1 * state + k2 * t->normal[random_bits(key, (uint64_t)(k & (SLOW_LENGTH - 1))) >> 52];
        out[k & (SLOW_LENGTH - 1)] = state;
    }
}

#define SMOOTH_KNOTS 6 /* the Gaussian along the line reaches three sigma to either side */

static void smooth_ring(const float in[SLOW_LENGTH], float out[SLOW_LENGTH])
{
    float weight[2 * SMOOTH_KNOTS + 1], round[SLOW_LENGTH + 2 * SMOOTH_KNOTS];
    for (int i = -SMOOTH_KNOTS; i <= SMOOTH_KNOTS; i++)
        weight[i + SMOOTH_KNOTS] = (float)exp(-i * i * (GRAIN_KNOT * GRAIN_KNOT / (2 * GRAIN_SMOOTH * GRAIN_SMOOTH)));
    for (int k = 0; k < SLOW_LENGTH + 2 * SMOOTH_KNOTS; k++)
        round[k] = in[(k - SMOOTH_KNOTS) & (SLOW_LENGTH - 1)];
    for (int k = 0; k < SLOW_LENGTH; k++) {
        out[k] = 0;
        for (int i = 0; i <= 2 * SMOOTH_KNOTS; i++)
            out[k] += weight[i] * round[k + i];
    }
}

/* To mean 0 and the variance captured, in fixed point. */
static void normalise(const float in[SLOW_LENGTH], double variance, int16_t out[SLOW_LENGTH])
{
    double mean = 0, own = 0;
    for (int k = 0; k < SLOW_LENGTH; k++)
        mean += in[k] / SLOW_LENGTH;
    for (int k = 0; k < SLOW_LENGTH; k++)
        own += (in[k] - mean) * (in[k] - mean) / SLOW_LENGTH;
    double scale = own > 0 ? sqrt(variance / own) * COEFFICIENT_UNIT : 0;
    for (int k = 0; k < SLOW_LENGTH; k++)
        out[k] = fixed((float)((in[k] - mean) * scale));
}

/* Each mode's coefficient is an Ornstein-Uhlenbeck process smoothed by the Gaussian with which it was captured, here
 * from knot to knot. */
void plb_pencil_tabulate_slow(grain_tables *t, const grain_model *g)
{
    float raw[SLOW_LENGTH], smooth[SLOW_LENGTH];
    for (int i = 0; i < GRAIN_MODES; i++) {
        ring_process(t, random_key(0, (uint64_t)i, PURPOSE_SLOW), exp(-GRAIN_KNOT / (double)g->mode_length[i]), raw);
        smooth_ring(raw, smooth);
        normalise(smooth, g->mode_within[i], t->slow[i]);
    }
}
