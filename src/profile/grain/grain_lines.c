/* SPDX-License-Identifier: MIT
 *
 * The first step of the capture collects the pixels of each line with their distance from the centreline, its depth and its
 * width.
 */
#include "profile/grain/grain.h"

#include "base/array.h"

#include <math.h>

#define WIDTH_BINS 40
#define WIDTH_STEP 0.25
#define TOP_BINS 4        /* nearest the centreline: the line's full depth, as far as its width goes */
#define DEPTH_REACH 1.25  /* px: the core of the thinnest lines */
#define MIN_LINE 64       /* usable columns of a line */

/* Computes the darkness of the strip's pixels by distance. An empty bin has the value of the one before it. */
static void fold(const grain_line *l, double mean[WIDTH_BINS])
{
    double sum[WIDTH_BINS] = {0}, n[WIDTH_BINS] = {0};
    for (int i = 0; i < l->n * GRAIN_ROWS; i++) {
        int bin = (int)(fabs((double)l->place[i]) / WIDTH_STEP);
        if (!l->usable[i / GRAIN_ROWS] || bin >= WIDTH_BINS)
            continue;
        sum[bin] += l->dark[i];
        n[bin]++;
    }
    int first = 0;
    while (first < WIDTH_BINS - 1 && n[first] == 0)
        first++;
    double last = sum[first] / fmax(n[first], 1);
    for (int k = 0; k < WIDTH_BINS; k++) {
        if (n[k] > 0)
            last = sum[k] / n[k];
        mean[k] = last;
    }
}

static double width_at_half_depth(const grain_line *l)
{
    double mean[WIDTH_BINS], half = 0;
    fold(l, mean);
    for (int k = 0; k < TOP_BINS; k++)
        half += mean[k] / TOP_BINS / 2;
    for (int k = 1; k < WIDTH_BINS; k++)
        if (mean[k] < half)
            return 2 * WIDTH_STEP * (k - 0.5 + fmax(0, mean[k - 1] - half) / (mean[k - 1] - mean[k]));
    return 2 * WIDTH_STEP * (WIDTH_BINS - 1);
}

static double mean_depth(const grain_line *l)
{
    double sum = 0, n = 0;
    for (int i = 0; i < l->n * GRAIN_ROWS; i++)
        if (l->usable[i / GRAIN_ROWS] && fabs((double)l->place[i]) < DEPTH_REACH) {
            sum += l->dark[i];
            n++;
        }
    return sum / fmax(n, 1);
}

/* Pixels as the strip has them: distances and darkness not scaled yet. */
static bool copy_strip(const line_strip *s, grain_line *l)
{
    size_t n = (size_t)s->n;
    *l = (grain_line){.n = s->n, .columns = s->columns, .usable = s->usable};
    l->coefficient = plb_new(n, sizeof *l->coefficient);
    l->place = plb_new(n, GRAIN_ROWS * sizeof *l->place);
    l->dark = plb_new(n, GRAIN_ROWS * sizeof *l->dark);
    l->level = plb_new(n, GRAIN_ROWS * sizeof *l->level);
    l->score = plb_new(n, GRAIN_ROWS * sizeof *l->score);
    if (!l->coefficient || !l->place || !l->dark || !l->level || !l->score)
        return false;
    for (int k = 0; k < s->n; k++)
        for (int o = -GRAIN_REACH; o <= GRAIN_REACH; o++) {
            int i = k * GRAIN_ROWS + o + GRAIN_REACH;
            l->place[i] = (float)((o - s->offset[k]) * s->cosine[k]);
            l->dark[i] = strip_dark(s, k, o);
        }
    return true;
}

/* To the reference width, the mean of the logarithms, and to relative darkness. */
static void scale(grain_lines *lines, grain_model *g)
{
    double sum = 0;
    for (size_t i = 0; i < lines->n; i++) {
        lines->v[i].weight = lines->v[i].columns / lines->columns;
        sum += lines->v[i].weight * log(lines->v[i].width);
    }
    g->reference_width = (float)exp(sum);
    for (size_t i = 0; i < lines->n; i++) {
        grain_line *l = &lines->v[i];
        double stretch = g->reference_width / l->width;
        for (int k = 0; k < l->n * GRAIN_ROWS; k++) {
            l->place[k] = (float)(l->place[k] * stretch);
            l->dark[k] = (float)(l->dark[k] / l->depth);
        }
    }
}

static void free_line(grain_line *l)
{
    plb_free(l->coefficient);
    plb_free(l->place);
    plb_free(l->dark);
    plb_free(l->level);
    plb_free(l->score);
}

static bool add_line(const line_strip *s, grain_lines *out)
{
    grain_line l;
    bool good = copy_strip(s, &l);
    l.width = good ? width_at_half_depth(&l) : 0;
    l.depth = good ? mean_depth(&l) : 0;
    if (l.depth > 1 && l.width > 0.5) {
        out->columns += l.columns;
        out->v[out->n++] = l;
    } else {
        free_line(&l); /* nothing of a line within 1.25 px */
    }
    return good;
}

bool plb_grain_lines_make(const line_strip strips[], size_t n, grain_lines *out, grain_model *g, error *err)
{
    *out = (grain_lines){.v = plb_new(n ? n : 1, sizeof *out->v)};
    bool good = out->v != NULL;
    for (size_t i = 0; i < n && good; i++)
        if (strips[i].columns >= MIN_LINE && out->columns + strips[i].n <= GRAIN_MAX_COLUMNS)
            good = add_line(&strips[i], out);
    if (good && out->n > 0)
        scale(out, g);
    if (!good)
        plb_grain_lines_free(out);
    return good || plb_fail_memory(err);
}

void plb_grain_lines_free(grain_lines *lines)
{
    for (size_t i = 0; i < lines->n; i++)
        free_line(&lines->v[i]);
    plb_free(lines->v);
    *lines = (grain_lines){0};
}
