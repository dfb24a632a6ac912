/* SPDX-License-Identifier: MIT
 *
 * The third step of the capture finds the ways in which the section changes slowly along a line. They are the leading
 * eigenvectors of the covariance of the root of the section after smoothing along the line (principal components). Of the root:
 * nothing is less dark than paper, and where a line is faint it varies less.
 */
#include "profile/grain/grain.h"

#include "profile/grain/grain_math.h"

#include "base/array.h"

#include <math.h>
#include <string.h>

#define PLACES GRAIN_MODE_PLACES
#define FIRST_PLACE (-8.0)
#define MODE_STEP 0.25
#define SMOOTH_RADIUS 32           /* four sigma */
#define COLUMNS_A_MODE 100         /* with fewer the modes are chance */
#define MIN_VARIANCE 1e-7        /* a mode below it is rounding */

/* ---- a column as a curve ---- */

/* Second derivatives, times h²/6, of the natural cubic spline through equidistant values (the standard tridiagonal system,
 * solved forwards and back). */
static void spline(const float y[GRAIN_ROWS], double m[GRAIN_ROWS])
{
    double factor[GRAIN_ROWS] = {0};
    m[0] = m[GRAIN_ROWS - 1] = 0;
    for (int i = 1; i < GRAIN_ROWS - 1; i++) {
        double pivot = 4 - factor[i - 1];
        factor[i] = 1 / pivot;
        m[i] = (((double)y[i + 1] - 2.0 * y[i] + y[i - 1]) - m[i - 1]) / pivot;
    }
    for (int i = GRAIN_ROWS - 2; i > 0; i--)
        m[i] -= factor[i] * m[i + 1];
}

/* Computes the darkness of column k at the places of the modes, by a cubic: straight lines would blur the flanks. */
static void column_at_places(const grain_line *l, int k, double v[PLACES])
{
    const float *t = l->place + k * GRAIN_ROWS, *y = l->dark + k * GRAIN_ROWS;
    double m[GRAIN_ROWS], step = ((double)t[GRAIN_ROWS - 1] - t[0]) / (GRAIN_ROWS - 1);
    spline(y, m);
    for (int p = 0; p < PLACES; p++) {
        double at = clamp((FIRST_PLACE + p * MODE_STEP - t[0]) / step, 0, GRAIN_ROWS - 1);
        int i = at < GRAIN_ROWS - 1 ? (int)at : GRAIN_ROWS - 2;
        double b = at - i, a = 1 - b;
        v[p] = a * y[i] + b * y[i + 1] + (a * a * a - a) * m[i] + (b * b * b - b) * m[i + 1];
    }
}

/* ---- smoothing along the line, over the usable columns only ---- */

static void smooth_column(const grain_line *l, int k, const double *weight, const double (*deviation)[PLACES], double out[PLACES])
{
    double weights = 0;
    memset(out, 0, PLACES * sizeof *out);
    for (int j = k > SMOOTH_RADIUS ? k - SMOOTH_RADIUS : 0; j <= k + SMOOTH_RADIUS && j < l->n; j++) {
        if (!l->usable[j])
            continue;
        double w = weight[j < k ? k - j : j - k];
        weights += w;
        for (int p = 0; p < PLACES; p++)
            out[p] += w * deviation[j][p];
    }
    for (int p = 0; p < PLACES; p++)
        out[p] /= weights;
}

/* A visitor is shown the root of each usable column, smoothed, less the base. */
typedef void visitor(grain_line *l, int k, const double smoothed[PLACES], void *closure);

static bool visit(grain_line *l, const double base[PLACES], visitor *visitor_of, void *closure)
{
    double weight[SMOOTH_RADIUS + 1], smoothed[PLACES];
    double(*column)[PLACES] = plb_new((size_t)l->n, sizeof *column);
    if (!column)
        return false;
    plb_gaussian(GRAIN_SMOOTH, SMOOTH_RADIUS, weight);
    for (int k = 0; k < l->n; k++)
        column_at_places(l, k, column[k]);
    for (int k = 0; k < l->n; k++)
        if (l->usable[k]) {
            smooth_column(l, k, weight, (const double(*)[PLACES])column, smoothed);
            for (int p = 0; p < PLACES; p++)
                smoothed[p] = (sqrt(fmax(0, smoothed[p])) - base[p]) * (base[p] > 0 ? plb_grain_root_slope(base[p]) : 1);
            visitor_of(l, k, smoothed, closure);
        }
    plb_free(column);
    return true;
}

/* ---- the mean root ---- */

