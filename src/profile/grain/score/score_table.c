/* SPDX-License-Identifier: MIT
 *
 * The fifth step of the capture tabulates how dark a pixel is, given how dark it is expected to be there: a table of
 * quantiles by expected level.
 */
#include "profile/grain/grain.h"

#include "base/number/normal.h"
#include "profile/grain/grain_math.h"

#include "base/array.h"
#include "base/sort.h"

#include <math.h>
#include <stdlib.h>

#define MIN_TABLE_PIXELS 300          /* pixels for one row of the table */
#define WIDEN 1.3           /* of the window of levels until it holds enough */
#define WIDEST 0.3
#define NARROWEST 0.002
#define SHIFT_ABOVE 0.1     /* above this level a pixel's darkness moves with its level within the window */
#define EMPTY_BELOW 0.008f  /* rows of lower levels are paper: what marks are there are not the line's */
#define CAP 0.25            /* a speck beside the line is not the line's: no quantile above CAP + CAP_SLOPE x level */
#define CAP_SLOPE 4
#define PLACES_END 8.0      /* px, of modes and table */
#define HIGHEST 1.399       /* level */
#define LAST_SCORE 3.0

/* ---- the expected level ---- */

static double expected(const grain_model *g, double place, const double coefficient[GRAIN_MODES])
{
    double root = plb_grain_root(g, place), slope = plb_grain_root_slope(root);
    if (fabs(place) <= PLACES_END)
        for (int i = 0; i < GRAIN_MODES; i++)
            root += coefficient[i] * plb_interpolate(g->mode[i], GRAIN_MODE_PLACES, -PLACES_END, PROFILE_SECTION_STEP, place) / slope;
    return root > 0 ? root * root : 0;
}

/* ---- the table ---- */

typedef struct {
    double *level, *dark; /* of all pixels that count */
    double *chosen;       /* as many */
    size_t n;
} pixels;

static bool collect(const grain_lines *lines, pixels *p)
{
    size_t capacity = (size_t)lines->columns * GRAIN_ROWS + 1;
    *p = (pixels){plb_new(capacity, sizeof(double)), plb_new(capacity, sizeof(double)), plb_new(capacity, sizeof(double)), 0};
    if (!p->level || !p->dark || !p->chosen)
        return false;
    for (size_t j = 0; j < lines->n; j++) {
        const grain_line *l = &lines->v[j];
        for (int i = 0; i < l->n * GRAIN_ROWS; i++)
            if (l->usable[i / GRAIN_ROWS] && fabs((double)l->place[i]) < PLACES_END) {
                p->level[p->n] = l->level[i];
                p->dark[p->n++] = l->dark[i];
            }
    }
    return true;
}

static size_t count_within(const pixels *p, double centre, double reach)
{
    size_t n = 0;
    for (size_t i = 0; i < p->n; i++)
        n += fabs(p->level[i] - centre) < reach;
    return n;
}

/* Gives the darknesses of the pixels about level `row`, sorted; how many. */
static size_t choose(pixels *p, int row)
{
    double c = plb_grain_levels[row];
    double above = plb_grain_levels[row < GRAIN_LEVELS - 1 ? row + 1 : row], below = plb_grain_levels[row > 0 ? row - 1 : row];
    double reach = (above - below) / 4;
    while (reach < WIDEST && count_within(p, c, reach) < MIN_TABLE_PIXELS)
        reach *= WIDEN;
    size_t n = 0;
    for (size_t i = 0; i < p->n; i++)
        if (fabs(p->level[i] - c) <= fmax(reach, NARROWEST))
            p->chosen[n++] = p->dark[i] - (c > SHIFT_ABOVE ? p->level[i] - c : 0);
    qsort(p->chosen, n, sizeof *p->chosen, plb_compare_doubles);
    return n;
}

/* Between the two order statistics next to it. */
static double quantile(const double *sorted, size_t n, double share)
{
    double at = share * (double)(n - 1);
    size_t i = at < (double)(n - 1) ? (size_t)at : n - 1, next = i + 1 < n ? i + 1 : i;
    return sorted[i] + (sorted[next] - sorted[i]) * (at - (double)i);
}

static double score_of_knot(int k)
{
    return -LAST_SCORE + k * 2 * LAST_SCORE / (GRAIN_SCORES - 1);
}

/* A level that no pixel has: the row below, moved up. */
static void fill_row(pixels *p, int row, grain_model *g)
{
    size_t n = choose(p, row);
    for (int k = 0; k < GRAIN_SCORES; k++) {
        double level = plb_grain_levels[row], v = row > 0 ? g->darkness[row - 1][k] + level - plb_grain_levels[row > 0 ? row - 1 : 0] : 0;
        if (n > 0)
            v = quantile(p->chosen, n, plb_normal_share(score_of_knot(k)));
        g->darkness[row][k] = (float)clamp(v, 0, level < EMPTY_BELOW ? 0 : CAP + CAP_SLOPE * level);
    }
}

bool plb_grain_darkness(grain_lines *lines, grain_model *g, error *err)
{
    for (size_t j = 0; j < lines->n; j++)
        for (int i = 0; i < lines->v[j].n * GRAIN_ROWS; i++)
            lines->v[j].level[i] = (float)expected(g, lines->v[j].place[i], lines->v[j].coefficient[i / GRAIN_ROWS]);
    pixels p;
    bool good = collect(lines, &p);
    for (int row = 0; row < GRAIN_LEVELS && good; row++)
        fill_row(&p, row, g);
    plb_free(p.level);
    plb_free(p.dark);
    plb_free(p.chosen);
    return good || plb_fail_memory(err);
}

/* ---- the other way ---- */

double plb_grain_score(const grain_model *g, double level, double dark)
{
    double m = clamp(level, 0, HIGHEST), q[GRAIN_SCORES];
    int row = 0, k = 0;
    while (row < GRAIN_LEVELS - 2 && plb_grain_levels[row + 1] <= m)
        row++;
    double w = (m - plb_grain_levels[row]) / ((double)plb_grain_levels[row + 1] - plb_grain_levels[row]);
    for (int i = 0; i < GRAIN_SCORES; i++) /* rising, also where the table is level */
        q[i] = g->darkness[row][i] * (1 - w) + g->darkness[row + 1][i] * w + i * 1e-7;
    while (k < GRAIN_SCORES - 2 && q[k + 1] < dark)
        k++;
    double share = q[k + 1] > q[k] ? (dark - q[k]) / (q[k + 1] - q[k]) : 0;
    return score_of_knot(k) + (score_of_knot(1) - score_of_knot(0)) * clamp(share, 0, 1);
}

double plb_grain_bare_score(const grain_model *g, double level, double least)
{
    double m = clamp(level, 0, HIGHEST);
    int row = 0, k = 0;
    while (row < GRAIN_LEVELS - 2 && plb_grain_levels[row + 1] <= m)
        row++;
    double w = (m - plb_grain_levels[row]) / ((double)plb_grain_levels[row + 1] - plb_grain_levels[row]), q = 0, before = 0;
    for (; k < GRAIN_SCORES; k++) {
        before = q;
        q = g->darkness[row][k] * (1 - w) + g->darkness[row + 1][k] * w;
        if (q >= least)
            break;
    }
    if (k == 0)
        return -LAST_SCORE;
    return score_of_knot(k < GRAIN_SCORES ? k : GRAIN_SCORES - 1) - (q > before ? clamp((q - least) / (q - before), 0, 1) : 0) * (score_of_knot(1) - score_of_knot(0));
}
