/* SPDX-License-Identifier: MIT
 *
 * The fourth step of the capture measures how the coefficients of the modes vary, between lines and along them.
 *
 * Along a line a coefficient is an Ornstein-Uhlenbeck process smoothed by the Gaussian that the capture smooths with: its
 * length is the one whose smoothed process has the correlation measured after smoothing.
 */
#include "profile/grain/grain.h"

#include <math.h>

#define KERNEL_RADIUS 65 /* eight sigma */

static const int lags[] = {12, 24, 40};                                    /* px; closer ones are the smoothing's own */
static const double lengths[] = {1, 4, 8, 12, 16, 24, 32, 48, 64, 96, 128}; /* px, tried in turn */
#define LAGS (sizeof lags / sizeof *lags)
#define LENGTHS (sizeof lengths / sizeof *lengths)

/* Covariance at `lag` of the smoothed process of unit variance; a Gaussian twice is one of root two times the width. */
static double smoothed_covariance(double length, int lag)
{
    double sum = 0, weights = 0;
    for (int k = -KERNEL_RADIUS; k <= KERNEL_RADIUS; k++) {
        double w = exp(-k * k / (4 * GRAIN_SMOOTH * GRAIN_SMOOTH));
        sum += w * exp(-fabs((double)(k + lag)) / length);
        weights += w;
    }
    return sum / weights;
}

/* Gives the length whose correlations are nearest those measured. */
static double length_of(const double correlation[LAGS])
{
    double best = lengths[0], least = HUGE_VAL;
    for (size_t i = 0; i < LENGTHS; i++) {
        double misfit = 0, variance = smoothed_covariance(lengths[i], 0);
        for (size_t j = 0; j < LAGS; j++) {
            double d = smoothed_covariance(lengths[i], lags[j]) / variance - correlation[j];
            misfit += d * d;
        }
        if (misfit < least) {
            least = misfit;
            best = lengths[i];
        }
    }
    return best;
}

static void average(grain_line *l)
{
    for (int i = 0; i < GRAIN_MODES; i++) {
        l->mean[i] = 0;
        for (int k = 0; k < l->n; k++)
            l->mean[i] += l->usable[k] ? l->coefficient[k][i] / l->columns : 0;
    }
}

/* Gives the mean product of deviations `lag` columns apart, times the columns of the line. */
static double products(const grain_line *l, int mode, int lag)
{
    double sum = 0, n = 0;
    for (int k = 0; k + lag < l->n; k++)
        if (l->usable[k] && l->usable[k + lag]) {
            sum += (l->coefficient[k][mode] - l->mean[mode]) * (l->coefficient[k + lag][mode] - l->mean[mode]);
            n++;
        }
    return n > 0 ? sum / n * l->columns : 0;
}

/* An odd mode's mean over all lines is zero: no side is preferred. */
static double variance_between(const grain_lines *lines, int mode, bool odd)
{
    double mean = 0, variance = 0;
    for (size_t i = 0; i < lines->n && !odd; i++)
        mean += lines->v[i].weight * lines->v[i].mean[mode];
    for (size_t i = 0; i < lines->n; i++)
        variance += lines->v[i].weight * (lines->v[i].mean[mode] - mean) * (lines->v[i].mean[mode] - mean);
    return variance;
}

void plb_grain_slow(grain_lines *lines, grain_model *g)
{
    for (size_t i = 0; i < lines->n; i++)
        average(&lines->v[i]);
    for (int m = 0; m < GRAIN_MODES; m++) {
        double correlation[LAGS] = {0}, within = 0;
        for (size_t i = 0; i < lines->n; i++) {
            within += products(&lines->v[i], m, 0);
            for (size_t j = 0; j < LAGS; j++)
                correlation[j] += products(&lines->v[i], m, lags[j]);
        }
        for (size_t j = 0; j < LAGS; j++)
            correlation[j] = within > 0 ? correlation[j] / within : 0;
        g->mode_within[m] = (float)(within / lines->columns);
        g->mode_between[m] = (float)variance_between(lines, m, g->mode_is_odd[m]);
        g->mode_length[m] = (float)length_of(correlation);
    }
}
