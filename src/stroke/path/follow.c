/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 2: a curve followed exactly, the deviation riding on its normal. So the free hand's deviation is laid on
 * the papers' model, and so a hand that does not stray draws any curve.
 */
#include "stroke/path/trace.h"

#include <math.h>

#define CURVE_STEP_MM 0.25
#define MIN_CURVE_STEPS 16

bool plb_trace_exactly(base_line *b, double length, const hand *h, path_samples *out)
{
    double n = fmax(ceil(length / CURVE_STEP_MM), MIN_CURVE_STEPS);
    if (!array_reserve(out, (size_t)n + 1))
        return false;
    for (size_t i = 0; i <= (size_t)n; i++) {
        double along = length * (double)i / n;
        out->v[out->n++].at = plb_base_place(b, along, plb_hand_off(h, along));
    }
    plb_path_measure(out, b->closed);
    return true;
}
