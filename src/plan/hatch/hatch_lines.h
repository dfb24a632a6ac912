/* SPDX-License-Identifier: MIT
 *
 * Lines across a shape, for tone and for solid shapes: what the hand's unevenness does to them.
 */
#ifndef PLB_PLAN_HATCH_HATCH_LINES_H
#define PLB_PLAN_HATCH_HATCH_LINES_H

#include "plan/hatch/hatch.h"
#include "plan/hatch/hatch_shape.h"
#include "plan/hatch/hatch_tone.h"

/* The marks that an area is given, and what they have in common. */
typedef struct {
    const plan_options *options;
    stroke_style style;
    track_list *out;
    error *err;
} marks;

/* Adds the straight line from a to b. False and `err` when out of memory, as below. */
bool plb_mark_line(const marks *m, point a, point b, double pressure);

/* hatch_lines.c: one layer of parallel lines, `spacing` mm apart on average, in the direction `angle` (radians), where the
 * shape lies within `page`. `layer` tells its random numbers from another layer's. */
typedef struct {
    double angle, spacing, pressure;
    int layer;
    double dense;            /* what `spacing` would be but for the bound on the number of lines, mm */
    double finest;           /* what the tone may change over, mm; 0: it changes slowly */
    const tone_source *tone; /* where it varies: `spacing` is then that of the darkest place; NULL: it is even */
} hatch_layer;
bool plb_hatch_lines(const shape *s, const hatch_layer *l, box page, const marks *m);

/* scribble.c: shapes whose bounds are narrower than this, mm, are solid. */
double plb_solid_breadth(double width);
/* Tells whether a shape is so thin or small that it is scribbled full rather than hatched, in *solid. */
bool plb_is_solid(const shape *s, double width, bool *solid, error *err);
/* Scribbles it full. *outline: whether its outline is still to be drawn. */
bool plb_scribble(const shape *s, box page, const marks *m, bool *outline);

#endif
