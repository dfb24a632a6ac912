/* SPDX-License-Identifier: MIT
 *
 * Tone by spacing and pressure. A person makes a light tone with a light hand and lines set wide apart, a darker one by
 * setting them closer and pressing more, and the darkest by going over the first layer once more. These go together, in one
 * row of techniques from faint to dark; how dark each comes out is measured on the pencil itself (api/tone.c), so that
 * whatever the pencil, a tone is met, as far as the pencil goes.
 */
#include "plan/hatch/hatch_tone.h"

#include <math.h>

/* Spacing of the first layer, in widths of the pencil's line, and pressure, at efforts 0, 1/2 and 1. The second layer sets in at
 * SECOND_FROM as lightly as the pencil marks at all, so that no tone jumps, and ends as the first (all chosen by eye). */
static const double spacing_at[3] = {2.1, .9, .55};
static const double pressure_at[3] = {.3, .58, 1.6};
#define SECOND_FROM 0.45
#define SECOND_WIDEST 1.1
#define SECOND_CLOSEST 0.55
#define SECOND_LIGHTEST 0.08
/* Lines closer than this, in widths of the pencil's line, are no longer seen one by one (chosen by eye). */
#define SINGLE_CLOSEST 1.35
/* Tones are drawn together towards the pencil's darkest by a smooth curve of this power: light ones stay, and the darker half of the greys keeps a
 * third of the scale (chosen by eye; 1.5 leaves more of the darks and draws middle tones paler than they are). */
#define REACH_POWER 2.0
/* From this part of the pencil's darkest tone on, an area is shaded with the softer pencil, where there is one: before the pencil is pressed as hard
 * as it can be (chosen by eye). */
#define SOFT_FROM 0.85

static double between(const double at[3], double t)
{
    return t < .5 ? at[0] + (at[1] - at[0]) * 2 * t : at[1] + (at[2] - at[1]) * (2 * t - 1);
}

technique plb_technique(double effort, double width)
{
    double t = effort < 0 ? 0 : effort > 1 ? 1 : effort;
    double first[3] = {log(spacing_at[0]), log(spacing_at[1]), log(spacing_at[2])};
    technique q = {.pressure = {between(pressure_at, t), 0}, .spacing = {width * exp(between(first, t)), 0}};
    if (t > SECOND_FROM) {
        double part = (t - SECOND_FROM) / (1 - SECOND_FROM);
        q.spacing[1] = width * SECOND_WIDEST * pow(SECOND_CLOSEST / SECOND_WIDEST, part);
        q.pressure[1] = SECOND_LIGHTEST + (q.pressure[0] - SECOND_LIGHTEST) * part;
    }
    return q;
}

/* Gives the darkest tone of the pencils at hand. */
static double reach_of(const plan_options *o)
{
    double darkest = o->tone.darkness[TONE_STEPS - 1];
    return o->soft_width > 0 ? fmax(darkest, o->soft_tone.darkness[TONE_STEPS - 1]) : darkest;
}

double plb_tone_within_reach(double darkness, const plan_options *o)
{
    double darkest = reach_of(o), p = REACH_POWER, c = darkest < 1 ? pow(darkest, -p) - 1 : 0;
    return darkness / pow(1 + c * pow(darkness, p), 1 / p);
}

bool plb_is_soft_tone(double darkness, const plan_options *o)
{
    return o->soft_width > 0 && plb_tone_within_reach(darkness, o) > SOFT_FROM * o->tone.darkness[TONE_STEPS - 1];
}

technique plb_technique_for(double darkness, bool is_soft, const plan_options *o)
{
    const double *scale = is_soft ? o->soft_tone.darkness : o->tone.darkness;
    double want = plb_tone_within_reach(darkness, o);
    int k = 1;
    while (k < TONE_STEPS - 1 && scale[k] < want)
        k++;
    double step = scale[k] - scale[k - 1], part = step > 0 ? (want - scale[k - 1]) / step : 1;
    technique q = plb_technique((k - 1 + part) / (TONE_STEPS - 1), is_soft ? o->soft_width : o->shade_width);
    q.is_soft = is_soft;
    if (want < scale[0]) /* fainter than the faintest: farther apart */
        q.spacing[0] *= scale[0] / want;
    return q;
}

technique plb_single_layer(technique q, double width, double coarser)
{
    q.spacing[0] = fmax(q.spacing[0], SINGLE_CLOSEST * width) * coarser;
    for (int k = 1; k < HATCH_LAYERS; k++)
        q.spacing[k] = 0;
    return q;
}

double plb_paint_darkness(const paint *p, bool colour)
{
    double darkness = colour ? p->alpha : 1 - plb_paint_lightness(*p);
    return darkness < 0 ? 0 : darkness > 1 ? 1 : darkness;
}

tone_source plb_tone_source(const display_list *list, const item *fill, const plan_options *o, const tone_curve *curve, bool colour)
{
    return (tone_source){.paint = &fill->paint, .gradient = plb_item_gradient(list, fill), .curve = curve, .colour = colour, .options = o};
}

double plb_darkness_at(const tone_source *t, point at)
{
    if (t->field)
        return plb_tone_curve_at(t->curve, plb_field_at(t->field, at));
    paint there = t->gradient ? plb_gradient_at(t->gradient, at) : *t->paint;
    return plb_tone_curve_at(t->curve, plb_paint_darkness(&there, t->colour));
}

double plb_darkest(const tone_source *t)
{
    const gradient *g = t->gradient;
    double most = g ? 0 : plb_paint_darkness(t->paint, t->colour);
    for (unsigned i = 0; g && i < g->n; i++) {
        const gradient_stop *s = &g->stops[i];
        paint there = {PAINT_SOLID, (double)s->red, (double)s->green, (double)s->blue, (double)s->alpha * g->opacity};
        most = fmax(most, plb_paint_darkness(&there, t->colour));
    }
    return plb_tone_curve_at(t->curve, most);
}
