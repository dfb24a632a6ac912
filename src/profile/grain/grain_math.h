/* SPDX-License-Identifier: MIT
 *
 * This header has the little numerical mathematics that the capture of grain needs. Matrices are row by row.
 */
#ifndef PLB_PROFILE_GRAIN_GRAIN_MATH_H
#define PLB_PROFILE_GRAIN_GRAIN_MATH_H

#include "base/geometry/interpolate.h"

#include <stdbool.h>

/* Gives the weights exp(-k²/2 sigma²) of k = 0 to radius, not normalised. */
void plb_gaussian(double sigma, int radius, double weight[]);
/* Smooths `n` bins that start at a line's middle, where the other side is their mirror image, by a Gaussian of one bin. */
void plb_smooth_folded(const double in[], double out[], int n);
/* Computes the eigenvalues of the symmetric n x n matrix `a`, left on its diagonal, and eigenvectors, the columns of `vectors`. */
void plb_eigen(double *a, double *vectors, int n);
/* Solves a x = b for a positive definite `a`; both are overwritten, b with x. False: `a` is not. */
bool plb_solve(double *a, double *b, int n);
/* Computes the lower triangle l with l lᵀ = a for a positive semi-definite `a` of any rank. */
void plb_semi_cholesky(const double *a, double *l, int n);

#endif
