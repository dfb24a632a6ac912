/* SPDX-License-Identifier: MIT
 *
 * Runs of lettering: which fills are one word, and how broad and bold that word is.
 */
#include "check.h"

#include "plan/letter/runs.h"

static void add_box(path *p, double x, double y, double w, double h, bool hole)
{
    point a = {x, y}, b = {x + w, y}, c = {x + w, y + h}, d = {x, y + h};
    CHECK(plb_path_move(p, a) && plb_path_line(p, hole ? d : b) && plb_path_line(p, c) && plb_path_line(p, hole ? b : d) && plb_path_close(p));
}

/* Adds an O of straight sides as high as `size`, with strokes as broad as `stem`. */
static void add_letter(display_list *l, double x, double size, double stem, double red)
{
    item it = {.kind = ITEM_FILL, .paint = {PAINT_SOLID, red, 0, 0, 1}, .clip = NO_CLIP};
    add_box(&it.path, x, 10, size * .8, size, false);
    add_box(&it.path, x + stem, 10 + stem, size * .8 - 2 * stem, size - 2 * stem, true);
    CHECK(plb_list_add(l, &it, NULL));
}

static letter_run run_of(const display_list *l, size_t i)
{
    letter_runs *r = plb_letter_runs_new(l, NULL);
    CHECK(r != NULL);
    letter_run run = r ? plb_letter_run_at(r, i) : (letter_run){0};
    plb_letter_runs_free(r);
    return run;
}

static void letters_beside_each_other_are_one_run(void)
{
    display_list l;
    plb_list_init(&l);
    for (int i = 0; i < 4; i++)
        add_letter(&l, 10 + 4 * i, 4, .4, 0);
    for (size_t i = 0; i < 4; i++) {
        letter_run run = run_of(&l, i);
        CHECK(run.fills == 4 && fabs(run.stem - .4) < 1e-9 && fabs(run.size - 4) < 1e-9 && !run.is_bold);
    }
    plb_list_free(&l);
}

static void another_colour_size_or_place_begins_another_run(void)
{
    display_list l;
    plb_list_init(&l);
    add_letter(&l, 10, 4, .4, 0);
    add_letter(&l, 14, 4, .4, .5);  /* another colour */
    add_letter(&l, 40, 4, .4, .5);  /* far away */
    add_letter(&l, 44, 4, .9, .5);  /* much thicker */
    add_letter(&l, 48, 70, .9, .5); /* no letter */
    for (size_t i = 0; i < 5; i++)
        CHECK(run_of(&l, i).fills == 1);
    CHECK(run_of(&l, 5).fills == 0);
    plb_list_free(&l);
}

static void a_word_on_an_area_of_its_paint_is_a_run_of_its_own(void)
{
    display_list l;
    plb_list_init(&l);
    item area = {.kind = ITEM_FILL, .paint = {PAINT_SOLID, 0, 0, 0, 1}, .clip = NO_CLIP}, word = area;
    add_box(&area.path, 0, 0, 30, 30, false);
    for (int i = 0; i < 3; i++)
        add_box(&word.path, 10 + 3 * i, 10, .4, 4, false);
    CHECK(plb_list_add(&l, &area, NULL) && plb_list_add(&l, &word, NULL));
    CHECK(run_of(&l, 0).fills == 1 && run_of(&l, 1).fills == 1 && run_of(&l, 1).stem < .5);
    plb_list_free(&l);
}

static void broad_stems_make_a_bold_run(void)
{
    display_list l;
    plb_list_init(&l);
    for (int i = 0; i < 3; i++)
        add_letter(&l, 10 + 4 * i, 4, .72, 0);
    CHECK(run_of(&l, 0).is_bold);
    plb_list_free(&l);
}

static void a_bar_by_itself_is_not_bold(void)
{
    display_list l;
    item it = {.kind = ITEM_FILL, .paint = {PAINT_SOLID, 0, 0, 0, 1}, .clip = NO_CLIP};
    plb_list_init(&l);
    add_box(&it.path, 0, 0, 3, 1, false);
    CHECK(plb_list_add(&l, &it, NULL));
    CHECK(!run_of(&l, 0).is_bold && fabs(run_of(&l, 0).stem - .75) < 1e-9);
    plb_list_free(&l);
}

int main(void)
{
    RUN(letters_beside_each_other_are_one_run);
    RUN(another_colour_size_or_place_begins_another_run);
    RUN(a_word_on_an_area_of_its_paint_is_a_run_of_its_own);
    RUN(broad_stems_make_a_bold_run);
    RUN(a_bar_by_itself_is_not_bold);
    CHECK_EXIT;
}
