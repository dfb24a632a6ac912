/* SPDX-License-Identifier: MIT
 *
 * This header has points, boxes and affine maps of the plane. The unit is the caller's (millimetres in the display list,
 * pixels in patches).
 */
#ifndef PLB_BASE_GEOMETRY_GEOM_H
#define PLB_BASE_GEOMETRY_GEOM_H

#include <math.h>
#include <stdbool.h>

typedef struct {
    double x, y;
} point;

/* x' = xx x + xy y + x0, y' = yx x + yy y + y0: the order of PostScript's [xx yx xy yy x0 y0]. */
typedef struct {
    double xx, yx, xy, yy, x0, y0;
} matrix;

/* A box is empty when x1 < x0 or y1 < y0. */
typedef struct {
    double x0, y0, x1, y1;
} box;

#define MATRIX_IDENTITY ((matrix){1, 0, 0, 1, 0, 0})
#define BOX_EMPTY ((box){1e300, 1e300, -1e300, -1e300})
#define PLB_PI 3.14159265358979323846

/* Returns the map that applies `a` first, then `b`. */
matrix plb_matrix_multiply(matrix a, matrix b);
matrix plb_matrix_scale(double sx, double sy);
matrix plb_matrix_rotate(double radians);
double plb_matrix_determinant(matrix m);
/* Inverts the map into `out`; returns false, and leaves `out`, when the map is singular or not finite. */
bool plb_matrix_invert(matrix m, matrix *out);
/* Returns the mean factor by which lengths grow: the square root of that of areas. */
double plb_matrix_expansion(matrix m);
/* Returns the direction that lines in the given one have after the mapping, degrees from x towards y, above -180 to 180; the given one where
 * the mapping leaves them no length. */
double plb_matrix_turn(matrix m, double degrees);

static inline point plb_matrix_apply(matrix m, point p)
{
    return (point){m.xx * p.x + m.xy * p.y + m.x0, m.yx * p.x + m.yy * p.y + m.y0};
}
/* Applies the linear part alone, as vectors and distances need. */
static inline point plb_matrix_apply_vector(matrix m, point v)
{
    return (point){m.xx * v.x + m.xy * v.y, m.yx * v.x + m.yy * v.y};
}

static inline point point_add(point a, point b) { return (point){a.x + b.x, a.y + b.y}; }
static inline point point_sub(point a, point b) { return (point){a.x - b.x, a.y - b.y}; }
static inline point point_scale(point a, double f) { return (point){a.x * f, a.y * f}; }
static inline point point_mix(point a, point b, double t) { return (point){a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}; }
static inline double point_dot(point a, point b) { return a.x * b.x + a.y * b.y; }
static inline double point_cross(point a, point b) { return a.x * b.y - a.y * b.x; }
static inline double plb_point_length(point a) { return sqrt(a.x * a.x + a.y * a.y); }
static inline double plb_point_distance(point a, point b) { return plb_point_length(point_sub(a, b)); }
/* Tells whether a direction is more than 60 degrees from level: a hand draws such lines downward, others across (chosen by eye). */
bool plb_point_is_steep(point way);

/* Return the smaller and the larger of two numbers; when one is NaN, either of them. */
static inline double lesser(double a, double b) { return a < b ? a : b; }
static inline double greater(double a, double b) { return a > b ? a : b; }

void plb_box_add(box *b, point p);
bool plb_box_is_empty(box b);

#endif
