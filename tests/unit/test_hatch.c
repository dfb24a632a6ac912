/* SPDX-License-Identifier: MIT
 *
 * Fills become hatching: where its lines lie, how many there are, what is solid, what is paper.
 */
#include "check.h"

#include "plan/hatch/hatch.h"
#include "plan/hatch/hatch_shape.h"
#include "plan/shape/region.h"

typedef struct {
    size_t n;
    double length, least_pressure;
    double along; /* x, of all of them */
    box bounds;
    point hole; /* no line may pass closer than `keep` to it */
    double keep, closest;
} tally;

static double distance(point p, point a, point b)
{
    point d = point_sub(b, a);
    double t = point_dot(point_sub(p, a), d) / point_dot(d, d);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return plb_point_distance(point_mix(a, b, t), p);
}

static void count(void *closure, const track *t)
{
    tally *k = closure;
    k->n++;
    k->least_pressure = fmin(k->least_pressure, (double)t->style.pressure);
    CHECK(t->style.kind == STROKE_HATCH && t->style.pressure > 0 && t->n >= 2);
    for (size_t i = 0; i < t->n; i++) {
        plb_box_add(&k->bounds, t->v[i].at);
        if (i > 0) {
            k->length += plb_point_distance(t->v[i - 1].at, t->v[i].at);
            k->along += fabs(t->v[i].at.x - t->v[i - 1].at.x);
            k->closest = fmin(k->closest, distance(k->hole, t->v[i - 1].at, t->v[i].at));
        }
    }
}

/* Hatches a fill and shows each mark. */
static bool hatch_fill(const hatcher *h, const item *fill, bool *outline, void (*show)(void *closure, const track *t), void *closure)
{
    track_list marks = {0};
    error err = {ERROR_NONE, ""};
    bool ok = plb_plan_hatch(h, fill, 0, outline, &marks, &err);
    for (size_t i = 0; i < marks.tracks.n; i++) {
        track t = plb_track_at(&marks, i);
        show(closure, &t);
    }
    plb_tracks_free(&marks);
    return ok;
}

static item fill_of(double grey)
{
    return (item){.kind = ITEM_FILL, .paint = {PAINT_SOLID, grey, grey, grey, 1}, .clip = NO_CLIP};
}

static const tone_curve plain = {2, {0, 1}, {0, 1}};
static const paint_manners none = {.n = 0};

static void polygon(item *it, const double *xy, int n)
{
    for (int i = 0; i < n; i++) {
        point p = {xy[2 * i], xy[2 * i + 1]};
        CHECK(i ? plb_path_line(&it->path, p) : plb_path_move(&it->path, p));
    }
    CHECK(plb_path_close(&it->path));
}

static void rectangle(item *it, double x0, double y0, double x1, double y1)
{
    polygon(it, (const double[]){x0, y0, x1, y0, x1, y1, x0, y1}, 4);
}

/* Hatches a fill on a page of 100 x 100 mm that has nothing else. */
static tally hatch(item *it, uint64_t seed, bool *outline)
{
    plan_options how = plb_plan_options_default();
    how.seed = seed;
    display_list list;
    plb_list_init(&list);
    list.width = list.height = 100;
    list.items.v = it;
    list.items.n = 1;
    hatcher h = plb_hatcher(&list, &how, &plain, &none);
    tally k = {.bounds = BOX_EMPTY, .least_pressure = 1e9, .hole = {50, 50}, .closest = 1e9};
    CHECK(hatch_fill(&h, it, outline, count, &k));
    return k;
}

static void a_square_is_covered_to_its_edges(void)
{
    item it = fill_of(.6);
    bool outline = false;
    rectangle(&it, 20, 20, 60, 50);
    tally k = hatch(&it, 1, &outline);
    CHECK(outline);
    CHECK_RANGE(k.bounds.x0, 19.5, 20.6);
    CHECK_RANGE(k.bounds.y0, 19.5, 20.6);
    CHECK_RANGE(k.bounds.x1, 59.4, 60.5);
    CHECK_RANGE(k.bounds.y1, 49.4, 50.5);
    plb_item_free(&it);
}

