/* SPDX-License-Identifier: MIT
 *
 * The ground: see ground.h. Blank paper of hdBPMN's scans has means of 234 to 254.8 and standard deviations of .4 to 3.3 at 300 dpi; the sheet drawn here is
 * one of the toned ones. Amounts are in grey levels and, where no measurement is named, chosen by eye.
 */
#include "surface/ground.h"

#include "base/array.h"
#include "base/geometry/interpolate.h"
#include "base/number/random.h"

#include <math.h>
#include <string.h>

#define TONE 244.0F
const float plb_ground_tint[3] = {1, 0.993F, 0.968F};

/* Clouds and flocks of the sheet, and its grain: amounts, and distances of the knots, mm. Grain finer than a pixel evens out. */
#define CLOUDS 2.4F
#define CLOUDS_MM 23.0
#define FLOCKS 1.8F
#define FLOCKS_MM 1.7
#define GRAIN 6.5F
#define GRAIN_MM (25.4 / 300)

/* Fibres are the lines where a noise of long cells crosses 0, this near to it; so dark, and as much lighter where they catch the light. A slower noise
 * breaks them. */
#define FIBRE_LAYERS 3
#define FIBRE_WITHIN 0.035F
#define FIBRE_DEPTH 5.0F
#define FIBRE_LONG_MM 4.5
#define FIBRE_WIDE_MM 1.4
#define FIBRE_BREAKS_MM 2.2
#define FIBRE_SHARE 0.25F

/* The heel of the hand drags graphite to the right and down: cells of the page so large, mm, are darkened by what lies so many cells before, less and less;
 * only where more than a share is covered; at most by so much, in some places more than in others. */
#define CELL_MM 1.0
#define MOST_CELLS 1200
#define LINE_MM 0.35
#define DRAG_CELLS 12
#define DRAG_FALL 4.0
#define DRAG_DOWN 0.35
#define SMEARS_FROM 0.3F
#define SMEAR 11.0F
#define SMEAR_PLACES_MM 14.0

/* Ghosts: this share of the long straight lines had a construction line, which went on beyond both ends by so much, mm, and lay this far aside; it is so
 * dark and half so wide. */
#define GHOST_SHARE 0.3
#define GHOST_LONG_MM 22.0
#define GHOST_BEYOND_MM 4.0
#define GHOST_MORE_MM 12.0
#define GHOST_ASIDE_MM 0.5
#define GHOST_DEPTH 9.0F
#define GHOST_HALF_MM 0.24
#define MOST_GHOSTS 80

typedef struct {
    point from, along; /* mm; the unit vector */
    double length;
} ghost;

struct ground {
    uint64_t key;
    double cell; /* mm */
    int columns, rows;
    float *smear; /* of each cell */
    ARRAY(ghost) ghosts;
};

void plb_ground_free(ground *g)
{
    if (!g)
        return;
    plb_free(g->smear);
    array_free(&g->ghosts);
    plb_free(g);
}

/* Places of a row that are worked on together: the first is `x` mm from the page's left, each is `step` from the one before. */
typedef struct {
    double x, y, step;
    int n;
    float *out;
} piece;

/* ---- noise ---- */

/* A lattice of numbers in -1 to 1, which a row of places runs across: place k lies at `at` + k `step`, in cells. */
typedef struct {
    uint64_t key;
    double at_a, at_b, step_a, step_b;
} lattice;

/* Gives the lattice whose cells are so long and wide, mm, and turned by an angle, seen from the piece. */
static lattice lattice_of(const ground *g, uint64_t number, double angle, double along, double wide, const piece *p)
{
    double c = cos(angle), s = sin(angle);
    return (lattice){random_mix(g->key + number), (c * p->x + s * p->y) / along, (c * p->y - s * p->x) / wide, c * p->step / along, -s * p->step / wide};
}

static float knot(uint64_t key, int64_t a, int64_t b)
{
    uint64_t bits = random_fold(key, a, b);
    return ((float)(bits & 0xffffff) + (float)(bits >> 40) - 16777215.0F) / 16777215.0F;
}

/* Computes smooth noise between the knots at n places. */
static void noise_row(const lattice *l, int n, float *out)
{
    int64_t a = INT64_MIN, b = INT64_MIN;
    float v[4] = {0};
    for (int k = 0; k < n; k++) {
        double fa = l->at_a + k * l->step_a, fb = l->at_b + k * l->step_b, ia = floor(fa), ib = floor(fb);
        if ((int64_t)ia != a || (int64_t)ib != b) {
            a = (int64_t)ia;
            b = (int64_t)ib;
            for (int i = 0; i < 4; i++)
                v[i] = knot(l->key, a + i % 2, b + i / 2);
        }
        float u = (float)(fa - ia), w = (float)(fb - ib);
        u = u * u * (3 - 2 * u);
        w = w * w * (3 - 2 * w);
        float upper = v[0] + (v[1] - v[0]) * u, lower = v[2] + (v[3] - v[2]) * u;
        out[k] = upper + (lower - upper) * w;
    }
}

