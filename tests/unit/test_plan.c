/* SPDX-License-Identifier: MIT
 *
 * From display list to strokes: flattening, corners, dashes, clips, what leaves a mark, identities.
 */
#include "check.h"

#include "plan/plan.h"
#include "plan/track.h"

typedef struct {
    display_list list;
    stroke_list strokes;
} setup;

static setup page(double width, double height)
{
    setup s;
    memset(&s, 0, sizeof s);
    plb_list_init(&s.list);
    s.list.width = width;
    s.list.height = height;
    return s;
}

static item *add(setup *s, item_kind kind, const double *xy, int n)
{
    item it = {.kind = kind, .paint = {PAINT_SOLID, 0, 0, 0, 1}, .clip = NO_CLIP, .width = 0.3};
    for (int i = 0; i < n; i++) {
        point p = {xy[2 * i], xy[2 * i + 1]};
        CHECK(i ? plb_path_line(&it.path, p) : plb_path_move(&it.path, p));
    }
    CHECK(plb_list_add(&s->list, &it, NULL));
    return &s->list.items.v[s->list.items.n - 1];
}

static int add_clip(setup *s, const double *xy, int n, int parent)
{
    clip c = {.parent = parent};
    int index = -2;
    for (int i = 0; i < n; i++) {
        point p = {xy[2 * i], xy[2 * i + 1]};
        CHECK(i ? plb_path_line(&c.path, p) : plb_path_move(&c.path, p));
    }
    CHECK(plb_list_add_clip(&s->list, &c, &index, NULL));
    return index;
}

static size_t plan_by(setup *s, double pencil_width)
{
    plan_options how = plb_plan_options_default();
    how.pencil_width = pencil_width;
    CHECK(plb_plan(&s->list, &how, NULL, &s->strokes, NULL));
    return s->strokes.strokes.n;
}

static size_t plan(setup *s)
{
    return plan_by(s, 0.35);
}

static double length_of(const setup *s, size_t i)
{
    const stroke *k = &s->strokes.strokes.v[i];
    double sum = 0;
    for (size_t j = 1; j < k->n; j++)
        sum += plb_point_distance(s->strokes.points.v[k->first + j - 1], s->strokes.points.v[k->first + j]);
    return sum;
}

static void clean(setup *s)
{
    plb_list_free(&s->list);
    plb_stroke_list_free(&s->strokes);
}

static void corners_end_strokes(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){10, 10, 50, 10, 50, 50}, 3);            /* a right angle: 2 */
    add(&s, ITEM_STROKE, (const double[]){10, 60, 50, 60, 90, 80}, 3);            /* 26.6 degrees: 1 */
    add(&s, ITEM_STROKE, (const double[]){10, 90, 50, 90, 90, 60}, 3);            /* 36.9 degrees: 2 */
    CHECK(plan(&s) == 5);
    size_t bent = 0;
    for (size_t i = 0; i < 5; i++)
        bent += s.strokes.strokes.v[i].n == 3;
    CHECK(bent == 1);
    clean(&s);
}

static void closed_shapes_start_at_a_corner(void)
{
    setup s = page(100, 100);
    item *it = add(&s, ITEM_STROKE, (const double[]){30, 10, 50, 10, 50, 50, 10, 50, 10, 10}, 5); /* begins mid-side */
    CHECK(plb_path_close(&it->path));
    CHECK(plan(&s) == 4);
    for (size_t i = 0; i < s.strokes.strokes.n; i++)
        CHECK(fabs(length_of(&s, i) - 40) < 1e-9 && !s.strokes.strokes.v[i].closed);
    clean(&s);
}

static void circles_are_one_closed_stroke(void)
{
    setup s = page(100, 100);
    item it = {.kind = ITEM_STROKE, .paint = {PAINT_SOLID, 0, 0, 0, 1}, .clip = NO_CLIP};
    CHECK(plb_path_arc(&it.path, (point){50, 50}, 20, 0, 2 * PLB_PI, false, MATRIX_IDENTITY) && plb_path_close(&it.path));
    CHECK(plb_list_add(&s.list, &it, NULL));
    CHECK(plan(&s) == 1 && s.strokes.strokes.v[0].closed);
    CHECK_RANGE(length_of(&s, 0), 2 * PLB_PI * 20 * 0.998, 2 * PLB_PI * 20);
    for (size_t i = 0; i < s.strokes.points.n; i++) { /* the chord's middle, too, is within 0.05 mm */
        CHECK_RANGE(plb_point_distance(s.strokes.points.v[i], (point){50, 50}), 20 - 0.05, 20 + 0.05);
        point m = i ? point_mix(s.strokes.points.v[i - 1], s.strokes.points.v[i], .5) : s.strokes.points.v[0];
        CHECK_RANGE(plb_point_distance(m, (point){50, 50}), 20 - 0.05, 20 + 0.05);
    }
    clean(&s);
}

