/* SPDX-License-Identifier: MIT
 *
 * Shading: which surface is seen at each place of the page, and how light it is, as areas of even tone.
 */
#ifndef PLB_TAP_MODEL_SHADE_SHADE_H
#define PLB_TAP_MODEL_SHADE_SHADE_H

#include "tap/model/view/view.h"

/* A buffer says for each cell of a fine raster over the page which triangle is seen there. */
typedef struct surface_buffer {
    int width, height;
    double cell;         /* mm */
    point corner;        /* of the first cell, mm on the page */
    uint32_t *triangle;  /* by row, then column; NO_TRIANGLE: none */
    float *depth;        /* of the nearest surface, mm; larger is nearer */
} surface_buffer;

bool plb_buffer_fill(const view *v, surface_buffer *b, error *err);
void plb_buffer_free(surface_buffer *b);
/* Gives the triangle that is seen at a place of the page, or NO_TRIANGLE. */
uint32_t plb_buffer_at(const surface_buffer *b, point mm);

/* Light comes from a direction: degrees to the right of the eye and above it. */
typedef struct {
    bool is_on;
    double azimuth, elevation;
} light;

/* An area has one tone: a path of closed loops, mm, filled by the even-odd rule. */
typedef struct {
    colour colour; /* of the material, darkened by what the light leaves; white leaves the paper blank */
    size_t first, n; /* of the loops */
    bool is_round;   /* part of a round surface, whose tone changes from `from` to `to`, mm */
    point from, to;
    colour colours[2]; /* there */
    bool is_directed;  /* its hatching runs in the … */
    double direction;  /* … direction, degrees clockwise from the right */
} tone_area;
typedef struct {
    size_t first, n; /* of the points */
} tone_loop;
typedef struct {
    ARRAY(point) points;
    ARRAY(tone_loop) loops;
    ARRAY(tone_area) areas;
} tone_list;

bool plb_shade(const view *v, const surface_buffer *b, light from, tone_list *out, error *err);
void plb_tone_list_free(tone_list *l);

/* Adds the loops around the cells of each region to the list: label[cell] is a region's number below `regions`, or none (UINT32_MAX).
 * loops_of[r] (as many as regions) gets the loops of region r, which lie in a row. */
bool plb_trace_regions(const surface_buffer *b, const uint32_t *label, uint32_t regions, tone_loop *loops_of, tone_list *out);

#endif
