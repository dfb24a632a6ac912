/* SPDX-License-Identifier: MIT
 *
 * A careful hand keeps words clear of hatching, smooths wiggles finer than the point, and meets the lines upon which it ends
 * others.
 */
#include "check.h"

#include "plan/habits/habits.h"
#include "plan/strokes/passes.h"
#include "plan/item/stages.h"

static stroke *add(stroke_list *list, double x0, double y0, double x1, double y1, stroke_kind kind)
{
    point ends[2] = {{x0, y0}, {x1, y1}};
    stroke s = {.style = {1, 0, kind}};
    CHECK(plb_plan_append(list, &s, ends, 2));
    return &list->strokes.v[list->strokes.n - 1];
}

static double distance(point p, point a, point b)
{
    point d = point_sub(b, a);
    double t = fmin(fmax(point_dot(point_sub(p, a), d) / point_dot(d, d), 0), 1);
    return plb_point_distance(p, point_mix(a, b, t));
}

/* Lines rise by 45 degrees, 1 mm apart, under a letter: none comes near, and what is away from it is there. */
static void hatching_keeps_clear_of_letters(void)
{
    const double width = 0.35;
    stroke_list list = {.width = 100, .height = 100};
    double before = 0, after = 0;
    for (int i = 0; i < 60; i++)
        add(&list, 10 + i, 60, 40 + i, 30, STROKE_HATCH);
    point a = {50, 40}, b = {53, 46};
    add(&list, a.x, a.y, b.x, b.y, STROKE_LETTER);
    before = 60 * plb_point_distance((point){10, 60}, (point){40, 30});
    CHECK(plb_plan_clearance(&list, width, NULL));
    for (size_t i = 0; i < list.strokes.n; i++) {
        const point *v = list.points.v + list.strokes.v[i].first;
        if (list.strokes.v[i].style.kind != STROKE_HATCH)
            continue;
        after += plb_point_distance(v[0], v[1]);
        for (int k = 0; k <= 100; k++)
            CHECK(distance(point_mix(v[0], v[1], k / 100.0), a, b) > width + 0.2);
    }
    CHECK_RANGE(before - after, 6, 20); /* about the area round the letter, over the spacing */
    plb_stroke_list_free(&list);
}

/* Level lines under two letters 2 mm apart, which ask for so much paper round them: gives the ink in the space between the letters, mm, and
 * how near the lines end to the first letter. */
static double ink_between(double clear, double *nearest)
{
    stroke_list list = {.width = 100, .height = 100};
    double ink = 0;
    *nearest = 100;
    for (int i = 0; i < 20; i++)
        add(&list, 20, 40 + .3 * i, 80, 40 + .3 * i, STROKE_HATCH);
    add(&list, 50, 41, 50, 45, STROKE_LETTER)->style.clear = (float)clear;
    add(&list, 52, 41, 52, 45, STROKE_LETTER)->style.clear = (float)clear;
    CHECK(plb_plan_clearance(&list, 0.2, NULL));
    for (size_t i = 0; i < list.strokes.n; i++) {
        const point *v = list.points.v + list.strokes.v[i].first;
        if (list.strokes.v[i].style.kind != STROKE_HATCH || v[0].y < 41.2 || v[0].y > 44.8)
            continue;
        ink += fmax(0, fmin(v[1].x, 52) - fmax(v[0].x, 50));
        *nearest = v[1].x < 50 ? fmin(*nearest, 50 - v[1].x) : *nearest;
    }
    plb_stroke_list_free(&list);
    return ink;
}

static void hatching_is_interrupted_for_words(void)
{
    double near_bars, near_words;
    CHECK(ink_between(0, &near_bars) > 8); /* bars have hatching between them, words have none */
    CHECK(ink_between(.8, &near_words) == 0);
    CHECK_RANGE(near_bars, .44, .46);
    CHECK_RANGE(near_words, .7, 1);
}

static void lettering_that_is_hatched_over_stays_so(void)
{
    stroke_list list = {.width = 100, .height = 100};
    add(&list, 50, 40, 53, 46, STROKE_LETTER);
    add(&list, 40, 43, 60, 43, STROKE_HATCH);
    CHECK(plb_plan_clearance(&list, 0.35, NULL));
    CHECK(list.strokes.n == 2);
    plb_stroke_list_free(&list);
}

/* ---- wiggles ---- */

typedef struct {
    size_t corners, points;
    box bounds;
    double turn; /* the largest where there is no corner, radians */
    point first, last;
} sight;

static void look(sight *s, const track *t)
{
    *s = (sight){.bounds = BOX_EMPTY, .points = t->n, .first = t->v[0].at, .last = t->v[t->n - 1].at};
    for (size_t i = 0; i < t->n; i++) {
        s->corners += t->v[i].corner;
        plb_box_add(&s->bounds, t->v[i].at);
        if (i == 0 || i + 1 == t->n || t->v[i].corner)
            continue;
        point in = point_sub(t->v[i].at, t->v[i - 1].at), out = point_sub(t->v[i + 1].at, t->v[i].at);
        s->turn = fmax(s->turn, fabs(atan2(point_cross(in, out), point_dot(in, out))));
    }
}

