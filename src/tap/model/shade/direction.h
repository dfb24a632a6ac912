/* SPDX-License-Identifier: MIT
 *
 * Directions of hatching: along the surface. A flat face is hatched down its slope; a round one along its principal direction of least
 * curvature where that is sure, as a cylinder along its axis, else down its slope.
 */
#ifndef PLB_TAP_MODEL_SHADE_DIRECTION_H
#define PLB_TAP_MODEL_SHADE_DIRECTION_H

#include "tap/model/shade/key_table.h"
#include "tap/model/view/view.h"

struct surface_buffer;

/* A direction on the page without a sense: the cosine and the sine of twice its angle, times how sure it is, 0 to 1. */
typedef struct {
    double cosine, sine;
} page_direction;

typedef struct {
    const view *v;                       /* borrowed */
    const unsigned char *is_round;       /* by patch; borrowed */
    page_direction *triangles;           /* by triangle */
    key_table places;                    /* a patch and a block of cells */
    ARRAY(page_direction) blocks;        /* by their numbers: the mean over the block and those around it */
} direction_field;

/* Finds the directions of what the buffer shows. False when out of memory. */
bool plb_find_directions(const view *v, const struct surface_buffer *b, const unsigned char *is_round, direction_field *f);
void plb_direction_free(direction_field *f);
/* Gives the direction at a cell of the buffer, in which triangle t is seen. */
page_direction plb_direction_at(const direction_field *f, uint32_t t, int x, int y);

/* Directions of round surfaces are told apart by so many sectors of half a turn. Chosen by eye: a hand's strokes stray by about as much. */
#define SECTORS 6u
uint32_t plb_direction_sector(page_direction d);
/* Gives the angle, whole degrees clockwise from the right, of the sum over n directions; false where they are not sure, or contradict each other. */
bool plb_direction_angle(page_direction sum, double n, double *degrees);

#endif
