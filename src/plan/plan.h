/* SPDX-License-Identifier: MIT
 *
 * The display list becomes strokes that a person would make: outlines of fills, dashes, clipped pieces, corners.
 */
#ifndef PLB_PLAN_PLAN_H
#define PLB_PLAN_PLAN_H

#include "base/error.h"
#include "list/list.h"
#include "list/strokes.h"

/* The most strokes and points that a plan may hold; beyond: ERROR_LIMIT. */
#define PLAN_MAX_STROKES 5000000u
#define PLAN_MAX_POINTS 60000000u

typedef enum { FILL_HATCH, FILL_OUTLINE, FILL_NONE } fill_style;
typedef enum { TEXT_HAND, TEXT_OUTLINE, TEXT_NONE } text_style;
typedef struct {
    fill_style fill;
    text_style text;
    bool colour;         /* each stroke in its paint's own colour */
    double pencil_width; /* of the pencil's line at half depth, mm: what one stroke covers */
    uint64_t seed;       /* of the unevenness that a plan itself has: dashes, hatching */
} plan_options;
plan_options plb_plan_options_default(void);

/* Fills `out`, which the caller frees on success; on failure it is empty. */
bool plb_plan(const display_list *list, const plan_options *o, const messenger *say, stroke_list *out, error *err);

#endif
