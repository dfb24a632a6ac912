/* SPDX-License-Identifier: MIT
 *
 * Stroke, stages 1 and 2: from the line that is meant to the path that is drawn.
 * Input: a stroke's base line, a polyline in mm. Output: samples of the path, and how the hand goes along it.
 */
#include "stroke/arm/hand.h"
#include "stroke/path/spline.h"
#include "stroke/stroke.h"

/* A stroke longer than this is not a drawing's: half a kilometre of pencil. */
#define MAX_STROKE_MM 5e5

bool plb_path_sample(const stroke_list *list, const stroke *s, const stroke_options *o, path_samples *out, error *err)
{
    base_line b = plb_base_line(list, s);
    const arm_model *arm = plb_arm_of(o);
    double length = plb_base_length(&b);
    if (!(length <= MAX_STROKE_MM))
        return plb_fail(err, ERROR_LIMIT, "a stroke is longer than %g m", MAX_STROKE_MM / 1000);
    out->n = 0;
    out->closed = s->closed;
    out->backward = plb_hand_backward(plb_base_way(&b), o->handed);
    out->pressure_first = out->pressure_last = 1;
    bool ok = arm->trace ? arm->trace(&b, s, length, o, out) : plb_path_spline(&b, arm, s, length, o, out);
    return ok || plb_fail_memory(err);
}

size_t plb_path_control_points(const stroke_list *list, const stroke *s, const stroke_options *o, point out[CONTROLS_MAX])
{
    base_line b = plb_base_line(list, s);
    const arm_model *arm = plb_arm_of(o);
    control c[CONTROLS_MAX];
    double length = plb_base_length(&b);
    size_t n = plb_path_spline_controls(arm, length, plb_base_way(&b), s, o, c);
    if (arm->follow)
        arm->follow(&b, s, length, o, c, n);
    for (size_t k = 0; k < n; k++)
        out[k] = plb_base_place(&b, c[k].along, c[k].off);
    return n;
}