static void dashes_are_strokes(void)
{
    setup s = page(100, 100);
    item *it = add(&s, ITEM_STROKE, (const double[]){0, 50, 100, 50}, 2);
    double pattern[2] = {6, 4};
    CHECK(array_push(&it->dash, pattern[0]) && array_push(&it->dash, pattern[1]));
    it->dash_offset = 3;
    CHECK(plan(&s) == 11); /* 3 mm, nine of 6 mm, and 3 mm again at 97 */
    double most = 0;
    for (size_t i = 0; i < 11; i++) { /* each a little off its place, none far */
        double length = length_of(&s, i), nominal = i == 0 || i == 10 ? 3 : 6;
        CHECK_RANGE(length, nominal - 1, nominal + 1);
        most = fmax(most, fabs(length - nominal));
        double middle = (s.strokes.points.v[2 * i].x + s.strokes.points.v[2 * i + 1].x) / 2;
        CHECK(i == 0 || i == 10 || fabs(middle - 10.0 * (double)i) < .55);
    }
    CHECK(most > .1);
    clean(&s);
}

/* A pattern that no pencil makes is drawn with larger dashes, dots with butt caps not at all. */
static void fine_dashes_are_made_larger(void)
{
    setup s = page(100, 100);
    item *it = add(&s, ITEM_STROKE, (const double[]){0, 50, 100, 50}, 2);
    CHECK(array_push(&it->dash, .01) && array_push(&it->dash, .01));
    size_t n = plan(&s);
    CHECK_RANGE((double)n, 100, 200);
    it = &s.list.items.v[0];
    plb_stroke_list_free(&s.strokes);
    it->dash.v[0] = 0;
    it->dash.v[1] = 2;
    CHECK(plan(&s) == 0);
    it->cap = LINE_CAP_ROUND;
    plb_stroke_list_free(&s.strokes);
    CHECK(plan(&s) >= 49);
    clean(&s);
}

static void mad_dashes_are_bounded(void)
{
    static const double patterns[][2] = {{1e-9, 1e-9}, {0, 0}, {0, 1e-12}, {-1, 3}, {1e300, 1e300}, {0, 1}};
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++) {
        setup s = page(1000, 1000);
        item *it = add(&s, ITEM_STROKE, (const double[]){0, 50, 1000, 50}, 2);
        CHECK(array_push(&it->dash, patterns[i][0]) && array_push(&it->dash, patterns[i][1]));
        it->dash_offset = 1e30;
        CHECK(plan(&s) <= 2000);
        clean(&s);
    }
}

/* A U-shaped clip inside a box: a line across both arms leaves two pieces. */
static void clips_keep_every_piece(void)
{
    setup s = page(100, 100);
    int outer = add_clip(&s, (const double[]){5, 5, 95, 5, 95, 95, 5, 95}, 4, NO_CLIP);
    int u = add_clip(&s, (const double[]){10, 10, 30, 10, 30, 70, 60, 70, 60, 10, 80, 10, 80, 90, 10, 90}, 8, outer);
    add(&s, ITEM_STROKE, (const double[]){0, 40, 100, 40}, 2)->clip = u;
    CHECK(plan(&s) == 2);
    CHECK(fabs(length_of(&s, 0) - 20) < 1e-9 && fabs(length_of(&s, 1) - 20) < 1e-9);
    clean(&s);
}

/* A clip's level edge at half its height lies on the border of two bands: no crossing may fall between them. */
static void level_clip_edges_cut_every_line(void)
{
    setup s = page(100, 100);
    int notch = add_clip(&s, (const double[]){0, 0, 100, 0, 100, 50, 50, 50, 50, 100, 0, 100}, 6, NO_CLIP);
    for (int i = 0; i < 500; i++) {
        double x = 52 + i * 0.0213;
        add(&s, ITEM_STROKE, (const double[]){x, 1.79 + i * 0.001, 52 + i * 0.019, 97.3 - i * 0.0006}, 2)->clip = notch;
        s.list.items.v[i].width = 0;
    }
    CHECK(plan_by(&s, 1e-3) == 500); /* so fine a pencil that no two are one line */
    for (size_t i = 0; i < s.strokes.strokes.n; i++)
        CHECK_RANGE(length_of(&s, i), 45, 49);
    clean(&s);
}

