/* SPDX-License-Identifier: MIT
 *
 * Capture, first step: where the line of a scan runs.
 *
 * Every column of the (slightly blurred) scan is cut into dark runs; a run continues the run of the column before that
 * it touches when each is the other's only neighbour, which makes chains. The chain with the most darkness is the
 * line; chains that carry on in its direction behind a crossing mark belong to it too.
 */
#include "profile/capture/line_find.h"

#include "base/array.h"

#include <math.h>
#include <stdlib.h>

#define BLUR_SIGMA 0.8   /* in 1/300 inch, px of coarser scans; joins the grains of a line, chosen by eye */
#define BLUR_RADIUS 3
#define BLUR_MAX 4      /* beyond 1200 dpi the blur does not grow with the resolution: it would take long */
#define DARK 0.90        /* a pixel darker than this share of the paper may be line, chosen by eye */
/* In 1/300 inch, chosen by eye: */
#define MAX_THICKNESS 20 /* thicker runs are crossings and blots */
#define MAX_GAP 60       /* bridged where another mark crosses */
#define MIN_PIECE 20     /* shorter chains are not taken on behind a gap */
#define AIM_LENGTH 40    /* of the end of a chain, to tell its direction */
#define AIM_MISS 2.0     /* how far off its direction the next chain may start … */
#define AIM_SPREAD 0.1   /* … and how much more for each pixel of gap */
#define MAX_RUNS (1u << 24)

/* A dark run of one column. Indices of other runs count from 1; 0: none. */
typedef struct {
    int x, top, bottom;
    uint32_t before, after; /* its neighbours in the chain */
    uint32_t first;         /* of its chain */
    double score;           /* of its chain up to here */
} dark_run;

typedef struct {
    const scan *s;
    double unit;
    int paper;
    int radius; /* of the blur, px */
    float kernel[BLUR_RADIUS * BLUR_MAX + 1];
    float *row_sums, *column; /* work space: one column each */
    ARRAY(dark_run) runs;
    ARRAY(const dark_run *) chains; /* the last run of each that is long enough to be taken on behind a gap */
} line_finder;

static int clamp(int v, int low, int high)
{
    return v < low ? low : v > high ? high : v;
}

static void make_kernel(line_finder *f)
{
    double sum = 0, scale = f->unit < 1 ? 1 : f->unit > BLUR_MAX ? BLUR_MAX : f->unit, sigma = BLUR_SIGMA * scale;
    f->radius = (int)ceil(BLUR_RADIUS * scale);
    for (int k = 0; k <= f->radius; k++)
        sum += (k ? 2 : 1) * exp(-k * k / (2 * sigma * sigma));
    for (int k = 0; k <= f->radius; k++)
        f->kernel[k] = (float)(exp(-k * k / (2 * sigma * sigma)) / sum);
}

/* Blurs column x of the scan by a Gaussian into f->column. */
static void blur_column(line_finder *f, int x)
{
    const scan *s = f->s;
    int column[2 * BLUR_RADIUS * BLUR_MAX + 1] = {0}, r = f->radius;
    for (int k = -r; k <= r; k++)
        column[k + r] = clamp(x + k, 0, s->width - 1);
    for (int y = 0; y < s->height; y++) {
        const uint8_t *row = s->grey + (size_t)y * (size_t)s->width;
        f->row_sums[y] = 0;
        for (int k = -r; k <= r; k++)
            f->row_sums[y] += f->kernel[abs(k)] * row[column[k + r]];
    }
    for (int y = 0; y < s->height; y++) {
        f->column[y] = 0;
        for (int k = -r; k <= r; k++)
            f->column[y] += f->kernel[abs(k)] * f->row_sums[clamp(y + k, 0, s->height - 1)];
    }
}

/* Appends the dark runs of f->column; the score of each is its depth. */
static bool cut_column(line_finder *f, int x, error *err)
{
    const double dark = DARK * f->paper;
    for (int y = 0; y < f->s->height; y++) {
        int top = y;
        double darkest = f->paper;
        for (; y < f->s->height && f->column[y] < dark; y++)
            darkest = fmin(darkest, f->column[y]);
        if (y == top || y - top > MAX_THICKNESS * f->unit)
            continue;
        if (f->runs.n == MAX_RUNS)
            return plb_fail(err, ERROR_LIMIT, "too many dark spots for the scan of a line");
        dark_run r = {.x = x, .top = top, .bottom = y, .first = (uint32_t)f->runs.n + 1, .score = f->paper - darkest};
        if (!array_push(&f->runs, r))
            return plb_fail_memory(err);
    }
    return true;
}

static bool touch(const dark_run *a, const dark_run *b)
{
    return b->top <= a->bottom + 1 && b->bottom >= a->top - 1;
}

/* Links each run of [old, now) to the one it alone touches of [now, end). Both are sorted from top to bottom. */
static void link_columns(line_finder *f, size_t old, size_t now, size_t end)
{
    dark_run *v = f->runs.v;
    for (size_t from = now; old < now; old++) {
        while (from < end && v[from].bottom < v[old].top - 1)
            from++;
        size_t found = 0, count = 0;
        for (size_t i = from; i < end && v[i].top <= v[old].bottom + 1; i++)
            if (!v[i].before && touch(&v[old], &v[i])) {
                found = i;
                count++;
            }
        if (count != 1)
            continue;
        v[old].after = (uint32_t)found + 1;
        v[found].before = (uint32_t)old + 1;
        v[found].first = v[old].first;
        v[found].score += v[old].score;
    }
}

