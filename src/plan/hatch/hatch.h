/* SPDX-License-Identifier: MIT
 *
 * Fills as a person shades them: tone by hatching, small and thin shapes solid. plumbago(7), HATCHING, tells the figures.
 */
#ifndef PLB_PLAN_HATCH_HATCH_H
#define PLB_PLAN_HATCH_HATCH_H

#include "list/display_list.h"
#include "plan/plan.h"
#include "plan/tone/cells.h"
#include "plan/tone/manners.h"
#include "plan/tone/tone_curve.h"
#include "plan/track.h"

/* Shapes of about the same tone, and the axes they have: sums over them, weighted. */
#define HATCH_FAMILIES 33
typedef struct {
    double weight, cosine, sine;
} hatch_family;

/* All fills of a drawing share the page, directions, and the bound on the number of lines. */
typedef struct {
    const display_list *list; /* borrowed, as … */
    const plan_options *options;  /* … is this */
    tone_curve curve;
    paint_manners manners;
    box page;                /* mm: nothing is hatched beyond it */
    double coarser;          /* all spacings are this many times as wide, >= 1, so that a drawing's lines stay in bounds */
    hatch_family families[HATCH_FAMILIES]; /* by darkness */
} hatcher;
hatcher plb_hatcher(const display_list *list, const plan_options *o, const tone_curve *curve, const paint_manners *manners);

/* Tells whether its tone may count: it is neither too small for a tone nor too light for a mark. */
bool plb_may_be_hatched(const item *fill, const plan_options *o);

/* Tells whether it is a blot rather than a stroke of a letter, in *blot: a dot, a pad, an arrowhead, a thick bar. False and `err`
 * when out of memory. */
bool plb_is_blot(const item *fill, const plan_options *o, bool *blot, error *err);

/* Appends the marks that give `fill` its tone to `out`: tracks with their style set (pressure; STROKE_HATCH; of the colour
 * `colour`), neither clipped nor hidden. *outline tells whether the caller should draw the shape's outline too: not
 * where the marks themselves follow it, nor round what is taken for paper. False and `err` when out of memory. */
bool plb_plan_hatch(const hatcher *h, const item *fill, uint32_t colour, bool *outline, track_list *out, error *err);

/* Appends the marks that give a group of cells its tones: hatching across all of them; `last` is the group's last cell. As above. */
bool plb_plan_hatch_cells(const hatcher *h, const item *last, const tone_field *f, track_list *out, error *err);

/* ---- hatch_direction.c ---- */

/* A shape this much longer than wide has an axis to follow: lines and scribbles go along it (chosen by eye). */
#define LONG_ELONGATION 2.2
/* A right hand's strokes rise to the right: their direction, radians (chosen by eye). */
#define HATCH_HABIT (-0.82)
/* Learns from a fill; all fills come before the first question. */
void plb_hatch_direction_learn(hatcher *h, const item *fill);
/* Gives the direction in which it is hatched, radians. */
double plb_hatch_direction(const hatcher *h, const item *fill);

#endif