/* As exporters that flatten finely leave them, each piece an item of its own. */
static void the_finest_pieces_make_one_line(void)
{
    static const double pieces[] = {.005, .01, .025, .035, .06, .1, .7};
    for (size_t k = 0; k < sizeof pieces / sizeof *pieces; k++) {
        setup s = page(100, 100);
        for (int i = 0; i < 40 / pieces[k]; i++) {
            double x = 10 + i * pieces[k];
            add(&s, ITEM_STROKE, (const double[]){x, 50, x + pieces[k], 50}, 2);
        }
        CHECK(plan(&s) == 1);
        CHECK_RANGE(length_of(&s, 0), 39.8, 41);
        clean(&s);
    }
}

static void fills_close_their_subpaths(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_FILL, (const double[]){10, 10, 50, 10, 50, 50}, 3);
    add(&s, ITEM_STROKE, (const double[]){60, 60, 90, 60, 90, 90}, 3);
    CHECK(plan(&s) == 3 + 2);
    int both = 0, one = 0;
    for (size_t i = 0; i < s.strokes.strokes.n; i++) {
        const stroke *k = &s.strokes.strokes.v[i];
        both += k->corner_first && k->corner_last; /* sides of the closed shape */
        one += k->corner_first != k->corner_last;  /* the two halves of the open line */
    }
    CHECK(both == 3 && one == 2);
    clean(&s);
}

static void even_odd_clips_have_holes(void)
{
    setup s = page(100, 100);
    clip c = {.even_odd = true, .parent = NO_CLIP};
    static const double outer[] = {10, 10, 90, 10, 90, 90, 10, 90}, inner[] = {40, 40, 60, 40, 60, 60, 40, 60};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 4; i++) {
            const double *xy = (k ? inner : outer) + 2 * i;
            CHECK(i ? plb_path_line(&c.path, (point){xy[0], xy[1]}) : plb_path_move(&c.path, (point){xy[0], xy[1]}));
        }
    int index;
    CHECK(plb_list_add_clip(&s.list, &c, &index, NULL));
    add(&s, ITEM_STROKE, (const double[]){0, 50, 100, 50}, 2)->clip = index;
    CHECK(plan(&s) == 2 && fabs(length_of(&s, 0) - 30) < 1e-9);
    clean(&s);
}

static void the_page_clips(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){-500, 50, 500, 50}, 2);
    add(&s, ITEM_STROKE, (const double[]){-500, -50, 500, -50}, 2);
    add(&s, ITEM_STROKE, (const double[]){0, 0, 100, 0}, 2); /* along the edge: it stays */
    CHECK(plan(&s) == 2 && fabs(length_of(&s, 0) - 100) < 0.2);
    clean(&s);
}

static void white_leaves_no_mark(void)
{
    setup s = page(100, 100);
    const double square[] = {10, 10, 50, 10, 50, 50, 10, 50, 10, 10};
    add(&s, ITEM_FILL, square, 5)->paint = (paint){PAINT_SOLID, 1, 1, 1, 1};
    add(&s, ITEM_FILL, square, 5)->paint = (paint){PAINT_SOLID, 0, 0, 0, 0.001};
    CHECK(plan(&s) == 0);
    plb_stroke_list_free(&s.strokes);
    add(&s, ITEM_FILL, square, 5)->paint = (paint){PAINT_SOLID, 1, 1, 0, 1};
    CHECK(plan(&s) == 4);
    clean(&s);
}

static void a_filled_and_stroked_shape_is_outlined_once(void)
{
    setup s = page(100, 100);
    const double square[] = {10, 10, 50, 10, 50, 50, 10, 50, 10, 10};
    add(&s, ITEM_FILL, square, 5);
    add(&s, ITEM_STROKE, square, 5);
    CHECK(plan(&s) == 4);
    clean(&s);
}

