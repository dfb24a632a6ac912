/* SPDX-License-Identifier: MIT
 *
 * Habits of a hand's lines, by their statistics: dashes, wide lines, circles, corners, lines along a ruler; and what must stay though they are there:
 * patterns, gaps, places.
 */
#include "check.h"

#include "plan/plan.h"
#include "stroke/stroke.h"

typedef struct {
    display_list list;
    stroke_list strokes;
    plan_options how;
} setup;

static setup page(void)
{
    setup s;
    memset(&s, 0, sizeof s);
    plb_list_init(&s.list);
    s.list.width = 200;
    s.list.height = 200;
    s.how = plb_plan_options_default();
    s.how.pencil_width = 0.3;
    s.how.shade_width = 0.42;
    s.how.is_touched = s.how.is_free = true;
    s.how.ruler = RULER_NONE;
    return s;
}

static item *add(setup *s, double width, const double *xy, int n, bool closed)
{
    item it = {.kind = ITEM_STROKE, .paint = {PAINT_SOLID, 0, 0, 0, 1}, .clip = NO_CLIP, .width = width};
    for (int i = 0; i < n; i++) {
        point p = {xy[2 * i], xy[2 * i + 1]};
        CHECK(i ? plb_path_line(&it.path, p) : plb_path_move(&it.path, p));
    }
    CHECK(!closed || plb_path_close(&it.path));
    CHECK(plb_list_add(&s->list, &it, NULL));
    return &s->list.items.v[s->list.items.n - 1];
}

static void plan(setup *s)
{
    CHECK(plb_plan(&s->list, &s->how, NULL, &s->strokes, NULL));
}

static void clean(setup *s)
{
    plb_list_free(&s->list);
    plb_stroke_list_free(&s->strokes);
}

static point first_of(const setup *s, const stroke *k) { return s->strokes.points.v[k->first]; }
static point last_of(const setup *s, const stroke *k) { return s->strokes.points.v[k->first + k->n - 1]; }

/* ---- dashes ---- */

static void add_dashed(setup *s, double y, const double *dash, size_t n)
{
    item *it = add(s, .35, (const double[]){10, y, 190, y}, 2, false);
    for (size_t k = 0; k < n; k++)
        CHECK(array_push(&it->dash, dash[k]));
}

typedef struct {
    double mean, deviation;
    size_t n;
} moments;

static moments moments_of(const double *v, size_t n)
{
    moments m = {0, 0, n};
    for (size_t i = 0; i < n; i++)
        m.mean += v[i] / (double)n;
    for (size_t i = 0; i < n; i++)
        m.deviation += (v[i] - m.mean) * (v[i] - m.mean) / (double)n;
    m.deviation = sqrt(m.deviation);
    return m;
}

/* The lengths differ as those of real rows, each dash is tilted, but their number and mean are the pattern's. */
static void dashes_are_uneven_but_keep_step(void)
{
    enum { ROWS = 12, MAX = 600 };
    double length[MAX], tilt[MAX];
    size_t n = 0;
    setup s = page();
    for (int i = 0; i < ROWS; i++)
        add_dashed(&s, 10 + 15 * i, (const double[]){3.6, 2.4}, 2);
    plan(&s);
    CHECK_RANGE((double)s.strokes.strokes.n, ROWS * 29, ROWS * 31);
    for (size_t i = 0; i < s.strokes.strokes.n; i++) {
        const stroke *k = &s.strokes.strokes.v[i];
        point way = point_sub(last_of(&s, k), first_of(&s, k));
        double row = round((first_of(&s, k).y - 10) / 15) * 15 + 10;
        CHECK(fabs(first_of(&s, k).y - row) < 0.6 && fabs(last_of(&s, k).y - row) < 0.6);
        if (first_of(&s, k).x < 11 || last_of(&s, k).x > 186)
            continue; /* begun or cut by the line's ends */
        length[n] = plb_point_length(way);
        tilt[n++] = atan2(way.y, way.x) * 180 / PLB_PI;
    }
    moments of_length = moments_of(length, n), of_tilt = moments_of(tilt, n);
    CHECK_RANGE(of_length.mean, 3.4, 4.0);
    CHECK_RANGE(of_length.deviation / of_length.mean, 0.23, 0.48);
    CHECK_RANGE(of_tilt.deviation, 1.5, 6);
    CHECK_RANGE(of_tilt.mean, -1, 1);
    clean(&s);
}

