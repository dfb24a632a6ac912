/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 1: where the arm passes (001 section 3.1; thesis section 3.2).
 * Input: the length of the line, mm, and the address of its random numbers. Output: control points in the line's own
 * frame, mm.
 *
 * Flash & Hogan's minimum-jerk movement between two points (001 equation 1) runs
 *
 *     x(t) = x0 + (x0 - xf) (15 tau^4 - 6 tau^5 - 10 tau^3),   tau = t / tf,   t in [0, 2]
 *
 * and is sampled at steps of dt that grow shorter as the line grows longer (001 table 1). The last control point is
 * at tf whatever dt is. The inner control points are pushed off the line by D, uniform in ±5 px of 1/300 inch.
 */
#include "base/number/random.h"
#include "base/number/units.h"
#include "stroke/stroke.h"

#include <math.h>

/* 001 section 3.1: "t_final = 2 provides satisfactory results, regardless of line length". */
#define T_FINAL 2.0

/* 001 table 1; the third row's value is printed in the thesis' table 3.1 only. Lengths in px of 1/300 inch. */
static const struct {
    double up_to_px, time_step;
} time_steps[] = {{200, 0.5}, {400, 0.3}, {INFINITY, 0.2}};

/* 001 section 3.1: D in [-5, +5] px. 002 section 3.1: [-3, +3] px, with a restoring force k1 = 0.1. */
#define SQUIGGLE_JERK_PX 5.0
#define SQUIGGLE_SPRING_PX 3.0
#define SPRING_K1 0.1

/* Below this length D shrinks in proportion. The papers are silent; at full size it would tear small shapes apart.
 * Chosen by eye: 100 px, half of the first row of table 1, so that D is at most 5 % of the length. */
#define FULL_SQUIGGLE_PX 100.0

/* Nor is D more than this share of the way to the nearer end. On long lines equation 1 puts the first control point
 * within 1 % of the length of the end; 5 px there would be a hook at every end. Chosen by eye; of real ends one in five
 * hooks, by 1 to 2 px. */
#define STEEPEST 0.2

static double time_step_of(double length)
{
    double px = length / MM_PER_PAPER_PX;
    size_t i = 0;
    while (px > time_steps[i].up_to_px)
        i++;
    return time_steps[i].time_step;
}

/* The share of the way done at tau: 10 tau^3 - 15 tau^4 + 6 tau^5. */
static double minimum_jerk(double tau)
{
    return tau * tau * tau * (10 + tau * (6 * tau - 15));
}

double plb_path_squiggle(double length, const stroke_options *o)
{
    double own = (o->arm == ARM_SPRING ? SQUIGGLE_SPRING_PX : SQUIGGLE_JERK_PX) * MM_PER_PAPER_PX;
    double d = o->squiggle < 0 ? own : o->squiggle;
    double full = FULL_SQUIGGLE_PX * MM_PER_PAPER_PX;
    return length < full ? d * length / full : d;
}

/* The largest deviation at the control point `k` of n: d, less near the ends. */
static double limit_at(const control *c, size_t k, size_t n, double d)
{
    double way = c[k].along < c[n - 1].along - c[k].along ? c[k].along : c[n - 1].along - c[k].along;
    return d < STEEPEST * way ? d : STEEPEST * way;
}

/* 001: independent deviations. */
static void deviate_freely(control *c, size_t n, double d, uint64_t key)
{
    for (size_t k = 1; k + 1 < n; k++)
        c[k].off = limit_at(c, k, n, d) * (2 * random_unit(key, k) - 1);
}

/* 002 equations 2 and 3: a deviational force D, renewed at each step, against a spring that pulls back towards the
 * control point before: F = D - k1 R, R the way from the one to the other, with unit mass and time step. */
static void deviate_on_spring(control *c, size_t n, double d, uint64_t key)
{
    for (size_t k = 1; k + 1 < n; k++) {
        double force = limit_at(c, k, n, d) * (2 * random_unit(key, k) - 1);
        double way = force - c[k - 1].off;
        c[k].off = force - SPRING_K1 * way;
    }
}

/* A bow of the whole movement: a parabola, which is an arc of a circle nearly. */
static void add_bow(control *c, size_t n, double bow)
{
    for (size_t k = 1; k + 1 < n; k++) {
        double u = c[k].along / c[n - 1].along;
        c[k].off += bow * 4 * u * (1 - u);
    }
}

double plb_arm_progress(uint64_t identity, const stroke_options *o, double tau)
{
    return o->arm == ARM_LOGNORMAL ? plb_lognormal_progress(random_key(o->seed, identity, PURPOSE_ARM), tau) : minimum_jerk(tau);
}

size_t plb_path_controls(double length, point way, uint64_t identity, const stroke_options *o, control out[CONTROLS_MAX])
{
    double dt = time_step_of(length);
    size_t steps = (size_t)ceil(T_FINAL / dt - 1e-9), n = steps + 1;
    for (size_t k = 0; k < n; k++) {
        double t = k == steps ? T_FINAL : dt * (double)k;
        out[k] = (control){length * plb_arm_progress(identity, o, t / T_FINAL), 0};
    }
    uint64_t key = random_key(o->seed, identity, PURPOSE_SQUIGGLE);
    double d = plb_path_squiggle(length, o), own = SQUIGGLE_JERK_PX * MM_PER_PAPER_PX;
    if (o->arm == ARM_SPRING)
        deviate_on_spring(out, n, d, key);
    else
        deviate_freely(out, n, d, key);
    if (o->arm == ARM_LOGNORMAL)
        add_bow(out, n, d * plb_lognormal_bow(random_key(o->seed, identity, PURPOSE_ARM)));
    if (o->arm == ARM_TORQUE)
        add_bow(out, n, (o->squiggle < 0 ? 1 : o->squiggle / own) * plb_torque_bow(way, o->handed));
    return n;
}
