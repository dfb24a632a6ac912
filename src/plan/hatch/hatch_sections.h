/* SPDX-License-Identifier: MIT
 *
 * Sections of a shape along lines of any direction.
 */
#ifndef PLB_PLAN_HATCH_HATCH_SECTIONS_H
#define PLB_PLAN_HATCH_HATCH_SECTIONS_H

#include "base/array.h"
#include "base/error.h"
#include "base/geometry/geom.h"

#include <stdint.h>

/* A directed edge; places in mm on the page. */
typedef struct {
    point from, to;
} shape_edge;
typedef ARRAY(shape_edge) shape_edges;

/* A direction and the coordinates it makes: u along it, v to its right (y is down on the page). */
typedef struct {
    double c, s;
} frame;
frame plb_frame(double radians);
static inline point frame_to(frame f, point p) { return (point){p.x * f.c + p.y * f.s, p.y * f.c - p.x * f.s}; }
static inline point frame_from(frame f, point q) { return (point){q.x * f.c - q.y * f.s, q.x * f.s + q.y * f.c}; }
/* Gives the bounds of a box's corners in the frame. */
box plb_frame_box(frame f, box b);

/* A piece of a line inside the shape: u from, u to. */
typedef struct {
    double from, to;
} span;

/* Sections of a shape along the u of a frame, asked for in the order of rising v. */
typedef struct {
    shape_edges edges;       /* in the frame, by their least v */
    box bounds;              /* in the frame */
    double tilt;             /* the steepest line that may be asked for: v per u */
    double pivot;            /* the u about which lines tilt */
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

/* Prepares the sections; `tilt` is the steepest line that will be asked for. False and `err` when out of memory; `k` is
 * then to be freed all the same. */
bool plb_sections_init(sections *k, const shape_edges *edges, bool even_odd, frame f, double tilt, error *err);
void plb_sections_free(sections *k);
/* Begins again with small v, for lines that tilt about another u; at first they tilt about the middle of the bounds. */
void plb_sections_restart(sections *k, double pivot);
/* Fills k->spans, in order of u, with the parts inside the shape of the line through (k->pivot, v) that rises by `tilt` per u. */
bool plb_sections_at(sections *k, double v, double tilt, error *err);
/* Gives v of that line at `u`. */
double plb_sections_v(const sections *k, double v, double tilt, double u);

#endif
