/* SPDX-License-Identifier: MIT
 *
 * Small fills of many tones that adjoin, as the cells of a heat map, the steps of a colour bar or the bands between contour lines: a
 * person shades them as one area, darker here and lighter there.
 */
#ifndef PLB_PLAN_TONE_CELLS_H
#define PLB_PLAN_TONE_CELLS_H

#include "list/display_list.h"
#include "plan/hidden/occlusion.h"

#include <stdint.h>

/* A tone_field says how dark each place of a group of cells is: rows of squares. */
typedef struct {
    box bounds;      /* mm */
    double square;   /* side, mm */
    int columns, rows;
    float *darkness; /* rows * columns, 0 to 1; 0 where no cell lies */
    double finest;   /* about the breadth of the narrower cells, mm */
} tone_field;

/* All groups of a drawing. */
typedef struct cell_groups cell_groups;

/* Tells by a glance whether there may be any: there are fills of many paints. */
bool plb_cells_may_be(const display_list *list);
/* Finds the groups; `o` tells which items are hidden. The list stays the caller's and must outlive the result. NULL and `err` when out of memory. */
cell_groups *plb_cells_new(const display_list *list, const occluders *o, error *err);
void plb_cells_free(cell_groups *g);
/* Gives one more than the number of the group that item `i` is a cell of; 0: it is none. */
uint32_t plb_cells_group(const cell_groups *g, size_t i);
/* Tells whether item `i` is the last cell of its group that is seen. */
bool plb_cells_is_last(const cell_groups *g, size_t i);
/* Gives the clip of the group's hatching, for a cell. */
int plb_cells_clip(const cell_groups *g, size_t i);
/* Fills the field of a group; the caller frees it with plb_field_free. False and `err` when out of memory. */
bool plb_cells_field(const cell_groups *g, uint32_t group, tone_field *f, error *err);
void plb_field_free(tone_field *f);
/* Gives the darkness at a place; 0 outside. */
double plb_field_at(const tone_field *f, point at);

#endif
