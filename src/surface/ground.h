/* SPDX-License-Identifier: MIT
 *
 * The ground is the sheet itself as a scanner sees it: toned, mottled, with fibres, smeared a little beside darks, and with ghosts of construction lines
 * that were rubbed out. It is a function of places on the page in mm, so that it is the same at any resolution, in any bands, on any threads.
 */
#ifndef PLB_SURFACE_GROUND_H
#define PLB_SURFACE_GROUND_H

#include "base/error.h"
#include "list/stroke_list.h"

#include <stdint.h>

typedef struct ground ground;

/* Makes the ground of a page with these strokes, which lie on the page, mm, and which it does not keep. NULL and `err` when out of memory. */
ground *plb_ground_new(const stroke_list *strokes, uint64_t seed, error *err);
void plb_ground_free(ground *g);
/* Computes the share of the light that comes back from bare paper, 1 from white, at n places, GROUND_PIECE at most: the first is `x`, `y` mm from the
 * page's upper left corner, and each is `step` mm to the right of the one before. */
#define GROUND_PIECE 256
void plb_ground_row(const ground *g, double x, double y, double step, int n, float *out);

/* Paper is not quite grey: it returns less blue. These are its shares of red, green and blue. */
extern const float plb_ground_tint[3];

#endif
