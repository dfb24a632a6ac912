/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 1, Plamondon's kinematic theory (1995; thesis section 2.2.2): the speed of a movement is the difference of
 * the answers of two muscle systems, the one that drives and the one that brakes, each a lognormal in time:
 *
 *     v(t) = D1 L(t; t0, mu1, sigma1) - D2 L(t; t0, mu2, sigma2),     D1 - D2 the length
 *
 * and its direction turns in proportion to the way, theta(t) = theta0 + C0 (way at t): an arc of a circle.
 * Input: the address of a line's random numbers. Output: the share of the way at a share of the time; the bow of the arc.
 *
 * The theory gives no values for drawing; those here were chosen so that the movement lasts half a second, never turns
 * back, and is fastest at two fifths of its time. sigma1 and D2 differ from line to line.
 */
#include "base/number/normal.h"
#include "base/number/random.h"
#include "stroke/arm/arm.h"

#include <math.h>

#define MU_1 (-1.6) /* log of seconds; t0 = 0 */
#define MU_2 (-1.4)
#define SIGMA_1 0.28
#define SIGMA_1_SPREAD 0.04
#define SIGMA_2 0.17
#define BRAKE 0.12 /* D2, share of the length */
#define BRAKE_SPREAD 0.05
#define SECONDS 0.5

/* Gives the way that one system alone has done: the lognormal's share. */
static double share(double t, double mu, double sigma)
{
    return t > 0 ? plb_normal_share((log(t) - mu) / sigma) : 0;
}

static double lognormal_progress(uint64_t key, double tau)
{
    double sigma = SIGMA_1 + SIGMA_1_SPREAD * (2 * random_unit(key, 0) - 1);
    double d2 = BRAKE + BRAKE_SPREAD * (2 * random_unit(key, 1) - 1), d1 = 1 + d2, t = tau * SECONDS;
    double all = d1 * share(SECONDS, MU_1, sigma) - d2 * share(SECONDS, MU_2, SIGMA_2);
    return (d1 * share(t, MU_1, sigma) - d2 * share(t, MU_2, SIGMA_2)) / all;
}

double plb_lognormal_bow(uint64_t key)
{
    return 2 * random_unit(key, 2) - 1;
}

/* The arc comes on top of the papers' deviations: as high as these are large. */
static void deviate_on_arc(const movement *m, control *c, size_t n)
{
    plb_deviate_freely(m, c, n);
    plb_add_bow(c, n, m->squiggle * plb_lognormal_bow(m->key));
}

const arm_model plb_arm_lognormal = {
    .name = "lognormal",
    .about = "Plamondon's kinematic theory: delta-lognormal speed, arcs",
    .squiggle_px = 5, /* as jerk */
    .progress = lognormal_progress,
    .deviate = deviate_on_arc,
};
