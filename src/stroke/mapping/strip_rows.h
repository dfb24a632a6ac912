/* SPDX-License-Identifier: MIT
 *
 * The rows of samples of one straight piece of the path, for this folder only: see strip_map.c for what a piece owns.
 */
#ifndef PLB_STROKE_MAPPING_STRIP_ROWS_H
#define PLB_STROKE_MAPPING_STRIP_ROWS_H

#include "base/geometry/geom.h"

#include <stdbool.h>

/* Page pixels [x0, x1) × [y0, y1); empty when x1 <= x0. */
typedef struct {
    int x0, y0, x1, y1;
} pixel_box;

/* A piece of the path in page pixels. */
typedef struct {
    point p0, p1, b0, b1, t;
    double length, s0; /* s0 in strip pixels */
    double left, right; /* how far it reaches to either side, page pixels */
    pixel_box in;             /* page pixels it may touch */
} piece;

/* Where samples of a piece lie: `samples` a page pixel and direction, number 0 in the middle of its first one. */
typedef struct {
    const piece *k;
    int samples;
    double strip_px; /* strip pixels per page pixel */
    double x, step;  /* of sample 0, and to the next, page pixels */
    double us;       /* … and across */
} piece_frame;

piece_frame plb_piece_frame(const piece *k, int samples, double strip_px);

/* So many rows of samples at a time. */
#define PIECE_ROWS 64
typedef struct {
    int n;
    int first[PIECE_ROWS], last[PIECE_ROWS];           /* samples within the piece; none where last < first */
    double y[PIECE_ROWS];                              /* page pixels */
    double a[PIECE_ROWS], b[PIECE_ROWS], u[PIECE_ROWS]; /* the quantities of strip_map.c at sample 0 */
    double along[PIECE_ROWS], along_step[PIECE_ROWS];  /* of the first sample, and to the next; strip pixels */
} piece_rows;

/* Rows of samples from number `from` of the piece's box on, `n` of them, at most PIECE_ROWS. */
void plb_piece_rows(const piece_frame *f, int from, int n, piece_rows *r);
/* Tells whether the piece owns a sample of row j. */
bool plb_piece_owns(const piece_frame *f, const piece_rows *r, int j, int sample);
/* Tells how far along the line it lies, strip pixels. */
double plb_piece_along(const piece_frame *f, const piece_rows *r, int j, int sample);

#endif
