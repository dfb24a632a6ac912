/* SPDX-License-Identifier: MIT
 *
 * Stroke, stages 1 and 2: from the line that is meant to the path that is drawn.
 * Input: a stroke's base line, a polyline in mm. Output: samples of the path, and how the hand goes along it.
 */
#include "stroke/arm/trajectory.h"

#include <math.h>

/* A stroke longer than this is not a drawing's: half a kilometre of pencil. */
#define LONGEST_MM 5e5

static point way_of(const base_line *b)
{
    return point_sub(b->v[b->n - 1], b->v[0]);
}

/* The modes, and in the graphite model what depends on direction and ends: the HLA knows neither. */
static hand hand_of(const base_line *b, const stroke *s, double length, const stroke_options *o)
{
    hand h = plb_hand(length, s->closed, s->identity, o);
    if (o->model != MODEL_GRAPHITE)
        return h;
    if (b->n > 2)
        plb_hand_reach(&h, plb_base_extent(b));
    if (s->closed)
        return h;
    bool backward = plb_hand_backward(way_of(b), o->handed);
    plb_hand_direct(&h, way_of(b), backward ? !s->corner_first : !s->corner_last, o);
    if (s->room > 0)
        plb_hand_keep(&h, (double)s->room * fmax(h.strength, 1));
    plb_hand_hooks(&h, !s->corner_first, !s->corner_last, s->identity, o);
    return h;
}

/* The path of a free hand. */
static bool sample_hand(base_line *b, const stroke *s, double length, const stroke_options *o, path_samples *out)
{
    hand h = hand_of(b, s, length, o);
    if (o->model == MODEL_GRAPHITE && !s->closed) {
        float *begin = &out->pressure_first, *end = &out->pressure_last;
        plb_hand_pressure(way_of(b), length, o, h.backward ? end : begin, h.backward ? begin : end);
    }
    if (b->n == 2)
        return plb_trace_line(b, length, &h, out);
    bool remembers = o->model == MODEL_GRAPHITE && h.strength > 0;
    return remembers ? plb_trace_curve(b, length, &h, s->identity, o, out) : plb_trace_ride(b, length, &h, out);
}

bool plb_path_sample(const stroke_list *list, const stroke *s, const stroke_options *o, path_samples *out, error *err)
{
    base_line b = plb_base_line(list, s);
    double length = plb_base_length(&b);
    if (!(length <= LONGEST_MM))
        return plb_fail(err, ERROR_LIMIT, "a stroke is longer than %g m", LONGEST_MM / 1000);
    out->n = 0;
    out->closed = s->closed;
    out->backward = plb_hand_backward(way_of(&b), o->handed);
    out->pressure_first = out->pressure_last = 1;
    bool ok = o->arm == ARM_HAND ? sample_hand(&b, s, length, o, out) : plb_path_spline(&b, s, length, o, out);
    return ok || plb_fail_memory(err);
}

size_t plb_path_control_points(const stroke_list *list, const stroke *s, const stroke_options *o, point out[CONTROLS_MAX])
{
    base_line b = plb_base_line(list, s);
    control c[CONTROLS_MAX];
    double length = plb_base_length(&b);
    size_t n = plb_path_spline_controls(length, way_of(&b), s, o, c);
    hand h = hand_of(&b, s, length, o);
    for (size_t k = 0; k < n; k++)
        out[k] = plb_base_place(&b, c[k].along, o->arm == ARM_HAND ? plb_hand_off(&h, c[k].along) : c[k].off);
    return n;
}
