/* SPDX-License-Identifier: MIT
 *
 * The eleventh step of the capture measures how lines differ: the joint normal distribution of their own figures.
 */
#include "profile/grain/grain.h"

#include "profile/grain/grain_math.h"

#include <math.h>

#define MIN_DEGREES 0.3 /* of freedom: one line tells nothing of the others, and its covariance is zero */

/* A line that was not scanned differs by so much more from the mean of those that were than these do, because a mean
 * and a variance of few lines are uncertain themselves. The factor is the variance of Student's t with as many degrees
 * of freedom, times that of the mean of n lines (the predictive distribution; Gelman et al., Bayesian Data Analysis,
 * 3rd ed., 2013, section 3.2). `shares`: the sum of the squares of the lines' shares, of equal ones 1 / n. */
#define MIN_FREEDOM 4.0 /* of a variance that is known at all; with fewer it is endless … */
static double predictive(double shares)
{
    double freedom = fmax(1 / shares - 1, MIN_FREEDOM);
    return fmin((1 + shares) * freedom / (freedom - 2), MIN_FREEDOM / (MIN_FREEDOM - 2)); /* … so no more than here */
}

/* Computes the figures of one line; `along`, `across`: what is added to its correlations, so that their means are the moments'. */
static void figures(const grain_line *l, const grain_model *g, double along, double across, double out[GRAIN_LINE])
{
    out[0] = log(l->depth);
    out[1] = log(l->width);
    out[2] = l->roughness;
    out[3] = l->along + along;
    out[4] = l->across + across;
    for (int i = 0; i < GRAIN_MODES; i++)
        out[5 + i] = g->mode_is_odd[i] ? 0 : l->mean[i];
}

void plb_grain_between(const grain_lines *lines, const grain_moments *m, grain_model *g)
{
    double along = m->correlation[1][0], across = m->correlation[0][1], degrees = 1, mean[GRAIN_LINE] = {0}, x[GRAIN_LINE];
    double covariance[GRAIN_LINE * GRAIN_LINE] = {0}, factor[GRAIN_LINE * GRAIN_LINE];
    for (size_t j = 0; j < lines->n; j++) {
        along -= lines->v[j].weight * lines->v[j].along;
        across -= lines->v[j].weight * lines->v[j].across;
        degrees -= lines->v[j].weight * lines->v[j].weight;
    }
    for (size_t j = 0; j < lines->n; j++) {
        figures(&lines->v[j], g, along, across, x);
        for (int i = 0; i < GRAIN_LINE; i++)
            mean[i] += lines->v[j].weight * x[i];
    }
    for (size_t j = 0; j < lines->n && lines->n > 1; j++) {
        figures(&lines->v[j], g, along, across, x);
        for (int i = 0; i < GRAIN_LINE * GRAIN_LINE; i++)
            covariance[i] += lines->v[j].weight * (x[i / GRAIN_LINE] - mean[i / GRAIN_LINE]) * (x[i % GRAIN_LINE] - mean[i % GRAIN_LINE]) /
                             fmax(degrees, MIN_DEGREES);
    }
    double more = predictive(1 - degrees);
    for (int i = 0; i < GRAIN_LINE * GRAIN_LINE; i++)
        covariance[i] *= more;
    plb_semi_cholesky(covariance, factor, GRAIN_LINE);
    for (int i = 0; i < GRAIN_LINE; i++) {
        g->line_mean[i] = (float)mean[i];
        for (int j = 0; j < GRAIN_LINE; j++)
            g->line_factor[i][j] = (float)factor[i * GRAIN_LINE + j];
    }
}
