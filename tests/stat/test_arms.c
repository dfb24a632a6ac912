/* SPDX-License-Identifier: MIT
 *
 * The arms: the speed of each model, and the bow of least torque change against an optimisation of the arm itself.
 */
#include "check.h"

#include "base/number/units.h"
#include "stroke/stroke.h"

/* ---- speed ---- */

enum { STEPS = 400 };

/* Speed at the middles of even time steps, in lengths a duration; returns where it is largest, as a share of the time. */
static double speed_of(const arm_model *arm, uint64_t identity, double v[STEPS])
{
    stroke_options o = {.seed = 1, .arm = arm};
    int peak = 0;
    for (int i = 0; i < STEPS; i++) {
        v[i] = STEPS * (plb_arm_progress(arm, identity, &o, (i + 1.0) / STEPS) - plb_arm_progress(arm, identity, &o, (double)i / STEPS));
        if (v[i] > v[peak])
            peak = i;
    }
    return (peak + 0.5) / STEPS;
}

/* One hill: up to its peak, down after it, from rest to rest, never back. */
static void check_bell(const double v[STEPS], double peak)
{
    CHECK(v[0] >= 0 && v[0] < 0.05 && v[STEPS - 1] >= 0 && v[STEPS - 1] < 0.15);
    for (int i = 1; i < STEPS; i++)
        CHECK((i + 0.5) / STEPS <= peak ? v[i] >= v[i - 1] - 1e-9 : v[i] <= v[i - 1] + 1e-9);
}

static void least_jerk_is_a_symmetric_bell(void)
{
    double v[STEPS], peak = speed_of(&plb_arm_jerk, 1, v), largest = v[STEPS / 2];
    check_bell(v, peak);
    CHECK_RANGE(peak, 0.495, 0.505);
    CHECK_RANGE(largest, 1.873, 1.876); /* thesis equation 3.2: C = 1.875 */
    for (int i = 0; i < STEPS; i++)
        CHECK(fabs(v[i] - v[STEPS - 1 - i]) < 1e-9);
}

static void lognormal_speed_is_a_skewed_bell(void)
{
    for (uint64_t identity = 1; identity <= 200; identity++) {
        double v[STEPS], peak = speed_of(&plb_arm_lognormal, identity, v), sum = 0;
        check_bell(v, peak);
        CHECK_RANGE(peak, 0.3, 0.42); /* early: a quick start, a long approach */
        for (int i = 0; i < STEPS; i++)
            sum += v[i] / STEPS;
        CHECK(fabs(sum - 1) < 1e-9); /* it arrives */
    }
    double a[STEPS], b[STEPS];
    speed_of(&plb_arm_lognormal, 1, a);
    speed_of(&plb_arm_lognormal, 2, b);
    CHECK(fabs(a[100] - b[100]) > 1e-3); /* no two lines alike */
}

static void control_points_follow_the_speed(void)
{
    stroke_options o = {.seed = 1, .arm = &plb_arm_lognormal, .squiggle = 0};
    control c[CONTROLS_MAX];
    size_t n = plb_movement_controls(o.arm, 80, (point){80, 0}, 7, &o, c);
    CHECK(n == 11);
    for (size_t k = 0; k < n; k++)
        CHECK(fabs(c[k].along - 80 * plb_arm_progress(o.arm, 7, &o, (double)k / 10)) < 1e-9 && c[k].off == 0);
    CHECK(c[5].along > 50); /* more than half way at half time */
}

/* ---- torque: the movement itself, found by optimisation ---- */

/* The arm of Uno, Kawato and Suzuki 1989, table 1, SI units; [0] the upper arm, [1] the forearm. */
static const double link_length[2] = {.25, .35}, centre_1 = .15, mass_1 = 1.1, inertia[2] = {.065, .100}, viscosity = .08;
#define SECONDS 0.5
enum { TIMES = 60, SHAPES = 4, UNKNOWNS = 2 * SHAPES };

