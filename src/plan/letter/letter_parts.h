/* SPDX-License-Identifier: MIT
 *
 * Step 1 of lettering takes a fill apart into what does not touch.
 */
#ifndef PLB_PLAN_LETTER_LETTER_PARTS_H
#define PLB_PLAN_LETTER_LETTER_PARTS_H

#include "list/display_list.h"
#include "plan/letter/medial/medial.h"

/* A fill is taken apart into what does not touch: each part is an outer contour with its holes and whatever
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