/* Returns the stroke that starts at this place. */
static const stroke *starting_at(const setup *s, double x, double y)
{
    for (size_t i = 0; i < s->strokes.strokes.n; i++) {
        const stroke *k = &s->strokes.strokes.v[i];
        if (plb_point_distance(s->strokes.points.v[k->first], (point){x, y}) < 1e-6)
            return k;
    }
    CHECK(false);
    return &s->strokes.strokes.v[0];
}

static void identities_are_distinct_and_stable(void)
{
    setup s = page(100, 100), t = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){10, 10, 50, 10}, 2);
    add(&s, ITEM_STROKE, (const double[]){10, 20, 50, 20}, 2);
    add(&t, ITEM_STROKE, (const double[]){70, 70, 80, 80}, 2); /* something else before */
    add(&t, ITEM_STROKE, (const double[]){50, 10, 10, 10}, 2); /* given the other way round */
    CHECK(plan(&s) == 2 && plan(&t) == 2);
    CHECK(starting_at(&s, 10, 10)->identity != starting_at(&s, 10, 20)->identity);
    CHECK(starting_at(&s, 10, 10)->identity == starting_at(&t, 10, 10)->identity);
    clean(&s);
    clean(&t);
}

static const paint white = {PAINT_SOLID, 1, 1, 1, 1}, glass = {PAINT_SOLID, 1, 1, 1, .5}, grey = {PAINT_SOLID, .9, .9, .9, 1};
static const double square[] = {40, 40, 60, 40, 60, 60, 40, 60};

static void opaque_areas_hide_what_came_before(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){10, 50, 90, 50}, 2);
    add(&s, ITEM_FILL, square, 4)->paint = white;
    add(&s, ITEM_STROKE, (const double[]){50, 10, 50, 90}, 2); /* later: it stays */
    CHECK(plan(&s) == 3);
    CHECK(fabs(length_of(&s, 0) - 30) < 1e-9 && fabs(length_of(&s, 1) - 30) < 1e-9 && fabs(length_of(&s, 2) - 80) < 1e-9);
    clean(&s);
}

static void glass_hides_nothing(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){10, 50, 90, 50}, 2);
    add(&s, ITEM_FILL, square, 4)->paint = glass;
    CHECK(plan(&s) == 1);
    clean(&s);
}

/* An area hides only where its clip leaves it. */
static void clipped_areas_hide_within_their_clip(void)
{
    setup s = page(100, 100);
    int half = add_clip(&s, (const double[]){0, 0, 50, 0, 50, 100, 0, 100}, 4, NO_CLIP);
    add(&s, ITEM_STROKE, (const double[]){10, 50, 90, 50}, 2);
    item *it = add(&s, ITEM_FILL, square, 4);
    it->paint = white;
    it->clip = half;
    CHECK(plan(&s) == 2);
    CHECK(fabs(length_of(&s, 0) - 30) < 1e-9 && fabs(length_of(&s, 1) - 40) < 1e-9);
    clean(&s);
}

static void neighbours_keep_their_outlines(void)
{
    setup s = page(100, 100);
    const double right[] = {60, 40, 80, 40, 80, 60, 60, 60};
    add(&s, ITEM_FILL, square, 4)->paint = grey;
    add(&s, ITEM_FILL, right, 4)->paint = grey;
    size_t n = plan(&s);
    double sum = 0; /* of seven sides: the shared one is there once */
    for (size_t i = 0; i < n; i++)
        sum += length_of(&s, i);
    CHECK(n == 5);
    CHECK_RANGE(sum, 140 - 1e-6, 140 + 1e-6);
    clean(&s);
}

/* Two overlapping squares of one paint: the outline of both together, two sides of each cut short. */
static void shapes_of_one_paint_are_one(void)
{
    setup s = page(100, 100);
    const double other[] = {50, 50, 70, 50, 70, 70, 50, 70};
    add(&s, ITEM_FILL, square, 4)->paint = grey;
    add(&s, ITEM_FILL, other, 4)->paint = grey;
    size_t n = plan(&s);
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += length_of(&s, i);
    CHECK(n == 8);
    CHECK_RANGE(sum, 120 - 1e-6, 120 + 1e-6);
    clean(&s);
}

