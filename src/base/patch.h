/* SPDX-License-Identifier: MIT
 *
 * A patch is a small raster of grey with its place on the page. Strokes hand patches to the surface.
 */
#ifndef PLB_BASE_PATCH_H
#define PLB_BASE_PATCH_H

#include <stdbool.h>
#include <stdint.h>

/* So many bytes lie behind a patch's pixels, so that loops may work on its rows in whole registers. */
#define PATCH_PAD 16
/* The largest side of a patch, in pixels: long strokes come as several patches that share no pixel. */
#define PATCH_SIDE 128

typedef struct {
    int x, y;          /* page pixel of grey[0]; may lie outside the page */
    int width, height; /* 1 to PATCH_SIDE */
    /* Columns [from, to) of each row may hold graphite; none when to is not beyond from. */
    uint8_t from[PATCH_SIDE], to[PATCH_SIDE];
    /* The pixels follow row by row, `width` a row: 255 has no graphite, lower values are darker. The profile's paper is 255. */
    uint8_t grey[PATCH_SIDE * PATCH_SIDE + PATCH_PAD];
} patch;

/* Receives the patches of a stroke one after the other. The caller owns the patch, which lives for the call only.
 * Returning false stops the stroke. */
typedef bool (*patch_sink)(void *closure, const patch *p);

#endif
