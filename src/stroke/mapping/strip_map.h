/* SPDX-License-Identifier: MIT
 *
 * The texture laid along the path. A texture is made in the strip frame: `along` the path and `across` it.
 */
#ifndef PLB_STROKE_MAPPING_STRIP_MAP_H
#define PLB_STROKE_MAPPING_STRIP_MAP_H

#include "base/patch.h"
#include "stroke/path/trajectory.h"

/* Evenly spaced samples of a texture, a row of them on the page. */
typedef struct {
    int n;
    double along, along_step;   /* the first one's place and the way to each next, px of the texture from the line's start */
    double across, across_step; /* … and from its centreline, positive to the right */
    double x, y, step;          /* the first one's place on the page and the way to each next (in x), mm */
} sample_row;

/* A texture in the strip frame, as the mapping asks for it. */
typedef struct {
    const void *texture;
    /* Darkness, 0 to 255, of each sample of `n` rows, one after the other, into `out`. */
    void (*shade)(const void *texture, const sample_row *rows, int n, uint8_t *out);
    bool one_by_one;   /* rows have one sample: each at its exact place, no matter what it costs */
    double half_width; /* px: farther across there is none */
    double beyond;     /* px: how far it reaches beyond the ends of an open line */
    double dpi;        /* of its pixels */
    bool whole_pixels; /* a sample stands for a whole pixel of the page, however coarse that is */
} shading;

/* A buffer for mapping, kept from stroke to stroke. */
typedef struct {
    uint8_t *fine;
    size_t size;
} map_buffer;

/* No pencil leaves graphite farther than this from its path, whatever a profile says. */
#define STROKE_REACH_MM 4.0

/* The page as the mapping sees it: its resolution, and the rows [top, bottom) that are wanted. */
typedef struct {
    double dpi;
    int top, bottom;
} map_page;

/* Lays the texture along the path and hands out the patches it makes on the page (strip_map.c). A pixel of the page belongs
 * to one patch of a stroke only, except where the stroke crosses itself. The rows wanted get the same pixels whatever
 * others are. */
bool plb_strip_map(const shading *s, const map_page *page, const path_samples *path, bool closed, map_buffer *buffer, patch_sink sink,
                   void *closure);

#endif
