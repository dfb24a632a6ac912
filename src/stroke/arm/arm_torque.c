/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 1, the movement of least change of torque (Uno, Kawato and Suzuki 1989; thesis section 2.2.1): of all
 * movements of an arm of two links from one point to another, that with the least integral of (d tau1/dt)^2 + (d tau2/dt)^2.
 * Input: the way from the first point to the last, mm on the page (y down). Output: how far the path bows out, mm.
 *
 * No formula is known for it, and to find one movement takes an optimisation. But over the size of a drawing it is nearly
 * quadratic: to second order in the way w the path leaves the chord by a parabola, whose height is a quadratic form in w for
 * each side, and so, across the chord, |w|^2 times a cubic form in the direction. A cubic form of a direction has the
 * harmonics 1 and 3, and of such forms only odd harmonics keep the side when the ends are exchanged, as they must:
 *
 *     height = |w|^2 (A1 cos a + B1 sin a + A3 cos 3a + B3 sin 3a),    a the direction, counted from right to away
 *
 * The four factors were fitted to the optimised movements of the arm with the segments of the paper (its table 1: lengths
 * .25 and .35 m, masses .9 and 1.1 kg, centres of mass at .11 and .15 m, inertias .065 and .1 kg m^2, viscosities .08
 * kg m^2/s), of 10 cm in half a second about a point .15 m to the left of the right shoulder and .35 m before it, where a sheet
 * lies. For movements of 5 to 20 cm what is left is below a tenth of the largest bow; test_arms.c repeats the optimisation
 * and compares. Along the way the movement is, to the same order, that of least jerk.
 */
#include "base/number/units.h"
#include "stroke/arm/arm.h"

#include <math.h>

/* Per mm. */
#define A1 0.918e-4
#define B1 0.723e-4
#define A3 (-1.037e-4)
#define B3 (-0.395e-4)
/* As far as the form was compared with the model; longer lines bow as these. */
#define MAX_BOWED_MM 200.0

double plb_torque_bow(point way, handedness handed)
{
    double mirror = handed == HANDED_LEFT ? -1 : 1, length = plb_point_length(way), reach = fmin(length, MAX_BOWED_MM);
    if (length == 0)
        return 0;
    double c = mirror * way.x / length, s = -way.y / length;
    double form = A1 * c + B1 * s + A3 * (4 * c * c * c - 3 * c) + B3 * (3 * s - 4 * s * s * s);
    return mirror * reach * reach * form;
}

/* The largest deviation D that leaves the bow as high as the model's: a larger or smaller one makes the bow so many times as high. */
#define SQUIGGLE_PX 5 /* as jerk */

static void deviate_by_torque(const movement *m, control *c, size_t n)
{
    const stroke_options *o = m->options;
    double share = o->squiggle < 0 ? 1 : o->squiggle / (SQUIGGLE_PX * MM_PER_PAPER_PX);
    plb_deviate_freely(m, c, n);
    plb_add_bow(c, n, share * plb_torque_bow(m->way, o->handed));
}

const arm_model plb_arm_torque = {
    .name = "torque",
    .about = "least change of torque of an arm of two links",
    .squiggle_px = SQUIGGLE_PX,
    .progress = plb_minimum_jerk,
    .deviate = deviate_by_torque,
};
