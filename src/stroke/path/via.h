/* SPDX-License-Identifier: MIT
 *
 * The movement of least jerk through via points.
 */
#ifndef PLB_STROKE_PATH_VIA_H
#define PLB_STROKE_PATH_VIA_H

#include "base/geometry/geom.h"

#include <stddef.h>

/* The elements of a 2 x 2 matrix, of the equations in via.c. */
typedef struct {
    double vj, aj, vs, as;
} via_block;
/* A place through which the hand means to pass (via.c). The unit of time is free. */
typedef struct {
    point at, velocity, acceleration;
    double duration; /* until the next one */
    via_block forward; /* kept during the solution */
} via;
/* Computes velocities and accelerations at `n` >= 2 places for the movement of least jerk, from rest to rest. */
void plb_via_solve(via *v, size_t n);
/* Gives the movement from v[0] to v[1]: coefficients of the powers of the share of the time, 0 to 1. */
typedef struct {
    double x[6], y[6];
} via_piece;
via_piece plb_via_piece(const via v[2]);
point plb_via_at(const via_piece *p, double t);

#endif
