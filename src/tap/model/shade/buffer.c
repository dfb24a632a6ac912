/* SPDX-License-Identifier: MIT
 *
 * The buffer of seen surfaces: see shade.h. Tone needs no more than the raster's exactness, for its areas end under lines, or where a hand
 * would not end more exactly; lines are never taken from here.
 */
#include "tap/model/shade/shade.h"

/* A cell measures this, mm, or more where a page of so many cells would not hold the drawing (chosen by eye: a third of a pencil's
 * line; time). */
#define CELL_MM 0.12
#ifndef MODEL_MAX_CELLS
#define MODEL_MAX_CELLS 4e6
#endif

void plb_buffer_free(surface_buffer *b)
{
    plb_free(b->triangle);
    plb_free(b->depth);
    *b = (surface_buffer){0};
}

uint32_t plb_buffer_at(const surface_buffer *b, point mm)
{
    double x = (mm.x - b->corner.x) / b->cell, y = (mm.y - b->corner.y) / b->cell;
    return x >= 0 && y >= 0 && x < b->width && y < b->height ? b->triangle[(size_t)y * (size_t)b->width + (size_t)x] : NO_TRIANGLE;
}

/* The columns of row y within the triangle, from `a` up to, not including, `b`. */
static bool columns(const point c[3], double y, double *a, double *b)
{
    int n = 0;
    double x[2] = {0, 0};
    for (int k = 0; k < 3 && n < 2; k++) {
        point p = c[k], q = c[(k + 1) % 3];
        if ((p.y <= y) != (q.y <= y))
            x[n++] = p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y));
    }
    *a = lesser(x[0], x[1]);
    *b = greater(x[0], x[1]);
    return n == 2;
}

static void fill_triangle(surface_buffer *b, const view *v, uint32_t t)
{
    vector at[3];
    point c[3];
    double top = 1e300, bottom = -1e300;
    for (int k = 0; k < 3; k++) {
        at[k] = view_corner(v, t, k);
        c[k] = (point){(at[k].x - b->corner.x) / b->cell - .5, (at[k].y - b->corner.y) / b->cell - .5}; /* middles of cells are whole */
        top = lesser(top, c[k].y);
        bottom = greater(bottom, c[k].y);
    }
    vector n = vector_cross(vector_sub(at[1], at[0]), vector_sub(at[2], at[0]));
    if (n.z == 0)
        return;
    /* Depth in cells: z0 + zx column + zy row. */
    double zx = -n.x / n.z * b->cell, zy = -n.y / n.z * b->cell, z0 = at[0].z - zx * c[0].x - zy * c[0].y;
    for (double y = ceil(greater(top, 0)); y <= bottom && y < b->height; y++) {
        double from, to;
        if (!columns(c, y, &from, &to))
            continue;
        size_t row = (size_t)y * (size_t)b->width;
        for (double x = ceil(greater(from, 0)); x < to && x < b->width; x++) {
            size_t i = row + (size_t)x;
            float z = (float)(z0 + zx * x + zy * y);
            if (b->triangle[i] == NO_TRIANGLE || z > b->depth[i]) {
                b->triangle[i] = t;
                b->depth[i] = z;
            }
        }
    }
}

bool plb_buffer_fill(const view *v, surface_buffer *b, error *err)
{
    double w = v->bounds.x1 - v->bounds.x0, h = v->bounds.y1 - v->bounds.y0;
    double cell = greater(CELL_MM, sqrt(w * h / MODEL_MAX_CELLS));
    cell = greater(cell, greater(w, h) / MODEL_MAX_CELLS * 100); /* a page like a hair */
    *b = (surface_buffer){.width = (int)(w / cell) + 3, .height = (int)(h / cell) + 3, .cell = cell};
    b->corner = (point){v->bounds.x0 - cell, v->bounds.y0 - cell};
    size_t n = (size_t)b->width * (size_t)b->height;
    b->triangle = plb_new(n, sizeof *b->triangle);
    b->depth = plb_new(n, sizeof *b->depth);
    if (!b->triangle || !b->depth) {
        plb_buffer_free(b);
        return plb_fail_memory(err);
    }
    for (size_t i = 0; i < n; i++)
        b->triangle[i] = NO_TRIANGLE;
    for (uint32_t t = 0; t < v->m->triangles.n; t++)
        fill_triangle(b, v, t);
    return true;
}
