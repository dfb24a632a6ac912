/* SPDX-License-Identifier: MIT
 *
 * A raster of the page that knows, for each cell, the latest area that covers the whole of it: where hundreds of areas
 * lie over each other, most of what is hidden is found hidden by one look. A cell that is called hidden is hidden; a hidden cell may be called open.
 */
#ifndef PLB_PLAN_HIDDEN_COVERAGE_RASTER_H
#define PLB_PLAN_HIDDEN_COVERAGE_RASTER_H

#include "plan/shape/region.h"
#include "plan/track.h"

typedef struct coverage_raster coverage_raster;

/* Makes a raster for a page of that size, mm, and about `areas` areas. NULL when out of memory. */
coverage_raster *plb_coverage_new(double width, double height, size_t areas);
void plb_coverage_free(coverage_raster *t);
/* Tells whether areas added so far cover the box, mm, as far as it is on the page. */
bool plb_coverage_hides_box(coverage_raster *t, box b);
/* Tells the same for the shape, which `within` holds; if the shape is not covered and it `covers`, it is added as
 * number `order`, as far as it is within the box: the last area comes first. False and `err` when out of memory. */
bool plb_coverage_add(coverage_raster *t, const path *shape, bool even_odd, box within, bool covers, size_t order, bool *is_hidden, error *err);
/* Tells whether an area later than `order` covers the cell that the point is in. */
bool plb_coverage_is_over(const coverage_raster *t, size_t order, point p);
/* Appends the places where the segment passes from covered cells to others, or back. False when out of memory. */
bool plb_coverage_cross(const coverage_raster *t, size_t order, point from, point to, crossings *at);

#endif