static int by_x(const void *a, const void *b)
{
    double x = ((const double *)a)[0], y = ((const double *)b)[0];
    return (x > y) - (x < y);
}

/* No gap closes; long and short dashes of one pattern are told apart, and follow each other. */
static void patterns_stay_patterns(void)
{
    for (uint64_t seed = 1; seed <= 5; seed++) {
        setup s = page();
        double dash[200][2]; /* begin, end */
        size_t n = 0;
        s.how.seed = seed;
        add_dashed(&s, 20, (const double[]){6, 2, 1, 2}, 4);
        plan(&s);
        for (size_t i = 0; i < s.strokes.strokes.n && n < 200; i++, n++) {
            dash[n][0] = first_of(&s, &s.strokes.strokes.v[i]).x;
            dash[n][1] = last_of(&s, &s.strokes.strokes.v[i]).x;
        }
        qsort(dash, n, sizeof *dash, by_x);
        for (size_t i = 0; i + 1 < n; i++) {
            double length = dash[i][1] - dash[i][0];
            CHECK_RANGE(dash[i + 1][0] - dash[i][1], 0.8, 3.6);
            if (i > 0)
                CHECK(i % 2 == 0 ? length > 3 : length < 2);
        }
        clean(&s);
    }
}

/* ---- wide lines ---- */

/* The passes are one company, lie so close that no gap shows, end raggedly about the cut, and turn there. */
static void wide_lines_are_one_company(void)
{
    setup s = page();
    add(&s, 4, (const double[]){20, 50, 120, 50}, 2, false);
    plan(&s);
    double across[100], end[100];
    size_t passes = 0, turns = 0;
    uint64_t company = s.strokes.strokes.v[0].style.company;
    float limit = s.strokes.strokes.v[0].max_deviation;
    CHECK(company != 0 && limit > 0);
    for (size_t i = 0; i < s.strokes.strokes.n; i++) {
        const stroke *k = &s.strokes.strokes.v[i];
        CHECK(k->style.company == company && k->max_deviation == limit);
        if (k->n > 2) {
            turns++;
            continue;
        }
        across[passes] = first_of(&s, k).y;
        end[passes++] = last_of(&s, k).x - 120;
    }
    CHECK(passes >= 14 && turns == passes - 3); /* the passes between the edges, two by two */
    qsort(across, passes, sizeof *across, by_x);
    for (size_t i = 1; i < passes; i++)
        CHECK_RANGE(across[i] - across[i - 1], 0, 0.42 * 0.9);
    moments of_end = moments_of(end, passes);
    CHECK_RANGE(of_end.deviation, 0.05, 0.3);
    CHECK_RANGE(of_end.mean, -0.2, 0.2);
    clean(&s);
}

/* ---- what the arm makes of strokes ---- */

static stroke_options free_hand(void)
{
    return (stroke_options){.seed = 1, .squiggle = -1, .dpi = 300, .model = &plb_model_graphite};
}

/* Two passes of one company stray by the same; neighbours of none do not. */
static void companies_stray_together(void)
{
    stroke_options o = free_hand();
    double apart[2] = {0, 0};
    for (int with = 0; with < 2; with++) {
        stroke_list list = {.width = 200, .height = 200};
        path_samples drawn[2] = {{0}, {0}};
        for (int i = 0; i < 2; i++) {
            point ends[2] = {{20, 50 + .3 * i}, {140, 50 + .3 * i}};
            stroke k = {.style = STROKE_STYLE_USUAL, .identity = 11 + (uint64_t)i, .first = list.points.n, .n = 2, .corner_first = true, .corner_last = true};
            k.style.company = with ? 77 : 0;
            CHECK(array_push(&list.points, ends[0]) && array_push(&list.points, ends[1]) && array_push(&list.strokes, k));
            CHECK(plb_path_sample(&list, &list.strokes.v[i], &o, &drawn[i], NULL));
        }
        for (size_t i = 0; i < drawn[0].n && i < drawn[1].n; i++)
            apart[with] = fmax(apart[with], fabs(drawn[1].v[i].at.y - drawn[0].v[i].at.y - .3));
        array_free(&drawn[0]);
        array_free(&drawn[1]);
        plb_stroke_list_free(&list);
    }
    CHECK_RANGE(apart[1], 0, 0.01);
    CHECK(apart[0] > 0.2);
}