static bool find_chains(line_finder *f, error *err)
{
    size_t old = 0, now = 0;
    for (int x = 0; x < f->s->width; x++) {
        blur_column(f, x);
        if (!cut_column(f, x, err))
            return false;
        link_columns(f, old, now, f->runs.n);
        old = now;
        now = f->runs.n;
    }
    return true;
}

static double middle(const dark_run *r)
{
    return (r->top + r->bottom - 1) / 2.0;
}

/* Gives the slope of the chain at its end `last` (towards +x) or its start (towards -x), as dy per column outwards. */
static double slope_outwards(const line_finder *f, const dark_run *end, bool right)
{
    const dark_run *v = f->runs.v, *r = end;
    for (int k = 0; k < AIM_LENGTH * f->unit && (right ? r->before : r->after); k++)
        r = &v[(right ? r->before : r->after) - 1];
    return r == end ? 0 : (middle(end) - middle(r)) / abs(end->x - r->x);
}

/* Gives the chain that carries on from `end`, as its run nearest to it; NULL: none. */
static const dark_run *next_piece(const line_finder *f, const dark_run *end, bool right)
{
    const dark_run *v = f->runs.v, *best = NULL;
    double slope = slope_outwards(f, end, right), best_gap = MAX_GAP * f->unit;
    for (size_t i = 0; i < f->chains.n; i++) {
        const dark_run *last = f->chains.v[i], *near = right ? &v[last->first - 1] : last;
        double gap = right ? near->x - end->x : end->x - near->x;
        double miss = fabs(middle(near) - middle(end) - slope * gap);
        if (gap >= 1 && gap < best_gap && miss <= AIM_MISS * f->unit + AIM_SPREAD * gap) {
            best = near;
            best_gap = gap;
        }
    }
    return best;
}

static void write_chain(const line_finder *f, const dark_run *first, const line_track *t)
{
    for (const dark_run *r = first;; r = &f->runs.v[r->after - 1]) {
        t->top[r->x - t->x0] = r->top;
        t->bottom[r->x - t->x0] = r->bottom;
        if (!r->after)
            return;
    }
}

/* Gives the other end of a chain, given one of them. */
static const dark_run *far_end(const line_finder *f, const dark_run *r, bool right)
{
    if (!right)
        return &f->runs.v[r->first - 1];
    while (r->after)
        r = &f->runs.v[r->after - 1];
    return r;
}

/* Follows the line from its best run outwards, piece by piece; `pieces` gets the first run of each. */
static bool collect(const line_finder *f, const dark_run *best, line_track *t, error *err)
{
    ARRAY(const dark_run *) pieces = {0};
    const dark_run *ends[2] = {&f->runs.v[best->first - 1], best};
    double score = best->score;
    bool good = array_push(&pieces, ends[0]);
    for (int right = 0; right < 2 && good; right++)
        for (const dark_run *near; good && (near = next_piece(f, ends[right], right));) {
            ends[right] = far_end(f, near, right);
            score += (right ? ends[right] : near)->score;
            good = array_push(&pieces, right ? near : ends[right]);
        }
    t->x0 = ends[0]->x;
    t->n = ends[1]->x - t->x0 + 1;
    t->top = plb_new((size_t)t->n, sizeof *t->top);
    t->bottom = plb_new((size_t)t->n, sizeof *t->bottom);
    good = good && t->top && t->bottom;
    for (size_t i = 0; i < pieces.n && good; i++)
        write_chain(f, pieces.v[i], t);
    t->score = score;
    array_free(&pieces);
    return good || plb_fail_memory(err);
}

static bool list_chains(line_finder *f)
{
    for (size_t i = 0; i < f->runs.n; i++) {
        const dark_run *r = &f->runs.v[i];
        if (!r->after && r->x - f->runs.v[r->first - 1].x >= MIN_PIECE * f->unit && !array_push(&f->chains, r))
            return false;
    }
    return true;
}

static bool find(line_finder *f, line_track *t, error *err)
{
    if (!f->row_sums || !f->column)
        return plb_fail_memory(err);
    if (!find_chains(f, err))
        return false;
    if (!list_chains(f))
        return plb_fail_memory(err);
    const dark_run *best = NULL;
    for (size_t i = 0; i < f->runs.n; i++)
        if (!best || f->runs.v[i].score > best->score)
            best = &f->runs.v[i];
    return !best || collect(f, best, t, err);
}

bool plb_line_find(const scan *s, double unit, int paper, line_track *t, error *err)
{
    *t = (line_track){0};
    line_finder f = {.s = s, .unit = unit, .paper = paper};
    make_kernel(&f);
    f.row_sums = plb_new((size_t)s->height, sizeof *f.row_sums);
    f.column = plb_new((size_t)s->height, sizeof *f.column);
    bool good = find(&f, t, err);
    plb_free(f.row_sums);
    plb_free(f.column);
    array_free(&f.runs);
    array_free(&f.chains);
    return good;
}

void plb_line_track_free(line_track *t)
{
    plb_free(t->top);
    plb_free(t->bottom);
    *t = (line_track){0};
}
