/* SPDX-License-Identifier: MIT
 *
 * Sketch habits and lines beside each other: what is added, what is changed, and what is left alone.
 */
#include "check.h"

#include "base/number/random.h"
#include "plan/habits/habits.h"
#include "plan/strokes/passes.h"
#include "stroke/stroke.h"

static stroke_list page(void)
{
    return (stroke_list){.width = 200, .height = 150};
}

static stroke *add(stroke_list *list, double x0, double y0, double x1, double y1, stroke_kind kind)
{
    point ends[2] = {{x0, y0}, {x1, y1}};
    stroke s = {.style = {1, 0, kind, false, kind == STROKE_HATCH}};
    CHECK(plb_plan_append(list, &s, ends, 2));
    return &list->strokes.v[list->strokes.n - 1];
}

static void add_corners(stroke_list *list, stroke_kind kind)
{
    stroke *s = add(list, 50, 50, 100, 50, kind);
    s->corner_first = s->corner_last = true;
}

static void add_circle(stroke_list *list, double x, double y, double r)
{
    point v[61];
    for (int i = 0; i <= 60; i++)
        v[i] = (point){x + r * cos(i % 60 * PLB_PI / 30), y + r * sin(i % 60 * PLB_PI / 30)};
    stroke s = {.style = STROKE_STYLE_USUAL, .closed = true};
    CHECK(plb_plan_append(list, &s, v, 61));
}

static plan_options options(double overshoot, double restate, bool construction)
{
    plan_options o = plb_plan_options_default();
    o.overshoot = overshoot;
    o.restate = restate;
    o.construction = construction;
    return o;
}

static void apply(stroke_list *list, double overshoot, double restate, bool construction)
{
    plan_options o = options(overshoot, restate, construction);
    CHECK(plb_plan_habits(list, &o, NULL));
}

static void all_are_off_by_default(void)
{
    stroke_list list = page();
    add_corners(&list, STROKE_LINE);
    add_circle(&list, 50, 100, 20);
    plan_options o = plb_plan_options_default();
    CHECK(plb_plan_habits(&list, &o, NULL));
    CHECK(list.strokes.n == 2 && list.strokes.v[0].corner_last && list.points.v[1].x == 100);
    plb_stroke_list_free(&list);
}

/* Outward, along the line, never by more than asked for; corners only. */
static void lines_run_past_corners(void)
{
    double sum = 0, exact = 0;
    for (int i = 0; i < 200; i++) {
        stroke_list list = page();
        stroke *s = add(&list, 50, 20 + i * 0.5, 100, 20 + i * 0.5, STROKE_LINE);
        s->corner_last = true;
        apply(&list, 2, 0, false);
        double past = list.points.v[1].x - 100;
        CHECK_RANGE(past, 0, 2);
        CHECK(list.points.v[0].x == 50 && list.points.v[1].y == list.points.v[0].y);
        CHECK(list.strokes.v[0].corner_last == (past == 0)); /* a free end is lifted */
        exact += past == 0;
        sum += past;
        plb_stroke_list_free(&list);
    }
    CHECK_RANGE(sum / 200, 0.8, 1.6);
    CHECK_RANGE(exact / 200, 0.1, 0.3);
}

static void small_things_are_left_alone(void)
{
    static const stroke_kind kinds[] = {STROKE_HATCH, STROKE_LETTER, STROKE_GUIDE};
    for (int k = 0; k < 3; k++) {
        stroke_list list = page();
        add_corners(&list, kinds[k]);
        apply(&list, 3, 1, true);
        CHECK(list.strokes.n == 1 && list.points.v[0].x == 50 && list.points.v[1].x == 100);
        plb_stroke_list_free(&list);
    }
    stroke_list list = page();
    stroke *s = add(&list, 50, 50, 53, 50, STROKE_LINE);
    s->corner_first = s->corner_last = true;
    apply(&list, 3, 1, true);
    CHECK(list.strokes.n == 1);
    CHECK_RANGE(list.points.v[1].x, 53, 53.31);
    plb_stroke_list_free(&list);
}