/* Three circles in a row, the outline of all: as long as it should be. */
static void circles_of_one_paint_are_one(void)
{
    setup s = page(120, 60);
    for (int i = 0; i < 3; i++) {
        item it = {.kind = ITEM_FILL, .paint = grey, .clip = NO_CLIP};
        CHECK(plb_path_arc(&it.path, (point){35 + 25 * i, 30}, 22, 0, 2 * PLB_PI, false, MATRIX_IDENTITY) && plb_path_close(&it.path));
        CHECK(plb_list_add(&s.list, &it, NULL));
    }
    size_t n = plan(&s);
    double sum = 0, seen = 2 * PLB_PI * 22 * 3 - 4 * 2 * 22 * acos(12.5 / 22);
    for (size_t i = 0; i < n; i++)
        sum += length_of(&s, i);
    CHECK_RANGE(sum, seen - 1, seen + 1);
    clean(&s);
}

/* The cap of a wide line hides a half disc, not a half square. */
static void round_caps_hide_round(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){50, 16, 90, 16}, 2); /* beside the disc, within the square */
    add(&s, ITEM_STROKE, (const double[]){10, 18, 90, 18}, 2);
    item *it = add(&s, ITEM_STROKE, (const double[]){50, 20, 50, 80}, 2);
    it->paint = white;
    it->width = 10;
    it->cap = LINE_CAP_ROUND;
    size_t n = plan(&s);
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += length_of(&s, i);
    CHECK_RANGE(sum, 40 - 3 + 80 - 2 * sqrt(25 - 4) - .2, 40 - 3 + 80 - 2 * sqrt(25 - 4) + .2);
    clean(&s);
}

static void holes_hide_nothing(void)
{
    setup s = page(100, 100);
    item *it = add(&s, ITEM_STROKE, (const double[]){10, 50, 90, 50}, 2);
    const double inner[] = {45, 45, 55, 45, 55, 55, 45, 55};
    it = add(&s, ITEM_FILL, square, 4);
    it->paint = white;
    it->even_odd = true;
    for (int i = 0; i < 4; i++)
        CHECK(i ? plb_path_line(&it->path, (point){inner[2 * i], inner[2 * i + 1]}) : plb_path_move(&it->path, (point){inner[0], inner[1]}));
    CHECK(plan(&s) == 3 && fabs(length_of(&s, 1) - 10) < 1e-9);
    clean(&s);
}

static void wide_white_lines_hide(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){10, 50, 90, 50}, 2);
    item *it = add(&s, ITEM_STROKE, (const double[]){50, 20, 50, 80}, 2);
    it->paint = white;
    it->width = 10;
    CHECK(plan(&s) == 2 && fabs(length_of(&s, 0) - 35) < 1e-9 && fabs(length_of(&s, 1) - 35) < 1e-9);
    clean(&s);
}

/* A grid of areas and many lines: against asking each area in turn. */
static void hiding_is_the_same_as_a_plain_search(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){1, 3, 99, 97}, 2);
    for (int i = 0; i < 300; i++) {
        double x = i * 7919 % 9700 / 100.0, y = i * 6101 % 8900 / 100.0;
        const double small[] = {x, y, x + 2, y, x + 2, y + 1.5, x, y + 1.5};
        add(&s, ITEM_FILL, small, 4)->paint = white;
    }
    size_t n = plan(&s);
    double sum = 0, seen = 0, whole = hypot(98, 94);
    for (size_t i = 0; i < n; i++)
        sum += length_of(&s, i);
    for (int k = 0; k < 100000; k++) {
        double x = 1 + 98 * (k + .5) / 1e5, y = 3 + 94 * (k + .5) / 1e5;
        bool hidden = false;
        for (int i = 0; i < 300; i++) {
            double left = i * 7919 % 9700 / 100.0, top = i * 6101 % 8900 / 100.0;
            hidden = hidden || (x > left && x < left + 2 && y > top && y < top + 1.5);
        }
        seen += !hidden * whole / 1e5;
    }
    CHECK(n > 5);
    CHECK_RANGE(sum, seen - .5, seen + .5);
    clean(&s);
}

static float pressure(const setup *s, size_t i)
{
    return s->strokes.strokes.v[i].style.pressure;
}

