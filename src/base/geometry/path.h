/* SPDX-License-Identifier: MIT
 *
 * A path has subpaths of straight lines and cubic Bézier curves, in whatever unit its owner says.
 */
#ifndef PLB_BASE_GEOMETRY_PATH_H
#define PLB_BASE_GEOMETRY_PATH_H

#include "base/array.h"
#include "base/geometry/geom.h"

#include <stdint.h>

typedef enum {
    PATH_MOVE,  /* 1 point: starts a subpath */
    PATH_LINE,  /* 1 point */
    PATH_CURVE, /* 3 points: two controls and the end */
    PATH_CLOSE  /* 0 points: back to the subpath's first point */
} path_op;

/* Each of `ops` takes so many of `points` as the list above says. A valid path starts with PATH_MOVE; after PATH_CLOSE the current
 * point is the subpath's first one and a PATH_LINE or PATH_CURVE may follow without a PATH_MOVE. */
typedef struct {
    ARRAY(uint8_t) ops;
    ARRAY(point) points;
} path;

/* Each of these appends to the path and returns false when out of memory; the path then stays as it was. */
bool plb_path_move(path *p, point to);
bool plb_path_line(path *p, point to);
bool plb_path_curve(path *p, point c1, point c2, point to);
bool plb_path_close(path *p);
/* Appends a circular arc about `centre` as curves (error below 3e-4 of the radius), angles in radians. A line leads to the arc's
 * start when the path has a current point, else a move. `clockwise` means towards smaller angles. */
bool plb_path_arc(path *p, point centre, double radius, double from, double to, bool clockwise, matrix ctm);
bool plb_path_append(path *to, const path *from, matrix m);
/* Empties the path and keeps its memory for the next one. */
void plb_path_clear(path *p);
void plb_path_free(path *p);
bool plb_path_equal(const path *a, const path *b);
bool plb_path_is_empty(const path *p);
/* Gives the current point; false when there is none. */
bool plb_path_current(const path *p, point *at);
void plb_path_transform(path *p, matrix m);
/* Returns the box around all points, controls included. */
box plb_path_bounds(const path *p);

#endif