/* Adds a circle; gives its stroke. */
static stroke *add_circle(stroke_list *list, double x, double y, double r, uint64_t identity)
{
    stroke k = {.style = STROKE_STYLE_USUAL, .identity = identity, .first = list->points.n, .n = 61, .closed = true};
    for (int i = 0; i <= 60; i++) {
        point p = {x + r * cos(i % 60 * PLB_PI / 30), y + r * sin(i % 60 * PLB_PI / 30)};
        CHECK(array_push(&list->points, p));
    }
    CHECK(array_push(&list->strokes, k));
    return &list->strokes.v[list->strokes.n - 1];
}

/* Gives the amplitude of the second harmonic of a drawn circle over its radius. */
static double second_harmonic(const path_samples *p, double x, double y, double r)
{
    double c = 0, s = 0, whole = 0;
    for (size_t i = 1; i < p->n && whole < 2 * PLB_PI * r; i++) {
        point d = {p->v[i].at.x - x, p->v[i].at.y - y};
        double step = p->v[i].along - p->v[i - 1].along, angle = atan2(d.y, d.x), off = plb_point_length(d) - r;
        c += step * off * cos(2 * angle);
        s += step * off * sin(2 * angle);
        whole += step;
    }
    return 2 * hypot(c, s) / whole / r;
}

static int compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Eggs as real ones are; begun between 11 and 1 o'clock; overdrawn by a quarter turn at most, and always closed. */
static void circles_are_eggs(void)
{
    enum { CIRCLES = 200 };
    stroke_options o = free_hand();
    stroke_list list = {.width = 200, .height = 200};
    path_samples drawn = {0};
    double egg[CIRCLES], longest = 0;
    for (int i = 0; i < CIRCLES; i++) {
        stroke k = *add_circle(&list, 50, 50, 4, 1000 + (uint64_t)i);
        CHECK(plb_path_sample(&list, &k, &o, &drawn, NULL));
        egg[i] = second_harmonic(&drawn, 50, 50, 4);
        point begin = point_sub(drawn.v[0].at, (point){50, 50});
        double turns = drawn.v[drawn.n - 1].along / (2 * PLB_PI * 4), at = atan2(begin.x, -begin.y) * 180 / PLB_PI;
        CHECK_RANGE(at, -45, 45);
        CHECK_RANGE(turns, 0.97, 1.3);
        CHECK(plb_point_distance(drawn.v[0].at, drawn.v[drawn.n - 1].at) > 0.01);
        longest = fmax(longest, turns);
    }
    qsort(egg, CIRCLES, sizeof *egg, compare_doubles);
    CHECK_RANGE(egg[CIRCLES / 2], 0.02, 0.06);
    CHECK_RANGE(egg[CIRCLES / 10], 0.005, 0.03);
    CHECK_RANGE(egg[CIRCLES * 9 / 10], 0.05, 0.12);
    CHECK(longest > 1.15);
    array_free(&drawn);
    plb_stroke_list_free(&list);
}

static void nested_circles_keep_apart(void)
{
    setup s = page();
    for (int k = 0; k < 3; k++) {
        double xy[120], r = 10 + 1.2 * k;
        for (int i = 0; i < 60; i++) {
            xy[2 * i] = 60 + r * cos(i * PLB_PI / 30);
            xy[2 * i + 1] = 60 + r * sin(i * PLB_PI / 30);
        }
        add(&s, .35, xy, 60, true);
    }
    plan(&s);
    CHECK(s.strokes.strokes.n == 3);
    for (size_t i = 0; i < s.strokes.strokes.n; i++)
        CHECK_RANGE((double)s.strokes.strokes.v[i].max_deviation, 0.1, 0.4);
    clean(&s);
}

