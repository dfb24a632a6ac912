/* SPDX-License-Identifier: MIT
 *
 * The arm's path over many seeds: control points per length class (001 table 1), their places (equation 1), the range
 * and independence of D, and that no two lines are alike; the free hand's wobble, hooks and directions.
 */
#include "check.h"

#include "base/number/random.h"
#include "base/number/units.h"
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
            CHECK(plb_movement_controls(plb_arm_of(&o), expected[i].px * PX * (1 + 1e-12), (point){1, 0}, seed * 77 + i, &o, c) == expected[i].n || expected[i].px == 200 || expected[i].px == 400);
            CHECK(plb_movement_controls(plb_arm_of(&o), expected[i].px * PX * (1 - 1e-12), (point){1, 0}, seed * 77 + i, &o, c) == expected[i].n);
        }
}

/* dt 0.5: tau 0, 1/4, 1/2, 3/4, 1; equation 1 by hand. The last is at tf though 0.3 does not divide 2. */
static void control_points_lie_where_equation_1_says(void)
{
    control c[CONTROLS_MAX];
    stroke_options o = options_for(1);
    CHECK(plb_movement_controls(plb_arm_of(&o), 100 * PX, (point){1, 0}, 5, &o, c) == 5);
    static const double share[5] = {0, 0.103515625, 0.5, 0.896484375, 1};
    for (int k = 0; k < 5; k++)
        CHECK(fabs(c[k].along / (100 * PX) - share[k]) < 1e-12);
    size_t n = plb_movement_controls(plb_arm_of(&o), 300 * PX, (point){1, 0}, 5, &o, c);
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
            size_t k = plb_movement_controls(plb_arm_of(&o), cases[i].px * PX, (point){1, 0}, 99, &o, c);
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
        size_t n = plb_movement_controls(plb_arm_of(&o), 1000 * PX, (point){1, 0}, seed, &o, c);
        for (size_t k = 1; k + 1 < n; k++) {
            double way = fmin(c[k].along, 1000 * PX - c[k].along);
            CHECK(fabs(c[k].off) <= fmin(5 * PX, 0.2 * way) + 1e-12);
        }
        products += c[4].off * c[5].off;
        squares += c[4].off * c[4].off;
        o.arm = &plb_arm_spring;
        n = plb_movement_controls(plb_arm_of(&o), 1000 * PX, (point){1, 0}, seed, &o, c);
        for (size_t k = 1; k + 1 < n; k++)
            CHECK(fabs(c[k].off) <= 3 * PX + 1e-12);
    }
    CHECK_RANGE(products / squares, -0.05, 0.05);
}

static void squiggle_zero_is_ruler_straight(void)
{
    point ends[2] = {{10, 20}, {70, 95}};
    stroke s = {.style = STROKE_STYLE_USUAL, .identity = 42, .n = 2};
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

static const arm_model *parallel_arm;

/* Measures how far a path deviates from its chord at 64 places along it. */
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
    static const arm_model *const arms[] = {&plb_arm_jerk, &plb_arm_spring, &plb_arm_hand};
    for (size_t i = 0; i < 3; i++) {
        parallel_arm = arms[i];
        compare_parallel_lines();
    }
}

static void ends_stay_where_the_drawing_has_them(void)
{
    for (uint64_t seed = 1; seed <= 200; seed++) {
        point ends[2] = {{3, 4}, {3 + (double)seed, 50}};
        stroke s = {.style = STROKE_STYLE_USUAL, .identity = seed, .n = 2};
        stroke_list list = {.strokes = {&s, 1, 1}, .points = {ends, 2, 2}};
        stroke_options o = options_for(seed);
        path_samples path = {0};
        CHECK(plb_path_sample(&list, &s, &o, &path, NULL));
        CHECK(plb_point_distance(path.v[0].at, ends[0]) < 1e-9);
        CHECK(plb_point_distance(path.v[path.n - 1].at, ends[1]) < 1e-9);
        array_free(&path);
    }
}

/* ---- the free hand ---- */

typedef struct {
    point ends[2];
    stroke s;
    stroke_list list;
    stroke_options o;
    path_samples path;
} hand_line;

