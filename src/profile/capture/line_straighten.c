/* SPDX-License-Identifier: MIT
 *
 * Capture, second step: the line straightened, greys scaled, other marks left out.
 */
#include "profile/capture/line_straighten.h"

#include "base/array.h"
#include "base/number/random.h"
#include "base/number/units.h"
#include "profile/capture/line_section.h"
#include "profile/histogram.h"

#include <math.h>
#include <stdlib.h>

/* In 1/300 inch: */
#define STRIP_REACH 17      /* rows kept on either side; the widest lines at hand end at 6 */
#define TRIM 14       /* columns left out at each end: a stroke's end fades over 8 to 12 */
#define RIM_NEAREST 8 /* the rim, where nothing but paper should be, starts here, or … */
#define RIM_CLEAR 4   /* … this far outside the line's own edge; chosen by eye */
#define RIM_ROWS 3
#define COARSE_SIGMA 6.0 /* smoothing of the centreline, first guess and final: below 12 px of wavelength the hand … */
#define FINE_SIGMA 4.0   /* … is smooth, what looks rough is grain */
#define RIM_LIGHT 245    /* a column whose rim is darker on average has another mark, or a printed grid, in it */
#define FAINT 0.04       /* darkness below this share of the paper's grey is noise to the centreline */

typedef struct {
    const scan *s;
    const line_track *t;
    double unit;
    int paper;
    int rim;      /* first row of the rim */
    double *line; /* the centreline: row by column */
    double *work;
} straightener;

/* Smooths by a Gaussian; the ends are carried on level. */
static void smooth(const double *in, double *out, int n, double sigma)
{
    int radius = (int)ceil(4 * sigma);
    for (int i = 0; i < n; i++) {
        double sum = 0, weights = 0;
        for (int k = -radius; k <= radius; k++) {
            int j = i + k < 0 ? 0 : i + k >= n ? n - 1 : i + k;
            double w = exp(-k * k / (2 * sigma * sigma));
            sum += w * in[j];
            weights += w;
        }
        out[i] = sum / weights;
    }
}

static bool seen(const line_track *t, int k)
{
    return t->bottom[k] > t->top[k];
}

/* Computes the middle of the dark run of each column; straight across gaps. */
static void rough_middles(const line_track *t, double *middle)
{
    int last = 0;
    for (int k = 0; k < t->n; k++) {
        if (!seen(t, k))
            continue;
        middle[k] = (t->top[k] + t->bottom[k] - 1) / 2.0;
        for (int i = last + 1; i < k; i++)
            middle[i] = middle[last] + (middle[k] - middle[last]) * (i - last) / (k - last);
        last = k;
    }
}

