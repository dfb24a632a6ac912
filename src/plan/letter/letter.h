/* SPDX-License-Identifier: MIT
 *
 * Lettering: a fill that is thin everywhere - text as glyph outlines, expanded strokes, thin bars - becomes the strokes of
 * a pen along its medial axis.
 */
#ifndef PLB_PLAN_LETTER_LETTER_H
#define PLB_PLAN_LETTER_LETTER_H

#include "plan/letter/medial.h"
#include "plan/plan.h"
#include "plan/track.h"

/* Appends the strokes of `fill` to `out`: of the kind STROKE_LETTER, in mm, corners marked. *taken is false, and nothing
 * appended, when the shape is not like lettering: solid, thick or far too large. False and `err` when out of memory. */
bool plb_plan_letter(const item *fill, const plan_options *o, bool *taken, track_list *out, error *err);

/* letter_parts.c: a fill taken apart into what does not touch: each part is an outer contour with its holes and whatever
 * overlaps with it. Parts are in the order in which they were drawn. */
typedef struct {
    contour_set outline;
    box bounds;
    double area, perimeter; /* mm^2, mm; of contours that overlap the sums */
} letter_part;
typedef struct {
    ARRAY(letter_part) parts;
} letter_parts;
/* Left empty, with true, when the fill is too complex to be lettering. */
bool plb_letter_split(letter_parts *p, const item *fill, error *err);
void plb_letter_parts_free(letter_parts *p);

#endif