/* Draws a line along `way` with the graphite model's hand. */
static void draw_by_hand(hand_line *l, point way, uint64_t identity)
{
    l->ends[0] = (point){300, 300};
    l->ends[1] = point_add(l->ends[0], way);
    l->s.style = STROKE_STYLE_USUAL;
    l->s.identity = random_mix(identity);
    l->s.n = 2;
    l->list = (stroke_list){.strokes = {&l->s, 1, 1}, .points = {l->ends, 2, 2}};
    l->o.seed = 3;
    l->o.model = &plb_model_graphite;
    l->o.arm = &plb_arm_hand;
    l->o.dpi = 300;
    CHECK(plb_path_sample(&l->list, &l->s, &l->o, &l->path, NULL));
}

/* How far the path is off the line at a share of its length, mm to the left of the line's direction. */
static double off_at(const hand_line *l, double share)
{
    point way = point_sub(l->ends[1], l->ends[0]);
    double length = plb_point_length(way);
    size_t i = 1;
    while (i + 1 < l->path.n && point_dot(point_sub(l->path.v[i].at, l->ends[0]), way) / length < share * length)
        i++;
    point a = point_sub(l->path.v[i - 1].at, l->ends[0]), b = point_sub(l->path.v[i].at, l->ends[0]);
    double along_a = point_dot(a, way) / length, along_b = point_dot(b, way) / length;
    return -point_cross(way, point_mix(a, b, (share * length - along_a) / (along_b - along_a))) / length;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median_of(double *v, int n)
{
    qsort(v, (size_t)n, sizeof *v, by_size);
    return v[n / 2];
}

/* The drawn paths themselves, sine mode by sine mode, over lines of all directions: the medians measured on scans. */
static void the_drawn_path_wobbles_as_measured(void)
{
    enum { LINES = 1500, MODES = 6 };
    static const double measured[MODES] = {.56, .22, .14, .095, .066, .044};
    static double amplitude[MODES][LINES], extreme[LINES];
    hand_line l = {.o = {.squiggle = -1, .handed = HANDED_RIGHT}};
    for (int i = 0; i < LINES; i++) {
        double angle = 2 * PLB_PI * i / LINES, length = 60;
        l.s.corner_first = l.s.corner_last = true;
        draw_by_hand(&l, (point){length * cos(angle), length * sin(angle)}, (uint64_t)i);
        double sum[MODES] = {0};
        extreme[i] = 0;
        for (int k = 1; k < 100; k++) {
            double off = off_at(&l, k / 100.0);
            extreme[i] = fmax(extreme[i], fabs(off) / length * 100);
            for (int m = 0; m < MODES; m++)
                sum[m] += off * sin((m + 1) * PLB_PI * k / 100.0) / 50;
        }
        for (int m = 0; m < MODES; m++)
            amplitude[m][i] = fabs(sum[m]) / length * 100;
    }
    for (int m = 0; m < MODES; m++)
        CHECK_RANGE(median_of(amplitude[m], LINES) / measured[m], 0.85, 1.2);
    CHECK_RANGE(median_of(extreme, LINES), 0.6, 1.2); /* measured: 1.0 */
    CHECK_RANGE(extreme[LINES / 10], 0.25, 0.6);      /* 0.44 */
    CHECK_RANGE(extreme[LINES * 9 / 10], 1.2, 2.2);   /* 2.2 over six hands; one hand varies less */
    array_free(&l.path);
}

/* The last 3 px lie 0.5 to 0.7 px off, one end in five more than 1.5 px; not at corners, nor on ruled lines. */
static void free_ends_hook_as_measured(void)
{
    enum { LINES = 3000 };
    double beyond = 0, mean = 0;
    hand_line l = {.o = {.squiggle = -1, .handed = HANDED_NONE}};
    for (int i = 0; i < LINES; i++) {
        draw_by_hand(&l, (point){40 * PX, 0}, (uint64_t)i);
        hand h = plb_hand(40 * PX, false, l.s.identity, &l.o);
        for (int end = 0; end < 2; end++) {
            beyond += fabs(off_at(&l, end)) / PX > 1.5;
            for (int px = 0; px < 3; px++) {
                double share = end ? 1 - px / 40.0 : px / 40.0;
                mean += fabs(off_at(&l, share) - plb_hand_off(&h, share * 40 * PX)) / PX / 3;
            }
        }
    }
    CHECK_RANGE(beyond / (2 * LINES), 0.18, 0.22);
    CHECK_RANGE(mean / (2 * LINES), 0.5, 0.75);
    l.s.corner_first = l.s.corner_last = true;
    draw_by_hand(&l, (point){40 * PX, 5}, 4);
    CHECK(plb_point_distance(l.path.v[0].at, l.ends[0]) < 1e-9 && plb_point_distance(l.path.v[l.path.n - 1].at, l.ends[1]) < 1e-9);
    l.s.corner_first = l.s.corner_last = false;
    l.o.squiggle = 0;
    draw_by_hand(&l, (point){40 * PX, 5}, 4);
    CHECK(fabs(off_at(&l, 0)) < 1e-9 && fabs(off_at(&l, 1)) < 1e-9);
    array_free(&l.path);
}

/* The mean over many lines of how far they are off at `share` of the way the hand goes, mm on the page upward. */
static double mean_rise(hand_line *l, point way, double share)
{
    enum { LINES = 2000 };
    double sum = 0;
    for (int i = 0; i < LINES; i++) {
        draw_by_hand(l, way, (uint64_t)i);
        double off = off_at(l, l->path.backward ? 1 - share : share);
        sum += (way.x > 0 ? off : -off) / LINES;
    }
    return sum;
}

/* The thesis, chapter 7: rightward lines end higher and lighter, leftward ones lower and darker; a left hand mirrors it;
 * lines toward the body stray less. All of it small. */
static void lines_differ_by_direction(void)
{
    hand_line l = {.o = {.squiggle = -1, .handed = HANDED_RIGHT}};
    CHECK_RANGE(mean_rise(&l, (point){80, 0}, 0.7), 0.06, 0.25);
    CHECK(!l.path.backward && l.path.pressure_last < 0.97f && l.path.pressure_first > 1);
    CHECK_RANGE(mean_rise(&l, (point){80, 0}, 1), 0.04, 0.13);
    CHECK_RANGE(mean_rise(&l, (point){-80, 0}, 0.7), -0.25, -0.06);
    CHECK(!l.path.backward && l.path.pressure_last > 1.03f);
    l.o.handed = HANDED_LEFT;
    CHECK_RANGE(mean_rise(&l, (point){80, 0}, 0.7), 0.06, 0.25); /* drawn to the left, and higher */
    CHECK(l.path.backward && l.path.pressure_first < 0.97f);
    draw_by_hand(&l, (point){10, 80}, 1);
    CHECK(!l.path.backward); /* steep lines are drawn downward by either hand */
    l.o.handed = HANDED_NONE;
    CHECK_RANGE(mean_rise(&l, (point){80, 0}, 0.7), -0.05, 0.05);
    CHECK(l.path.pressure_first == 1 && l.path.pressure_last == 1);
    hand down = plb_hand(80, false, 5, &l.o), up = down;
    l.o.handed = HANDED_RIGHT;
    plb_hand_direct(&down, (point){0, 80}, false, &l.o);
    plb_hand_direct(&up, (point){80, -60}, false, &l.o);
    CHECK(fabs(down.amplitude[0]) < 0.85 * fabs(up.amplitude[0]));
    array_free(&l.path);
}

/* A path is accurate first and deviates after the middle. */
static void the_second_half_strays_more(void)
{
    double first = 0, second = 0;
    hand_line l = {.o = {.squiggle = -1, .handed = HANDED_RIGHT}};
    for (int i = 0; i < 2000; i++) {
        draw_by_hand(&l, (point){0, 90}, (uint64_t)i);
        first += fabs(off_at(&l, 0.25));
        second += fabs(off_at(&l, 0.75));
    }
    CHECK_RANGE(second / first, 1.1, 1.6);
    array_free(&l.path);
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
    RUN(the_drawn_path_wobbles_as_measured);
    RUN(free_ends_hook_as_measured);
    RUN(lines_differ_by_direction);
    RUN(the_second_half_strays_more);
    CHECK_EXIT;
}
