/* SPDX-License-Identifier: MIT
 *
 * The eighth step of the capture measures moments of the scores of neighbouring pixels, every line's divided by its roughness.
 */
#include "profile/grain/grain.h"

#include "profile/grain/grain_math.h"

#include <math.h>

#define FIRST_VOLATILE 2        /* lags along at which products of squares tell the volatility */
#define CORRELATION_GAIN 1.1    /* of the next pixel: makes up for what the table's clipping takes; chosen by eye */
#define VOLATILITY_GAIN 1.5     /* makes up for what its own decay along the line takes; chosen by eye */
#define MIN_COLUMN_CORRELATION 0.05
#define MAX_COLUMN_CORRELATION 0.95
#define MAX_VOLATILITY 1.5

typedef struct {
    double sum, n;
} mean;

static double value(mean m)
{
    return m.n > 0 ? m.sum / m.n : 0;
}

static void add(mean *m, double x)
{
    if (isnan(x))
        return;
    m->sum += x;
    m->n++;
}

typedef struct {
    mean product[GRAIN_FAR_TO + 1][GRAIN_ASIDE]; /* of scores so far apart */
    mean squares[GRAIN_LAGS][GRAIN_ASIDE]; /* of their squares */
    mean step, steps;                      /* squared step along; product of two of them, two rows apart */
} moment_sums;

static double score_at(const grain_line *l, int k, int o, double scale)
{
    return l->score[k * GRAIN_ROWS + o] * scale;
}

/* Both diagonals count: the grain has no preferred side. */
static void add_products(const grain_line *l, int a, int c, moment_sums *s)
{
    double scale = exp(-l->roughness);
    for (int k = 0; k + a < l->n; k++)
        for (int o = 0; o + c < GRAIN_ROWS; o++) {
            double here = score_at(l, k, o, scale), there = score_at(l, k + a, o + c, scale);
            add(&s->product[a][c], here * there);
            add(&s->product[a][c], score_at(l, k, o + c, scale) * score_at(l, k + a, o, scale));
            if (a < GRAIN_LAGS)
                add(&s->squares[a][c], here * here * there * there);
        }
}

static void add_steps(const grain_line *l, moment_sums *s)
{
    double scale = exp(-l->roughness);
    for (int k = 0; k + 1 < l->n; k++)
        for (int o = 0; o < GRAIN_ROWS; o++) {
            double step = score_at(l, k + 1, o, scale) - score_at(l, k, o, scale), other = NAN;
            if (o + 2 < GRAIN_ROWS)
                other = score_at(l, k + 1, o + 2, scale) - score_at(l, k, o + 2, scale);
            add(&s->step, step * step);
            add(&s->steps, step * step * other * other);
        }
}

/* Computes the correlations without what still correlates far along the line: that is the modes' part. */
static void correlate(const moment_sums *s, double variance, grain_moments *m)
{
    double plateau[GRAIN_ASIDE] = {0};
    for (int c = 0; c < GRAIN_ASIDE; c++)
        for (int a = GRAIN_FAR_FROM; a <= GRAIN_FAR_TO; a++)
            plateau[c] += value(s->product[a][c]) / variance / (GRAIN_FAR_TO - GRAIN_FAR_FROM + 1);
    for (int a = 0; a < GRAIN_LAGS; a++)
        for (int c = 0; c < GRAIN_ASIDE; c++)
            m->correlation[a][c] = clamp((value(s->product[a][c]) / variance - plateau[c]) / fmax(1 - plateau[0], 0.1), -1, 1);
    m->correlation[0][1] *= CORRELATION_GAIN;
    m->correlation[1][0] *= CORRELATION_GAIN;
}

/* Computes the covariance of the log amplitudes of pixels `aside` rows apart: products of squares beyond what their
 * correlation makes (for normal variables E x²y² = 1 + 2 r²). */
static double log_amplitude(const moment_sums *s, double variance, const grain_moments *m, int aside)
{
    double sum = 0;
    for (int a = FIRST_VOLATILE; a < GRAIN_LAGS; a++) {
        double r = m->correlation[a][aside];
        sum += log(fmax(value(s->squares[a][aside]) / (variance * variance) / (1 + 2 * r * r), 1e-3)) / 4;
    }
    return sum / (GRAIN_LAGS - FIRST_VOLATILE);
}

void plb_grain_moments(const grain_lines *lines, grain_model *g, grain_moments *m)
{
    static const int far_lags[] = {0, 1, 2, 3, 4, 8, 9, 10, 11, 12};
    moment_sums s = {0};
    for (size_t i = 0; i < lines->n; i++) {
        for (size_t a = 0; a < sizeof far_lags / sizeof *far_lags; a++)
            for (int c = 0; c < GRAIN_ASIDE; c++)
                add_products(&lines->v[i], far_lags[a], c, &s);
        add_steps(&lines->v[i], &s);
    }
    double variance = fmax(value(s.product[0][0]), 1e-6), step = value(s.step);
    correlate(&s, variance, m);
    double same = log_amplitude(&s, variance, m, 0), next = log_amplitude(&s, variance, m, 1), second = log_amplitude(&s, variance, m, 2);
    m->common = step > 0 ? value(s.steps) / (step * step) - 1 - 4 * second : 0;
    g->volatility = (float)clamp(sqrt(fmax(same, 0) * VOLATILITY_GAIN), 0, MAX_VOLATILITY);
    g->volatility_across = (float)clamp(next / fmax(same, 1e-3), MIN_COLUMN_CORRELATION, MAX_COLUMN_CORRELATION);
}
