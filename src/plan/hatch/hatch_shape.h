/* SPDX-License-Identifier: MIT
 *
 * A filled shape, ready to be hatched: its edges and measures, and its sections along lines of any direction.
 */
#ifndef PLB_PLAN_HATCH_HATCH_SHAPE_H
#define PLB_PLAN_HATCH_HATCH_SHAPE_H

#include "plan/hatch/hatch.h"

/* A directed edge; places in mm on the page. */
typedef struct {
    point from, to;
} shape_edge;

typedef struct {
    ARRAY(shape_edge) edges;
    box bounds;
    bool even_odd;
    size_t subpaths;
    bool is_convex;    /* one subpath that turns one way only */
    uint64_t identity; /* a hash of its geometry */
    /* Of the filled part; 0 when there is none. */
    double area;       /* mm2 */
    double perimeter;  /* mm, of all edges */
    point centre;
    double axis;       /* direction of its long axis, radians in (-pi/2, pi/2] */
    double elongation; /* standard deviation along the axis over that across it, >= 1 */
} shape;

/* False and `err` when out of memory; `s` is then to be freed all the same. */
bool plb_shape_init(shape *s, const item *fill, error *err);
void plb_shape_free(shape *s);
/* How broad it is, mm: the mean length of its sections in that of four directions in which they are shortest. */
bool plb_shape_breadth(const shape *s, double *breadth, error *err);

/* A direction and the coordinates it makes: u along it, v to its right (y is down on the page). */
typedef struct {
    double c, s;
} frame;
frame plb_frame(double radians);
static inline point frame_to(frame f, point p) { return (point){p.x * f.c + p.y * f.s, p.y * f.c - p.x * f.s}; }
static inline point frame_from(frame f, point q) { return (point){q.x * f.c - q.y * f.s, q.x * f.s + q.y * f.c}; }
/* The bounds of a box's corners in the frame. */
box plb_frame_box(frame f, box b);

/* A piece of a line inside the shape: u from, u to. */
typedef struct {
    double from, to;
} span;

/* Sections of a shape along the u of a frame, asked for in the order of rising v. */
typedef struct {
    ARRAY(shape_edge) edges; /* in the frame, by their least v */
    box bounds;              /* in the frame */
    double tilt;             /* the steepest line that may be asked for: v per u */
    bool even_odd;
    size_t next;             /* the first edge not yet met */
    ARRAY(uint32_t) active;
    ARRAY(struct crossing) crossings;
    ARRAY(span) spans;       /* the answer */
} sections;
struct crossing {
    double u;
    int turn;
};

bool plb_sections_init(sections *k, const shape *s, frame f, double tilt, error *err);
void plb_sections_free(sections *k);
/* Fills k->spans, in order of u, with the parts inside the shape of the line through the middle of the bounds at `v`
 * that rises by `tilt` per u. */
bool plb_sections_at(sections *k, double v, double tilt, error *err);
/* v of that line at `u`. */
double plb_sections_v(const sections *k, double v, double tilt, double u);

#endif
