/* SPDX-License-Identifier: MIT
 *
 * The raster of topmost areas: see coverage_raster.h. Areas come from the last painted to the first, so a cell is settled by
 * the first that covers it, and each row keeps its open cells as a forest of links to the next one (Tarjan's
 * union-find): a settled stretch is passed in one step, however many areas lie below it.
 */
#include "plan/hidden/coverage_raster.h"

#include "plan/shape/flatten.h"
#include "plan/shape/grid.h"

#include <math.h>
#include <stdlib.h>

/* Cells along the longer side: so many times the root of the number of areas, within bounds (by estimate). */
#define CELLS_PER_ROOT 16
#define CELLS_MIN 64
#define CELLS_MAX 1024
/* Cells and crossings looked at for one drawing, about a second of them; after that areas are no longer added. */
#define MAX_RASTER_WORK 3e7

typedef struct {
    point a, b;
} shape_edge;

typedef struct {
    double x;
    int way; /* the edge's direction: 1 down, -1 up */
} crossing;

struct coverage_raster {
    grid cells; /* its cell size is all that is used, for walks */
    int columns, rows;
    uint32_t *top;  /* of each cell: one more than the order of what covers it; 0: nothing does */
    uint32_t *open; /* of each cell, and of one past each row's end: itself, or on towards the next open one */
    uint32_t *mark; /* of each cell: the last shape with an edge in it, as in `top` */
    int *low, *high;  /* of each row: the columns that the shape at work lies in */
    size_t *first;    /* of each row, and one more: where its crossings start */
    track_list lines;  /* of the shape at work … */
    ARRAY(shape_edge) edges; /* … and their edges */
    ARRAY(crossing) at;
    double work;
};

coverage_raster *plb_coverage_new(double width, double height, size_t areas)
{
    coverage_raster *t = plb_new(1, sizeof *t);
    if (!t)
        return NULL;
    double side = fmin(fmax(CELLS_PER_ROOT * sqrt((double)areas), CELLS_MIN), CELLS_MAX);
    t->cells.cell = fmax(width, height) / side;
    t->columns = (int)ceil(width / t->cells.cell);
    t->rows = (int)ceil(height / t->cells.cell);
    size_t rows = (size_t)t->rows, n = rows * (size_t)t->columns;
    t->top = plb_new(n, sizeof *t->top);
    t->mark = plb_new(n, sizeof *t->mark);
    t->open = plb_new(n + rows, sizeof *t->open);
    t->low = plb_new(rows, sizeof *t->low);
    t->high = plb_new(rows, sizeof *t->high);
    t->first = plb_new(rows + 2, sizeof *t->first);
    if (!t->top || !t->mark || !t->open || !t->low || !t->high || !t->first) {
        plb_coverage_free(t);
        return NULL;
    }
    for (size_t i = 0; i < n + rows; i++)
        t->open[i] = (uint32_t)(i % ((size_t)t->columns + 1));
    return t;
}

void plb_coverage_free(coverage_raster *t)
{
    if (!t)
        return;
    plb_free(t->top);
    plb_free(t->mark);
    plb_free(t->open);
    plb_free(t->low);
    plb_free(t->high);
    plb_free(t->first);
    plb_tracks_free(&t->lines);
    array_free(&t->edges);
    array_free(&t->at);
    plb_free(t);
}

/* Gives the first open column of the row from `column` on; t->columns: none. */
static int next_open(coverage_raster *t, int row, int column)
{
    uint32_t *open = t->open + (size_t)row * ((size_t)t->columns + 1), k = (uint32_t)column;
    while (open[k] != k)
        k = open[k] = open[open[k]];
    return (int)k;
}

static int clamp(double k, int n)
{
    return k <= 0 ? 0 : k >= n ? n - 1 : (int)k;
}

static int column_of(const coverage_raster *t, double x)
{
    return clamp(x / t->cells.cell, t->columns);
}

static int row_of(const coverage_raster *t, double y)
{
    return clamp(y / t->cells.cell, t->rows);
}

bool plb_coverage_hides_box(coverage_raster *t, box b)
{
    int left = column_of(t, b.x0), right = column_of(t, b.x1), row = row_of(t, b.y0), last = row_of(t, b.y1);
    while (row <= last && next_open(t, row, left) > right)
        row++;
    return row > last;
}

/* ---- a shape ---- */

/* Finds the edges of the shape at work, whose subpaths are closed. */
static bool find_edges(coverage_raster *t, const path *shape, error *err)
{
    plb_tracks_clear(&t->lines);
    if (!plb_plan_flatten(shape, true, &t->lines, err))
        return false;
    bool ok = true;
    t->edges.n = 0;
    for (size_t k = 0; ok && k < t->lines.tracks.n; k++) {
        track line = plb_track_at(&t->lines, k);
        ok = array_reserve(&t->edges, line.n);
        for (size_t i = 0; ok && i < line.n; i++)
            t->edges.v[t->edges.n++] = (shape_edge){line.v[i].at, line.v[(i + 1) % line.n].at};
    }
    return ok;
}

