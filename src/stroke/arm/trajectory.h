/* SPDX-License-Identifier: MIT
 *
 * What the files of the path share: a base line to read from, samples to write.
 */
#ifndef PLB_STROKE_ARM_TRAJECTORY_H
#define PLB_STROKE_ARM_TRAJECTORY_H

#include "stroke/stroke.h"

/* A base line, a polyline in mm, with a cursor, since it is read from start to end. */
typedef struct {
    const point *v;
    size_t n, at;    /* the segment from at to at + 1 … */
    double passed;   /* … begins at this arc length */
    bool closed;
} base_line;

/* path_base.c */
base_line plb_base_line(const stroke_list *list, const stroke *s);
double plb_base_length(const base_line *b);
/* The diagonal of the box around it: of a straight line, its length. */
double plb_base_extent(const base_line *b);
/* The place `along` mm from the start and `off` mm to the left of the direction there; moves the cursor. */
point plb_base_place(base_line *b, double along, double off);
/* Arc lengths and tangents of samples whose places are known; samples that coincide with the one before are dropped. */
void plb_path_measure(path_samples *out, bool closed);

/* path_spline.c: the papers' path of a line of `length` mm. False when out of memory. */
bool plb_path_spline(base_line *b, const stroke *s, double length, const stroke_options *o, path_samples *out);
/* Its control points in the line's own frame; their count. */
size_t plb_path_spline_controls(double length, point way, const stroke *s, const stroke_options *o, control c[CONTROLS_MAX]);
/* path_straight.c: a free hand's path along a straight line. path_follow.c: along a curve that it knows exactly.
 * path_curve.c: along a curve that it remembers by via points; where the stroke is closed, it starts at a place of its own,
 * passes it at the end, and `out` becomes an open path. False when out of memory. */
bool plb_trace_line(const base_line *b, double length, const hand *h, path_samples *out);
bool plb_trace_ride(base_line *b, double length, const hand *h, path_samples *out);
bool plb_trace_curve(const base_line *b, double length, const hand *h, uint64_t identity, const stroke_options *o, path_samples *out);

/* The elements of a 2 x 2 matrix, of the equations in path_via.c. */
typedef struct {
    double vj, aj, vs, as;
} via_block;
/* A place through which the hand means to pass (path_via.c). The unit of time is free. */
typedef struct {
    point at, velocity, acceleration;
    double duration; /* until the next one */
    via_block forward; /* kept during the solution */
} via;
/* Velocities and accelerations at `n` >= 2 places for the movement of least jerk, from rest to rest. */
void plb_via_solve(via *v, size_t n);
/* The movement from v[0] to v[1]: coefficients of the powers of the share of the time, 0 to 1. */
typedef struct {
    double x[6], y[6];
} via_piece;
via_piece plb_via_piece(const via v[2]);
point plb_via_at(const via_piece *p, double t);

#endif
