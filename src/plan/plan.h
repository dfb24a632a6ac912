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

/* Fills `out`, which the caller frees on success; on failure it is empty. */
bool plb_plan(const display_list *list, const messenger *say, stroke_list *out, error *err);

#endif
