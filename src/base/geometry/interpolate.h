/* SPDX-License-Identifier: MIT
 *
 * Values between those of a table.
 */
#ifndef PLB_BASE_GEOMETRY_INTERPOLATE_H
#define PLB_BASE_GEOMETRY_INTERPOLATE_H

static inline double clamp(double x, double low, double high)
{
    return x >= low ? x <= high ? x : high : low; /* NaN gives low */
}

/* `v` at `x` between its n >= 2 values at first + k * step; level beyond the ends. */
double plb_interpolate(const float v[], int n, double first, double step, double x);

#endif
