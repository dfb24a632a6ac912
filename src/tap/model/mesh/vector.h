/* SPDX-License-Identifier: MIT
 *
 * This header has vectors of space, in the model's own unit or, once projected, in mm on the page and mm of depth.
 */
#ifndef PLB_TAP_MODEL_MESH_VECTOR_H
#define PLB_TAP_MODEL_MESH_VECTOR_H

#include "base/geometry/geom.h"

#include <math.h>
#include <stdbool.h>

typedef struct {
    double x, y, z;
} vector;

static inline vector vector_add(vector a, vector b) { return (vector){a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline vector vector_sub(vector a, vector b) { return (vector){a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline vector vector_scale(vector a, double f) { return (vector){a.x * f, a.y * f, a.z * f}; }
static inline vector vector_mix(vector a, vector b, double t) { return vector_add(a, vector_scale(vector_sub(b, a), t)); }
static inline double vector_dot(vector a, vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline vector vector_cross(vector a, vector b)
{
    return (vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline double vector_length(vector a) { return sqrt(vector_dot(a, a)); }
static inline double vector_distance(vector a, vector b) { return vector_length(vector_sub(a, b)); }
/* Returns the vector of length 1; no direction stays none. */
static inline vector vector_unit(vector a)
{
    double l = vector_length(a);
    return l > 0 ? vector_scale(a, 1 / l) : (vector){0, 0, 0};
}
/* Tells whether it can be a place: coordinates are finite and so small that products of four of them are, too. */
static inline bool vector_is_place(vector a) { return fabs(a.x) < 1e60 && fabs(a.y) < 1e60 && fabs(a.z) < 1e60; }
/* Returns the angle between two directions, radians. */
static inline double vector_angle(vector a, vector b) { return atan2(vector_length(vector_cross(a, b)), vector_dot(a, b)); }

#endif