static void a_share_of_long_lines_is_drawn_twice(void)
{
    stroke_list list = page();
    for (int i = 0; i < 400; i++)
        add(&list, 10, i * 0.3, 90, i * 0.3 + 10, STROKE_LINE);
    for (int i = 0; i < 100; i++)
        add(&list, 100, i * 0.3, 110, i * 0.3, STROKE_LINE); /* short */
    apply(&list, 0, 0.3, false);
    CHECK_RANGE((double)list.strokes.n - 500, 0.23 * 400, 0.37 * 400);
    for (size_t i = 500; i < list.strokes.n; i++) {
        const stroke *s = &list.strokes.v[i];
        CHECK(s->style.pressure < 0.9f && s->style.kind == STROKE_LINE && s->max_deviation > 0 && s->max_deviation < 1);
        CHECK_RANGE(plb_point_distance(list.points.v[s->first], list.points.v[s->first + 1]), 75, 84);
    }
    CHECK(plb_plan_identify(&list, NULL));
    for (size_t i = 0; i < list.strokes.n; i++)
        for (size_t k = 0; k < i; k++)
            CHECK(list.strokes.v[i].identity != list.strokes.v[k].identity);
    plb_stroke_list_free(&list);
}

static size_t count_guides(const stroke_list *list)
{
    size_t n = 0;
    for (size_t i = 0; i < list->strokes.n; i++)
        n += list->strokes.v[i].style.kind == STROKE_GUIDE;
    return n;
}

static void guides_carry_long_lines_on(void)
{
    stroke_list list = page();
    add(&list, 50, 40, 90, 40, STROKE_LINE);
    add(&list, 95, 40, 140, 40, STROKE_LINE); /* on the same line: one guide */
    add(&list, 50, 40, 50, 100, STROKE_LINE);
    add(&list, 60, 60, 65, 60, STROKE_LINE); /* short: none */
    apply(&list, 0, 0, true);
    CHECK(list.strokes.n == 6 && count_guides(&list) == 2);
    const point *v = list.points.v + list.strokes.v[4].first;
    CHECK(list.strokes.v[4].style.pressure < 0.5f);
    CHECK_RANGE(v[0].x, 50 - 18 * 1.4, 50 - 4 * 0.6);
    CHECK_RANGE(v[1].x, 140 + 4 * 0.6, 140 + 18 * 1.4);
    CHECK(fabs(v[0].y - 40) < 1e-9 && fabs(v[1].y - 40) < 1e-9);
    plb_stroke_list_free(&list);
}

static void guides_stay_on_the_page_and_cross_circles(void)
{
    stroke_list list = page();
    add(&list, 1, 1, 199, 149, STROKE_LINE);
    add_circle(&list, 60, 60, 25);
    add_circle(&list, 150, 30, 2); /* small: none */
    apply(&list, 0, 0, true);
    CHECK(count_guides(&list) == 3);
    for (size_t i = 0; i < list.strokes.n; i++) {
        const stroke *s = &list.strokes.v[i];
        for (size_t k = s->first; k < s->first + s->n; k++)
            CHECK(list.points.v[k].x >= -1e-9 && list.points.v[k].x <= 200 + 1e-9 && list.points.v[k].y >= -1e-9 && list.points.v[k].y <= 150 + 1e-9);
    }
    plb_stroke_list_free(&list);
}

/* ---- lines beside each other ---- */

