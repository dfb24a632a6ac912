/* SPDX-License-Identifier: MIT
 *
 * A filled shape, ready to be hatched: its edges and measures.
 */
#ifndef PLB_PLAN_HATCH_HATCH_SHAPE_H
#define PLB_PLAN_HATCH_HATCH_SHAPE_H

#include "list/display_list.h"
#include "plan/hatch/hatch_sections.h"

typedef struct {
    shape_edges edges;
    box bounds;
    bool even_odd;
    size_t subpaths;
    bool is_convex;    /* one subpath that turns one way only */
    uint64_t identity; /* a hash of its geometry */
    /* These figures describe the filled part; 0 when there is none. */
    double area;       /* mm2 */
    double perimeter;  /* mm, of all edges */
    point centre;
    double axis;       /* direction of its long axis, radians in (-pi/2, pi/2] */
    double elongation; /* standard deviation along the axis over that across it, >= 1 */
} shape;

/* Measures the shape. False and `err` when out of memory; `s` is then to be freed all the same. */
bool plb_shape_init(shape *s, const item *fill, error *err);
void plb_shape_free(shape *s);
/* Tells how broad it is, mm: the mean length of its sections in that of four directions in which they are shortest. */
bool plb_shape_breadth(const shape *s, double *breadth, error *err);

#endif