static void weight_and_tone_are_pressure(void)
{
    setup s = page(100, 100);
    for (int i = 0; i < 5; i++) /* most lines are of one width: it is the usual one */
        add(&s, ITEM_STROKE, (const double[]){10, 10 + i, 90, 10 + i}, 2);
    add(&s, ITEM_STROKE, (const double[]){10, 50, 90, 50}, 2)->width = .6;
    add(&s, ITEM_STROKE, (const double[]){10, 60, 90, 60}, 2)->width = .1;
    add(&s, ITEM_STROKE, (const double[]){10, 70, 90, 70}, 2)->paint = grey;
    CHECK(plan(&s) == 8);
    CHECK(pressure(&s, 0) == 1 && pressure(&s, 4) == 1);
    CHECK(pressure(&s, 5) > 1.2 && pressure(&s, 6) < .8 && pressure(&s, 7) < .5);
    clean(&s);
}

/* A line of 4 mm: passes side by side fill its width and do not leave it. */
static void wide_lines_are_passes(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){10, 50, 90, 50}, 2)->width = 4;
    size_t n = plan(&s);
    CHECK(n >= 8 && n <= 40);
    double low = 100, high = 0;
    for (size_t i = 0; i < s.strokes.points.n; i++) {
        low = fmin(low, s.strokes.points.v[i].y);
        high = fmax(high, s.strokes.points.v[i].y);
    }
    CHECK_RANGE(low, 48, 48.3);
    CHECK_RANGE(high, 51.7, 52);
    clean(&s);
}

static void pieces_of_a_line_are_one_stroke(void)
{
    setup s = page(100, 100);
    for (int i = 0; i < 9; i++) { /* in pieces, some turned round, with one that crosses at a joint */
        double x = 10 + 9 * (i * 5 % 9), y = 20 + x / 3;
        add(&s, ITEM_STROKE, i & 1 ? (const double[]){x, y, x + 9, y + 3} : (const double[]){x + 9, y + 3, x, y}, 2);
    }
    add(&s, ITEM_STROKE, (const double[]){19, 10, 19, 80}, 2);
    CHECK(plan(&s) == 2);
    CHECK(s.strokes.strokes.v[0].n == 2 && s.strokes.strokes.v[1].n == 2);
    clean(&s);
}

static void other_pressure_or_a_corner_ends_a_line(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){10, 20, 50, 20}, 2);
    add(&s, ITEM_STROKE, (const double[]){50, 20, 90, 20}, 2)->paint = grey;
    add(&s, ITEM_STROKE, (const double[]){10, 50, 50, 50}, 2);
    add(&s, ITEM_STROKE, (const double[]){50, 50, 50, 90}, 2);
    CHECK(plan(&s) == 4);
    size_t corners = 0; /* of the last two, where they meet */
    for (size_t i = 0; i < 4; i++)
        corners += s.strokes.strokes.v[i].corner_first + s.strokes.strokes.v[i].corner_last;
    CHECK(corners == 2);
    clean(&s);
}

/* A circle in 24 chords, separate lines: one closed curve, rounder than it was. */
static void chords_become_a_circle(void)
{
    setup s = page(100, 100);
    for (int i = 0; i < 24; i++) {
        double a = 2 * PLB_PI * i / 24, b = 2 * PLB_PI * (i + 1) / 24;
        add(&s, ITEM_STROKE, (const double[]){50 + 20 * cos(a), 50 + 20 * sin(a), 50 + 20 * cos(b), 50 + 20 * sin(b)}, 2);
    }
    CHECK(plan(&s) == 1 && s.strokes.strokes.v[0].closed);
    for (size_t i = 1; i < s.strokes.points.n; i++)
        CHECK_RANGE(plb_point_distance(point_mix(s.strokes.points.v[i - 1], s.strokes.points.v[i], .5), (point){50, 50}), 19.93, 20.03);
    clean(&s);
}

static void a_shallow_bend_stays(void)
{
    setup s = page(200, 100);
    add(&s, ITEM_STROKE, (const double[]){10, 50, 100, 40, 190, 50}, 3);
    CHECK(plan(&s) == 1 && s.strokes.points.n == 3);
    clean(&s);
}

static void lines_drawn_twice_are_drawn_once(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){10, 20, 70, 20}, 2);
    add(&s, ITEM_STROKE, (const double[]){70, 20.01, 10, 20}, 2);     /* the same, back */
    add(&s, ITEM_STROKE, (const double[]){30, 20, 50, 20}, 2);        /* a part */
    add(&s, ITEM_STROKE, (const double[]){60, 20, 95, 20}, 2);        /* goes beyond: joined to it */
    add(&s, ITEM_STROKE, (const double[]){10, 21, 70, 21}, 2);        /* another line */
    add(&s, ITEM_STROKE, (const double[]){10, 15, 90, 25}, 2);        /* one that crosses at a flat angle */
    CHECK(plan(&s) == 3);
    double sum = 0;
    for (size_t i = 0; i < 3; i++)
        sum += length_of(&s, i);
    CHECK_RANGE(sum, 85 + 60 + hypot(80, 10) - .01, 85 + 60 + hypot(80, 10) + .01);
    clean(&s);
}

