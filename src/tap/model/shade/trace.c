/* SPDX-License-Identifier: MIT
 *
 * Regions of a raster become outlines: along the cells' sides, then straightened.
 */
#include "tap/model/shade/shade.h"

/* An outline may stray so far from the cells' sides, in cells: a slanted edge is a staircase of steps of 1. */
#define STRAY 0.75
/* Loops around less, mm², are left out, holes as well: a hand does not hatch them (chosen by eye). */
#define MIN_AREA 1.2
/* … and those whose area over half their length, mm, is less: strips as narrow as a line. */
#define MIN_BREADTH 0.35

typedef struct {
    const surface_buffer *b;
    const uint32_t *label;
    unsigned char *is_done; /* by cell: its upper side is in a loop of its region */
    ARRAY(point) loop;      /* corners of cells */
    ARRAY(unsigned char) is_kept;
    tone_list *out;
} tracer;

static bool is_in(const tracer *t, int x, int y, uint32_t region)
{
    return x >= 0 && y >= 0 && x < t->b->width && y < t->b->height && t->label[(size_t)y * (size_t)t->b->width + (size_t)x] == region;
}

/* Walks around the region with it on the right, from the upper left corner of the cell. The corner x y has the cells x-1 and x, y-1 and y
 * around it; `way` is 0 right, 1 down, 2 left, 3 up. */
