/* SPDX-License-Identifier: MIT
 *
 * A line straightened, its greys on a scale where paper is 255, and what is not the pencil's left out.
 */
#ifndef PLB_PROFILE_CAPTURE_LINE_STRIP_H
#define PLB_PROFILE_CAPTURE_LINE_STRIP_H

#include "profile/hand.h"
#include "profile/profile.h"

/* Columns are shifted by whole pixels, nothing is resampled: every grey is a pixel of the scan. Column k is
 * grey[k * rows] to grey[k * rows + rows - 1], rows = 2 * reach + 1, its middle row the one nearest the centreline. */
typedef struct {
    int n, reach;
    uint8_t *grey;
    float *dark;     /* 255 - grey for the grain: neither rounded nor cut at STRIP_LIGHTEST, but paper beyond 8 px */
    double *offset;  /* of the centreline from the middle row, -0.5 to 0.5 px */
    double *cosine;  /* of its direction: a row's distance from the centreline is (row - offset) * cosine */
    bool *usable;    /* false: near an end of the line, or another mark is here */
    int columns;     /* how many are usable */
    int paper;       /* grey of the paper in the scan */
    int centre;      /* median grey of the middle row */
    double width_half, width_tenth; /* px, across the line */
    int strays;      /* how far its line strays: so many … */
    double stray[HAND_MODES]; /* … modes' amplitudes, times a free hand's */
} line_strip;

/* Greys above this, on the scale where paper is 255, are paper: beyond the lines of the scans at hand 99 of 100 pixels
 * are lighter (scanner noise and JPEG ringing). They are set to 255. */
#define STRIP_LIGHTEST 246
/* The same for the grain. It needs the tails: what lies between 246 and 250 is the line's own faint rim. */
#define STRIP_GRAIN_LIGHTEST 250
#define STRIP_GRAIN_REACH 8 /* in 1/300 inch: rows beyond are paper */

static inline int strip_rows(const line_strip *s)
{
    return 2 * s->reach + 1;
}
/* Gives the grey `o` rows from the middle of column k, and the distance of that pixel from the centreline. */
static inline uint8_t strip_grey(const line_strip *s, int k, int o)
{
    return s->grey[(size_t)k * (size_t)strip_rows(s) + (size_t)(o + s->reach)];
}
static inline float strip_dark(const line_strip *s, int k, int o)
{
    return s->dark[(size_t)k * (size_t)strip_rows(s) + (size_t)(o + s->reach)];
}
static inline double strip_distance(const line_strip *s, int k, int o)
{
    double d = (o - s->offset[k]) * s->cosine[k];
    return d < 0 ? -d : d;
}

#endif
