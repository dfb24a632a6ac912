/* SPDX-License-Identifier: MIT
 *
 * The tables of a prepared pencil, for this folder only.
 */
#ifndef PLB_STROKE_PENCIL_H
#define PLB_STROKE_PENCIL_H

#include "stroke/stroke.h"

#define CENTRE_STEPS 4096

/* Of the graphite model. */
#define GRAIN_SCORE_UNIT 40   /* steps of a score: 3 sigma fit a byte */
#define GRAIN_LEVEL_UNIT 180  /* steps of a level: 1.4 fits a byte */
#define GRAIN_RELATIVE_UNIT 4096 /* steps of relative darkness */
#define GRAIN_KNOT 4          /* the section is worked out every so many columns */
#define GRAIN_SMOOTH_KNOTS 6  /* the Gaussian along the line reaches three sigma to either side */
#define GRAIN_NORMALS 4096    /* a normal number per 12 random bits */
#define GRAIN_PLACES_PADDED 72 /* the modes' 65 places, up to a whole number of vectors */
#define GRAIN_MAP 641         /* entries of the map from field to score, -8 to 8 */

typedef struct {
    float normal[GRAIN_NORMALS];
    int8_t score[GRAIN_MAP];                 /* normal score of a field value, in 1/GRAIN_SCORE_UNIT */
    uint16_t darkness[256][128];             /* relative darkness by level and half the score's steps */
    float section[GRAIN_PLACES_PADDED];      /* mean section at the modes' places */
    float mode[GRAIN_MODES][GRAIN_PLACES_PADDED]; /* modes, faded where there is hardly any line */
    float knot_keep[GRAIN_MODES];            /* of the slow process: correlation from knot to knot … */
    float knot_scale[GRAIN_MODES];           /* … and the factor that makes it as wide as captured */
    float smooth[2 * GRAIN_SMOOTH_KNOTS + 1];
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

/* Fills p->grain from p->profile->grain (pencil_grain.c); false when out of memory. */
bool plb_pencil_tabulate_grain(pencil *p);

#endif