/* ---- smears ---- */

static float *cell_at(const ground *g, float *map, double x, double y)
{
    double column = floor(x / g->cell), row = floor(y / g->cell);
    return column >= 0 && row >= 0 && column < g->columns && row < g->rows ? &map[(size_t)row * (size_t)g->columns + (size_t)column] : NULL;
}

/* Adds up which share of each cell the strokes cover. */
static void cover(const ground *g, const stroke_list *list, float *map)
{
    for (size_t i = 0; i < list->strokes.n; i++) {
        const stroke *s = &list->strokes.v[i];
        double wide = LINE_MM * (double)s->style.pressure * (s->style.breadth > 0 ? (double)s->style.breadth : 1);
        for (size_t k = s->first + 1; k < s->first + s->n; k++) {
            point a = list->points.v[k - 1], b = list->points.v[k];
            double length = plb_point_distance(a, b), steps = fmin(ceil(2 * length / g->cell), 4.0 * MOST_CELLS);
            for (double t = 0.5; t < steps; t++) {
                point p = point_mix(a, b, t / steps);
                float *cell = cell_at(g, map, p.x, p.y);
                if (cell)
                    *cell += (float)(length / steps * wide / (g->cell * g->cell));
            }
        }
    }
}

/* Drags what is dark to the right and down. */
static void drag(ground *g, const float *covered)
{
    for (int row = 0; row < g->rows; row++)
        for (int column = 0; column < g->columns; column++) {
            float sum = 0, whole = 0;
            for (int k = 1; k <= DRAG_CELLS; k++) {
                int from_column = column - k, from_row = row - (int)(DRAG_DOWN * k + 0.5);
                float weight = (float)exp(-k / DRAG_FALL), dark = from_column >= 0 && from_row >= 0 ? covered[(size_t)from_row * (size_t)g->columns + (size_t)from_column] : 0;
                sum += weight * fminf(fmaxf(dark - SMEARS_FROM, 0), 1);
                whole += weight;
            }
            g->smear[(size_t)row * (size_t)g->columns + (size_t)column] = SMEAR * sum / whole;
        }
}

static float smear_at(const ground *g, int column, int row)
{
    return column >= 0 && row >= 0 && column < g->columns && row < g->rows ? g->smear[(size_t)row * (size_t)g->columns + (size_t)column] : 0;
}

/* Takes the smears' depth, between the middles of four cells, from a row of the ground. */
static void smear_row(const ground *g, const piece *p, const float *places)
{
    double fy = p->y / g->cell - 0.5;
    int row = (int)floor(fy);
    float w = (float)(fy - row);
    for (int k = 0; k < p->n; k++) {
        double fx = (p->x + k * p->step) / g->cell - 0.5;
        int column = (int)floor(fx);
        float u = (float)(fx - column);
        float upper = smear_at(g, column, row) * (1 - u) + smear_at(g, column + 1, row) * u;
        float lower = smear_at(g, column, row + 1) * (1 - u) + smear_at(g, column + 1, row + 1) * u;
        p->out[k] -= (upper * (1 - w) + lower * w) * fmaxf(0.4F + places[k], 0);
    }
}

/* ---- ghosts ---- */

static bool find_ghosts(ground *g, const stroke_list *list)
{
    bool ok = true;
    for (size_t i = 0; ok && i < list->strokes.n && g->ghosts.n < MOST_GHOSTS; i++) {
        const stroke *s = &list->strokes.v[i];
        const point *v = list->points.v + s->first;
        uint64_t key = random_mix(g->key ^ s->identity);
        double length = plb_point_distance(v[0], v[s->n - 1]);
        if (s->n != 2 || s->style.kind != STROKE_LINE || s->style.company || length < GHOST_LONG_MM || random_unit(key, 0) >= GHOST_SHARE)
            continue;
        point along = point_scale(point_sub(v[1], v[0]), 1 / length);
        double before = GHOST_BEYOND_MM + GHOST_MORE_MM * random_unit(key, 1), after = GHOST_BEYOND_MM + GHOST_MORE_MM * random_unit(key, 2);
        double aside = GHOST_ASIDE_MM * (2 * random_unit(key, 3) - 1);
        point from = {v[0].x - along.x * before - along.y * aside, v[0].y - along.y * before + along.x * aside};
        ghost made = {from, along, length + before + after};
        ok = array_push(&g->ghosts, made);
    }
    return ok;
}

