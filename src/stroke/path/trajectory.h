/* SPDX-License-Identifier: MIT
 *
 * The path of a stroke: from the line that is meant, the base line, to samples of the line that is drawn.
 */
#ifndef PLB_STROKE_PATH_TRAJECTORY_H
#define PLB_STROKE_PATH_TRAJECTORY_H

#include "base/array.h"
#include "base/error.h"
#include "list/stroke_list.h"
#include "stroke/options.h"

/* A point of a drawn path. */
typedef struct {
    point at;      /* mm on the page */
    point tangent; /* unit vector */
    double along;  /* arc length from the start, mm */
} path_sample;
/* A drawn path: an ARRAY of samples, and how it is drawn. */
typedef struct {
    path_sample *v;
    size_t n, capacity;
    bool closed;   /* ends where it starts, smoothly: what goes along it runs on across the joint */
    bool backward; /* the hand starts at the last sample: there the pencil is set down, at the first it is lifted */
    float pressure_first, pressure_last; /* times the stroke's own pressure; evenly changing along the path; usually 1 */
} path_samples;

/* A base line, a polyline in mm, with a cursor, since it is read from start to end. */
typedef struct {
    const point *v;
    size_t n, at;    /* the segment from at to at + 1 … */
    double passed;   /* … begins at this arc length */
    bool closed;
} base_line;

/* base_line.c */
base_line plb_base_line(const stroke_list *list, const stroke *s);
double plb_base_length(const base_line *b);
/* Gives the way from its first point to its last, mm. */
point plb_base_way(const base_line *b);
/* Gives the diagonal of the box around it: of a straight line, its length. */
double plb_base_extent(const base_line *b);
/* Gives the radius of a closed line that is a circle, or a smooth polygon for one, mm; of others 0. */
double plb_base_radius(const base_line *b);
/* Gives the place `along` mm from the start and `off` mm to the left of the direction there; moves the cursor. */
point plb_base_place(base_line *b, double along, double off);
/* Computes arc lengths and tangents of samples whose places are known; samples that coincide with the one before are dropped. */
void plb_path_measure(path_samples *out, bool closed);

#endif
