/* SPDX-License-Identifier: MIT
 *
 * Curves through many samples: a path that stays within a given distance of a smooth polyline and has far fewer points.
 */
#ifndef PLB_BASE_GEOMETRY_FIT_CURVES_H
#define PLB_BASE_GEOMETRY_FIT_CURVES_H

#include "base/geometry/path.h"

typedef struct {
    point at, tangent; /* unit vector */
    double along;      /* arc length from the first sample */
} fit_sample;

/* Appends a subpath of lines and cubic Bézier curves from the first sample to the last; each sample lies within `max_error` of
 * it. Needs n >= 2 samples, none at the place of the one before. False when out of memory. */
bool plb_fit_curves(const fit_sample *v, size_t n, double max_error, path *out);

#endif