/* Takes one ghost's depth from a piece; rubbed out more in some places than in others. */
static void ghost_row(const ghost *t, const piece *p, const float *places)
{
    double down = p->y - t->from.y, low = 0, high = p->n;
    /* A place dx to the right of the ghost's beginning is dx along.y - down along.x across: which dx are within the half width? */
    if (fabs(t->along.y) > 1e-9) {
        double middle = t->from.x - p->x + down * t->along.x / t->along.y, half = GHOST_HALF_MM / fabs(t->along.y);
        low = clamp(ceil((middle - half) / p->step), 0, p->n);
        high = clamp(floor((middle + half) / p->step) + 1, 0, p->n);
    } else if (fabs(down) > GHOST_HALF_MM)
        return;
    for (int k = (int)low; k < (int)high; k++) {
        double dx = p->x + k * p->step - t->from.x, across = (dx * t->along.y - down * t->along.x) / GHOST_HALF_MM, at = dx * t->along.x + down * t->along.y;
        if (at > 0 && at < t->length && fabs(across) < 1)
            p->out[k] -= GHOST_DEPTH * (float)((1 - across * across) * fmin(1, fmin(at, t->length - at))) * fmaxf(0.55F + places[k], 0);
    }
}

/* ---- the sheet ---- */

ground *plb_ground_new(const stroke_list *strokes, uint64_t seed, error *err)
{
    ground *g = plb_new(1, sizeof *g);
    float *covered = NULL;
    if (g) {
        double side = fmax(strokes->width, strokes->height);
        g->key = random_key(seed, 0, PURPOSE_GROUND);
        g->cell = fmax(CELL_MM, side / MOST_CELLS);
        g->columns = (int)ceil(strokes->width / g->cell) + 1;
        g->rows = (int)ceil(strokes->height / g->cell) + 1;
        size_t cells = (size_t)g->columns * (size_t)g->rows;
        g->smear = plb_new(cells, sizeof *g->smear);
        covered = plb_new(cells, sizeof *covered);
    }
    bool ok = g && g->smear && covered && find_ghosts(g, strokes);
    if (ok) {
        cover(g, strokes, covered);
        drag(g, covered);
    }
    plb_free(covered);
    if (ok)
        return g;
    plb_ground_free(g);
    plb_fail_memory(err);
    return NULL;
}

/* Adds a noise of square cells. */
static void add_noise(const ground *g, uint64_t number, double cell, float amount, const piece *p)
{
    float noise[GROUND_PIECE];
    lattice l = lattice_of(g, number, 0, cell, cell, p);
    noise_row(&l, p->n, noise);
    for (int k = 0; k < p->n; k++)
        p->out[k] += amount * noise[k];
}

static void add_fibres(const ground *g, const piece *p)
{
    float course[GROUND_PIECE], breaks[GROUND_PIECE];
    for (int i = 0; i < FIBRE_LAYERS; i++) {
        double angle = (i + random_unit(g->key, (uint64_t)i)) * PLB_PI / FIBRE_LAYERS;
        lattice l = lattice_of(g, 10 + (uint64_t)i, angle, FIBRE_LONG_MM, FIBRE_WIDE_MM, p);
        noise_row(&l, p->n, course);
        l = lattice_of(g, 20 + (uint64_t)i, 0, FIBRE_BREAKS_MM, FIBRE_BREAKS_MM, p);
        noise_row(&l, p->n, breaks);
        for (int k = 0; k < p->n; k++) {
            float near = 1 - fabsf(course[k]) / FIBRE_WITHIN, seen = breaks[k] - FIBRE_SHARE;
            if (near > 0 && seen > 0)
                p->out[k] -= (i == 0 ? -FIBRE_DEPTH : FIBRE_DEPTH) * near * fminf(2 * seen, 1);
        }
    }
}

void plb_ground_row(const ground *g, double x, double y, double step, int n, float *out)
{
    float places[GROUND_PIECE];
    piece p = {x, y, step, n, out};
    for (int k = 0; k < n; k++)
        out[k] = TONE;
    add_noise(g, 1, CLOUDS_MM, CLOUDS, &p);
    add_noise(g, 2, FLOCKS_MM, FLOCKS, &p);
    add_noise(g, 3, GRAIN_MM, GRAIN * (float)fmin(1, GRAIN_MM / step), &p);
    add_fibres(g, &p);
    lattice l = lattice_of(g, 4, 0, SMEAR_PLACES_MM, SMEAR_PLACES_MM, &p);
    noise_row(&l, n, places);
    smear_row(g, &p, places);
    for (size_t i = 0; i < g->ghosts.n; i++)
        ghost_row(&g->ghosts.v[i], &p, places);
    for (int k = 0; k < n; k++)
        out[k] = fminf(fmaxf(out[k], 0), 255) / 255;
}
