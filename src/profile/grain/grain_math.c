/* SPDX-License-Identifier: MIT
 *
 * This file has the little numerical mathematics that the capture of grain needs.
 */
#include "profile/grain/grain_math.h"

#include <math.h>

#define SWEEPS 60           /* of Jacobi's method; a dozen suffice */
#define CONVERGED 1e-24     /* squares off the diagonal, as a share of all */
#define DEPENDENT 1e-9      /* a pivot below this share of its variance is rounding */
#define FOLD_RADIUS 4       /* bins, four sigma */

void plb_gaussian(double sigma, int radius, double weight[])
{
    for (int k = 0; k <= radius; k++)
        weight[k] = exp(-k * k / (2 * sigma * sigma));
}

void plb_smooth_folded(const double in[], double out[], int n)
{
    double w[FOLD_RADIUS + 1];
    plb_gaussian(1, FOLD_RADIUS, w);
    for (int i = 0; i < n; i++) {
        double sum = 0, weights = 0;
        for (int k = -FOLD_RADIUS; k <= FOLD_RADIUS; k++) {
            int j = i + k < 0 ? -1 - (i + k) : i + k; /* bin -1 is bin 0 of the other side */
            sum += w[k < 0 ? -k : k] * in[j < n ? j : n - 1];
            weights += w[k < 0 ? -k : k];
        }
        out[i] = sum / weights;
    }
}

/* ---- eigenvalues: cyclic Jacobi (Golub & Van Loan, Matrix Computations, section 8.5) ---- */

/* Rotates columns p and q. */
static void rotate_columns(double *a, int n, int p, int q, double c, double s)
{
    for (int i = 0; i < n; i++) {
        double x = a[i * n + p], y = a[i * n + q];
        a[i * n + p] = c * x - s * y;
        a[i * n + q] = s * x + c * y;
    }
}

static void rotate_rows(double *a, int n, int p, int q, double c, double s)
{
    for (int i = 0; i < n; i++) {
        double x = a[p * n + i], y = a[q * n + i];
        a[p * n + i] = c * x - s * y;
        a[q * n + i] = s * x + c * y;
    }
}

/* Makes a[p][q] zero. */
static void annihilate(double *a, double *vectors, int n, int p, int q)
{
    double apq = a[p * n + q];
    if (fabs(apq) < 1e-300)
        return;
    double theta = (a[q * n + q] - a[p * n + p]) / (2 * apq);
    double t = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(theta * theta + 1));
    double c = 1 / sqrt(t * t + 1), s = t * c;
    rotate_columns(a, n, p, q, c, s);
    rotate_rows(a, n, p, q, c, s);
    rotate_columns(vectors, n, p, q, c, s);
}

static bool is_diagonal(const double *a, int n)
{
    double off = 0, all = 0;
    for (int i = 0; i < n * n; i++) {
        all += a[i] * a[i];
        off += i / n == i % n ? 0 : a[i] * a[i];
    }
    return off <= CONVERGED * all;
}

void plb_eigen(double *a, double *vectors, int n)
{
    for (int i = 0; i < n * n; i++)
        vectors[i] = i / n == i % n;
    for (int sweep = 0; sweep < SWEEPS && !is_diagonal(a, n); sweep++)
        for (int p = 0; p < n - 1; p++)
            for (int q = p + 1; q < n; q++)
                annihilate(a, vectors, n, p, q);
}

/* ---- Cholesky ---- */

/* Gives the rest of a[i][j] after the first j columns of the factor. */
static double remainder_at(const double *a, const double *l, int n, int i, int j)
{
    double x = a[i * n + j];
    for (int k = 0; k < j; k++)
        x -= l[i * n + k] * l[j * n + k];
    return x;
}

void plb_semi_cholesky(const double *a, double *l, int n)
{
    for (int i = 0; i < n * n; i++)
        l[i] = 0;
    for (int j = 0; j < n; j++) {
        double pivot = remainder_at(a, l, n, j, j);
        if (!(pivot > DEPENDENT * a[j * n + j]))
            continue;
        l[j * n + j] = sqrt(pivot);
        for (int i = j + 1; i < n; i++)
            l[i * n + j] = remainder_at(a, l, n, i, j) / l[j * n + j];
    }
}

bool plb_solve(double *a, double *b, int n)
{
    for (int j = 0; j < n; j++) { /* the factor replaces the lower triangle */
        double pivot = remainder_at(a, a, n, j, j);
        if (!(pivot > 0))
            return false;
        a[j * n + j] = sqrt(pivot);
        for (int i = j + 1; i < n; i++)
            a[i * n + j] = remainder_at(a, a, n, i, j) / a[j * n + j];
    }
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++)
            b[i] -= a[i * n + k] * b[k];
        b[i] /= a[i * n + i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++)
            b[i] -= a[k * n + i] * b[k];
        b[i] /= a[i * n + i];
    }
    return true;
}