/* ---- corners and rulers ---- */

/* Corners of boxes: some met exactly, some passed, some not reached, some rounded; all by fractions of a millimetre. */
static void corners_are_met_by_chance(void)
{
    enum { BOXES = 100 };
    setup s = page();
    int exact = 0, passed = 0, before = 0, bent = 0, ends = 0;
    for (int i = 0; i < BOXES; i++) {
        double x = 10 + 18 * (i % 10), y = 10 + 18 * (i / 10); /* no two lie on one line */
        add(&s, .35, (const double[]){x + .1 * (i / 10), y + .1 * (i % 10), x + 10 + .1 * (i / 10), y + .1 * (i % 10), x + 10 + .1 * (i / 10), y + 9 + .1 * (i % 10), x + .1 * (i / 10), y + 9 + .1 * (i % 10)}, 4, true);
    }
    plan(&s);
    CHECK(s.strokes.strokes.n == 4 * BOXES);
    for (size_t i = 0; i < s.strokes.strokes.n; i++) {
        const stroke *k = &s.strokes.strokes.v[i];
        point way = point_sub(last_of(&s, k), first_of(&s, k));
        if (k->n > 2) {
            bent++;
            continue;
        }
        double more = plb_point_length(way) - (fabs(way.x) > fabs(way.y) ? 10 : 9);
        CHECK_RANGE(more, -1.3, 1.3);
        exact += fabs(more) < 1e-6;
        passed += more > 0.05;
        before += more < -0.05;
        ends++;
    }
    CHECK(exact > BOXES / 8 && passed > BOXES && before > BOXES / 5 && bent > BOXES / 5);
    CHECK(exact + passed + before > ends * 9 / 10);
    clean(&s);
}

/* An arrowhead, a tick and the joint of three lines are met exactly. */
static void small_and_sharp_corners_are_met(void)
{
    setup s = page();
    add(&s, .35, (const double[]){17, 9, 20, 10, 17, 11}, 3, false);
    add(&s, .35, (const double[]){50, 50, 53, 50, 53, 53}, 3, false);
    add(&s, .35, (const double[]){80, 50, 100, 50, 80, 55}, 3, false);
    plan(&s);
    for (size_t i = 0; i < s.strokes.strokes.n; i++)
        for (int k = 0; k < 2; k++) {
            point p = k ? last_of(&s, &s.strokes.strokes.v[i]) : first_of(&s, &s.strokes.strokes.v[i]);
            CHECK(p.x == round(p.x) && p.y == round(p.y));
        }
    clean(&s);
}

static void long_level_lines_are_ruled(void)
{
    static const struct {
        ruler_use use;
        bool frame, slanted, shorter;
    } rows[] = {{RULER_NONE, false, false, false}, {RULER_AUTO, true, false, false}, {RULER_ALL, true, true, true}};
    for (int i = 0; i < 3; i++) {
        setup s = page();
        s.how.ruler = rows[i].use;
        add(&s, .35, (const double[]){10, 20, 150, 20}, 2, false);
        add(&s, .35, (const double[]){10, 60, 150, 100}, 2, false);
        add(&s, .35, (const double[]){10, 150, 40, 150}, 2, false);
        plan(&s);
        CHECK(s.strokes.strokes.n == 3);
        for (size_t k = 0; k < 3; k++) {
            const stroke *t = &s.strokes.strokes.v[k];
            point a = first_of(&s, t);
            bool is_ruled = a.y < 30 ? rows[i].frame : a.y < 110 ? rows[i].slanted : rows[i].shorter;
            CHECK((t->max_deviation > 0) == is_ruled && t->max_deviation < 0.4f);
        }
        clean(&s);
    }
}

int main(void)
{
    RUN(dashes_are_uneven_but_keep_step);
    RUN(patterns_stay_patterns);
    RUN(wide_lines_are_one_company);
    RUN(companies_stray_together);
    RUN(circles_are_eggs);
    RUN(nested_circles_keep_apart);
    RUN(corners_are_met_by_chance);
    RUN(small_and_sharp_corners_are_met);
    RUN(long_level_lines_are_ruled);
    CHECK_EXIT;
}
