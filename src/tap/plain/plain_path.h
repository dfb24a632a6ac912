/* SPDX-License-Identifier: MIT
 *
 * Builds a path on the script surface in cairo's way: 24.8 fixed-point numbers; lines that go on in one direction are
 * one line, lines without length go (cairo-path-fixed.c does so while a path is made). Points come in user units and
 * pass through the path's matrix.
 */
#ifndef PLB_TAP_PLAIN_PLAIN_PATH_H
#define PLB_TAP_PLAIN_PLAIN_PATH_H

#include "tap/plain/plain_text.h"
#include "tap/common/tap_page.h"

#include <stdint.h>

#define PLAIN_NEAR 0.01 /* user units: more than the step of cairo's numbers, by which librsvg tells points apart */

typedef struct {
    int32_t x, y;
} plain_point;

enum { PLAIN_MOVE, PLAIN_LINE, PLAIN_CURVE, PLAIN_CLOSE };

typedef struct {
    matrix matrix;
    unsigned char *ops;
    plain_point *points;
    size_t n_ops, n_points, ops_capacity, points_capacity;
    plain_point current, start;
    bool has_current; /* there is a current point */
    bool is_pending;  /* a move to it is to be written before the next line or curve, and after the last */
    bool is_empty;    /* nothing moves: a fill leaves no ink */
    bool is_upright;  /* all lines are horizontal or vertical, no curves: cairo has its own ways with such */
    bool failed;      /* too far, not a number, out of memory */
} plain_path;

/* Forgets the path, keeps its memory. */
void plb_plain_begin(plain_path *p, const matrix *to_surface);
void plb_plain_free(plain_path *p);

void plb_plain_move(plain_path *p, double x, double y);
void plb_plain_line(plain_path *p, double x, double y);
void plb_plain_curve(plain_path *p, const double at[6]);
void plb_plain_close(plain_path *p);

typedef struct {
    double from[2], to[2], radii[2];
    double rotation; /* of the first radius, degrees */
    bool is_large, is_positive;
} plain_arc;

/* SVG 1.1, F.6. */
void plb_plain_draw_arc(plain_path *p, const plain_arc *a);

/* w and h above 0; radii from 0. */
void plb_plain_rectangle(plain_path *p, const double at[4], double rx, double ry);
/* at: centre and radii, these above 0. */
void plb_plain_ellipse(plain_path *p, const double at[4]);

/* Adds the path that a path element's d describes (plain_data.c). `square`: caps are square, which librsvg also draws
 * where subpaths have no length, in its own way: such paths are refused. False: d is not well-formed, or beyond limits.
 * */
bool plb_plain_data(plain_path *p, plain_text d, bool square);
/* Adds the lines that a polyline's points describe; `closed` makes a polygon of them. */
bool plb_plain_points(plain_path *p, plain_text points, bool closed, bool square);

#endif
