/* SPDX-License-Identifier: MIT
 *
 * The table of arms: see arm.h.
 */
#include "stroke/arm/arm.h"

static const arm_model *const arms[] = {&plb_arm_hand, &plb_arm_jerk, &plb_arm_spring, &plb_arm_lognormal, &plb_arm_torque};

const arm_model *plb_arm_at(size_t i)
{
    return i < sizeof arms / sizeof *arms ? arms[i] : NULL;
}
