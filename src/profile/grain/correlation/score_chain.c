/* SPDX-License-Identifier: MIT
 *
 * The ninth step of the capture fits the chain. The scores of a column are those of the one before it times a coefficient,
 * the same in all rows, plus innovations. The coefficient has two values, high (smooth) and low (broken), in a Markov
 * chain: lines are alternately smooth and broken over their whole width.
 */
#include "profile/grain/grain.h"

#include "profile/grain/grain_math.h"

#include <math.h>

#define SHARE_HIGH 0.42      /* of the columns; chosen by eye */
#define COMMON_GAIN 0.7      /* of the common steps the chain makes; chosen by eye */
#define MIN_SPREAD 0.04    /* below it the coefficient is constant */
#define LONG_MEAN 0.45       /* up to here the chain alone makes the correlation along; beyond, the less the more there is … */
#define MIN_LONG_MEAN 0.15 /* … down to here: its memory is too long for the blur of a soft scan; both chosen by trial */
#define MAX_HIGH 0.93
#define LOWEST (-0.95)
#define MAX_PERSISTENT 0.8
#define MEMORY 12            /* columns after which an innovation is forgotten */

/* Gives the chain's part of the correlation with the next column. The rest is the filter's. */
static double mean_of(const grain_moments *m)
{
    double next = m->correlation[1][0], beyond = fmax(0, next - LONG_MEAN);
    return clamp(next - 2 * beyond, beyond > 0 ? MIN_LONG_MEAN : 0, LONG_MEAN);
}

void plb_grain_chain(const grain_moments *m, grain_model *g)
{
    const double p = SHARE_HIGH;
    double mean = mean_of(m), spread = sqrt(fmax(m->common * COMMON_GAIN, 0)) * (1 - mean), rho = 0;
    if (spread < MIN_SPREAD)
        spread = 0;
    if (spread > 0)
        rho = clamp((m->correlation[2][0] - mean * mean) / (spread * spread), -p / (1 - p), MAX_PERSISTENT);
    double high = mean + spread * sqrt((1 - p) / p), low = mean - spread * sqrt(p / (1 - p));
    if (high > MAX_HIGH) {
        high = MAX_HIGH;
        low = (mean - p * high) / (1 - p);
    }
    g->chain_high = (float)high;
    g->chain_low = (float)fmax(low, LOWEST);
    g->chain_share = (float)p;
    g->chain_correlation = (float)rho;
}

/* A product over columns, oldest first, of numbers that depend on each column's state: its mean over the chain. */
typedef struct {
    double high, low; /* mean of the product so far where the newest column is in this state, times the state's share */
} chain_mean;

/* Gives the factor by which column number `column` before the newest (0: the newest) multiplies the innovation of the column `age` before, for one
 * coefficient: the innovation comes in with sqrt(1 - a^2) and is multiplied by every later coefficient. */
static double passage(double a, int column, int age)
{
    return column > age ? 1 : column == age ? sqrt(1 - a * a) : a;
}

/* Mean of the product of what is left of two innovations: that of the column `lag` + k before in the column `lag` before,
 * and that of the column q before in the newest. */
static double mean_product(const grain_model *g, int lag, int k, int q)
{
    double p = g->chain_share, rho = g->chain_correlation, a[2] = {g->chain_low, g->chain_high};
    chain_mean m = {p, 1 - p};
    int oldest = lag + k > q ? lag + k : q;
    for (int c = oldest; c >= 0; c--) {
        double f[2];
        for (int i = 0; i < 2; i++)
            f[i] = passage(a[i], c, q) * (c >= lag ? passage(a[i], c - lag, k) : 1);
        if (c < oldest)
            m = (chain_mean){m.high * (p + rho * (1 - p)) + m.low * p * (1 - rho), m.high * (1 - p - rho * (1 - p)) + m.low * (1 - p * (1 - rho))};
        m.high *= f[1];
        m.low *= f[0];
    }
    return m.high + m.low;
}

void plb_grain_chain_response(const grain_model *g, double response[GRAIN_LAGS][GRAIN_LAGS])
{
    for (int d = 0; d < GRAIN_LAGS; d++) {
        for (int e = 0; e < GRAIN_LAGS; e++)
            response[d][e] = 0;
        for (int k = 0; k < MEMORY; k++)
            for (int q = 0; q < MEMORY; q++) {
                int apart = d + k - q < 0 ? q - k - d : d + k - q;
                if (apart < GRAIN_LAGS)
                    response[d][apart] += mean_product(g, d, k, q);
            }
    }
}
