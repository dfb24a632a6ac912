/* SPDX-License-Identifier: MIT
 *
 * A region of the plane bounded by straight edges, made from a path and a fill rule, that answers two questions fast:
 * is a point inside, and where does a segment cross the boundary. Edges are sorted into horizontal bands.
 */
#ifndef PLB_PLAN_SHAPE_REGION_H
#define PLB_PLAN_SHAPE_REGION_H

#include "base/array.h"
#include "base/error.h"
#include "base/geometry/path.h"

/* A line along the edge of an area or of the page is half seen: it stays, and so does a line no farther beyond the edge than this
 * (neighbours share outlines). */
#define EDGE_MARGIN_MM 0.05

typedef struct region region;
typedef ARRAY(double) crossings;

/* Makes a region of the path. NULL and `err` when out of memory. */
region *plb_region_new(const path *p, bool even_odd, error *err);
void plb_region_free(region *r);
box plb_region_bounds(const region *r);
/* Tells whether the region is one upright rectangle: its bounds then say all. */
bool plb_region_is_box(const region *r);
/* Tells whether the point is inside, or within `margin` of the boundary. */
bool plb_region_contains(const region *r, point p, double margin);
/* Tells whether the point is inside, and farther than `margin` from the boundary. */
bool plb_region_covers(const region *r, point p, double margin);
/* Tells how many edges a question about that point looks at, about. */
double plb_region_work(const region *r, point p);
/* Appends the parameters in (0, 1) where the segment meets the boundary, some maybe more than once, and adds to *work about how many
 * edges were looked at. False when out of memory. */
bool plb_region_cross(const region *r, point from, point to, crossings *at, double *work);

#endif