static void neighbours_limit_deviation(void)
{
    stroke_list list = page();
    add(&list, 20, 50, 180, 50, STROKE_LINE);
    add(&list, 180, 51, 30, 51, STROKE_LINE);   /* a millimetre beside it */
    add(&list, 20, 90, 180, 90, STROKE_LINE);   /* alone */
    add(&list, 100, 20, 100, 120, STROKE_LINE); /* crosses all */
    add(&list, 20, 90, 180, 93, STROKE_LINE);   /* meets an end */
    CHECK(plb_plan_neighbours(&list, 1, NULL));
    CHECK_RANGE(list.strokes.v[0].max_deviation, 0.3, 0.4);
    CHECK_RANGE(list.strokes.v[1].max_deviation, 0.3, 0.4);
    CHECK(list.strokes.v[2].max_deviation == 0 && list.strokes.v[3].max_deviation == 0 && list.strokes.v[4].max_deviation == 0);
    plb_stroke_list_free(&list);
}

/* Two thousand lines beside each other, each in three pieces; on every other one a short one ends. So many are shared out. */
static stroke_list many_lines(int rows)
{
    stroke_list list = {.width = 30, .height = rows + 10};
    for (int y = 5; y < rows + 5; y++) {
        for (int k = 0; k < 3; k++)
            add(&list, 5 + (y + k) % 3 * 6, y, 11 + (y + k) % 3 * 6, y, STROKE_LINE);
        if (y % 2)
            add(&list, 12, y, 12.3, y + 0.4, STROKE_LINE);
    }
    return list;
}

static void threads_change_no_stroke(void)
{
    enum { ROWS = 2100 };
    static const int threads[] = {1, 2, 7};
    stroke_list by[3];
    for (int k = 0; k < 3; k++) {
        by[k] = many_lines(ROWS);
        CHECK(plb_plan_join(&by[k], 0.1, threads[k], NULL) && plb_plan_smooth(&by[k], NULL));
        CHECK(plb_plan_neighbours(&by[k], threads[k], NULL) && plb_plan_junctions(&by[k], threads[k], NULL));
        CHECK(by[k].strokes.n == ROWS + ROWS / 2 && by[k].points.n == by[0].points.n);
        CHECK(!memcmp(by[k].points.v, by[0].points.v, by[0].points.n * sizeof *by[0].points.v));
        int beside = 0, met = 0;
        for (size_t i = 0; i < by[k].strokes.n; i++) {
            const stroke *s = &by[k].strokes.v[i], *t = &by[0].strokes.v[i];
            CHECK(s->first == t->first && s->n == t->n && s->max_deviation == t->max_deviation);
            beside += s->max_deviation > 0.3f;
            met += s->max_deviation > 0 && s->max_deviation < 0.3f;
        }
        CHECK(beside == ROWS / 2 && met == ROWS / 2);
    }
    for (int k = 0; k < 3; k++)
        plb_stroke_list_free(&by[k]);
}

/* Two lines of a wall, drawn by the hand with many seeds: they hardly ever touch. */
static void the_lines_of_a_wall_stay_apart(void)
{
    stroke_list list = page();
    add(&list, 10, 50, 190, 50, STROKE_LINE);
    add(&list, 10, 51.2, 190, 51.2, STROKE_LINE);
    for (int i = 0; i < 2; i++)
        list.strokes.v[i].corner_first = list.strokes.v[i].corner_last = true;
    CHECK(plb_plan_neighbours(&list, 1, NULL) && plb_plan_identify(&list, NULL));
    double touching = 0;
    path_samples drawn[2] = {{0}, {0}};
    for (uint64_t seed = 1; seed <= 300; seed++) {
        stroke_options o = {.seed = seed, .squiggle = -1, .model = &plb_model_graphite, .arm = &plb_arm_hand, .handed = HANDED_RIGHT, .dpi = 300};
        double gap = 1e9;
        for (int i = 0; i < 2; i++)
            CHECK(plb_path_sample(&list, &list.strokes.v[i], &o, &drawn[i], NULL));
        for (size_t k = 0; k < drawn[0].n && k < drawn[1].n; k++) /* sampled at the same places */
            gap = fmin(gap, drawn[1].v[k].at.y - drawn[0].v[k].at.y);
        touching += gap < 0.2;
    }
    CHECK_RANGE(touching / 300, 0, 0.03);
    array_free(&drawn[0]);
    array_free(&drawn[1]);
    plb_stroke_list_free(&list);
}

