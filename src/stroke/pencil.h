/* SPDX-License-Identifier: MIT
 *
 * The tables of a prepared pencil, for this folder only.
 */
#ifndef PLB_STROKE_PENCIL_H
#define PLB_STROKE_PENCIL_H

#include "stroke/stroke.h"

#define CENTRE_STEPS 4096

struct pencil {
    const profile *profile;
    int half_beside;  /* rows beside the centre that take the darker range */
    int half_rows;    /* rows on either side of the centre altogether */
    int beside_low, beside_span;   /* uniform in [low, low + span - 1] */
    int outside_low, outside_span;
    uint8_t centre[CENTRE_STEPS];  /* the centre histogram's quantile function */
    uint8_t nearest[PROFILE_GREYS][PROFILE_GREYS]; /* [i][j]: the grey nearest to j that stands beside i in the CCM */
};

#endif
