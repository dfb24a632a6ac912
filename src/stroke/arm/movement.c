/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 1: where the arm passes (001 section 3.1; thesis section 3.2), as far as all arms share the movement.
 * Input: the length of the line, mm, and the address of its random numbers. Output: control points in the line's own
 * frame, mm.
 *
 * Flash & Hogan's minimum-jerk movement between two points (001 equation 1) runs
 *
 *     x(t) = x0 + (x0 - xf) (15 tau^4 - 6 tau^5 - 10 tau^3),   tau = t / tf,   t in [0, 2]
 *
 * and is sampled at steps of dt that grow shorter as the line grows longer (001 table 1). The last control point is
 * at tf whatever dt is. The inner control points are pushed off the line by at most D. An arm may have another course of
 * time than equation 1, and another way to push.
 */
#include "base/number/random.h"
#include "base/number/units.h"
#include "stroke/arm/arm.h"

#include <math.h>

/* 001 section 3.1: "t_final = 2 provides satisfactory results, regardless of line length". */
#define T_FINAL 2.0

/* 001 table 1; the third row's value is printed in the thesis' table 3.1 only. Lengths in px of 1/300 inch. */
static const struct {
    double up_to_px, time_step;
} time_steps[] = {{200, 0.5}, {400, 0.3}, {INFINITY, 0.2}};

/* Below this length D shrinks in proportion. The papers are silent; at full size it would tear small shapes apart.
 * Chosen by eye: 100 px, half of the first row of table 1, so that D is at most 5 % of the length. */
#define FULL_SQUIGGLE_PX 100.0

/* Nor is D more than this share of the way to the nearer end. On long lines equation 1 puts the first control point
 * within 1 % of the length of the end; 5 px there would be a hook at every end. Chosen by eye; of real ends one in five
 * hooks, by 1 to 2 px. */
#define MAX_DEVIATION_OF_WAY 0.2

static double time_step_of(double length)
{
    double px = length / MM_PER_PAPER_PX;
    size_t i = 0;
    while (px > time_steps[i].up_to_px)
        i++;
    return time_steps[i].time_step;
}

/* 10 tau^3 - 15 tau^4 + 6 tau^5. */
double plb_minimum_jerk(uint64_t key, double tau)
{
    (void)key;
    return tau * tau * tau * (10 + tau * (6 * tau - 15));
}

double plb_arm_squiggle(const arm_model *arm, double length, const stroke_options *o)
{
    double d = o->squiggle < 0 ? arm->squiggle_px * MM_PER_PAPER_PX : o->squiggle;
    double full = FULL_SQUIGGLE_PX * MM_PER_PAPER_PX;
    return length < full ? d * length / full : d;
}

double plb_deviation_limit(const movement *m, const control *c, size_t k, size_t n)
{
    double way = c[k].along < c[n - 1].along - c[k].along ? c[k].along : c[n - 1].along - c[k].along;
    return m->squiggle < MAX_DEVIATION_OF_WAY * way ? m->squiggle : MAX_DEVIATION_OF_WAY * way;
}

void plb_deviate_freely(const movement *m, control *c, size_t n)
{
    for (size_t k = 1; k + 1 < n; k++)
        c[k].off = plb_deviation_limit(m, c, k, n) * (2 * random_unit(m->squiggle_key, k) - 1);
}

void plb_add_bow(control *c, size_t n, double bow)
{
    for (size_t k = 1; k + 1 < n; k++) {
        double u = c[k].along / c[n - 1].along;
        c[k].off += bow * 4 * u * (1 - u);
    }
}

double plb_arm_progress(const arm_model *arm, uint64_t identity, const stroke_options *o, double tau)
{
    return arm->progress(random_key(o->seed, identity, PURPOSE_ARM), tau);
}

size_t plb_movement_controls(const arm_model *arm, double length, point way, uint64_t identity, const stroke_options *o, control out[CONTROLS_MAX])
{
    movement m = {.length = length, .way = way, .squiggle = plb_arm_squiggle(arm, length, o), .options = o};
    m.key = random_key(o->seed, identity, PURPOSE_ARM);
    m.squiggle_key = random_key(o->seed, identity, PURPOSE_SQUIGGLE);
    double dt = time_step_of(length);
    size_t steps = (size_t)ceil(T_FINAL / dt - 1e-9), n = steps + 1;
    for (size_t k = 0; k < n; k++) {
        double t = k == steps ? T_FINAL : dt * (double)k;
        out[k] = (control){length * arm->progress(m.key, t / T_FINAL), 0};
    }
    arm->deviate(&m, out, n);
    return n;
}
