/* SPDX-License-Identifier: MIT
 *
 * This header lists the steps that capture the grain, in the order in which they are taken, and what they share. plumbago(7) tells the
 * model. Distances are signed, in pixels of 1/300 inch; "relative" darkness is divided by the line's depth.
 */
#ifndef PLB_PROFILE_GRAIN_GRAIN_H
#define PLB_PROFILE_GRAIN_GRAIN_H

#include "profile/capture/line_strip.h"
#include "profile/profile.h"

#define GRAIN_REACH 12 /* rows kept on either side of the middle one */
#define GRAIN_ROWS (2 * GRAIN_REACH + 1)
#define GRAIN_LAGS 5   /* of the scores' correlation: 0 to 4 along … */
#define GRAIN_ASIDE 3  /* … and 0 to 2 across */
#define GRAIN_CORE 0.35f /* expected level from which a pixel has a score: below, clipping at the paper hides it */
#define GRAIN_FAR_FROM 8 /* columns apart at which only what is slow still correlates … */
#define GRAIN_FAR_TO 12  /* … to; these chosen by eye */
#define GRAIN_MIN_COLUMNS 300     /* fewer tell nothing */
#define GRAIN_MAX_COLUMNS 400000  /* of one profile, 34 m of line: a bound on memory */

/* One line. Pixel (k, o) of column k and row o - GRAIN_REACH is element k * GRAIN_ROWS + o. */
typedef struct {
    int n, columns;         /* all, and the usable ones */
    const bool *usable;     /* the strip's */
    double depth, width;    /* mean darkness within 1.25 px of the centreline; width at half depth */
    double weight;          /* its share of all columns */
    double (*coefficient)[GRAIN_MODES]; /* of column k */
    double mean[GRAIN_MODES];           /* … over the line */
    float *place;           /* distance from the centreline, scaled to the reference width */
    float *dark;            /* relative darkness */
    float *level;           /* … that is expected there */
    float *score;           /* normal score of the one given the other; NaN outside the core */
    double roughness;       /* log of the scores' rms */
    double along, across;   /* correlation of its scores with the next column and row */
} grain_line;

typedef struct {
    grain_line *v;
    size_t n;
    double columns;
} grain_lines;

/* Moments of the scores of all lines. */
typedef struct {
    double correlation[GRAIN_LAGS][GRAIN_ASIDE]; /* by lag along and across, what is slow taken off */
    double common;                               /* how much all rows of a column step together */
} grain_moments;

/* grain_lines.c: the strips as grain_lines; the reference width. The strips stay in use. */
bool plb_grain_lines_make(const line_strip strips[], size_t n, grain_lines *out, grain_model *g, error *err);
void plb_grain_lines_free(grain_lines *lines);
/* section/section_mean.c: g->section. */
void plb_grain_section(const grain_lines *lines, grain_model *g);
/* Gives the root of g->section so far from the centreline: where nothing deviates. */
double plb_grain_root(const grain_model *g, double place);
/* Tells how fast its square changes: modes are in darkness, and work on the root by this much less. */
double plb_grain_root_slope(double root);
/* section/section_modes.c: g->mode, the coefficients of the columns; g->section becomes the square of the mean root. */
bool plb_grain_modes(grain_lines *lines, grain_model *g, error *err);
/* section/section_process.c: g->mode_between, mode_within, mode_length; the means of the coefficients. */
void plb_grain_slow(grain_lines *lines, grain_model *g);
/* score/score_table.c: the levels of the pixels and g->darkness; the normal score of a darkness at a level. */
bool plb_grain_darkness(grain_lines *lines, grain_model *g, error *err);
double plb_grain_score(const grain_model *g, double level, double dark);
/* Gives the score below which a pixel shows nothing; `least`: the relative darkness of the faintest grey. -3: it always shows. */
double plb_grain_bare_score(const grain_model *g, double level, double least);
/* score/scores.c: scores, roughness and own correlation of the lines, g->place_scale. */
void plb_grain_scores(grain_lines *lines, grain_model *g);
/* score/score_places.c: g->place_along, place_across. */
void plb_grain_places(const grain_lines *lines, grain_model *g);
/* correlation/score_moments.c: g->volatility, volatility_across. */
void plb_grain_moments(const grain_lines *lines, grain_model *g, grain_moments *m);
/* correlation/score_chain.c: g->chain_…; response[d][e] is the covariance at lag d of the chain's output where its innovations have
 * unit covariance at lags e and -e. */
void plb_grain_chain(const grain_moments *m, grain_model *g);
void plb_grain_chain_response(const grain_model *g, double response[GRAIN_LAGS][GRAIN_LAGS]);
/* correlation/noise_filter.c: the filter that gives the chain's output the correlation `wanted`; g->filter. */
void plb_grain_solve_filter(double response[GRAIN_LAGS][GRAIN_LAGS], double wanted[GRAIN_LAGS][GRAIN_ASIDE],
                            float out[GRAIN_TAPS][GRAIN_TAPS]);
void plb_grain_filter(const grain_moments *m, grain_model *g);
/* grain_between.c: g->line_mean, line_factor. */
void plb_grain_between(const grain_lines *lines, const grain_moments *m, grain_model *g);

/* grain_capture.c: all of it. Too little line leaves g->present false. */
bool plb_grain_capture(const line_strip strips[], size_t n, grain_model *g, error *err);

/* grain_refine.c: corrects p->grain by what the lines that `sample` draws with it are captured as. */
bool plb_grain_refine(profile *p, line_sampler *sample, void *closure, error *err);

/* Takes the correlation of another grain, and its spread in part: the more the less dark. */
void plb_grain_borrow(grain_model *g, const grain_model *from);

/* ---- grain_fields.c: the numbers of a grain_model in the order of the file, and what they may be ---- */

typedef struct {
    size_t offset, count; /* of floats in a grain_model */
    float low, high;
} grain_field;
#define GRAIN_FIELDS 22
extern const grain_field plb_grain_fields[GRAIN_FIELDS];
/* True when every number is finite and within its bounds, and the numbers fit together. */
bool plb_grain_is_sound(const grain_model *g);
/* Moves every number into its bounds. */
void plb_grain_clamp(grain_model *g);

#endif
