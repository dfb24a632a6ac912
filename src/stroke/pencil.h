/* SPDX-License-Identifier: MIT
 *
 * The tables of a prepared pencil, for this folder only.
 */
#ifndef PLB_STROKE_PENCIL_H
#define PLB_STROKE_PENCIL_H

#include "stroke/texture/graphite/paper.h"
#include "stroke/texture/models.h"

#define CENTRE_STEPS 4096

/* The graphite model's tables of whole numbers: all that a stroke needs. */
#define FIELD_UNIT PAPER_UNIT /* steps of a score's standard deviation in the field: 4 sigma fit a byte */
#define NOISE_UNIT 2048       /* … and before the field is rounded to bytes */
#define NOISE_LENGTH 2048     /* of the sequence of white noise: every other normal number */
#define NOISE_PAD 96          /* rows of the broadest stroke, at least */
#define AMPLITUDE_LENGTH 512  /* columns of the ring of amplitudes */
#define AMPLITUDE_UNIT 64
#define GRAIN_NORMALS 4096    /* a normal number per 12 random bits */
#define GRAIN_KNOT 4          /* the section is worked out every so many columns */
#define GRAIN_PLACES_PADDED 72 /* the modes' 65 places, up to a whole number of vectors */
#define SLOW_LENGTH 2048      /* knots of a slow process on its ring */
#define COEFFICIENT_UNIT 2880 /* steps of a mode's coefficient: half of them times 32768 of a mode's value … */
#define ROOT_UNIT 1440        /* … are the root of a level in these */
#define GRAIN_LEVEL_UNIT 180  /* steps of a level in the end: 1.4 fits a byte */
#define GRAIN_RELATIVE_UNIT 4096 /* steps of relative darkness */
#define DARKNESS_ROWS 96      /* small enough to stay in the nearest cache */
#define DARKNESS_SCALES 4
#define ROW_PLACES 65         /* distances from the centreline … */
#define ROW_PLACE_STEP 0.125  /* … px of the reference width */
#define ROUGH_CLASSES 32      /* of roughness, in equal steps of its logarithm … */
#define ROUGH_LOG_STEP 0.04   /* … about 1 */

typedef struct {
    float normal[GRAIN_NORMALS];
    int16_t noise[GRAIN_CLASSES][GRAIN_TAPS][NOISE_LENGTH + NOISE_PAD]; /* pencil_noise.c */
    int8_t amplitude[AMPLITUDE_LENGTH][2 * NOISE_PAD]; /* of the grain, about 1 */
    int16_t slow[GRAIN_MODES][SLOW_LENGTH];
    int16_t root[GRAIN_PLACES_PADDED];              /* of the section at the modes' places */
    int16_t mode[GRAIN_MODES][GRAIN_PLACES_PADDED];
    int8_t score_correction[ROUGH_CLASSES][256]; /* normal score of field value k - 128, less the field value */
    struct {
        uint8_t share; /* how much of that difference holds, of 256 */
        uint8_t row;   /* of the table of darkness: close together where little is expected */
    } at_level[256];
    /* Relative darkness by row and half the score's steps: of a pixel of 1/300 inch, and of pixels two, three and four
     * times as broad, whose score is that of their mean. */
    uint16_t darkness[DARKNESS_SCALES][DARKNESS_ROWS][128];
    int16_t row_spread[ROW_PLACES], row_outer[ROW_PLACES]; /* by distance from the centreline: see texture_grain.c */
    float row_along[ROW_PLACES];
    float outer_across;              /* how much the outer rows correlate across beyond the inner ones */
    double reach;                    /* px of the reference width from the centreline: farther there is nothing */
    float chain_high, chain_low;     /* the profile's, farther apart to make up for the paper, which does not join in */
    paper paper;
} grain_tables;

struct pencil {
    const profile *profile;
    grain_tables *grain; /* NULL: the profile has none */
    int half_beside;  /* rows beside the centre that take the darker range */
    int half_rows;    /* rows on either side of the centre altogether */
    int beside_low, beside_span;   /* uniform in [low, low + span - 1] */
    int outside_low, outside_span;
    uint8_t centre[CENTRE_STEPS];  /* the centre histogram's quantile function */
    uint8_t nearest[PROFILE_GREYS][PROFILE_GREYS]; /* [i][j]: the grey nearest to j that stands beside i in the CCM */
};

/* Makes p->grain from p->profile->grain (pencil_grain.c); false when out of memory. */
bool plb_pencil_tabulate_grain(pencil *p, paper_kind on);
/* pencil_noise.c: t->noise, from t->normal and t->paper; t->amplitude, false when out of memory; t->slow. */
void plb_pencil_tabulate_noise(grain_tables *t, const grain_model *g);
bool plb_pencil_tabulate_amplitude(grain_tables *t, const grain_model *g);
void plb_pencil_tabulate_slow(grain_tables *t, const grain_model *g);

#endif
