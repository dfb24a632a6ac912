/* SPDX-License-Identifier: MIT
 *
 * Which tone a fill gets: cells as one area, tones that carry words, manners that tell paints apart.
 */
#include "check.h"

#include "plan/tone/crowd.h"
#include "plan/tone/cells.h"
#include "plan/tone/manners.h"
#include "plan/tone/tone_curve.h"

#include <math.h>

static display_list page(void)
{
    display_list list;
    plb_list_init(&list);
    list.width = list.height = 100;
    return list;
}

static void fill(display_list *list, double x, double y, double w, double h, double grey)
{
    item it = {.kind = ITEM_FILL, .paint = {PAINT_SOLID, grey, grey, grey, 1}, .clip = NO_CLIP};
    CHECK(plb_path_move(&it.path, (point){x, y}) && plb_path_line(&it.path, (point){x + w, y}) && plb_path_line(&it.path, (point){x + w, y + h}) &&
          plb_path_line(&it.path, (point){x, y + h}) && plb_path_close(&it.path));
    CHECK(plb_list_add(list, &it, NULL));
}

static void line(display_list *list, double x0, double y0, double x1, double y1)
{
    item it = {.kind = ITEM_STROKE, .paint = {PAINT_SOLID, 0, 0, 0, 1}, .clip = NO_CLIP, .width = 0.3};
    CHECK(plb_path_move(&it.path, (point){x0, y0}) && plb_path_line(&it.path, (point){x1, y1}));
    CHECK(plb_list_add(list, &it, NULL));
}

static plan_options hatching(void)
{
    plan_options o = plb_plan_options_default();
    o.fill = FILL_HATCH;
    return o;
}

typedef struct {
    clipper *clips;
    occluders *occluders;
    cell_groups *cells;
} groups;

static groups find_groups(const display_list *list, const plan_options *o)
{
    groups g = {.clips = plb_clipper_new(list, NULL)};
    g.occluders = plb_occluders_new(list, o, g.clips, NULL);
    g.cells = plb_cells_new(list, g.occluders, NULL);
    CHECK(g.cells);
    return g;
}

static void free_groups(groups *g)
{
    plb_cells_free(g->cells);
    plb_occluders_free(g->occluders);
    plb_clipper_free(g->clips);
}

static void cells_that_adjoin_are_one_field(void)
{
    display_list list = page();
    plan_options o = hatching();
    for (int i = 0; i < 100; i++)
        fill(&list, 20 + i % 10 * 2, 20 + i / 10 * 2, 2, 2, i / 110.);
    fill(&list, 60, 60, 1, 1, .5); /* beside them */
    groups g = find_groups(&list, &o);
    CHECK(plb_cells_group(g.cells, 0) == 1 && plb_cells_group(g.cells, 99) == 1 && plb_cells_group(g.cells, 100) == 0);
    CHECK(plb_cells_is_last(g.cells, 99) && !plb_cells_is_last(g.cells, 98));
    tone_field f;
    CHECK(plb_cells_field(g.cells, 1, &f, NULL));
    for (int i = 0; i < 100; i++)
        CHECK(fabs(plb_field_at(&f, (point){21 + i % 10 * 2, 21 + i / 10 * 2}) - (1 - i / 110.)) < 1e-6);
    CHECK(plb_field_at(&f, (point){19, 25}) == 0 && plb_field_at(&f, (point){25, 41}) == 0);
    plb_field_free(&f);
    free_groups(&g);
    plb_list_free(&list);
}

/* A chessboard of squares of `side` mm, about a third and two thirds dark: gives by how much the two differ in the field. */
static double contrast_of_squares(double side)
{
    display_list list = page();
    plan_options o = hatching();
    tone_field f;
    for (int i = 0; i < 144; i++)
        fill(&list, 20 + i % 12 * side, 20 + i / 12 * side, side, side, ((i % 12 + i / 12) % 2 ? .3 : .6) + i % 7 * .01);
    groups g = find_groups(&list, &o);
    CHECK(plb_cells_group(g.cells, 0) == 1 && plb_cells_field(g.cells, 1, &f, NULL));
    double dark = 0, light = 0;
    for (int i = 0; i < 144; i++) {
        double at = plb_field_at(&f, (point){20 + (i % 12 + .5) * side, 20 + (i / 12 + .5) * side});
        CHECK(at >= 0 && at <= 1);
        *((i % 12 + i / 12) % 2 ? &dark : &light) += at / 72;
    }
    CHECK_RANGE((dark + light) / 2, .49, .55); /* the mean stays */
    plb_field_free(&f);
    free_groups(&g);
    plb_list_free(&list);
    return dark - light;
}

