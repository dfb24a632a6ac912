/* SPDX-License-Identifier: MIT
 *
 * The arm's path over many seeds: control points per length class (001 table 1), their places (equation 1), the range
 * and independence of D, and that no two lines are alike.
 */
#include "check.h"

#include "base/random.h"
#include "base/units.h"
#include "stroke/stroke.h"

#define PX MM_PER_PAPER_PX

static stroke_options options_for(uint64_t seed)
{
    stroke_options o = {.seed = seed, .squiggle = -1, .dpi = 300};
    return o;
}

static void control_points_per_length_class(void)
{
    static const struct {
        double px;
        size_t n;
    } expected[] = {{10, 5}, {199, 5}, {200, 5}, {201, 8}, {400, 8}, {401, 11}, {3000, 11}};
    for (uint64_t seed = 1; seed <= 50; seed++)
        for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
            control c[CONTROLS_MAX];
            stroke_options o = options_for(seed);
            CHECK(plb_path_controls(expected[i].px * PX * (1 + 1e-12), seed * 77 + i, &o, c) == expected[i].n || expected[i].px == 200 || expected[i].px == 400);
            CHECK(plb_path_controls(expected[i].px * PX * (1 - 1e-12), seed * 77 + i, &o, c) == expected[i].n);
        }
}

/* dt 0.5: tau 0, 1/4, 1/2, 3/4, 1; equation 1 by hand. The last is at tf though 0.3 does not divide 2. */
static void control_points_lie_where_equation_1_says(void)
{
    control c[CONTROLS_MAX];
    stroke_options o = options_for(1);
    CHECK(plb_path_controls(100 * PX, 5, &o, c) == 5);
    static const double share[5] = {0, 0.103515625, 0.5, 0.896484375, 1};
    for (int k = 0; k < 5; k++)
        CHECK(fabs(c[k].along / (100 * PX) - share[k]) < 1e-12);
    size_t n = plb_path_controls(300 * PX, 5, &o, c);
    CHECK(n == 8 && fabs(c[7].along - 300 * PX) < 1e-12 && c[6].along < c[7].along);
    CHECK(c[0].off == 0 && c[7].off == 0);
}

/* The middle control point: it is far enough from both ends for D in full. */
static void squiggle_is_uniform_in_its_range(void)
{
    static const struct {
        double px, d;
    } cases[] = {{150, 5}, {350, 5}, {2000, 5}, {50, 2.5}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double sum = 0, squares = 0, largest = 0, n = 0, bins[10] = {0};
        for (uint64_t seed = 1; seed <= 12000; seed++, n++) {
            control c[CONTROLS_MAX];
            stroke_options o = options_for(seed);
            size_t k = plb_path_controls(cases[i].px * PX, 99, &o, c);
            double d = c[k / 2].off / PX;
            sum += d;
            squares += d * d;
            largest = fmax(largest, fabs(d));
            bins[(int)fmin(9, (d / cases[i].d + 1) * 5)]++;
        }
        CHECK_RANGE(sum / n, -0.05 * cases[i].d, 0.05 * cases[i].d);
        CHECK_RANGE(largest, 0.97 * cases[i].d, cases[i].d + 1e-9);
        CHECK_RANGE(sqrt(squares / n), 0.57 * cases[i].d, 0.585 * cases[i].d); /* 1/sqrt(3) */
        for (int b = 0; b < 10; b++)
            CHECK_RANGE(bins[b] * 10.0 / n, 0.9, 1.1);
    }
}

/* At every inner control point: D stays in its range, is independent of its neighbours', and makes no hook at an end. */
static void squiggle_keeps_its_limits(void)
{
    double products = 0, squares = 0;
    for (uint64_t seed = 1; seed <= 4000; seed++) {
        control c[CONTROLS_MAX];
        stroke_options o = options_for(seed);
        size_t n = plb_path_controls(1000 * PX, seed, &o, c);
        for (size_t k = 1; k + 1 < n; k++) {
            double way = fmin(c[k].along, 1000 * PX - c[k].along);
            CHECK(fabs(c[k].off) <= fmin(5 * PX, 0.2 * way) + 1e-12);
        }
        products += c[4].off * c[5].off;
        squares += c[4].off * c[4].off;
        o.arm = ARM_SPRING;
        n = plb_path_controls(1000 * PX, seed, &o, c);
        for (size_t k = 1; k + 1 < n; k++)
            CHECK(fabs(c[k].off) <= 3 * PX + 1e-12);
    }
    CHECK_RANGE(products / squares, -0.05, 0.05);
}

