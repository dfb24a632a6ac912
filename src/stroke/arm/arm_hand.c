/* SPDX-License-Identifier: MIT
 *
 * A free hand as measured: deviations in waves over the whole line instead of at control points, hooks at free ends, and a
 * memory of curves.
 */
#include "base/number/random.h"
#include "base/number/units.h"
#include "stroke/path/trace.h"
#include "stroke/texture/models.h"

#include <math.h>

/* Gives the hand of a stroke: the modes and, if the model is measured, all that depends on direction and ends. The papers know neither. */
static hand hand_of(const base_line *b, const stroke *s, double length, const stroke_options *o, bool measured)
{
    hand h = plb_hand(length, s->closed, measured && s->style.company ? s->style.company : s->identity, o);
    if (!measured)
        return h;
    if (b->n > 2)
        plb_hand_reach(&h, plb_base_extent(b));
    double radius = s->closed ? plb_base_radius(b) : 0;
    if (radius > 0)
        plb_hand_egg(&h, radius, random_key(o->seed, s->style.company ? s->style.company : s->identity, PURPOSE_HAND));
    bool backward = plb_hand_backward(plb_base_way(b), o->handed);
    if (!s->closed)
        plb_hand_direct(&h, plb_base_way(b), backward ? !s->corner_first : !s->corner_last, o);
    if (s->max_deviation > 0)
        plb_hand_keep(&h, (double)s->max_deviation * fmax(h.strength, 1));
    if (!s->closed)
        plb_hand_hooks(&h, !s->corner_first, !s->corner_last, s->identity, o);
    return h;
}

static bool is_measured(const stroke_options *o)
{
    return o->model && o->model->is_measured;
}

static bool trace(base_line *b, const stroke *s, double length, const stroke_options *o, path_samples *out)
{
    bool measured = is_measured(o);
    hand h = hand_of(b, s, length, o, measured);
    if (measured && !s->closed) {
        float *begin = &out->pressure_first, *end = &out->pressure_last;
        plb_hand_pressure(plb_base_way(b), length, o, h.backward ? end : begin, h.backward ? begin : end);
    }
    if (b->n == 2)
        return plb_trace_line(b, length, &h, out);
    bool remembers = measured && h.strength > 0;
    return remembers ? plb_trace_curve(b, length, &h, s->identity, o, out) : plb_trace_exactly(b, length, &h, out);
}

static void follow(const base_line *b, const stroke *s, double length, const stroke_options *o, control *c, size_t n)
{
    hand h = hand_of(b, s, length, o, is_measured(o));
    for (size_t k = 0; k < n; k++)
        c[k].off = plb_hand_off(&h, c[k].along);
}

const arm_model plb_arm_hand = {
    .name = "hand",
    .about = "a free hand as measured",
    .squiggle_px = 5, /* which stands for the hand as measured: hand_modes.c */
    .progress = plb_minimum_jerk,
    .deviate = plb_deviate_freely,
    .trace = trace,
    .follow = follow,
};