/* Computes the part of an edge that is on the page or just beside it; false: none is. */
static bool clip_edge(const coverage_raster *t, shape_edge *e)
{
    double more = EDGE_MARGIN_MM, size[2] = {t->columns * t->cells.cell, t->rows * t->cells.cell}, from = 0, to = 1;
    double at[2] = {e->a.x, e->a.y}, way[2] = {e->b.x - e->a.x, e->b.y - e->a.y};
    for (int k = 0; k < 2; k++) {
        if (way[k] == 0 && (at[k] < -more || at[k] > size[k] + more))
            return false;
        if (way[k] == 0)
            continue;
        double s = (-more - at[k]) / way[k], u = (size[k] + more - at[k]) / way[k];
        from = fmax(from, fmin(s, u));
        to = fmin(to, fmax(s, u));
    }
    *e = (shape_edge){point_mix(e->a, e->b, from), point_mix(e->a, e->b, to)};
    return from <= to;
}

/* Marks the cells that the shape's edges come near to, and finds each row's outermost. */
static void mark_edges(coverage_raster *t, uint32_t name)
{
    for (int row = 0; row < t->rows; row++) {
        t->low[row] = t->columns;
        t->high[row] = -1;
    }
    for (size_t i = 0; i < t->edges.n; i++) {
        shape_edge e = t->edges.v[i];
        if (!clip_edge(t, &e))
            continue;
        grid_walk w = plb_grid_walk(&t->cells, e.a, e.b, EDGE_MARGIN_MM);
        int64_t column, row;
        while (plb_grid_step(&w, &column, &row)) {
            t->work++;
            if (column < 0 || row < 0 || column >= t->columns || row >= t->rows)
                continue;
            t->mark[row * t->columns + column] = name;
            t->low[row] = column < t->low[row] ? (int)column : t->low[row];
            t->high[row] = column > t->high[row] ? (int)column : t->high[row];
        }
    }
}

static bool hides_marked(coverage_raster *t)
{
    for (int row = 0; row < t->rows; row++)
        if (t->high[row] >= 0 && next_open(t, row, t->low[row]) <= t->high[row])
            return false;
    return true;
}

/* Computes the rows whose middle an edge passes: from the first to before the last. */
static void rows_passed(const coverage_raster *t, shape_edge e, int *first, int *last)
{
    double low = fmin(e.a.y, e.b.y) / t->cells.cell - .5, high = fmax(e.a.y, e.b.y) / t->cells.cell - .5;
    *first = (int)fmin(fmax(ceil(low), 0), t->rows);
    *last = (int)fmin(fmax(ceil(high), 0), t->rows);
}

static int compare_crossings(const void *a, const void *b)
{
    const crossing *x = a, *y = b;
    return (x->x > y->x) - (x->x < y->x);
}

/* Finds where the edges cross the rows' middles, row after row, from left to right. */
static bool find_crossings(coverage_raster *t)
{
    int row, last;
    size_t *first = t->first + 1; /* of the row before: counted one on, so that filling moves it to its place */
    for (row = 0; row <= t->rows; row++)
        t->first[row] = first[row] = 0;
    for (size_t i = 0; i < t->edges.n; i++)
        for (rows_passed(t, t->edges.v[i], &row, &last); row < last; row++)
            first[row + 1]++;
    for (row = 0; row < t->rows; row++)
        first[row + 1] += first[row];
    size_t n = first[t->rows];
    t->work += (double)n;
    t->at.n = 0;
    if (!array_reserve(&t->at, n))
        return false;
    for (size_t i = 0; i < t->edges.n; i++) {
        shape_edge e = t->edges.v[i];
        for (rows_passed(t, e, &row, &last); row < last; row++) {
            double y = (row + .5) * t->cells.cell;
            t->at.v[first[row]++] = (crossing){e.a.x + (y - e.a.y) / (e.b.y - e.a.y) * (e.b.x - e.a.x), e.a.y < e.b.y ? 1 : -1};
        }
    }
    for (row = 0; row < t->rows; row++)
        if (t->first[row + 1] > t->first[row] + 1)
            qsort(t->at.v + t->first[row], t->first[row + 1] - t->first[row], sizeof *t->at.v, compare_crossings);
    return true;
}

/* Settles the open cells of a row from one column to another that hold no edge of the shape. */
static void settle(coverage_raster *t, int row, int from, int to, uint32_t name)
{
    uint32_t *open = t->open + (size_t)row * ((size_t)t->columns + 1);
    for (int k = from <= to ? next_open(t, row, from) : t->columns; k <= to; k = next_open(t, row, k + 1)) {
        size_t cell = (size_t)row * (size_t)t->columns + (size_t)k;
        t->work++;
        if (t->mark[cell] == name)
            continue;
        t->top[cell] = name;
        open[k] = (uint32_t)k + 1;
    }
}