static void small_cells_get_contrast_for_the_pencils_breadth(void)
{
    double of_3 = contrast_of_squares(3), of_1 = contrast_of_squares(1), of_half = contrast_of_squares(.6);
    CHECK_RANGE(of_3, .29, .31);
    CHECK_RANGE(of_1, .32, .37);
    CHECK_RANGE(of_half, .38, .5);
}

/* The same hatching whatever the cells' size: white in the middle of black stays white, and no cell has an outline. */
static void a_field_is_hatched_across_its_cells(void)
{
    display_list list = page();
    plan_options o = hatching();
    stroke_list out;
    for (int i = 0; i < 400; i++)
        fill(&list, 20 + i % 20, 20 + i / 20, 1, 1, i % 20 >= 5 && i % 20 < 15 && i / 20 >= 5 && i / 20 < 15 ? 1 : i % 9 / 40.);
    CHECK(plb_plan(&list, &o, NULL, &out, NULL) && out.strokes.n > 20);
    for (size_t i = 0; i < out.strokes.n; i++) {
        const stroke *s = &out.strokes.v[i];
        point middle = point_mix(out.points.v[s->first], out.points.v[s->first + s->n - 1], .5);
        CHECK(s->style.kind == STROKE_HATCH);
        CHECK(!(middle.x > 26 && middle.x < 34 && middle.y > 26 && middle.y < 34));
    }
    plb_stroke_list_free(&out);
    plb_list_free(&list);
}

/* A chart of few tones, and dots that lie here and there, are no field. */
static void charts_and_dots_are_no_cells(void)
{
    display_list list = page();
    plan_options o = hatching();
    for (int i = 0; i < 30; i++)
        fill(&list, 20 + i % 6, 20 + i / 6, 1, 1, i % 3 / 3.);
    for (int i = 0; i < 30; i++)
        fill(&list, 50 + i % 6 * 1.3, 50 + i / 6 * 1.3, 1, 1, i / 30.);
    groups g = find_groups(&list, &o);
    for (size_t i = 0; i < 60; i++)
        CHECK(plb_cells_group(g.cells, i) == 0);
    free_groups(&g);
    plb_list_free(&list);
}

static tone_curve curve_of(const display_list *list, bool *is_inked)
{
    plan_options o = hatching();
    tone_curve c;
    CHECK(plb_tone_curve_find(list, &o, &c, is_inked, NULL));
    for (int i = 1; i <= 100; i++)
        CHECK(plb_tone_curve_at(&c, i / 100.) >= plb_tone_curve_at(&c, (i - 1) / 100.));
    CHECK(plb_tone_curve_at(&c, 0) == 0 && plb_tone_curve_at(&c, 1) == 1);
    return c;
}

static void tones_below_lines_and_words_are_light(void)
{
    bool is_inked[8] = {false};
    display_list list = page();
    fill(&list, 10, 10, 40, 40, .4);
    line(&list, 60, 60, 90, 60);
    tone_curve beside = curve_of(&list, is_inked);
    CHECK(fabs(plb_tone_curve_at(&beside, .6) - (.6)) < 1e-9);
    line(&list, 15, 20, 45, 30);
    tone_curve below = curve_of(&list, is_inked);
    CHECK(plb_tone_curve_at(&below, .6) < .3 && plb_tone_curve_at(&below, .6) > .2 && plb_tone_curve_at(&below, .9) > .6);
    plb_list_free(&list);
    list = page();
    fill(&list, 10, 10, 40, 40, .4);
    fill(&list, 20, 20, .4, 3, 0); /* a letter */
    tone_curve word = curve_of(&list, is_inked);
    CHECK_RANGE(plb_tone_curve_at(&word, .6), .4, .55); /* hatching is interrupted for words */
    plb_list_free(&list);
}

static void small_white_words_are_written(void)
{
    bool is_inked[8] = {false};
    display_list list = page();
    fill(&list, 10, 10, 80, 80, .1);
    fill(&list, 20, 20, .4, 3, 1);
    fill(&list, 21, 20, .4, 3, 1);
    fill(&list, 60, 60, .8, 6, 1);
    tone_curve c = curve_of(&list, is_inked);
    CHECK(!is_inked[0] && is_inked[1] && is_inked[2] && !is_inked[3]);
    CHECK(plb_tone_curve_at(&c, .9) > .8);
    plb_list_free(&list);
}

static void white_words_on_a_picture_that_is_left_out_are_written(void)
{
    for (unsigned pictures = 0; pictures < 2; pictures++) {
        bool is_inked[8] = {false};
        display_list list = page();
        list.omissions.n[OMISSION_IMAGE] = pictures;
        fill(&list, 10, 10, 80, 80, 1); /* the paper that it leaves */
        fill(&list, 20, 20, .4, 3, 1);
        fill(&list, 60, 60, .8, 6, 1);
        curve_of(&list, is_inked);
        CHECK(!is_inked[0] && is_inked[1] == (pictures > 0) && is_inked[2] == (pictures > 0));
        plb_list_free(&list);
    }
}

