/* SPDX-License-Identifier: MIT
 *
 * The arm of the authors' earlier manuscript: the movement of least jerk, whose deviations a spring holds back (002 section
 * 3.1).
 */
#include "base/number/random.h"
#include "stroke/arm/arm.h"

/* 002 section 3.1: the restoring force. */
#define SPRING_K1 0.1

/* 002 equations 2 and 3: a deviational force D, renewed at each step, against a spring that pulls back towards the
 * control point before: F = D - k1 R, R the way from the one to the other, with unit mass and time step. */
static void deviate_on_spring(const movement *m, control *c, size_t n)
{
    for (size_t k = 1; k + 1 < n; k++) {
        double force = plb_deviation_limit(m, c, k, n) * (2 * random_unit(m->squiggle_key, k) - 1);
        double way = force - c[k - 1].off;
        c[k].off = force - SPRING_K1 * way;
    }
}

const arm_model plb_arm_spring = {
    .name = "spring",
    .about = "the force model of the papers' manuscript",
    .squiggle_px = 3, /* 002 section 3.1: D in [-3, +3] px */
    .progress = plb_minimum_jerk,
    .deviate = deviate_on_spring,
};
