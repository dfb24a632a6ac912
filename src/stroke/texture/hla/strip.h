/* SPDX-License-Identifier: MIT
 *
 * The papers' texture is a strip of greys (001 section 3.2).
 */
#ifndef PLB_STROKE_TEXTURE_HLA_STRIP_H
#define PLB_STROKE_TEXTURE_HLA_STRIP_H

#include "base/error.h"
#include "stroke/mapping/strip_map.h"

/* The texture in the strip frame: `columns` along the line, `rows` across (odd, the middle row is the centreline),
 * one byte a pixel of the profile's resolution, 255 = paper; row by row. */
#define STRIP_MARGIN 2 /* pixels of paper around it: one for the blur, one for interpolation */
typedef struct {
    int columns, rows;
    size_t capacity;
    uint8_t *grey, *spare; /* spare: of the same size, for the blur */
} strip;
void plb_strip_free(strip *s);

/* Each step of 001 section 3.2 by itself (texture_fill.c, texture_ccm.c, texture_blur.c). */
bool plb_texture_fill(strip *s, double length_px, const pencil *p, uint64_t seed, uint64_t identity, error *err);
/* Returns the number of passes; `changes` (may be NULL, else of CCM_MAX_PASSES) gets the changes of each. */
#define CCM_MAX_PASSES 32
int plb_texture_ccm(strip *s, const pencil *p, long changes[CCM_MAX_PASSES]);
void plb_texture_blur(strip *s);
/* Lets a closed line's texture run on across its joint: the margins at the ends take the columns of the other end. */
void plb_texture_wrap(strip *s);
/* All three in order; `closed` strokes are wrapped. */
bool plb_texture(strip *s, double length_px, bool closed, const pencil *p, uint64_t seed, uint64_t identity, error *err);

/* Gives the papers' strip as a texture to map (bilinear between its pixels). */
shading plb_strip_shading(const strip *s, double dpi);
/* Its greys darker or paler by `pressure`, times the usual. */
void plb_strip_press(strip *s, double pressure);

#endif