static bool walk(tracer *t, int x0, int y0, uint32_t region)
{
    static const int dx[4] = {1, 0, -1, 0}, dy[4] = {0, 1, 0, -1};
    /* The cells ahead on the left and on the right of each way, from the corner. */
    static const int left[4][2] = {{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}, right[4][2] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
    int x = x0, y = y0, way = 0;
    t->loop.n = 0;
    do {
        if (way == 0)
            t->is_done[(size_t)y * (size_t)t->b->width + (size_t)x] = 1;
        x += dx[way];
        y += dy[way];
        bool on_left = is_in(t, x + left[way][0], y + left[way][1], region), on_right = is_in(t, x + right[way][0], y + right[way][1], region);
        /* Cells that meet in a corner are apart: the walk turns to its own side. */
        int turned = !on_right ? (way + 1) % 4 : on_left ? (way + 3) % 4 : way;
        if (turned != way && !array_push(&t->loop, ((point){x, y})))
            return false;
        way = turned;
    } while (x != x0 || y != y0 || way != 0);
    return true;
}

/* ---- straightening ---- */

static double distance_to_chord(point a, point b, point p)
{
    point d = point_sub(b, a), q = point_sub(p, a);
    double l = plb_point_length(d);
    return l > 0 ? fabs(point_cross(d, q)) / l : plb_point_length(q);
}

/* Keeps the points between `first` and `last` (which may lie beyond the end: the loop goes round) that are needed [DP73]. */
static bool keep_needed(tracer *t, size_t first, size_t last)
{
    ARRAY(size_t) todo = {0};
    size_t n = t->loop.n;
    bool ok = array_push(&todo, first) && array_push(&todo, last);
    while (ok && todo.n) {
        size_t b = todo.v[--todo.n], a = todo.v[--todo.n], farthest = a;
        double most = STRAY;
        for (size_t i = a + 1; i < b; i++) {
            double d = distance_to_chord(t->loop.v[a % n], t->loop.v[b % n], t->loop.v[i % n]);
            if (d > most)
                most = d, farthest = i;
        }
        if (farthest == a)
            continue;
        t->is_kept.v[farthest % n] = 1;
        ok = array_push(&todo, a) && array_push(&todo, farthest) && array_push(&todo, farthest) && array_push(&todo, b);
    }
    array_free(&todo);
    return ok;
}

static bool straighten(tracer *t)
{
    size_t n = t->loop.n, far = 0;
    t->is_kept.n = 0;
    if (!array_reserve(&t->is_kept, n))
        return false;
    for (size_t i = 0; i < n; i++) {
        t->is_kept.v[i] = 0;
        if (plb_point_distance(t->loop.v[0], t->loop.v[i]) > plb_point_distance(t->loop.v[0], t->loop.v[far]))
            far = i;
    }
    t->is_kept.v[0] = t->is_kept.v[far] = 1;
    return keep_needed(t, 0, far) && keep_needed(t, far, n);
}

static void measure(const tracer *t, double *area, double *length)
{
    size_t n = t->loop.n;
    *area = *length = 0;
    for (size_t i = 0; i < n; i++) {
        point a = t->loop.v[i], b = t->loop.v[(i + 1) % n];
        *area += point_cross(a, b) / 2;
        *length += plb_point_distance(a, b);
    }
}

static bool add_loop(tracer *t)
{
    double area, length, cell = t->b->cell;
    measure(t, &area, &length);
    if (fabs(area) * cell * cell < MIN_AREA || fabs(area) / length * 2 * cell < MIN_BREADTH)
        return true;
    if (!straighten(t))
        return false;
    tone_loop l = {t->out->points.n, 0};
    for (size_t i = 0; i < t->loop.n; i++)
        if (t->is_kept.v[i]) {
            point p = {t->b->corner.x + t->loop.v[i].x * cell, t->b->corner.y + t->loop.v[i].y * cell};
            if (!array_push(&t->out->points, p))
                return false;
            l.n++;
        }
    return array_push(&t->out->loops, l);
}

/* Walks around all regions; owner gets the region of each loop. */
static bool trace_all(tracer *t, number_list *owner)
{
    const surface_buffer *b = t->b;
    size_t cells = (size_t)b->width * (size_t)b->height, first = t->out->loops.n;
    bool ok = true;
    for (size_t i = 0; ok && i < cells; i++) {
        int x = (int)(i % (size_t)b->width), y = (int)(i / (size_t)b->width);
        uint32_t region = t->label[i];
        if (region == UINT32_MAX || t->is_done[i] || is_in(t, x, y - 1, region))
            continue;
        ok = walk(t, x, y, region) && add_loop(t);
        while (ok && owner->n < t->out->loops.n - first)
            ok = array_push(owner, region);
    }
    return ok;
}

/* Puts the loops of one region, of those from number `first` on, in a row; loops_of says where. */
static bool sort_loops(tone_list *l, size_t first, const number_list *owner, uint32_t regions, tone_loop *loops_of)
{
    tone_loop *sorted = plb_new(owner->n + 1, sizeof *sorted);
    if (!sorted)
        return false;
    for (uint32_t r = 0; r < regions; r++)
        loops_of[r] = (tone_loop){0, 0};
    for (size_t i = 0; i < owner->n; i++)
        loops_of[owner->v[i]].n++;
    size_t at = first;
    for (uint32_t r = 0; r < regions; r++) {
        loops_of[r].first = at;
        at += loops_of[r].n;
        loops_of[r].n = 0;
    }
    for (size_t i = 0; i < owner->n; i++) {
        tone_loop *of = &loops_of[owner->v[i]];
        sorted[of->first - first + of->n++] = l->loops.v[first + i];
    }
    for (size_t i = 0; i < owner->n; i++)
        l->loops.v[first + i] = sorted[i];
    plb_free(sorted);
    return true;
}

bool plb_trace_regions(const surface_buffer *b, const uint32_t *label, uint32_t regions, tone_loop *loops_of, tone_list *out)
{
    tracer t = {.b = b, .label = label, .out = out, .is_done = plb_new((size_t)b->width * (size_t)b->height, 1)};
    number_list owner = {0};
    size_t first = out->loops.n;
    bool ok = t.is_done && trace_all(&t, &owner) && sort_loops(out, first, &owner, regions, loops_of);
    plb_free(t.is_done);
    array_free(&t.loop);
    array_free(&t.is_kept);
    array_free(&owner);
    return ok;
}
