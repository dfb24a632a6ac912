/* SPDX-License-Identifier: MIT
 *
 * The papers' arm: the movement of least jerk, with a random deviation at each control point (001 section 3.1).
 */
#include "stroke/arm/arm.h"

const arm_model plb_arm_jerk = {
    .name = "jerk",
    .about = "least jerk with random deviation, as in the papers",
    .squiggle_px = 5, /* 001 section 3.1: D in [-5, +5] px */
    .progress = plb_minimum_jerk,
    .deviate = plb_deviate_freely,
};