static void darker_takes_more_lines(void)
{
    double before = 0;
    for (int k = 9; k >= 0; k--) {
        item it = fill_of(k / 10.0);
        bool outline;
        rectangle(&it, 20, 20, 60, 60);
        tally t = hatch(&it, 1, &outline);
        CHECK(t.length > before);
        before = t.length;
        plb_item_free(&it);
    }
    CHECK(before > 40 * 40 / .35); /* black is covered more than once */
}

static void faint_tones_are_left_to_the_paper(void)
{
    item it = fill_of(.98);
    bool outline = false;
    rectangle(&it, 20, 20, 60, 60);
    CHECK(hatch(&it, 1, &outline).n == 0 && outline);
    plb_item_free(&it);
}

static void a_light_page_is_paper_but_a_dark_one_is_shaded(void)
{
    item light = fill_of(.8), dark = fill_of(.2);
    bool outline = true;
    rectangle(&light, 0, 0, 100, 100);
    CHECK(hatch(&light, 1, &outline).n == 0 && !outline);
    rectangle(&dark, 0, 0, 100, 100);
    CHECK(hatch(&dark, 1, &outline).n > 100 && outline);
    plb_item_free(&light);
    plb_item_free(&dark);
}

static void two_squares(item *it, bool even_odd, bool inner_backwards)
{
    static const double there[] = {35, 35, 65, 35, 65, 65, 35, 65}, back[] = {35, 35, 35, 65, 65, 65, 65, 35};
    it->even_odd = even_odd;
    rectangle(it, 20, 20, 80, 80);
    polygon(it, inner_backwards ? back : there, 4);
}

static void holes_stay_free_by_either_rule(void)
{
    for (int k = 0; k < 4; k++) {
        item it = fill_of(.4);
        bool outline, has_hole = k & 1 || k & 2;
        two_squares(&it, k & 1, k & 2);
        tally t = hatch(&it, 1, &outline);
        if (has_hole)
            CHECK_RANGE(t.closest, 14.5, 16);
        else
            CHECK_RANGE(t.closest, 0, 1);
        plb_item_free(&it);
    }
}

/* A five-pointed star in one stroke: its middle is filled by the nonzero rule alone. */
static void a_star_that_crosses_itself(void)
{
    for (int k = 0; k < 2; k++) {
        item it = fill_of(.4);
        bool outline;
        double xy[10];
        for (int i = 0; i < 5; i++) {
            xy[2 * i] = 50 + 40 * sin(i * 4 * PLB_PI / 5);
            xy[2 * i + 1] = 50 - 40 * cos(i * 4 * PLB_PI / 5);
        }
        it.even_odd = k;
        polygon(&it, xy, 5);
        tally t = hatch(&it, 1, &outline);
        CHECK_RANGE(t.closest, k ? 11 : 0, k ? 14 : 1);
        plb_item_free(&it);
    }
}

static void measures_of_a_bar(void)
{
    item it = fill_of(0);
    shape s;
    matrix turn = plb_matrix_rotate(.5);
    rectangle(&it, 10, 20, 50, 24);
    plb_path_transform(&it.path, turn);
    CHECK(plb_shape_init(&s, &it, NULL));
    CHECK_RANGE(s.area, 160 * .99, 160 * 1.01);
    CHECK_RANGE(s.axis, .48, .52);
    CHECK_RANGE(s.elongation, 9.5, 10.5);
    CHECK_RANGE(s.perimeter, 87.99, 88.01);
    CHECK(s.is_convex);
    point middle = plb_matrix_apply(turn, (point){30, 22});
    CHECK(plb_point_distance(s.centre, middle) < .1);
    plb_shape_free(&s);
    plb_item_free(&it);
}

static void long_shapes_are_hatched_along_their_axis(void)
{
    item it = fill_of(.7);
    bool outline;
    rectangle(&it, 10, 45, 90, 55);
    tally t = hatch(&it, 1, &outline);
    CHECK(t.along > .95 * t.length);
    plb_item_free(&it);
}

