/* SPDX-License-Identifier: MIT
 *
 * Tone: how a darkness is made of spacing, pressure and layers.
 */
#ifndef PLB_PLAN_HATCH_TONE_H
#define PLB_PLAN_HATCH_TONE_H

#include "list/list.h"
#include "plan/plan.h"

/* How an area is hatched. */
#define HATCH_LAYERS 2
typedef struct {
    double pressure;
    double spacing[HATCH_LAYERS]; /* of each layer's lines, mm; 0: no such layer */
} technique;

/* From the faintest, 0, to the darkest, 1; `width` is the pencil's, mm. */
technique plb_technique(double effort, double width);
/* The technique for a darkness (0 paper to 1 black) with the pencil of these options. */
technique plb_technique_for(double darkness, const plan_options *o);

/* The darkness that is meant at a place: the paint's, there. In colour it is how densely the pencil covers. */
double plb_paint_darkness(const paint *p, bool colour);

#endif
