/* SPDX-License-Identifier: MIT
 *
 * The sixth step of the capture works out the normal score of every pixel of the core; how rough each line is; how the spread of
 * the scores depends on the distance from the centreline.
 */
#include "profile/grain/grain.h"

#include "profile/grain/grain_math.h"

#include "base/number/random.h"

#include <math.h>

#define SPREAD_STEP 0.5      /* px */
#define MIN_SPREAD_PIXELS 100          /* pixels for a place's own spread */
#define FADE_FROM 0.4       /* levels over which the dependence on place sets in */
#define FADE_OVER 0.4
#define MIN_ROUGHNESS (-2.0)
#define MAX_ROUGHNESS 1.0

/* Greys are whole numbers: spread evenly over the level they stand for. */
static double undo_rounding(const grain_line *l, size_t line, int pixel)
{
    uint64_t key = random_key(0, line, PURPOSE_GRAIN);
    return l->dark[pixel] + (random_unit(key, (uint64_t)pixel) - 0.5) / l->depth;
}

/* Scores and the log of their root mean square. */
static void score_line(grain_line *l, size_t line, const grain_model *g)
{
    double squares = 0, n = 0;
    for (int i = 0; i < l->n * GRAIN_ROWS; i++) {
        l->score[i] = NAN;
        if (!l->usable[i / GRAIN_ROWS] || l->level[i] < GRAIN_CORE)
            continue;
        double z = plb_grain_score(g, l->level[i], undo_rounding(l, line, i));
        l->score[i] = (float)z;
        squares += z * z;
        n++;
    }
    l->roughness = n > 0 ? clamp(log(squares / n) / 2, MIN_ROUGHNESS, MAX_ROUGHNESS) : 0;
}

static void measure_places(const grain_lines *lines, grain_model *g)
{
    double squares[GRAIN_PLACES] = {0}, n[GRAIN_PLACES] = {0}, smooth_squares[GRAIN_PLACES], smooth_n[GRAIN_PLACES];
    for (size_t j = 0; j < lines->n; j++) {
        const grain_line *l = &lines->v[j];
        for (int i = 0; i < l->n * GRAIN_ROWS; i++) {
            if (isnan(l->score[i]))
                continue;
            int bin = (int)fmin(fabs((double)l->place[i]) / SPREAD_STEP, GRAIN_PLACES - 1);
            squares[bin] += l->score[i] * l->score[i] * exp(-2 * l->roughness);
            n[bin]++;
        }
    }
    plb_smooth_folded(squares, smooth_squares, GRAIN_PLACES);
    plb_smooth_folded(n, smooth_n, GRAIN_PLACES);
    for (int k = 0; k < GRAIN_PLACES; k++)
        g->place_scale[k] = smooth_n[k] > MIN_SPREAD_PIXELS ? (float)fmax(0.1, sqrt(smooth_squares[k] / smooth_n[k])) : 1;
}

static void divide_by_place(grain_line *l, const grain_model *g)
{
    for (int i = 0; i < l->n * GRAIN_ROWS; i++) {
        double at_place = plb_interpolate(g->place_scale, GRAIN_PLACES, SPREAD_STEP / 2, SPREAD_STEP, fabs((double)l->place[i]));
        double fade = clamp((l->level[i] - FADE_FROM) / FADE_OVER, 0, 1);
        l->score[i] = (float)(l->score[i] / (1 + (at_place - 1) * fade));
    }
}

/* Gives the mean product of scores so many columns and rows apart, divided by the mean square. */
static double own_correlation(const grain_line *l, int columns, int rows)
{
    double sum = 0, n = 0, squares = 0, m = 0;
    for (int k = 0; k < l->n; k++)
        for (int o = 0; o < GRAIN_ROWS; o++) {
            double z = l->score[k * GRAIN_ROWS + o];
            if (isnan(z))
                continue;
            squares += z * z;
            m++;
            if (k + columns >= l->n || o + rows >= GRAIN_ROWS || isnan(l->score[(k + columns) * GRAIN_ROWS + o + rows]))
                continue;
            sum += z * l->score[(k + columns) * GRAIN_ROWS + o + rows];
            n++;
        }
    return n > 0 && squares > 0 ? clamp(sum / n / (squares / m), -1, 1) : 0;
}

void plb_grain_scores(grain_lines *lines, grain_model *g)
{
    for (size_t j = 0; j < lines->n; j++)
        score_line(&lines->v[j], j, g);
    measure_places(lines, g);
    for (size_t j = 0; j < lines->n; j++) {
        divide_by_place(&lines->v[j], g);
        lines->v[j].along = own_correlation(&lines->v[j], 1, 0);
        lines->v[j].across = own_correlation(&lines->v[j], 0, 1);
    }
}
