/* SPDX-License-Identifier: MIT
 *
 * The last step of the capture corrects the grain. Lines drawn with what was measured, measured in the same way, come out a little
 * different: rounder flanks, less correlation. What was measured is moved by that difference the other way, once (the
 * bootstrap's correction of a bias: Efron & Tibshirani, An Introduction to the Bootstrap, 1993, chapter 10; in econometrics
 * indirect inference).
 */
#include "profile/capture/line_straighten.h"
#include "profile/grain/grain.h"

#include "base/array.h"
#include "base/geometry/interpolate.h"
#include "base/number/units.h"

#include <math.h>
#include <string.h>

/* The lines drawn, px at 300 dpi: 66 x 5 mm, a line of 60 mm and more than a free hand deviates. So many of them that their own
 * chance is small beside what is corrected. */
#define LINES 120
#define SAMPLE_WIDTH 780
#define SAMPLE_HEIGHT 59
#define PAPER 255

/* Shares of the difference: the whole of it would overshoot, as the figures hang together; chosen by trial on the pencils
 * of w0054 and w0028 of hdBPMN. */
#define SHARE 0.8
#define SHARE_OF_DARKNESS 0.6
#define MAX_CORRECTION_RATIO 1.6

static float towards(float now, float measured, float drawn, double share)
{
    return (float)(now + share * (measured - drawn));
}

/* Corrects a figure that is still as measured. */
static float corrected(float was, float drawn)
{
    return towards(was, was, drawn, SHARE);
}

static float scaled_towards(float now, double measured, double drawn)
{
    double ratio = drawn > 0 ? clamp(measured / drawn, 1 / MAX_CORRECTION_RATIO, MAX_CORRECTION_RATIO) : 1;
    return (float)(now * pow(ratio, SHARE));
}

static double sum_of(const float v[], int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += v[i];
    return sum;
}

/* Quantiles rise with the score. */
static void correct_darkness(float now[GRAIN_SCORES], const float drawn[GRAIN_SCORES])
{
    for (int k = 0; k < GRAIN_SCORES; k++) {
        now[k] = towards(now[k], now[k], drawn[k], SHARE_OF_DARKNESS);
        now[k] = k > 0 && now[k] < now[k - 1] ? now[k - 1] : now[k];
    }
}

static void correct(grain_model *g, const grain_model *drawn)
{
    const grain_model was = *g;
    double within = sum_of(was.mode_within, GRAIN_MODES), within_drawn = sum_of(drawn->mode_within, GRAIN_MODES);
    for (int k = 0; k < GRAIN_SECTION; k++)
        g->section[k] = corrected(was.section[k], drawn->section[k]);
    for (int i = 0; i < GRAIN_MODES; i++)
        g->mode_within[i] = scaled_towards(was.mode_within[i], within, within_drawn);
    for (int i = 0; i < GRAIN_LEVELS; i++)
        correct_darkness(g->darkness[i], drawn->darkness[i]);
    for (int k = 0; k < GRAIN_PLACES; k++) {
        g->place_scale[k] = scaled_towards(was.place_scale[k], (double)was.place_scale[k], (double)drawn->place_scale[k]);
        g->place_along[k] = corrected(was.place_along[k], drawn->place_along[k]);
        g->place_across[k] = corrected(was.place_across[k], drawn->place_across[k]);
    }
    g->volatility = corrected(was.volatility, drawn->volatility);
    g->volatility_across = corrected(was.volatility_across, drawn->volatility_across);
    for (int i = 0; i < 3; i++)
        g->line_mean[i] = corrected(was.line_mean[i], drawn->line_mean[i]);
    g->line_mean[4] = corrected(was.line_mean[4], drawn->line_mean[4]);
    /* A line's own part of the correlation along is the line's difference from the mean: the chain has the mean. */
    g->chain_high = towards(was.chain_high, was.line_mean[3], drawn->line_mean[3], SHARE);
    g->chain_low = towards(was.chain_low, was.line_mean[3], drawn->line_mean[3], SHARE);
    plb_grain_clamp(g);
}

/* Computes the strip of one picture; one without a line has no columns. */
static bool take_strip(uint8_t *grey, line_strip *strip, error *err)
{
    const scan s = {SAMPLE_WIDTH, SAMPLE_HEIGHT, PAPER_PX_PER_INCH, grey};
    line_track t = {0};
    *strip = (line_strip){0};
    bool good = plb_line_find(&s, 1, PAPER, &t, err) && (t.n == 0 || plb_line_strip_make(&s, &t, 1, PAPER, strip, err));
    plb_line_track_free(&t);
    return good;
}

static bool capture_drawn(uint8_t *grey, grain_model *drawn, error *err)
{
    line_strip strips[LINES] = {{0}};
    bool good = true;
    for (int i = 0; i < LINES && good; i++)
        good = take_strip(grey + (size_t)i * SAMPLE_WIDTH * SAMPLE_HEIGHT, &strips[i], err);
    good = good && plb_grain_capture(strips, LINES, drawn, err);
    for (int i = 0; i < LINES; i++)
        plb_line_strip_free(&strips[i]);
    return good;
}

bool plb_grain_refine(profile *p, line_sampler *sample, void *closure, error *err)
{
    const size_t size = (size_t)LINES * SAMPLE_WIDTH * SAMPLE_HEIGHT;
    uint8_t *grey = plb_new(size, 1);
    if (!grey)
        return plb_fail_memory(err);
    memset(grey, PAPER, size);
    grain_model drawn;
    bool good = sample(closure, p, LINES, SAMPLE_WIDTH, SAMPLE_HEIGHT, grey, err) && capture_drawn(grey, &drawn, err);
    plb_free(grey);
    if (good && drawn.present)
        correct(&p->grain, &drawn);
    return good;
}
