/* SPDX-License-Identifier: MIT
 *
 * The medial axis of a flat shape (Blum 1967) consists of the centres of the largest discs that fit into it. The shape is scan
 * converted, thinned in the order of distance to its edge, and what is left read off as a graph of branches, which is
 * cleaned of what the shape's ends and joints alone have made and then read as strokes of a pen.
 *
 * Lengths here are pixels of the raster, x right and y down; pixel (0, 0) covers the square up to (1, 1).
 */
#ifndef PLB_PLAN_LETTER_MEDIAL_H
#define PLB_PLAN_LETTER_MEDIAL_H

#include "base/array.h"
#include "base/error.h"
#include "base/geometry/geom.h"

#include <stdbool.h>
#include <stdint.h>

/* Closed polygons of one shape: contour k has the points start[k] up to start[k + 1] (or the last one). */
typedef struct {
    ARRAY(point) points;
    ARRAY(size_t) starts;
    bool even_odd;
} contour_set;
void plb_contour_set_free(contour_set *o);

typedef struct {
    int width, height; /* with a rim of empty pixels all around */
    point origin;      /* where pixel (0, 0) begins, in the outline's unit */
    double pixel;      /* its side, in the outline's unit */
    size_t area;       /* pixels inside */
    double largest;    /* radius of all */
    float *radius;     /* of the largest disc around each pixel's centre, <= 0: outside */
    uint8_t *on;       /* the pixels inside; after thinning the medial axis */
} raster;

/* No raster has more pixels than the first; none more than the second when the shape's contours pass fewer than one of
 * RASTER_SPARSE of them: time grows with the pixels, the gain with the ink. */
#define RASTER_MAX_PIXELS (1024 * 1024)
#define RASTER_USUAL_PIXELS (256 * 1024)
#define RASTER_SPARSE 200

/* medial_raster.c: `o` at `pixel` a side; false and `err` when out of memory. The caller frees it. A raster beyond
 * these bounds is left empty (width 0) with true. */
bool plb_raster_fill(raster *r, const contour_set *o, double pixel, error *err);
void plb_raster_free(raster *r);
static inline bool raster_inside(const raster *r, point p)
{
    return p.x >= 0 && p.y >= 0 && p.x < r->width && p.y < r->height && r->radius[(int)p.y * r->width + (int)p.x] > 0;
}

/* medial_thin.c: leaves of r->on a line one pixel wide with the topology of the shape. */
bool plb_medial_thin(raster *r, error *err);

typedef struct {
    point at;
    double radius; /* of the disc there */
} medial_point;

typedef struct {
    point at;
    double radius;
    int degree;   /* branch ends here */
    bool gone;    /* joined away, or the tip of a leaf that is gone */
} medial_node;

typedef struct {
    int node[2];
    size_t first, n; /* its points in medial.points, from node[0] to node[1], both included; n >= 2 */
    double length;
    bool gone;
    int spur; /* used while pruning: the joint that it is a spur of */
} medial_branch;

typedef struct {
    ARRAY(medial_node) nodes;
    ARRAY(medial_branch) branches;
    ARRAY(medial_point) points;
} medial;
void plb_medial_free(medial *m);

/* A shape whose axis has more branches than this is no letter; the graph is then left empty. */
#define MEDIAL_MAX_BRANCHES 2000u

/* medial_graph.c: the graph of a thinned raster. */
bool plb_medial_graph(medial *m, const raster *r, error *err);

/* medial_arm.c: a branch seen from one of its ends. Its direction is taken over so many radii (chosen by eye: long enough
 * for pixels, short enough for bowls). */
#define ARM_REACH 2.5
typedef struct {
    int node;
    size_t cut;      /* index into medial.points where the joint's or end's influence is over */
    point anchor;    /* that point */
    point outward;   /* unit vector from there along the branch, away from the end */
    double radius;   /* usual for the branch */
    int step;        /* +1 or -1: along medial.points away from the end */
} medial_arm;
medial_arm plb_medial_arm(const medial *m, const medial_branch *b, int end);
/* Finds where the lines of two arms meet; false when they are as good as parallel. */
bool plb_medial_arms_meet(const medial_arm *a, const medial_arm *b, point *at);
/* 0 when the two go on straight into each other, up to pi; radians. */
double plb_medial_arms_bend(const medial_arm *a, const medial_arm *b);

/* medial_prune.c: takes away spurs, serifs and doubled joints. `stem`: the shape's usual thickness; `detail`: what sticks out less than this is a spur. */
bool plb_medial_prune(medial *m, double stem, double detail, error *err);

/* medial_corner.c: branches are parted where a stroke turns a corner. */
bool plb_medial_corners(medial *m, const raster *r, error *err);

typedef struct {
    point at;
    bool corner;
} pen_point;

typedef struct {
    size_t first, n; /* its points in pen.points */
    bool closed;     /* then its last point is its first */
} pen_stroke;

typedef struct {
    ARRAY(pen_point) points;
    ARRAY(pen_stroke) strokes;
} pen;
void plb_pen_free(pen *p);

/* medial_strokes.c: the branches joined to strokes of a pen as wide as `nib`; a lone node becomes a stroke of one point. */
bool plb_medial_strokes(const medial *m, const raster *r, double nib, pen *out, error *err);

/* medial_smooth.c: each stroke straight or smooth between its corners; `stem` is the shape's usual thickness. */
bool plb_pen_smooth(pen *p, double stem, error *err);

#endif
