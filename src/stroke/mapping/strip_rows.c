/* SPDX-License-Identifier: MIT
 *
 * Which samples of a row a piece of the path owns, and how far along the line they lie: see strip_map.c.
 * Input: a piece, in page pixels; how densely samples lie. Output: per row the samples from first to last, with the place
 * of the first along the line and the way to each next.
 *
 * A row is cut by the four lines that bound the piece; the numbers of its samples are rounded, and the outermost ones are
 * tested, so that two pieces never both own a sample of their common bound. All rows go through each step together, in loops
 * that fit broad vectors.
 */
#include "stroke/mapping/strip_rows.h"

#include "base/simd_clones.h"

#include <stdint.h>

piece_frame plb_piece_frame(const piece *k, int samples, double strip_px)
{
    double step = 1.0 / samples;
    return (piece_frame){k, samples, strip_px, k->in.x0 + step / 2, step, -k->t.y * step};
}

/* The loops below read these terms of a piece, kept where nothing that the loops write can change them. */
typedef struct {
    double ax, bx, step, us, left, right; /* a sample on: a and b, times the step; across */
    double s0, length;                    /* strip pixels */
} terms;

static inline terms terms_of(const piece_frame *f)
{
    const piece *k = f->k;
    return (terms){k->b0.x, k->b1.x, f->step, f->us, k->left, k->right, k->s0, k->length * f->strip_px};
}

static inline int is_outside(const terms *t, double a, double b, double u, double i)
{
    double across = u + i * t->us;
    return (a + i * t->ax * t->step < 0) | (b + i * t->bx * t->step >= 0) | (across > t->right) | (across < -t->left);
}

static inline double along(const terms *t, double a, double b, double i)
{
    double ai = a + i * t->ax * t->step, bi = b + i * t->bx * t->step;
    return t->s0 + t->length * ai / (ai - bi);
}

bool plb_piece_owns(const piece_frame *f, const piece_rows *r, int j, int sample)
{
    terms t = terms_of(f);
    return !is_outside(&t, r->a[j], r->b[j], r->u[j], sample);
}

double plb_piece_along(const piece_frame *f, const piece_rows *r, int j, int sample)
{
    terms t = terms_of(f);
    return along(&t, r->a[j], r->b[j], sample);
}

/* Computes a, b and across, as the banner of strip_map.c defines them, at sample 0 of each row. */
PLB_SIMD_CLONES static void place_rows(const piece_frame *f, int from, piece_rows *r)
{
    const piece *k = f->k;
    const double top = k->in.y0, samples = f->samples;
    const double a0 = (f->x - k->p0.x) * k->b0.x, b0 = (f->x - k->p1.x) * k->b1.x, u0 = k->t.y * (f->x - k->p0.x);
    for (int j = 0; j < r->n; j++) {
        double y = top + (from + j + 0.5) / samples, dy0 = y - k->p0.y, dy1 = y - k->p1.y;
        r->y[j] = y;
        r->a[j] = a0 + dy0 * k->b0.y;
        r->b[j] = b0 + dy1 * k->b1.y;
        r->u[j] = k->t.x * dy0 - u0;
    }
}

/* Narrows low to high to the samples i where sign c + aside + i step >= 0. */
PLB_SIMD_CLONES static void narrow(const double *restrict c, double sign, double aside, double step, int n, double *restrict low, double *restrict high)
{
    const double inverse = step != 0 ? 1 / step : 0;
    if (step > 0)
        for (int j = 0; j < n; j++) {
            double x = -(aside + sign * c[j]) * inverse;
            low[j] = x > low[j] ? x : low[j];
        }
    else if (step < 0)
        for (int j = 0; j < n; j++) {
            double x = -(aside + sign * c[j]) * inverse;
            high[j] = x < high[j] ? x : high[j];
        }
    else
        for (int j = 0; j < n; j++)
            high[j] = aside + sign * c[j] < 0 ? low[j] - 1 : high[j];
}

/* Rounds low, at least -1/2, and high to the whole samples between them. */
PLB_SIMD_CLONES static void round_rows(const double *restrict low, const double *restrict high, int n, int *restrict first, int *restrict last)
{
    for (int j = 0; j < n; j++) {
        bool some = low[j] <= high[j]; /* and so both fit an int */
        double l = some ? low[j] - 1e-9 : 0, h = some ? high[j] + 1e-9 : -1;
        int from = (int)l, to = (int)h;
        first[j] = from + (from < l);
        last[j] = to - (to > h);
    }
}

/* Drops samples at both ends that are not in the piece: seldom any. */
static void trim_row(const piece_frame *f, piece_rows *r, int j)
{
    while (r->first[j] <= r->last[j] && !plb_piece_owns(f, r, j, r->first[j]))
        r->first[j]++;
    while (r->first[j] <= r->last[j] && !plb_piece_owns(f, r, j, r->last[j]))
        r->last[j]--;
}

/* Finds the rows that have such ends; gives their number. */
PLB_SIMD_CLONES static int64_t find_ragged(const piece_frame *f, const piece_rows *r, int64_t ragged[PIECE_ROWS])
{
    const terms t = terms_of(f);
    int64_t some = 0;
    for (int j = 0; j < r->n; j++) {
        ragged[j] = is_outside(&t, r->a[j], r->b[j], r->u[j], r->first[j]) | is_outside(&t, r->a[j], r->b[j], r->u[j], r->last[j]);
        some += ragged[j];
    }
    return some;
}

static void trim_rows(const piece_frame *f, piece_rows *r)
{
    int64_t ragged[PIECE_ROWS] = {0};
    if (find_ragged(f, r, ragged) > 0)
        for (int j = 0; j < r->n; j++)
            if (ragged[j])
                trim_row(f, r, j);
}

PLB_SIMD_CLONES static void run_along(const piece_frame *f, piece_rows *r)
{
    const terms t = terms_of(f);
    for (int j = 0; j < r->n; j++) {
        double first = r->first[j], last = r->last[j];
        double from = along(&t, r->a[j], r->b[j], first), to = along(&t, r->a[j], r->b[j], last);
        double step = (to - from) / (last > first ? last - first : 1);
        r->along[j] = from;
        r->along_step[j] = last > first ? step : 0;
    }
}

void plb_piece_rows(const piece_frame *f, int from, int n, piece_rows *r)
{
    const piece *k = f->k;
    double low[PIECE_ROWS], high[PIECE_ROWS], last = (double)(k->in.x1 - k->in.x0) * f->samples - 0.5;
    r->n = n;
    place_rows(f, from, r);
    for (int j = 0; j < n; j++) {
        low[j] = -0.5;
        high[j] = last;
    }
    narrow(r->a, 1, 0, k->b0.x * f->step, n, low, high);
    narrow(r->b, -1, 0, -k->b1.x * f->step, n, low, high);
    narrow(r->u, 1, k->left, f->us, n, low, high);
    narrow(r->u, -1, k->right, -f->us, n, low, high);
    round_rows(low, high, n, r->first, r->last);
    trim_rows(f, r);
    run_along(f, r);
}
