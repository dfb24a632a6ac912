/* SPDX-License-Identifier: MIT
 *
 * A drawing's curve of tones: how dark a fill is shaded so that what lies on it is read. A person lightens the shading behind words and
 * lines, and keeps it dark behind words left white; small white words are written dark, in a gap of the shading.
 */
#ifndef PLB_PLAN_TONE_TONE_CURVE_H
#define PLB_PLAN_TONE_TONE_CURVE_H

#include "plan/plan.h"

#define TONE_KNOTS 5
/* A tone_curve rises from (0, 0) to (1, 1) in straight pieces, so the order of tones stays. */
typedef struct {
    int n;
    double in[TONE_KNOTS], out[TONE_KNOTS];
} tone_curve;

/* Leaves every tone as it is. */
tone_curve plb_tone_curve_plain(void);
/* Finds the curve that a drawing needs. For each of its items, `is_inked` becomes true where the item is a letter that is white on a dark
 * area, and too small to be left open between a pencil's lines: it is lettered instead. False and `err` when out of memory. */
bool plb_tone_curve_find(const display_list *list, const plan_options *o, tone_curve *curve, bool *is_inked, error *err);
/* Gives the darkness (0 to 1) that stands for a darkness. */
double plb_tone_curve_at(const tone_curve *curve, double darkness);

#endif
