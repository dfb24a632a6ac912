/* SPDX-License-Identifier: MIT
 *
 * The tenth step of the capture finds the filter that makes the chain's innovations from white noise. First the covariance
 * of the innovations with which the chain's output has the covariance measured (least squares with a ridge), then its
 * spectral root.
 */
#include "profile/grain/grain.h"

#include "profile/grain/grain_math.h"

#include <math.h>

#define RIDGE 0.01            /* the square of 0.1 */
#define CLASS_STEP 0.1        /* of correlation across */
#define MIN_FILTER_ACROSS 0.02
#define SPECTRUM_SIDE 32               /* of the spectrum */
#define MIN_POWER 1e-3
#define FILTER_REACH (GRAIN_TAPS / 2)
#define TURN 6.283185307179586

/* Column c of the innovations' covariance by lag along, from column c of the wanted one; `first`: that at lag 0 is 1. */
static void solve_column(const double response[GRAIN_LAGS][GRAIN_LAGS], const double wanted[GRAIN_LAGS], bool first, double out[GRAIN_LAGS])
{
    double a[GRAIN_LAGS * GRAIN_LAGS], b[GRAIN_LAGS];
    int from = first ? 1 : 0, n = GRAIN_LAGS - from;
    for (int i = 0; i < n; i++) {
        b[i] = 0;
        for (int d = 0; d < GRAIN_LAGS; d++)
            b[i] += response[d][i + from] * (wanted[d] - (first ? response[d][0] : 0));
        for (int j = 0; j < n; j++) {
            a[i * n + j] = i == j ? RIDGE : 0;
            for (int d = 0; d < GRAIN_LAGS; d++)
                a[i * n + j] += response[d][i + from] * response[d][j + from];
        }
    }
    out[0] = 1;
    bool good = plb_solve(a, b, n); /* the ridge makes it positive definite */
    for (int i = 0; i < n; i++)
        out[i + from] = good ? b[i] : 0;
}

/* Computes the spectrum of an array that is even along both axes, given by its first lags. */
static void spectrum(const double covariance[GRAIN_LAGS][GRAIN_ASIDE], const double cosine[SPECTRUM_SIDE], double power[SPECTRUM_SIDE][SPECTRUM_SIDE])
{
    for (int u = 0; u < SPECTRUM_SIDE; u++)
        for (int v = 0; v < SPECTRUM_SIDE; v++) {
            power[u][v] = 0;
            for (int d = 0; d < GRAIN_LAGS; d++)
                for (int c = 0; c < GRAIN_ASIDE; c++)
                    power[u][v] += covariance[d][c] * (d ? 2 : 1) * (c ? 2 : 1) * cosine[u * d % SPECTRUM_SIDE] * cosine[v * c % SPECTRUM_SIDE];
        }
}

/* Gives the tap d columns and c rows from the middle, not normalised. */
static double tap(const double power[SPECTRUM_SIDE][SPECTRUM_SIDE], const double cosine[SPECTRUM_SIDE], int d, int c)
{
    double sum = 0;
    for (int u = 0; u < SPECTRUM_SIDE; u++)
        for (int v = 0; v < SPECTRUM_SIDE; v++)
            sum += sqrt(fmax(power[u][v], MIN_POWER)) * cosine[u * d % SPECTRUM_SIDE] * cosine[v * c % SPECTRUM_SIDE];
    return sum;
}

/* Computes the middle of the root of the spectrum, with unit energy. */
static void root_filter(const double covariance[GRAIN_LAGS][GRAIN_ASIDE], float out[GRAIN_TAPS][GRAIN_TAPS])
{
    double cosine[SPECTRUM_SIDE], power[SPECTRUM_SIDE][SPECTRUM_SIDE], h[GRAIN_TAPS][GRAIN_TAPS], energy = 0;
    for (int i = 0; i < SPECTRUM_SIDE; i++)
        cosine[i] = cos(TURN * i / SPECTRUM_SIDE);
    spectrum(covariance, cosine, power);
    for (int d = -FILTER_REACH; d <= FILTER_REACH; d++)
        for (int c = -FILTER_REACH; c <= FILTER_REACH; c++) {
            double t = tap((const double(*)[SPECTRUM_SIDE])power, cosine, d < 0 ? -d : d, c < 0 ? -c : c);
            h[d + FILTER_REACH][c + FILTER_REACH] = t;
            energy += t * t;
        }
    for (int i = 0; i < GRAIN_TAPS * GRAIN_TAPS; i++)
        out[i / GRAIN_TAPS][i % GRAIN_TAPS] = (float)(h[i / GRAIN_TAPS][i % GRAIN_TAPS] / sqrt(energy));
}

void plb_grain_solve_filter(double response[GRAIN_LAGS][GRAIN_LAGS], double wanted[GRAIN_LAGS][GRAIN_ASIDE], float out[GRAIN_TAPS][GRAIN_TAPS])
{
    double covariance[GRAIN_LAGS][GRAIN_ASIDE];
    for (int c = 0; c < GRAIN_ASIDE; c++) {
        double column[GRAIN_LAGS], solved[GRAIN_LAGS];
        for (int d = 0; d < GRAIN_LAGS; d++)
            column[d] = wanted[d][c];
        solve_column((const double(*)[GRAIN_LAGS])response, column, c == 0, solved);
        for (int d = 0; d < GRAIN_LAGS; d++)
            covariance[d][c] = solved[d];
    }
    root_filter((const double(*)[GRAIN_ASIDE])covariance, out);
}

void plb_grain_filter(const grain_moments *m, grain_model *g)
{
    double response[GRAIN_LAGS][GRAIN_LAGS], wanted[GRAIN_LAGS][GRAIN_ASIDE];
    plb_grain_chain_response(g, response);
    for (int class = 0; class < GRAIN_CLASSES; class++) {
        for (int d = 0; d < GRAIN_LAGS; d++)
            for (int c = 0; c < GRAIN_ASIDE; c++)
                wanted[d][c] = m->correlation[d][c] * (c == 1 ? class * CLASS_STEP / fmax(m->correlation[0][1], MIN_FILTER_ACROSS) : 1);
        plb_grain_solve_filter(response, wanted, g->filter[class]);
    }
}