/* A white string with brackets is 4.4 mm high, its capitals are not 4. */
static void brackets_make_no_white_word_large(void)
{
    for (int is_known = 0; is_known < 2; is_known++) {
        bool is_inked[8] = {false};
        display_list list = page();
        fill(&list, 10, 10, 80, 80, .1);
        fill(&list, 20, 20, .4, 4.4, 1);
        if (is_known) {
            list.items.v[1].text = plb_new(1, sizeof(text_run));
            CHECK(list.items.v[1].text);
            list.items.v[1].text->em = 3.8;
        }
        curve_of(&list, is_inked);
        CHECK(is_inked[1] == is_known);
        plb_list_free(&list);
    }
}

/* Dots in a row under a line, `n` of them at once on its corners where it has markers: is the line over a crowd, and are the dots? */
static void look_at_crowd(int n, bool on_corners, bool is_first, bool *is_line, bool *are_dots)
{
    crowd_part part[64] = {CROWD_NONE};
    plan_options o = hatching();
    display_list list = page();
    if (is_first)
        line(&list, 5, 50, 95, 50);
    for (int i = 0; i < n; i++)
        fill(&list, 10 + 4 * i, 49.5, 1, 1, .3);
    if (on_corners)
        for (int i = 0; i < n; i++)
            line(&list, 10.5 + 4 * i, 50, 14.5 + 4 * i, 50);
    else if (!is_first)
        line(&list, 5, 50, 95, 50);
    CHECK(plb_crowds_find(&list, &o, part, NULL));
    *is_line = *are_dots = false;
    for (size_t i = 0; i < list.items.n; i++) {
        *is_line = *is_line || part[i] == CROWD_LINE;
        *are_dots = *are_dots || part[i] == CROWD_DOT;
        CHECK(part[i] == CROWD_NONE || (part[i] == CROWD_LINE) == (list.items.v[i].kind == ITEM_STROKE));
    }
    plb_list_free(&list);
}

static void a_line_over_a_crowd_of_dots_is_told_from_them(void)
{
    bool is_line, are_dots;
    look_at_crowd(18, false, false, &is_line, &are_dots);
    CHECK(is_line && are_dots);
    look_at_crowd(4, false, false, &is_line, &are_dots); /* no crowd */
    CHECK(!is_line && !are_dots);
    look_at_crowd(18, true, false, &is_line, &are_dots); /* markers */
    CHECK(!is_line && !are_dots);
    look_at_crowd(18, false, true, &is_line, &are_dots); /* below them: a grid */
    CHECK(!is_line && !are_dots);
}

static void paints_that_look_alike_differ_in_manner(void)
{
    display_list list = page();
    plan_options o = hatching();
    tone_curve plain = plb_tone_curve_plain();
    paint_manners m;
    fill(&list, 10, 10, 20, 20, .60);
    fill(&list, 30, 10, 20, 20, .62);
    fill(&list, 50, 10, 20, 20, .60);
    fill(&list, 10, 50, 20, 20, .92);
    groups g = find_groups(&list, &o);
    CHECK(plb_manners_find(&list, &o, &plain, g.cells, &m, NULL) && m.n == 3);
    manner a = plb_manner_of(&m, &list.items.v[0].paint), b = plb_manner_of(&m, &list.items.v[1].paint);
    manner again = plb_manner_of(&m, &list.items.v[2].paint), light = plb_manner_of(&m, &list.items.v[3].paint);
    CHECK(a.is_told && b.is_told && a.turn != b.turn && a.turn == again.turn && a.coarser == again.coarser && light.turn == a.turn);
    free_groups(&g);
    plb_list_free(&list);
    list = page();
    fill(&list, 10, 10, 20, 20, .5);
    fill(&list, 30, 10, 20, 20, .8);
    g = find_groups(&list, &o);
    CHECK(plb_manners_find(&list, &o, &plain, g.cells, &m, NULL) && !plb_manner_of(&m, &list.items.v[0].paint).is_told);
    free_groups(&g);
    plb_list_free(&list);
}

int main(void)
{
    RUN(cells_that_adjoin_are_one_field);
    RUN(small_cells_get_contrast_for_the_pencils_breadth);
    RUN(a_field_is_hatched_across_its_cells);
    RUN(charts_and_dots_are_no_cells);
    RUN(tones_below_lines_and_words_are_light);
    RUN(small_white_words_are_written);
    RUN(brackets_make_no_white_word_large);
    RUN(a_line_over_a_crowd_of_dots_is_told_from_them);
    RUN(white_words_on_a_picture_that_is_left_out_are_written);
    RUN(paints_that_look_alike_differ_in_manner);
    CHECK_EXIT;
}
