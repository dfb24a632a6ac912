/* SPDX-License-Identifier: MIT
 *
 * Manners of hatching: where graphite cannot tell two paints of a drawing apart by tone, direction and spacing do. One paint has one
 * manner in the whole drawing, so that a legend's keys are hatched as what they stand for.
 */
#ifndef PLB_PLAN_TONE_MANNERS_H
#define PLB_PLAN_TONE_MANNERS_H

#include "plan/tone/cells.h"
#include "plan/tone/tone_curve.h"

/* A manner says how a paint's hatching differs from the usual. */
typedef struct {
    double turn;    /* radians, added to the direction: where the direction tells, to that of habit, so that all differ */
    double coarser; /* above 1: one layer of lines, which are seen, with spacing so many times as wide */
    bool is_told;   /* by its direction */
} manner;

#define MANNERS_MAX_PAINTS 12 /* more are a scale of tones, no chart */
typedef struct {
    int n;
    paint paints[MANNERS_MAX_PAINTS];
    manner manners[MANNERS_MAX_PAINTS];
} paint_manners;

/* Finds the manners of a drawing's paints; none where there are too many paints for a chart. False and `err` when out of memory. */
bool plb_manners_find(const display_list *list, const plan_options *o, const tone_curve *curve, const cell_groups *cells, paint_manners *m, error *err);
/* Gives the manner of a paint. */
manner plb_manner_of(const paint_manners *m, const paint *p);

#endif