/* A zigzag of 45 degrees, `step` mm from corner to corner along x. */
static sight zigzag(double step, int corners)
{
    track_list zigzags = {0}, simpler = {0};
    sight s;
    CHECK(plb_track_begin(&zigzags, &(track){.style = STROKE_STYLE_USUAL}));
    for (int i = 0; i < corners + 2; i++)
        CHECK(plb_track_push(&zigzags, (point){10 + i * step, 10 + (i & 1 ? step : 0)}, i > 0 && i <= corners));
    CHECK(plb_plan_simplify(&zigzags, 0.35, &simpler, NULL) && simpler.tracks.n == 1);
    track t = plb_track_at(&simpler, 0);
    look(&s, &t);
    CHECK(s.first.x == 10 && fabs(s.last.x - (10 + (corners + 1) * step)) < 1e-9);
    plb_tracks_free(&zigzags);
    plb_tracks_free(&simpler);
    return s;
}

static void fine_wiggles_are_one_movement(void)
{
    sight fine = zigzag(0.1, 200), coarse = zigzag(3, 200), short_one = zigzag(0.1, 4);
    CHECK(fine.corners == 2); /* where the wiggle begins and ends */
    CHECK(fine.turn < 1);
    CHECK_RANGE(fine.bounds.y1 - fine.bounds.y0, 0, 0.101);
    CHECK(coarse.corners == 200 && coarse.points == 202);
    CHECK(short_one.corners == 4);
}

/* A closed track whose ends differ by less than a point is cut at its corner into one that ends exactly where it begins. */
static void closed_tracks_end_where_they_begin(void)
{
    track_list closed = {0}, pieces = {0};
    CHECK(plb_track_begin(&closed, &(track){.style = STROKE_STYLE_USUAL, .closed = true}));
    CHECK(plb_track_push(&closed, (point){5, 5}, true) && plb_track_push(&closed, (point){9, 5}, false) &&
          plb_track_push(&closed, (point){7, 9}, false) && plb_track_push(&closed, (point){5 + 1e-6, 5}, true));
    CHECK(plb_plan_corners(&closed, &pieces, NULL) && pieces.tracks.n == 1);
    track t = plb_track_at(&pieces, 0);
    CHECK(t.n == 4 && t.v[0].at.x == t.v[3].at.x && t.v[0].at.y == t.v[3].at.y);
    plb_tracks_free(&closed);
    plb_tracks_free(&pieces);
}

/* ---- meeting ---- */

static void lines_that_others_end_upon_stray_little(void)
{
    stroke_list list = {.width = 200, .height = 200};
    add(&list, 10, 100, 110, 100, STROKE_LINE); /* a scale, */
    add(&list, 60, 100, 60, 103, STROKE_LINE);  /* its tick, */
    add(&list, 10, 50, 110, 50, STROKE_LINE);   /* one that is only crossed, */
    add(&list, 60, 40, 60, 60, STROKE_LINE);
    add(&list, 110, 50, 110, 20, STROKE_LINE);  /* or met at its end, */
    add(&list, 10, 150, 110, 150, STROKE_LINE); /* and one with hatching upon it */
    add(&list, 50, 150, 60, 140, STROKE_HATCH);
    CHECK(plb_plan_junctions(&list, 1, NULL));
    for (size_t i = 0; i < list.strokes.n; i++)
        CHECK((list.strokes.v[i].max_deviation > 0) == (i == 0));
    CHECK_RANGE(list.strokes.v[0].max_deviation, 0.05, 0.35);
    plb_stroke_list_free(&list);
}

static void lines_keep_out_of_letters_beside_them(void)
{
    stroke_list list = {.width = 200, .height = 200};
    add(&list, 10, 100, 110, 100, STROKE_LINE); /* an axis, a number 1 mm below; */
    add(&list, 10, 50, 110, 50, STROKE_LINE);   /* a line with nothing near; */
    add(&list, 10, 150, 110, 150, STROKE_LINE); /* and one through a letter */
    add(&list, 60, 150.1, 60, 152, STROKE_LETTER);
    add(&list, 59, 101, 61, 104, STROKE_LETTER);
    CHECK(plb_plan_beside_letters(&list, 0.2, 1, NULL));
    CHECK_RANGE(list.strokes.v[0].max_deviation, 0.3, 0.5);
    CHECK(list.strokes.v[1].max_deviation == 0);
    CHECK_RANGE(list.strokes.v[2].max_deviation, 0.01, 0.1);
    CHECK(list.strokes.v[3].max_deviation == 0);
    plb_stroke_list_free(&list);
}

int main(void)
{
    RUN(hatching_keeps_clear_of_letters);
    RUN(hatching_is_interrupted_for_words);
    RUN(lettering_that_is_hatched_over_stays_so);
    RUN(fine_wiggles_are_one_movement);
    RUN(closed_tracks_end_where_they_begin);
    RUN(lines_that_others_end_upon_stray_little);
    RUN(lines_keep_out_of_letters_beside_them);
    CHECK_EXIT;
}
