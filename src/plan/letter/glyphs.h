/* SPDX-License-Identifier: MIT
 *
 * The store keeps the middle lines of letters, worked out once for each shape: a page of text has thousands of letters and a few dozen
 * shapes. A shape is the outline of a part, seen from its first point and put on a lattice finer than any line shows: copies of a letter
 * that differ by rounding alone are one shape. All that is told of a shape follows from the shape alone, so neither the letters before it
 * nor the room that is left change a stroke.
 */
#ifndef PLB_PLAN_LETTER_GLYPHS_H
#define PLB_PLAN_LETTER_GLYPHS_H

#include "plan/letter/letter_parts.h"

/* A stroke ends half of so many pencil widths before the tip (chosen by eye). */
#define NIB_PENCILS 0.5

/* The shapes of one plan, with what is known of each. */
typedef struct glyph_store glyph_store;

/* A glyph is one shape. Lengths are mm; places are seen from the first point of its outline. */
typedef struct {
    contour_set outline; /* on the lattice */
    double area, perimeter;
    uint64_t code;    /* a hash of all that */
    uint32_t next;    /* the glyph before this one with the same last bits of the code, counted from 1; 0: none */
    bool is_rastered; /* false: the shape is too large for that */
    bool has_axis;    /* `axis` is worked out */
    double stem;      /* how broad its strokes are: 2 area / perimeter, contours that overlap counted once */
    double largest;   /* radius of the largest disc inside */
    pen axis;         /* the strokes of a pen along its middle */
} glyph;

/* Makes an empty store for a plan with a pencil of that width, mm. NULL and `err` when out of memory. The caller frees it. */
glyph_store *plb_glyphs_new(double shade_width, error *err);
void plb_glyphs_free(glyph_store *s);
/* Gives the shape of the part, measured, but for its axis. It belongs to the store and stays until the next call. NULL and `err` when out of memory. */
const glyph *plb_glyph(glyph_store *s, const letter_part *part, error *err);
/* Gives the axis of the glyph that the last call of plb_glyph gave. NULL and `err` when out of memory. */
const pen *plb_glyph_axis(glyph_store *s, const glyph *g, error *err);

#endif
