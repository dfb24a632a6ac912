/* SPDX-License-Identifier: MIT
 *
 * Hash grid: see grid.h.
 */
#include "plan/shape/grid.h"

#include <math.h>
#include <string.h>

bool plb_grid_init(grid *g, double cell, size_t n)
{
    memset(g, 0, sizeof *g);
    g->cell = cell;
    g->heads = 1024;
    while (g->heads < n && g->heads < (size_t)1 << 24)
        g->heads *= 2;
    g->head = plb_new(g->heads, sizeof *g->head);
    if (!g->head)
        return false;
    memset(g->head, 0xff, g->heads * sizeof *g->head); /* GRID_END */
    return true;
}

void plb_grid_free(grid *g)
{
    plb_free(g->head);
    array_free(&g->entries);
}

int64_t plb_grid_cell(const grid *g, double at)
{
    return (int64_t)floor(at / g->cell);
}

bool plb_grid_put(grid *g, int64_t column, int64_t row, uint32_t value)
{
    return plb_grid_put_marked(g, column, row, value, 0);
}

bool plb_grid_put_marked(grid *g, int64_t column, int64_t row, uint32_t value, double mark)
{
    uint32_t *head = plb_grid_head(g, column, row);
    grid_entry e = {value, *head, (float)mark};
    if (g->entries.n >= GRID_END || !array_push(&g->entries, e))
        return false;
    *head = (uint32_t)(g->entries.n - 1);
    return true;
}

double plb_grid_turn(point way)
{
    return atan2(way.y, way.x) / PLB_PI;
}

int64_t plb_grid_part(double turn, int parts)
{
    double whole = turn + 2;
    return (int64_t)((whole - floor(whole)) * parts) % parts;
}

/* Computes the columns of the walk's row: where the segment passes it. */
static void enter_row(grid_walk *w)
{
    double cell = w->g->cell, height = w->b.y - w->a.y, x0 = w->a.x, x1 = w->b.x;
    if (height > 1e-9) {
        double top = ((double)w->row * cell - w->margin - w->a.y) / height, bottom = (((double)w->row + 1) * cell + w->margin - w->a.y) / height;
        x0 = point_mix(w->a, w->b, fmin(fmax(top, 0), 1)).x;
        x1 = point_mix(w->a, w->b, fmin(fmax(bottom, 0), 1)).x;
    }
    w->column = plb_grid_cell(w->g, fmin(x0, x1) - w->margin);
    w->last_column = plb_grid_cell(w->g, fmax(x0, x1) + w->margin);
}

grid_walk plb_grid_walk(const grid *g, point a, point b, double margin)
{
    grid_walk w = {.g = g, .a = a.y <= b.y ? a : b, .b = a.y <= b.y ? b : a, .margin = margin};
    w.row = plb_grid_cell(g, w.a.y - margin);
    w.last_row = plb_grid_cell(g, w.b.y + margin);
    enter_row(&w);
    return w;
}

bool plb_grid_step(grid_walk *w, int64_t *column, int64_t *row)
{
    if (w->column > w->last_column) {
        if (w->row >= w->last_row)
            return false;
        w->row++;
        enter_row(w);
    }
    *column = w->column++;
    *row = w->row;
    return true;
}
