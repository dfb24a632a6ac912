/* SPDX-License-Identifier: MIT
 *
 * A hash grid of the plane: numbers put into square cells and found again. Its memory grows with what is put in, not
 * with the plane.
 */
#ifndef PLB_PLAN_SHAPE_GRID_H
#define PLB_PLAN_SHAPE_GRID_H

#include "base/array.h"
#include "base/geometry/geom.h"
#include "base/number/random.h"

#include <stdint.h>

typedef struct {
    uint32_t value, next; /* of the chain of its cell; GRID_END ends it */
    float mark;           /* the caller's: what it wants to know before it follows the value */
} grid_entry;
#define GRID_END UINT32_MAX

typedef struct {
    double cell; /* mm */
    uint32_t *head;
    size_t heads; /* a power of two */
    ARRAY(grid_entry) entries;
} grid;

/* Prepares the grid for about `n` numbers. False when out of memory, as with plb_grid_put. */
bool plb_grid_init(grid *g, double cell, size_t n);
void plb_grid_free(grid *g);
int64_t plb_grid_cell(const grid *g, double at);
bool plb_grid_put(grid *g, int64_t column, int64_t row, uint32_t value);
bool plb_grid_put_marked(grid *g, int64_t column, int64_t row, uint32_t value, double mark);
/* Gives the place of the cell's first entry in memory, for callers that look into many cells and fetch that place ahead. */
static inline uint32_t *plb_grid_head(const grid *g, int64_t column, int64_t row)
{
    return &g->head[random_fold(0, column, row) & (g->heads - 1)];
}
/* Gives the first entry of the chain that holds the cell's numbers, latest first, and maybe some of other cells. */
static inline uint32_t plb_grid_first(const grid *g, int64_t column, int64_t row)
{
    return *plb_grid_head(g, column, row);
}

/* Gives a direction as a share of half a turn, -1 to 1, then the one of so many equal parts of half a turn that holds
 * such a share: lines are kept apart by their direction, whichever way they are drawn. */
double plb_grid_turn(point way);
int64_t plb_grid_part(double turn, int parts);

/* A walk through the cells that come within `margin` of a segment (and maybe a few more beside its ends). */
typedef struct {
    const grid *g;
    int64_t row, last_row, column, last_column;
    point a, b; /* a above b */
    double margin;
} grid_walk;
grid_walk plb_grid_walk(const grid *g, point a, point b, double margin);
bool plb_grid_step(grid_walk *w, int64_t *column, int64_t *row);

#endif