static void add_root(grain_line *l, int k, const double s[PLACES], void *closure)
{
    (void)l, (void)k;
    double *sum = closure;
    for (int p = 0; p < PLACES; p++)
        sum[p] += s[p];
}

/* Over all columns and both sides: as the section, which is its square, will say. */
static bool find_base(const grain_lines *lines, grain_model *g, double base[PLACES])
{
    const double none[PLACES] = {0};
    double sum[PLACES] = {0};
    for (size_t i = 0; i < lines->n; i++)
        if (!visit(&lines->v[i], none, add_root, sum))
            return false;
    for (int k = 0; k < PLACES / 2; k++) {
        double inner = (sum[PLACES / 2 + k] + sum[PLACES / 2 - k]) / 2, outer = (sum[PLACES / 2 + k + 1] + sum[PLACES / 2 - k - 1]) / 2;
        double root = (inner + outer) / 2 / lines->columns;
        g->section[k] = (float)(root * root);
    }
    for (int p = 0; p < PLACES; p++)
        base[p] = plb_grain_root(g, FIRST_PLACE + p * MODE_STEP);
    return true;
}

/* ---- covariance and its eigenvectors ---- */

static void add_products(grain_line *l, int k, const double s[PLACES], void *closure)
{
    (void)l, (void)k;
    double *sum = closure;
    for (int p = 0; p < PLACES; p++)
        for (int q = 0; q < PLACES; q++)
            sum[p * PLACES + q] += s[p] * s[q];
}

/* Mean, and the mean of it and its mirror image: a line has no preferred side, so every mode is even or odd. */
static void mirror(double *k, double columns)
{
    const int last = PLACES * PLACES - 1;
    for (int i = 0; i <= last / 2; i++) {
        double both = (k[i] + k[last - i]) / 2 / columns;
        k[i] = k[last - i] = both;
    }
}

/* Mode i from column `c` of the eigenvectors: exactly even or odd, its first large value positive. */
static void take_mode(const double *vectors, int c, int i, grain_model *g)
{
    double greatest = 0, with_mirror = 0, sign = 0;
    for (int p = 0; p < PLACES; p++) {
        greatest = fmax(greatest, fabs(vectors[p * PLACES + c]));
        with_mirror += vectors[p * PLACES + c] * vectors[(PLACES - 1 - p) * PLACES + c];
    }
    double parity = with_mirror < 0 ? -1 : 1;
    g->mode_is_odd[i] = parity < 0;
    for (int p = 0; p < PLACES; p++) {
        double v = vectors[p * PLACES + c];
        if (sign == 0 && fabs(v) > greatest / 2)
            sign = v < 0 ? -1 : 1;
    }
    for (int p = 0; p < PLACES; p++)
        g->mode[i][p] = (float)(sign * (vectors[p * PLACES + c] + parity * vectors[(PLACES - 1 - p) * PLACES + c]) / 2);
}

/* Sorts the greatest eigenvalues first; what little data cannot tell stays zero. */
static void take_modes(double *k, const double *vectors, double columns, grain_model *g)
{
    for (int i = 0; i < GRAIN_MODES && i < columns / COLUMNS_A_MODE; i++) {
        int best = 0;
        for (int c = 1; c < PLACES; c++)
            if (k[c * PLACES + c] > k[best * PLACES + best])
                best = c;
        if (!(k[best * PLACES + best] > MIN_VARIANCE))
            break;
        take_mode(vectors, best, i, g);
        k[best * PLACES + best] = -1;
    }
}

static void project(grain_line *l, int k, const double s[PLACES], void *closure)
{
    const grain_model *g = closure;
    for (int i = 0; i < GRAIN_MODES; i++) {
        l->coefficient[k][i] = 0;
        for (int p = 0; p < PLACES; p++)
            l->coefficient[k][i] += s[p] * g->mode[i][p];
    }
}

bool plb_grain_modes(grain_lines *lines, grain_model *g, error *err)
{
    double *k = plb_new(PLACES * PLACES, sizeof *k), *vectors = plb_new(PLACES * PLACES, sizeof *vectors), base[PLACES];
    bool good = k && vectors && find_base(lines, g, base);
    for (size_t i = 0; i < lines->n && good; i++)
        good = visit(&lines->v[i], base, add_products, k);
    if (good) {
        mirror(k, lines->columns);
        plb_eigen(k, vectors, PLACES);
        take_modes(k, vectors, lines->columns, g);
    }
    for (size_t i = 0; i < lines->n && good; i++)
        good = visit(&lines->v[i], base, project, g);
    plb_free(k);
    plb_free(vectors);
    return good || plb_fail_memory(err);
}
