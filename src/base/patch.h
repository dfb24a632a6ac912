/* SPDX-License-Identifier: MIT
 *
 * A patch: a small raster of grey with its place on the page. It is what a stroke hands to the surface.
 */
#ifndef PLB_BASE_PATCH_H
#define PLB_BASE_PATCH_H

#include <stdbool.h>
#include <stdint.h>

/* Room behind a patch's pixels, so that its rows may be worked on in whole registers. */
#define PATCH_PAD 16
/* The largest side of a patch, in pixels: long strokes come as several patches that share no pixel. */
#define PATCH_SIDE 128

typedef struct {
    int x, y;          /* page pixel of grey[0]; may lie outside the page */
    int width, height; /* 1 to PATCH_SIDE */
    /* Columns [from, to) of each row may hold graphite; none when to is not beyond from. */
    uint8_t from[PATCH_SIDE], to[PATCH_SIDE];
    /* Row by row, `width` a row. 255: no graphite; lower: darker. On a scale where the profile's paper is 255. */
    uint8_t grey[PATCH_SIDE * PATCH_SIDE + PATCH_PAD];
} patch;

/* Receives the patches of a stroke one after the other; the patch is the caller's and dies with the call.
 * False stops the stroke. */
typedef bool (*patch_sink)(void *closure, const patch *p);

#endif