/* A faint line first, a strong one upon it: both are there. */
static void a_faint_line_stands_for_no_strong_one(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){10, 20, 70, 20}, 2)->paint = grey;
    add(&s, ITEM_STROKE, (const double[]){10, 20, 70, 20}, 2);
    CHECK(plan(&s) == 2);
    clean(&s);
}

/* The way of the pencil through a scattered crowd of short lines is a small part of what it was. */
static void near_lines_are_drawn_together(void)
{
    setup s = page(200, 200);
    unsigned seed = 3;
    double given = 0, way = 0;
    point before = {0, 0};
    for (int i = 0; i < 1000; i++) {
        seed = seed * 1664525u + 1013904223u;
        double x = (seed >> 8) % 1900 / 10.0;
        seed = seed * 1664525u + 1013904223u;
        double y = (seed >> 8) % 1900 / 10.0;
        add(&s, ITEM_STROKE, (const double[]){x, y, x + 3, y + 1}, 2);
        given += plb_point_distance(before, (point){x, y});
        before = (point){x + 3, y + 1};
    }
    size_t n = plan(&s);
    before = (point){0, 0};
    for (size_t i = 0; i < n; i++) {
        const stroke *k = &s.strokes.strokes.v[i];
        way += plb_point_distance(before, s.strokes.points.v[k->first]);
        before = s.strokes.points.v[k->first + k->n - 1];
    }
    CHECK(n > 900);
    CHECK_RANGE(way, 0, given / 10);
    clean(&s);
}

static void lines_are_pulled_rightwards_or_down(void)
{
    setup s = page(100, 100);
    add(&s, ITEM_STROKE, (const double[]){70, 20, 10, 20}, 2);
    add(&s, ITEM_STROKE, (const double[]){40, 90, 40, 30}, 2);
    CHECK(plan(&s) == 2);
    for (size_t i = 0; i < 2; i++) {
        const point *v = s.strokes.points.v + s.strokes.strokes.v[i].first;
        CHECK(v[0].x < v[1].x || v[0].y < v[1].y);
    }
    clean(&s);
}

int main(void)
{
    RUN(corners_end_strokes);
    RUN(closed_shapes_start_at_a_corner);
    RUN(circles_are_one_closed_stroke);
    RUN(dashes_are_strokes);
    RUN(fine_dashes_are_made_larger);
    RUN(mad_dashes_are_bounded);
    RUN(clips_keep_every_piece);
    RUN(level_clip_edges_cut_every_line);
    RUN(the_finest_pieces_make_one_line);
    RUN(fills_close_their_subpaths);
    RUN(even_odd_clips_have_holes);
    RUN(the_page_clips);
    RUN(white_leaves_no_mark);
    RUN(a_filled_and_stroked_shape_is_outlined_once);
    RUN(identities_are_distinct_and_stable);
    RUN(opaque_areas_hide_what_came_before);
    RUN(glass_hides_nothing);
    RUN(clipped_areas_hide_within_their_clip);
    RUN(neighbours_keep_their_outlines);
    RUN(holes_hide_nothing);
    RUN(shapes_of_one_paint_are_one);
    RUN(circles_of_one_paint_are_one);
    RUN(round_caps_hide_round);
    RUN(wide_white_lines_hide);
    RUN(hiding_is_the_same_as_a_plain_search);
    RUN(weight_and_tone_are_pressure);
    RUN(wide_lines_are_passes);
    RUN(pieces_of_a_line_are_one_stroke);
    RUN(other_pressure_or_a_corner_ends_a_line);
    RUN(chords_become_a_circle);
    RUN(a_shallow_bend_stays);
    RUN(lines_drawn_twice_are_drawn_once);
    RUN(a_faint_line_stands_for_no_strong_one);
    RUN(near_lines_are_drawn_together);
    RUN(lines_are_pulled_rightwards_or_down);
    CHECK_EXIT;
}