/* Gives the whole number at most `k`, within low..high; shapes may lie far beyond what an integer holds. */
static int floor_within(double k, int low, int high)
{
    return k >= high ? high : k > low ? (int)floor(k) : low;
}

/* Only cells that are within the box, but for those at the page's border, are settled. */
static void fill(coverage_raster *t, bool even_odd, box within, uint32_t name)
{
    double cell = t->cells.cell, more = EDGE_MARGIN_MM;
    int left = within.x0 <= 0 ? 0 : floor_within(ceil((within.x0 + more) / cell), 0, t->columns);
    int top = within.y0 <= 0 ? 0 : floor_within(ceil((within.y0 + more) / cell), 0, t->rows);
    int right = floor_within((within.x1 - more) / cell, 0, t->columns) - 1, bottom = floor_within((within.y1 - more) / cell, 0, t->rows) - 1;
    for (int row = top; row <= bottom; row++) {
        int winding = 0;
        for (size_t i = t->first[row]; i + 1 < t->first[row + 1]; i++) {
            winding += even_odd ? 1 : t->at.v[i].way;
            if (even_odd ? !(winding & 1) : winding == 0)
                continue;
            int from = floor_within(ceil(t->at.v[i].x / cell - .5), left, t->columns), to = floor_within(ceil(t->at.v[i + 1].x / cell - .5) - 1, -1, right);
            settle(t, row, from, to, name);
        }
    }
}

static bool is_within(box b, box within)
{
    return b.x0 >= within.x0 && b.y0 >= within.y0 && b.x1 <= within.x1 && b.y1 <= within.y1;
}

bool plb_coverage_add(coverage_raster *t, const path *shape, bool even_odd, box within, bool covers, size_t order, bool *is_hidden, error *err)
{
    *is_hidden = false;
    if (t->work > MAX_RASTER_WORK || order >= UINT32_MAX)
        return true;
    if (!find_edges(t, shape, err))
        return plb_fail_memory(err);
    mark_edges(t, (uint32_t)order + 1);
    *is_hidden = is_within(plb_path_bounds(shape), within) && hides_marked(t);
    if (*is_hidden || !covers)
        return true;
    if (!find_crossings(t))
        return plb_fail_memory(err);
    fill(t, even_odd, within, (uint32_t)order + 1);
    return true;
}

/* ---- questions ---- */

static bool is_over(const coverage_raster *t, size_t order, int64_t column, int64_t row)
{
    return column >= 0 && row >= 0 && column < t->columns && row < t->rows && t->top[row * t->columns + column] > order + 1;
}

bool plb_coverage_is_over(const coverage_raster *t, size_t order, point p)
{
    return is_over(t, order, plb_grid_cell(&t->cells, p.x), plb_grid_cell(&t->cells, p.y));
}

/* The part of a segment's way along one axis: to the next border of cells, and from one to the next. */
typedef struct {
    double next, step; /* parameters */
    int64_t way;
} axis;

static axis axis_of(const coverage_raster *t, double from, double to)
{
    double cell = t->cells.cell, length = to - from;
    if (length == 0)
        return (axis){INFINITY, INFINITY, 0};
    double border = (floor(from / cell) + (length > 0)) * cell;
    return (axis){(border - from) / length, cell / fabs(length), length > 0 ? 1 : -1};
}

/* Narrows the parameters to the part of a segment whose coordinate lies within `n` cells; false: no part does. Cells beyond
 * the raster are open, so nothing is crossed there. */
static bool within_raster(const coverage_raster *t, double from, double length, int64_t n, double *enters, double *leaves)
{
    double far_edge = (double)n * t->cells.cell;
    if (length == 0)
        return from >= 0 && from <= far_edge;
    double low = -from / length, high = (far_edge - from) / length;
    *enters = fmax(*enters, fmin(low, high));
    *leaves = fmin(*leaves, fmax(low, high));
    return *enters < *leaves;
}

bool plb_coverage_cross(const coverage_raster *t, size_t order, point from, point to, crossings *at)
{
    double enters = 0, leaves = 1;
    if (!within_raster(t, from.x, to.x - from.x, t->columns, &enters, &leaves) || !within_raster(t, from.y, to.y - from.y, t->rows, &enters, &leaves))
        return true;
    point start = from;
    from = point_mix(start, to, enters);
    to = point_mix(start, to, leaves);
    int64_t column = plb_grid_cell(&t->cells, from.x), row = plb_grid_cell(&t->cells, from.y);
    axis x = axis_of(t, from.x, to.x), y = axis_of(t, from.y, to.y);
    bool before = is_over(t, order, column, row);
    for (double s = fmin(x.next, y.next); s < 1; s = fmin(x.next, y.next)) {
        axis *a = x.next <= y.next ? &x : &y;
        *(a == &x ? &column : &row) += a->way;
        a->next += a->step;
        bool now = is_over(t, order, column, row);
        if (now != before && s > 0 && !array_push(at, enters + s * (leaves - enters)))
            return false;
        before = now;
    }
    return true;
}