typedef struct {
    double q[2];
} joints;

static joints joints_at(double x, double y)
{
    const double *l = link_length;
    double elbow = acos((x * x + y * y - l[0] * l[0] - l[1] * l[1]) / (2 * l[0] * l[1]));
    return (joints){{atan2(y, x) - atan2(l[1] * sin(elbow), l[0] + l[1] * cos(elbow)), elbow}};
}

/* Shape j: t^3 (1 - t)^3 times a power of (2 t - 1): at rest at both ends; its derivatives by t, numerically. */
static double shape(int j, double t)
{
    return t * t * t * (1 - t) * (1 - t) * (1 - t) * pow(2 * t - 1, j);
}

static double least_jerk(double t)
{
    return t * t * t * (10 - 15 * t + 6 * t * t);
}

/* Returns the angle of joint k at t. */
static double angle(const joints *from, const joints *to, const double c[UNKNOWNS], int k, double t)
{
    double q = from->q[k] + (to->q[k] - from->q[k]) * least_jerk(t);
    for (int j = 0; j < SHAPES; j++)
        q += c[2 * j + k] * shape(j, t);
    return q;
}

static void torque_at(const joints *from, const joints *to, const double c[UNKNOWNS], double t, double out[2])
{
    double q[2], v[2], a[2], h = 1e-3;
    for (int k = 0; k < 2; k++) {
        double before = angle(from, to, c, k, t - h), after = angle(from, to, c, k, t + h);
        q[k] = angle(from, to, c, k, t);
        v[k] = (after - before) / (2 * h) / SECONDS;
        a[k] = (after - 2 * q[k] + before) / (h * h) / (SECONDS * SECONDS);
    }
    double m = mass_1 * link_length[0] * centre_1, co = cos(q[1]), si = sin(q[1]);
    out[0] = (inertia[0] + inertia[1] + 2 * m * co + mass_1 * link_length[0] * link_length[0]) * a[0] + (inertia[1] + m * co) * a[1] -
             m * si * (2 * v[0] + v[1]) * v[1] + viscosity * v[0];
    out[1] = (inertia[1] + m * co) * a[0] + inertia[1] * a[1] + m * si * v[0] * v[0] + viscosity * v[1];
}

/* The changes of both torques from time step to time step: what is to be least in the sum of squares. */
static void changes(const joints *from, const joints *to, const double c[UNKNOWNS], double r[2 * TIMES])
{
    double before[2];
    torque_at(from, to, c, 0.002, before);
    for (int i = 0; i < TIMES; i++) {
        double now[2];
        torque_at(from, to, c, 0.002 + 0.996 * (i + 1) / TIMES, now);
        for (int k = 0; k < 2; k++) {
            r[2 * i + k] = now[k] - before[k];
            before[k] = now[k];
        }
    }
}

static void solve(double m[UNKNOWNS][UNKNOWNS + 1])
{
    for (int i = 0; i < UNKNOWNS; i++) {
        for (int k = 0; k < UNKNOWNS; k++) {
            double f = m[k][i] / m[i][i];
            for (int j = i; k != i && j <= UNKNOWNS; j++)
                m[k][j] -= f * m[i][j];
        }
    }
}

/* Gauss and Newton's steps from the movement that is straight in joint space. */
static void optimise(const joints *from, const joints *to, double c[UNKNOWNS])
{
    static double r[2 * TIMES], moved[UNKNOWNS][2 * TIMES];
    memset(c, 0, UNKNOWNS * sizeof *c);
    for (int step = 0; step < 5; step++) {
        double m[UNKNOWNS][UNKNOWNS + 1] = {{0}};
        changes(from, to, c, r);
        for (int j = 0; j < UNKNOWNS; j++) {
            double kept = c[j];
            c[j] += 1e-3;
            changes(from, to, c, moved[j]);
            c[j] = kept;
        }
        for (int i = 0; i < 2 * TIMES; i++)
            for (int j = 0; j < UNKNOWNS; j++) {
                double dj = (moved[j][i] - r[i]) / 1e-3;
                for (int k = 0; k < UNKNOWNS; k++)
                    m[j][k] += dj * (moved[k][i] - r[i]) / 1e-3;
                m[j][UNKNOWNS] -= dj * r[i];
            }
        solve(m);
        for (int j = 0; j < UNKNOWNS; j++)
            c[j] += m[j][UNKNOWNS] / m[j][j];
    }
}

