/* SPDX-License-Identifier: MIT
 *
 * Lettering in a hand's alphabet: the table is well made, letters stay in their places, no two are alike, what the alphabet lacks is left.
 */
#include "check.h"

#include "plan/letter/hand/alphabet.h"
#include "plan/letter/hand/hand.h"

static void add_box(path *p, double x, double y, double w, double h)
{
    CHECK(plb_path_move(p, (point){x, y}) && plb_path_line(p, (point){x + w, y}) && plb_path_line(p, (point){x + w, y + h}) && plb_path_line(p, (point){x, y + h}) &&
          plb_path_close(p));
}

/* A word of boxes 2 mm wide and 4 mm high on the baseline y = 10, each 3 mm on; `codes` ends with 0. */
static item word(const uint32_t *codes)
{
    item it = {.kind = ITEM_FILL, .paint = {PAINT_SOLID, 0, 0, 0, 1}, .clip = NO_CLIP, .text = plb_new(1, sizeof(text_run))};
    it.text->em = 5.5;
    for (int i = 0; codes[i]; i++) {
        character c = {{codes[i]}, 1, {5 + 3 * i, 10}};
        CHECK(array_push(&it.text->characters, c));
        add_box(&it.path, 5 + 3 * i, 6, 2, 4);
    }
    return it;
}

static track_list lettered(item *it, uint64_t seed, path *rest)
{
    track_list out = {0};
    CHECK(plb_hand_letters(it, .15, seed, &out, rest));
    return out;
}

static void each_form_is_drawn(void)
{
    for (uint32_t code = 1; code < 0x2400; code++) {
        const letter_form *f = plb_alphabet_find(code);
        const marked_letter *m = plb_alphabet_find_marked(code);
        if (!f && !m)
            continue;
        CHECK(!m || (plb_alphabet_find(m->letter) && *m->mark));
        for (uint64_t seed = 0; seed < 8; seed++) {
            item it = word((uint32_t[]){code, 0});
            path rest = {0};
            track_list l = lettered(&it, seed, &rest);
            CHECK(l.tracks.n > 0 && rest.ops.n == 0);
            for (size_t i = 0; i < l.points.n; i++) {
                point p = l.points.v[i].at;
                CHECK(p.x > 4 && p.x < 8 && p.y > 5 && p.y < 11);
            }
            plb_tracks_free(&l);
            plb_item_free(&it);
        }
    }
    CHECK(plb_alphabet_find('A') && plb_alphabet_find('9') && plb_alphabet_find(0x2300) && plb_alphabet_find(0x3b1) && plb_alphabet_find_marked(0xe9));
}

static void no_two_letters_are_alike(void)
{
    item it = word((uint32_t[]){'n', 'n', 'n', 0});
    path rest = {0};
    track_list l = lettered(&it, 1, &rest), other = lettered(&it, 2, &rest);
    track a = plb_track_at(&l, 0), b = plb_track_at(&l, l.tracks.n / 3), c = plb_track_at(&other, 0);
    CHECK(fabs(b.v[0].at.x - a.v[0].at.x - 3) > 1e-6 && (c.v[0].at.x != a.v[0].at.x || c.v[0].at.y != a.v[0].at.y));
    track_list again = lettered(&it, 1, &rest);
    CHECK(again.points.n == l.points.n && !memcmp(again.points.v, l.points.v, l.points.n * sizeof *l.points.v));
    plb_tracks_free(&l);
    plb_tracks_free(&other);
    plb_tracks_free(&again);
    plb_item_free(&it);
}

static void what_is_not_known_is_left(void)
{
    item it = word((uint32_t[]){'n', 0x4e2d, 'o', 0});
    path rest = {0};
    add_box(&it.path, 5, 10.5, 8, .2); /* a line under the word */
    track_list l = lettered(&it, 1, &rest);
    CHECK(rest.ops.n == 10 && rest.points.v[0].x == 8 && rest.points.v[4].y == 10.5);
    CHECK(l.tracks.n >= 3);
    plb_path_free(&rest);
    plb_tracks_free(&l);
    plb_item_free(&it);
}

/* The word turned by a right angle runs up the page. */
static void lettering_follows_its_baseline(void)
{
    item it = word((uint32_t[]){'l', 'l', 0});
    path rest = {0};
    matrix up = {0, -1, 1, 0, 0, 50};
    plb_path_transform(&it.path, up);
    CHECK(plb_text_run_map(it.text, up, true));
    track_list l = lettered(&it, 1, &rest);
    track t = plb_track_at(&l, 0);
    CHECK(l.tracks.n == 2 && fabs(t.v[0].at.x - t.v[t.n - 1].at.x) > 3 && fabs(t.v[0].at.y - t.v[t.n - 1].at.y) < 1);
    CHECK(t.v[0].at.x < t.v[t.n - 1].at.x); /* from the top down */
    plb_tracks_free(&l);
    plb_item_free(&it);
}

int main(void)
{
    RUN(each_form_is_drawn);
    RUN(no_two_letters_are_alike);
    RUN(what_is_not_known_is_left);
    RUN(lettering_follows_its_baseline);
    CHECK_EXIT;
}