static int compare_int(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* Finds where the rim starts: outside the edge of a line of median thickness. */
static bool place_rim(straightener *w, error *err)
{
    const line_track *t = w->t;
    int *heights = plb_new((size_t)t->n, sizeof *heights), n = 0;
    if (!heights)
        return plb_fail_memory(err);
    for (int k = 0; k < t->n; k++)
        if (seen(t, k))
            heights[n++] = t->bottom[k] - t->top[k];
    qsort(heights, (size_t)n, sizeof *heights, compare_int);
    double edge = heights[n / 2] / 2.0 + RIM_CLEAR * w->unit;
    w->rim = (int)ceil(fmax(edge, RIM_NEAREST * w->unit));
    plb_free(heights);
    return true;
}

/* Gives the grey of the scan; paper outside the scan. */
static int grey_at(const straightener *w, int x, int y)
{
    return y < 0 || y >= w->s->height ? w->paper : w->s->grey[(size_t)y * (size_t)w->s->width + (size_t)x];
}

/* Gives the centre of darkness of column k about row y. */
static double centroid(const straightener *w, int k, double y)
{
    double sum = 0, moment = 0;
    int middle = (int)floor(y + 0.5);
    for (int o = -w->rim; o <= w->rim; o++) {
        double dark = w->paper - grey_at(w, w->t->x0 + k, middle + o);
        if (dark < FAINT * w->paper)
            continue;
        sum += dark;
        moment += dark * (middle + o);
    }
    return sum < 1 || !seen(w->t, k) ? y : moment / sum;
}

static void find_centreline(straightener *w)
{
    int n = w->t->n;
    rough_middles(w->t, w->work);
    smooth(w->work, w->line, n, COARSE_SIGMA * w->unit);
    for (int k = 0; k < n; k++)
        w->work[k] = centroid(w, k, w->line[k]);
    smooth(w->work, w->line, n, FINE_SIGMA * w->unit);
}

/* Scales a grey so that paper is 255, and noise of the paper is paper. A hash of the pixel's place rounds up or down,
 * so that the mean is kept and no grey is left without pixels (plain rounding would comb the histograms). */
static uint8_t scaled(const straightener *w, int x, int y)
{
    int full = grey_at(w, x, y) * 255, g = full / w->paper;
    uint64_t place = random_mix((uint64_t)x << 32 | (uint32_t)y);
    g += (int)(place % (uint64_t)w->paper) < full % w->paper;
    return (uint8_t)(g > STRIP_LIGHTEST ? 255 : g);
}

/* Gives the grey for the grain: unchanged, but paper is paper. */
static float darkness(const straightener *w, int x, int y)
{
    double grey = fmin(255, grey_at(w, x, y) * 255.0 / w->paper);
    return grey > STRIP_GRAIN_LIGHTEST ? 0 : (float)(255 - grey);
}

/* Tells whether nothing but paper is in the rim rows of column k; clears what lies beyond the line. */
static bool straighten_column(const straightener *w, line_strip *out, int k)
{
    int x = w->t->x0 + k, middle = (int)floor(w->line[k] + 0.5);
    double rim = 0;
    int rows = (int)ceil(RIM_ROWS * w->unit);
    for (int o = w->rim; o < w->rim + rows; o++)
        rim += fmin(255, grey_at(w, x, middle - o) * 255.0 / w->paper) + fmin(255, grey_at(w, x, middle + o) * 255.0 / w->paper);
    uint8_t *column = out->grey + (size_t)k * (size_t)strip_rows(out);
    float *dark = out->dark + (size_t)k * (size_t)strip_rows(out);
    for (int o = -out->reach; o <= out->reach; o++) {
        column[o + out->reach] = abs(o) >= w->rim ? 255 : scaled(w, x, middle + o);
        dark[o + out->reach] = abs(o) > STRIP_GRAIN_REACH * w->unit ? 0 : darkness(w, x, middle + o);
    }
    out->offset[k] = w->line[k] - middle;
    double slope = (w->line[k + 1 < out->n ? k + 1 : k] - w->line[k > 0 ? k - 1 : k]) / (k > 0 && k + 1 < out->n ? 2 : 1);
    out->cosine[k] = 1 / sqrt(1 + slope * slope);
    return rim >= RIM_LIGHT * 2.0 * rows;
}

/* A column is usable when the line was seen for TRIM columns on either side and the rims here and next to it are
 * clear. */
static void mark_usable(const straightener *w, line_strip *out, const bool *clear)
{
    int trim = (int)ceil(TRIM * w->unit), whole = 0;
    for (int k = 0; k < out->n; k++) {
        whole = seen(w->t, k) ? whole + 1 : 0;
        int mid = k - trim;
        if (whole >= 2 * trim + 1)
            out->usable[mid] = clear[mid - 1] && clear[mid] && clear[mid + 1];
    }
    for (int k = 0; k < out->n; k++)
        out->columns += out->usable[k];
}

static void measure(line_strip *s)
{
    uint32_t middle[PROFILE_GREYS] = {0};
    double mean[PROFILE_SECTION_BINS], sd[PROFILE_SECTION_BINS];
    section_sums sums = {0};
    for (int k = 0; k < s->n; k++)
        if (s->usable[k])
            middle[strip_grey(s, k, 0)]++;
    plb_section_add(&sums, s, 1);
    plb_section_figures(&sums, mean, sd);
    s->centre = plb_histogram_percentile(middle, PROFILE_GREYS, 0.5);
    s->width_half = plb_section_width(mean, 0.5);
    s->width_tenth = plb_section_width(mean, 0.1);
}

static void measure_hand(const straightener *w, line_strip *s)
{
    int trim = (int)ceil(TRIM * w->unit);
    if (s->n > 2 * trim)
        s->strays = plb_hand_compare(w->line + trim, s->n - 2 * trim, MM_PER_INCH / PAPER_PX_PER_INCH / w->unit, s->stray);
}

static bool straighten(straightener *w, line_strip *out, error *err)
{
    if (!place_rim(w, err))
        return false;
    size_t n = (size_t)w->t->n;
    out->n = w->t->n;
    out->paper = w->paper;
    out->reach = (int)ceil(STRIP_REACH * w->unit);
    out->grey = plb_new(n, (size_t)strip_rows(out));
    out->dark = plb_new(n, (size_t)strip_rows(out) * sizeof *out->dark);
    out->offset = plb_new(n, sizeof *out->offset);
    out->cosine = plb_new(n, sizeof *out->cosine);
    out->usable = plb_new(n, sizeof *out->usable);
    bool *clear = plb_new(n, sizeof *clear);
    w->line = plb_new(n, sizeof *w->line);
    w->work = plb_new(n, sizeof *w->work);
    bool good = out->grey && out->dark && out->offset && out->cosine && out->usable && clear && w->line && w->work;
    if (good) {
        find_centreline(w);
        for (int k = 0; k < out->n; k++)
            clear[k] = straighten_column(w, out, k);
        mark_usable(w, out, clear);
        measure(out);
        measure_hand(w, out);
    }
    plb_free(clear);
    plb_free(w->line);
    plb_free(w->work);
    return good || plb_fail_memory(err);
}

bool plb_line_strip_make(const scan *s, const line_track *t, double unit, int paper, line_strip *out, error *err)
{
    *out = (line_strip){0};
    straightener w = {.s = s, .t = t, .unit = unit, .paper = paper};
    if (straighten(&w, out, err))
        return true;
    plb_line_strip_free(out);
    return false;
}

void plb_line_strip_free(line_strip *strip)
{
    plb_free(strip->grey);
    plb_free(strip->dark);
    plb_free(strip->offset);
    plb_free(strip->cosine);
    plb_free(strip->usable);
    *strip = (line_strip){0};
}