/* Tall bars of a chart beside short ones: one direction; squares of another tone have the hand's own. */
static void shapes_of_one_tone_share_a_direction(void)
{
    plan_options how = plb_plan_options_default();
    display_list list;
    plb_list_init(&list);
    list.width = list.height = 100;
    for (int i = 0; i < 8; i++) {
        item it = fill_of(i == 7 ? .3 : .7);
        rectangle(&it, 10 * i + 5, i == 2 || i == 7 ? 82 : 20, 10 * i + 12, 90);
        CHECK(plb_list_add(&list, &it, NULL));
    }
    hatcher h = plb_hatcher(&list, &how, &plain, &none);
    for (size_t i = 0; i < 7; i++)
        CHECK_RANGE(fabs(plb_hatch_direction(&h, &list.items.v[i])), PLB_PI / 2 - .01, PLB_PI / 2 + .01);
    CHECK(plb_hatch_direction(&h, &list.items.v[7]) == HATCH_HABIT);
    plb_list_free(&list);
}

static void a_thin_bar_is_one_stroke_and_a_dot_a_dab(void)
{
    item bar = fill_of(0), dot = fill_of(0), larger = fill_of(0);
    bool outline = true;
    rectangle(&bar, 20, 20, 40, 20.4);
    tally t = hatch(&bar, 1, &outline);
    CHECK(t.n == 1 && !outline && t.bounds.x0 >= 20 && t.bounds.x1 <= 40);
    CHECK(plb_path_arc(&dot.path, (point){50, 50}, .3, 0, 2 * PLB_PI, false, MATRIX_IDENTITY));
    t = hatch(&dot, 1, &outline);
    CHECK(t.n >= 1 && t.n <= 3 && !outline && t.bounds.x0 >= 49.7 && t.bounds.x1 <= 50.3);
    CHECK(plb_path_arc(&larger.path, (point){50, 50}, 1, 0, 2 * PLB_PI, false, MATRIX_IDENTITY));
    t = hatch(&larger, 1, &outline); /* back and forth, then round: all inside */
    CHECK(t.n == 2 || t.n == 3);
    CHECK(!outline && t.bounds.x0 > 49.03 && t.bounds.x1 < 50.97 && t.bounds.y0 > 49.03 && t.bounds.y1 < 50.97);
    plb_item_free(&bar);
    plb_item_free(&dot);
    plb_item_free(&larger);
}

static void an_arrowhead_is_scribbled_inside(void)
{
    item it = fill_of(0);
    bool outline = true;
    polygon(&it, (const double[]){50, 50, 54, 48.8, 54, 51.2}, 3);
    tally t = hatch(&it, 1, &outline);
    region *r = plb_region_new(&it.path, false, NULL);
    CHECK(r && !outline && t.n >= 2 && t.length > 4 * 2.4 / 2 / .35); /* enough to cover it */
    CHECK(t.bounds.x0 > 50 && t.bounds.x1 < 54 && t.bounds.y0 > 48.8 && t.bounds.y1 < 51.2);
    plb_region_free(r);
    plb_item_free(&it);
}

static void another_seed_moves_every_line(void)
{
    item it = fill_of(.5);
    bool outline;
    rectangle(&it, 20, 20, 60, 50);
    tally a = hatch(&it, 1, &outline), b = hatch(&it, 1, &outline), c = hatch(&it, 2, &outline);
    CHECK(a.length == b.length && a.n == b.n);
    CHECK(a.length != c.length);
    plb_item_free(&it);
}

/* A shape of 200,000 corners on a page of 10 m, and one as large as the world: bounded work, within the page. */
static void huge_shapes_stay_in_bounds(void)
{
    item it = fill_of(.1);
    display_list list;
    plan_options how = plb_plan_options_default();
    tally k = {.bounds = BOX_EMPTY, .least_pressure = 1e9, .closest = 1e9};
    plb_list_init(&list);
    list.width = list.height = 1e4;
    for (int i = 0; i < 200000; i++) {
        double a = 2 * PLB_PI * i / 200000, r = i % 2 ? 4900 : 4890;
        point p = {5000 + r * cos(a), 5000 + r * sin(a)};
        CHECK(i ? plb_path_line(&it.path, p) : plb_path_move(&it.path, p));
    }
    CHECK(plb_list_add(&list, &it, NULL));
    it = fill_of(.1);
    polygon(&it, (const double[]){-9e6, -9e6, 9e6, -9e6, 0, 9e6}, 3);
    CHECK(plb_list_add(&list, &it, NULL));
    hatcher h = plb_hatcher(&list, &how, &plain, &none);
    bool outline;
    for (size_t i = 0; i < list.items.n; i++)
        CHECK(hatch_fill(&h, &list.items.v[i], &outline, count, &k));
    CHECK_RANGE((double)k.n, 1e5, 3e6);
    CHECK(k.bounds.x0 > -5000 && k.bounds.x1 < 15000 && k.bounds.y0 > -5000 && k.bounds.y1 < 15000);
    plb_list_free(&list);
}

