/* SPDX-License-Identifier: MIT
 *
 * Tone: how a darkness is made of spacing, pressure and layers.
 */
#ifndef PLB_PLAN_HATCH_HATCH_TONE_H
#define PLB_PLAN_HATCH_HATCH_TONE_H

#include "list/display_list.h"
#include "plan/plan.h"
#include "plan/tone/cells.h"
#include "plan/tone/tone_curve.h"

/* Lighter tones are left to the paper (chosen by eye: gradients begin unseen, and what is all but white stays white). */
#define MIN_DARKNESS 0.03

/* A technique says how an area is hatched. */
#define HATCH_LAYERS 2
typedef struct {
    bool is_soft;                 /* with the softer pencil */
    double pressure[HATCH_LAYERS];
    double spacing[HATCH_LAYERS]; /* of each layer's lines, mm; 0: no such layer */
} technique;

/* Gives the technique of an effort from the faintest, 0, to the darkest, 1; `width` is the pencil's, mm. */
technique plb_technique(double effort, double width);
/* Tells whether an area whose darkest place has this darkness (0 paper to 1 black) is shaded with the softer pencil. */
bool plb_is_soft_tone(double darkness, const plan_options *o);
/* Gives the technique for a darkness with the pencil of these options, or their softer one. */
technique plb_technique_for(double darkness, bool is_soft, const plan_options *o);

/* Gives the darkness that the pencils can make of a darkness: d / (1 + (c d)^p)^(1/p), with c such that black becomes the pencil's darkest. */
double plb_tone_within_reach(double darkness, const plan_options *o);
/* Gives the technique with one layer of lines that are seen one by one, so that their direction and spacing tell; spacing `coarser` times. */
technique plb_single_layer(technique q, double width, double coarser);

/* A tone comes from one paint or from a gradient. */
typedef struct {
    const paint *paint;
    const gradient *gradient; /* NULL: the paint's tone is the same everywhere, unless there is a … */
    const tone_field *field;  /* … NULL otherwise */
    const tone_curve *curve;
    bool colour;
    bool is_soft;             /* its darkest place asks for the softer pencil */
    const plan_options *options;
} tone_source;
/* `curve` is borrowed: all tones go through it. */
tone_source plb_tone_source(const display_list *list, const item *fill, const plan_options *o, const tone_curve *curve, bool colour);
/* Gives the darkest of all its places. */
double plb_darkest(const tone_source *t);
double plb_darkness_at(const tone_source *t, point at);

/* Gives the darkness that a paint means. In colour the darkness is how densely the pencil covers. */
double plb_paint_darkness(const paint *p, bool colour);

#endif
