/* SPDX-License-Identifier: MIT
 *
 * The display list becomes strokes that a person would make: outlines of fills, dashes, clipped pieces, corners.
 */
#ifndef PLB_PLAN_PLAN_H
#define PLB_PLAN_PLAN_H

#include "base/error.h"
#include "list/list.h"

#include <stdint.h>
#include <stdio.h>

/* One movement of the pencil along a smooth line, in mm on paper. */
typedef struct {
    uint64_t identity; /* where its random numbers live: a hash of its shape, distinct for each stroke of a list */
    size_t first, n;   /* its points in stroke_list.points; n >= 2, no two neighbours equal */
    bool closed;       /* ends where it starts, smoothly */
} stroke;

typedef struct {
    double width, height; /* of the page, mm */
    ARRAY(stroke) strokes;
    ARRAY(point) points;
} stroke_list;

/* Fills `out` (initialised to {0} by the caller, who frees it). */
bool plb_plan(const display_list *list, const messenger *say, stroke_list *out, error *err);
void plb_stroke_list_free(stroke_list *s);
/* The text form: --dump=strokes. */
bool plb_stroke_list_print(const stroke_list *s, FILE *to);

#endif
