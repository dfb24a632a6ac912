/* SPDX-License-Identifier: MIT
 *
 * Capture of the grain, eighth step: the chain. The scores of a column are those of the one before it times a coefficient,
 * the same in all rows, plus innovations. The coefficient has two values, high (smooth) and low (broken), in a Markov
 * chain: lines are alternately smooth and broken over their whole width.
 */
#include "profile/grain.h"

#include "profile/grain_math.h"

#include "base/random.h"

#include <math.h>

#define SHARE_HIGH 0.42      /* of the columns; chosen by eye */
#define COMMON_GAIN 0.7      /* of the common steps the chain makes; chosen by eye */
#define LEAST_SPREAD 0.04    /* below it the coefficient is constant */
#define MOST_MEAN 0.9
#define MOST_HIGH 0.93
#define LOWEST (-0.95)
#define MOST_PERSISTENT 0.8
#define SAMPLES 60000        /* columns simulated for the response */
#define MEMORY 12            /* columns after which an innovation is forgotten */

void plb_grain_chain(const grain_moments *m, grain_model *g)
{
    const double p = SHARE_HIGH;
    double mean = clamp(m->correlation[1][0], 0, MOST_MEAN), spread = sqrt(fmax(m->common * COMMON_GAIN, 0)) * (1 - mean), rho = 0;
    if (spread < LEAST_SPREAD)
        spread = 0;
    if (spread > 0)
        rho = clamp((m->correlation[2][0] - mean * mean) / (spread * spread), -p / (1 - p), MOST_PERSISTENT);
    double high = mean + spread * sqrt((1 - p) / p), low = mean - spread * sqrt(p / (1 - p));
    if (high > MOST_HIGH) {
        high = MOST_HIGH;
        low = (mean - p * high) / (1 - p);
    }
    g->chain_high = (float)high;
    g->chain_low = (float)fmax(low, LOWEST);
    g->chain_share = (float)p;
    g->chain_correlation = (float)rho;
}

/* One column on: the coefficient of the new one. */
static double next_coefficient(const grain_model *g, uint64_t key, uint64_t column, bool *high)
{
    double p = g->chain_share, rho = g->chain_correlation;
    double a = *high ? g->chain_high : g->chain_low;
    *high = random_unit(key, column) < (*high ? p + rho * (1 - p) : p * (1 - rho));
    return a;
}

/* How much of the innovation of the column k before is in this one; `past`: coefficients, the newest first. */
static void memory_of(const double past[MEMORY], double share[MEMORY])
{
    double product = 1;
    for (int k = 0; k < MEMORY; k++) {
        share[k] = product * sqrt(1 - past[k] * past[k]);
        product *= past[k];
    }
}

/* Adds the covariance of columns `lag` apart that innovations of all lags make. */
static void add_response(const double before[MEMORY], const double now[MEMORY], int lag, double response[GRAIN_LAGS])
{
    for (int k = 0; k < MEMORY; k++)
        for (int q = 0; q < MEMORY; q++) {
            int apart = lag + k - q < 0 ? q - k - lag : lag + k - q;
            if (apart < GRAIN_LAGS)
                response[apart] += before[k] * now[q] / SAMPLES;
        }
}

void plb_grain_chain_response(const grain_model *g, double response[GRAIN_LAGS][GRAIN_LAGS])
{
    uint64_t key = random_key(0, 0, PURPOSE_CHAIN);
    double past[MEMORY] = {0}, shares[GRAIN_LAGS][MEMORY] = {{0}};
    bool high = false;
    for (int d = 0; d < GRAIN_LAGS; d++)
        for (int e = 0; e < GRAIN_LAGS; e++)
            response[d][e] = 0;
    for (int x = 0; x < SAMPLES + 2 * MEMORY; x++) {
        for (int k = MEMORY - 1; k > 0; k--)
            past[k] = past[k - 1];
        past[0] = next_coefficient(g, key, (uint64_t)x, &high);
        memory_of(past, shares[x % GRAIN_LAGS]);
        for (int d = 0; d < GRAIN_LAGS && x >= 2 * MEMORY; d++)
            add_response(shares[(x - d) % GRAIN_LAGS], shares[x % GRAIN_LAGS], d, response[d]);
    }
}