/* The bow of the optimal movement along `way` (mm on the page), about the place where the sheet lies: mm to the left. */
static double optimal_bow(point way)
{
    double dx = way.x / 2000, dy = -way.y / 2000, x = -.15, y = .35, c[UNKNOWNS], sum = 0, squares = 0;
    joints from = joints_at(x - dx, y - dy), to = joints_at(x + dx, y + dy);
    optimise(&from, &to, c);
    double l = 2 * sqrt(dx * dx + dy * dy);
    for (int i = 1; i < 100; i++) { /* the parabola that fits best */
        double q0 = angle(&from, &to, c, 0, i / 100.0), q1 = q0 + angle(&from, &to, c, 1, i / 100.0);
        double px = link_length[0] * cos(q0) + link_length[1] * cos(q1) - (x - dx);
        double py = link_length[0] * sin(q0) + link_length[1] * sin(q1) - (y - dy);
        double u = (px * dx + py * dy) * 2 / (l * l), off = (py * dx - px * dy) * 2 / l, f = 4 * u * (1 - u);
        sum += off * f;
        squares += f * f;
    }
    return 1000 * sum / squares;
}

static void torque_bows_as_the_optimal_movement_does(void)
{
    static const double lengths[] = {50, 100, 200};
    for (int i = 0; i < 3; i++) {
        double l = lengths[i], largest = 0.21e-3 * l * l;
        for (int k = 0; k < 12; k++) {
            double a = 2 * PLB_PI * k / 12 + 0.1;
            point way = {l * cos(a), -l * sin(a)};
            CHECK_RANGE((plb_torque_bow(way, HANDED_RIGHT) - optimal_bow(way)) / largest, -0.1, 0.1);
        }
    }
}

/* Gently curved, by the direction; the same line whichever end is the first; a left arm is a mirror. */
static void torque_bows_gently(void)
{
    double least = 1e9, most = 0;
    for (int k = 0; k < 36; k++) {
        double a = 2 * PLB_PI * k / 36;
        point way = {100 * cos(a), 100 * sin(a)};
        double bow = plb_torque_bow(way, HANDED_RIGHT);
        least = fmin(least, fabs(bow));
        most = fmax(most, fabs(bow));
        CHECK(fabs(plb_torque_bow(point_scale(way, -1), HANDED_RIGHT) + bow) < 1e-12);
        CHECK(fabs(plb_torque_bow((point){-way.x, way.y}, HANDED_LEFT) + bow) < 1e-12);
        CHECK(fabs(plb_torque_bow(point_scale(way, 0.5), HANDED_RIGHT) - bow / 4) < 1e-12);
    }
    CHECK_RANGE(most, 1, 3); /* up to 1 to 3 % of 10 cm */
    CHECK_RANGE(least, 0, 0.3);
    stroke_options o = {.seed = 1, .arm = &plb_arm_torque, .squiggle = 0};
    control c[CONTROLS_MAX];
    size_t n = plb_movement_controls(o.arm, 100, (point){60, 80}, 7, &o, c);
    for (size_t k = 0; k < n; k++)
        CHECK(c[k].off == 0); /* --squiggle 0 is a ruler for every arm */
}

int main(void)
{
    RUN(least_jerk_is_a_symmetric_bell);
    RUN(lognormal_speed_is_a_skewed_bell);
    RUN(control_points_follow_the_speed);
    RUN(torque_bows_as_the_optimal_movement_does);
    RUN(torque_bows_gently);
    CHECK_EXIT;
}