/* Lines all over a page, each with a random identity. */
static stroke_list many_touches(size_t n)
{
    stroke_list list = page();
    for (size_t i = 0; i < n; i++) {
        double x = 190 * random_unit(7, 2 * i), y = 140 * random_unit(7, 2 * i + 1);
        add(&list, x, y, x + 10, y + 5, i % 4 == 3 ? STROKE_HATCH : STROKE_LINE)->identity = random_mix(i);
    }
    return list;
}

/* The point broadens and is sharpened, pressure lives; hatching keeps both. */
static void touch_changes_over_a_page(void)
{
    plan_options o = plb_plan_options_default();
    o.point = 0.6;
    o.is_touched = true;
    stroke_list list = many_touches(2000);
    plb_plan_touch(&list, &o);
    double n = 0, sum = 0, squares = 0, breadth = 0, finest = 9, broadest = 0;
    for (size_t i = 0; i < list.strokes.n; i++) {
        stroke_style s = list.strokes.v[i].style;
        if (s.kind == STROKE_HATCH) {
            CHECK(s.pressure == 1 && s.breadth == 1);
            continue;
        }
        double p = log((double)s.pressure);
        n++;
        sum += p;
        squares += p * p;
        breadth += (double)s.breadth;
        finest = fmin(finest, (double)s.breadth);
        broadest = fmax(broadest, (double)s.breadth);
    }
    CHECK_RANGE(sqrt(squares / n - sum / n * (sum / n)), 0.18, 0.28);
    CHECK_RANGE(finest, 0.6, 0.63);
    CHECK_RANGE(broadest, 0.80, 0.841);
    CHECK_RANGE(breadth / n / (o.point * plb_wear_mean(&o)), 0.97, 1.03);
    plb_stroke_list_free(&list);
}

/* Lines added elsewhere, even drawn before, change no line's touch. */
static void touch_is_each_line_s_own(void)
{
    plan_options o = plb_plan_options_default();
    o.point = 0.6;
    o.is_touched = true;
    stroke_list all = many_touches(400), some = many_touches(400);
    for (size_t i = 0; i < 200; i++)
        some.strokes.v[i] = some.strokes.v[2 * i + 1];
    some.strokes.n = 200;
    plb_plan_touch(&all, &o);
    plb_plan_touch(&some, &o);
    for (size_t i = 0; i < 200; i++) {
        stroke_style a = all.strokes.v[2 * i + 1].style, b = some.strokes.v[i].style;
        CHECK(a.pressure == b.pressure && a.breadth == b.breadth);
    }
    plb_stroke_list_free(&all);
    plb_stroke_list_free(&some);
}

static void a_blunt_point_stays_as_it_is(void)
{
    plan_options o = plb_plan_options_default();
    stroke_list list = many_touches(50);
    plb_plan_touch(&list, &o);
    for (size_t i = 0; i < list.strokes.n; i++)
        CHECK(list.strokes.v[i].style.breadth == 1);
    plb_stroke_list_free(&list);
}

int main(void)
{
    RUN(all_are_off_by_default);
    RUN(lines_run_past_corners);
    RUN(small_things_are_left_alone);
    RUN(a_share_of_long_lines_is_drawn_twice);
    RUN(guides_carry_long_lines_on);
    RUN(guides_stay_on_the_page_and_cross_circles);
    RUN(neighbours_limit_deviation);
    RUN(threads_change_no_stroke);
    RUN(the_lines_of_a_wall_stay_apart);
    RUN(touch_changes_over_a_page);
    RUN(touch_is_each_line_s_own);
    RUN(a_blunt_point_stays_as_it_is);
    CHECK_EXIT;
}