/* How much of the marks, mm times pressure, lies in each third of the way from x = 20 to 80. */
typedef struct {
    double ink[3];
} thirds;

static void count_thirds(void *closure, const track *t)
{
    thirds *k = closure;
    for (size_t i = 1; i < t->n; i++) {
        point a = t->v[i - 1].at, b = t->v[i].at;
        int which = (int)(((a.x + b.x) / 2 - 20) / 20);
        k->ink[which < 0 ? 0 : which > 2 ? 2 : which] += plb_point_distance(a, b) * (double)t->style.pressure;
    }
}

static void gradients_are_hatched_by_their_local_tone(void)
{
    plan_options how = plb_plan_options_default();
    display_list list;
    item it = fill_of(.5);
    gradient g = {.from = {20, 0}, .to = {80, 0}, .extend = GRADIENT_PAD, .to_space = MATRIX_IDENTITY, .opacity = 1};
    thirds k = {{0, 0, 0}};
    bool outline = false;
    plb_list_init(&list);
    list.width = list.height = 100;
    it.paint.kind = PAINT_GRADIENT;
    plb_gradient_add_stop(&g, (gradient_stop){0, .1f, .1f, .1f, 1});
    plb_gradient_add_stop(&g, (gradient_stop){1, 1, 1, 1, 1});
    CHECK(plb_list_add_gradient(&list, &g, &it.gradient, NULL));
    CHECK(it.gradient == 1);
    rectangle(&it, 20, 20, 80, 60);
    CHECK(plb_list_add(&list, &it, NULL));
    hatcher h = plb_hatcher(&list, &how, &plain, &none);
    CHECK(hatch_fill(&h, &list.items.v[0], &outline, count_thirds, &k));
    CHECK(outline && k.ink[0] > 1.7 * k.ink[1] && k.ink[1] > 2.2 * k.ink[2] && k.ink[2] > 0);
    plb_list_free(&list);
}

static void slivers_and_nothing(void)
{
    item flat = fill_of(0), point_like = fill_of(0), sliver = fill_of(0);
    bool outline;
    polygon(&flat, (const double[]){10, 10, 30, 10, 20, 10}, 3);
    polygon(&point_like, (const double[]){10, 10, 10, 10}, 2);
    polygon(&sliver, (const double[]){10, 10, 90, 10.01, 10, 10.02}, 3);
    CHECK(hatch(&flat, 1, &outline).n == 0 && outline);
    CHECK(hatch(&point_like, 1, &outline).n == 0);
    CHECK(hatch(&sliver, 1, &outline).n <= 2);
    plb_item_free(&flat);
    plb_item_free(&point_like);
    plb_item_free(&sliver);
}

int main(void)
{
    RUN(a_square_is_covered_to_its_edges);
    RUN(darker_takes_more_lines);
    RUN(faint_tones_are_left_to_the_paper);
    RUN(a_light_page_is_paper_but_a_dark_one_is_shaded);
    RUN(holes_stay_free_by_either_rule);
    RUN(a_star_that_crosses_itself);
    RUN(measures_of_a_bar);
    RUN(long_shapes_are_hatched_along_their_axis);
    RUN(shapes_of_one_tone_share_a_direction);
    RUN(a_thin_bar_is_one_stroke_and_a_dot_a_dab);
    RUN(an_arrowhead_is_scribbled_inside);
    RUN(another_seed_moves_every_line);
    RUN(huge_shapes_stay_in_bounds);
    RUN(gradients_are_hatched_by_their_local_tone);
    RUN(slivers_and_nothing);
    CHECK_EXIT;
}
