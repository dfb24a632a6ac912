/* SPDX-License-Identifier: MIT
 *
 * This header interpolates between the values of a table.
 */
#ifndef PLB_BASE_GEOMETRY_INTERPOLATE_H
#define PLB_BASE_GEOMETRY_INTERPOLATE_H

static inline double clamp(double x, double low, double high)
{
    return x >= low ? x <= high ? x : high : low; /* NaN gives low */
}

/* Returns the value at `x` of the table `v`, whose n >= 2 values lie at first + k * step; beyond its ends the table is level. */
double plb_interpolate(const float v[], int n, double first, double step, double x);

#endif