static void squiggle_zero_is_ruler_straight(void)
{
    point ends[2] = {{10, 20}, {70, 95}};
    stroke s = {.touch = TOUCH_USUAL, .identity = 42, .n = 2};
    stroke_list list = {.width = 100, .height = 100, .strokes = {&s, 1, 1}, .points = {ends, 2, 2}};
    stroke_options o = options_for(3);
    o.squiggle = 0;
    path_samples path = {0};
    CHECK(plb_path_sample(&list, &s, &o, &path, NULL));
    point d = point_sub(ends[1], ends[0]);
    for (size_t i = 0; i < path.n; i++)
        CHECK(fabs(point_cross(d, point_sub(path.v[i].at, ends[0]))) / plb_point_length(d) < 1e-9);
    array_free(&path);
}

static arm_model parallel_arm;

/* Deviation of a path from its chord at 64 places along it. */
static void deviations(const stroke_list *list, const stroke *s, uint64_t seed, double out[64])
{
    stroke_options o = options_for(seed);
    o.arm = parallel_arm;
    path_samples path = {0};
    CHECK(plb_path_sample(list, s, &o, &path, NULL));
    point from = list->points.v[s->first], d = point_sub(list->points.v[s->first + 1], from);
    double length = plb_point_length(d);
    size_t i = 0;
    for (int k = 0; k < 64; k++) {
        double along = (k + 0.5) / 64 * length;
        while (i + 1 < path.n && point_dot(point_sub(path.v[i].at, from), d) / length < along)
            i++;
        out[k] = point_cross(d, point_sub(path.v[i].at, from)) / length;
    }
    array_free(&path);
}

static double correlation(const double *a, const double *b, int n)
{
    double ma = 0, mb = 0, ab = 0, aa = 0, bb = 0;
    for (int i = 0; i < n; i++) {
        ma += a[i] / n;
        mb += b[i] / n;
    }
    for (int i = 0; i < n; i++) {
        ab += (a[i] - ma) * (b[i] - mb);
        aa += (a[i] - ma) * (a[i] - ma);
        bb += (b[i] - mb) * (b[i] - mb);
    }
    return ab / sqrt(aa * bb);
}

/* Equal parallel lines in one drawing: over 100 of them the mean correlation of neighbours' deviations is about 0. */
static void compare_parallel_lines(void)
{
    enum { LINES = 101 };
    point ends[2 * LINES];
    stroke strokes[LINES];
    double d[LINES][64], sum = 0;
    for (int i = 0; i < LINES; i++) {
        ends[2 * i] = (point){10, 5 + 2.0 * i};
        ends[2 * i + 1] = (point){190, 5 + 2.0 * i};
        strokes[i] = (stroke){.identity = random_mix((uint64_t)i + 1), .first = 2 * (size_t)i, .n = 2};
    }
    stroke_list list = {.strokes = {strokes, LINES, LINES}, .points = {ends, 2 * LINES, 2 * LINES}};
    for (int i = 0; i < LINES; i++)
        deviations(&list, &strokes[i], 1, d[i]);
    for (int i = 0; i + 1 < LINES; i++)
        sum += correlation(d[i], d[i + 1], 64);
    CHECK_RANGE(sum / (LINES - 1), -0.1, 0.1);
}

static void parallel_lines_differ(void)
{
    static const arm_model arms[] = {ARM_JERK, ARM_SPRING, ARM_HAND};
    for (size_t i = 0; i < 3; i++) {
        parallel_arm = arms[i];
        compare_parallel_lines();
    }
}

static void ends_stay_where_the_drawing_has_them(void)
{
    for (uint64_t seed = 1; seed <= 200; seed++) {
        point ends[2] = {{3, 4}, {3 + (double)seed, 50}};
        stroke s = {.touch = TOUCH_USUAL, .identity = seed, .n = 2};
        stroke_list list = {.strokes = {&s, 1, 1}, .points = {ends, 2, 2}};
        stroke_options o = options_for(seed);
        path_samples path = {0};
        CHECK(plb_path_sample(&list, &s, &o, &path, NULL));
        CHECK(plb_point_distance(path.v[0].at, ends[0]) < 1e-9);
        CHECK(plb_point_distance(path.v[path.n - 1].at, ends[1]) < 1e-9);
        array_free(&path);
    }
}

int main(void)
{
    RUN(control_points_per_length_class);
    RUN(control_points_lie_where_equation_1_says);
    RUN(squiggle_is_uniform_in_its_range);
    RUN(squiggle_keeps_its_limits);
    RUN(squiggle_zero_is_ruler_straight);
    RUN(parallel_lines_differ);
    RUN(ends_stay_where_the_drawing_has_them);
    CHECK_EXIT;
}
