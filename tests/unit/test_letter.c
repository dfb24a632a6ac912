/* SPDX-License-Identifier: MIT
 *
 * Lettering: thin shapes become pen strokes along their medial axis; solid ones are left to others.
 */
#include "check.h"

#include "plan/letter/letter.h"
#include "plan/letter/medial/medial.h"

#define MOST 64

typedef struct {
    bool taken, even_odd;
    path path;
    letter_run run;     /* that the shape is one of */
    size_t n;           /* strokes */
    size_t corners;     /* of all together */
    point first[MOST], last[MOST], middle[MOST];
    double length[MOST];
    bool closed[MOST], letter;
    box bounds;
    float pressure;
} result;

static void note(result *r, const track *t)
{
    CHECK(t->n >= 2);
    if (r->n < MOST) {
        r->first[r->n] = t->v[0].at;
        r->last[r->n] = t->v[t->n - 1].at;
        r->middle[r->n] = t->v[t->n / 2].at;
        r->length[r->n] = plb_track_length(t);
        r->closed[r->n] = t->closed;
    }
    r->n++;
    for (size_t i = 0; i < t->n; i++) {
        r->corners += t->v[i].corner;
        plb_box_add(&r->bounds, t->v[i].at);
    }
    r->letter = t->style.kind == STROKE_LETTER;
    r->pressure = t->style.pressure;
}

static void add_polygon(result *r, const double *xy, int n)
{
    for (int i = 0; i < n; i++) {
        point p = {xy[2 * i], xy[2 * i + 1]};
        CHECK(i ? plb_path_line(&r->path, p) : plb_path_move(&r->path, p));
    }
    CHECK(plb_path_close(&r->path));
}

static void add_circle(result *r, double x, double y, double radius, bool backwards)
{
    path circle = {0};
    CHECK(plb_path_arc(&circle, (point){x, y}, radius, 0, (backwards ? -2 : 2) * PLB_PI, backwards, MATRIX_IDENTITY) && plb_path_close(&circle));
    CHECK(plb_path_append(&r->path, &circle, MATRIX_IDENTITY));
    plb_path_free(&circle);
}

/* Letters what was added, turned by `degrees` about the origin. */
static result letter(result *r, double degrees)
{
    item it = {.kind = ITEM_FILL, .paint = {PAINT_SOLID, 0, 0, 0, 1}, .clip = NO_CLIP, .path = r->path, .even_odd = r->even_odd};
    plan_options options = plb_plan_options_default();
    plb_path_transform(&it.path, plb_matrix_rotate(degrees * PLB_PI / 180));
    r->bounds = BOX_EMPTY;
    track_list strokes = {0};
    glyph_store *glyphs = plb_glyphs_new(options.pencil_width, NULL);
    CHECK(glyphs && plb_plan_letter(&it, r->run, &options, glyphs, &r->taken, &strokes, NULL));
    plb_glyphs_free(glyphs);
    for (size_t i = 0; i < strokes.tracks.n; i++) {
        track t = plb_track_at(&strokes, i);
        note(r, &t);
    }
    plb_tracks_free(&strokes);
    plb_path_free(&it.path);
    CHECK(r->taken || r->n == 0);
    return *r;
}

static result polygon(const double *xy, int n, double degrees)
{
    result r = {0};
    add_polygon(&r, xy, n);
    return letter(&r, degrees);
}

static void bars_become_their_centre_lines(void)
{
    for (int turn = 0; turn < 360; turn++) { /* with five points it goes through the raster */
        result r = polygon((const double[]){0, 0, 10, 0, 10, .5, 0, .5, 0, .25}, turn < 180 ? 5 : 4, turn);
        CHECK(r.taken && r.n == 1 && r.corners == 0 && r.letter);
        CHECK_RANGE(r.length[0], 9.5, 10);
        point along = {cos(turn * PLB_PI / 180), sin(turn * PLB_PI / 180)};
        for (int end = 0; end < 2; end++) { /* both ends lie in the middle of the bar */
            double off = point_cross(along, end ? r.last[0] : r.first[0]);
            CHECK_RANGE(off, .25 - .07, .25 + .07); /* a pixel is .06 */
        }
    }
}

/* A stem of .4 mm that ends in a hook hardly longer than it is thick, as an f in a sans serif font: the pen goes round and out to the hook's end,
 * whichever way the letter is turned. */
static void a_short_hook_is_followed_to_its_end(void)
{
    static const double hook[] = {0, 4, 0, .75, .05, .45, .17, .2, .36, .05, .6, 0, 1, 0, 1, .34, .7, .34, .55, .38, .45, .5, .4, .75, .4, 4};
    for (int turn = 0; turn < 360; turn += 30) {
        result r = polygon(hook, 13, turn);
        point along = {cos(turn * PLB_PI / 180), sin(turn * PLB_PI / 180)}, tip = r.first[0];
        CHECK(r.taken && r.n == 1);
        if (fabs(point_cross(along, tip)) > 2)
            tip = r.last[0];
        CHECK_RANGE(point_dot(along, tip), .75, 1.05);
        CHECK_RANGE(point_cross(along, tip), 0, .36);
    }
}

static const double ell[] = {0, 0, .5, 0, .5, 4, 3, 4, 3, 4.5, 0, 4.5};

static void an_l_is_one_stroke_with_a_corner(void)
{
    for (int turn = 0; turn < 360; turn += 7) {
        result r = polygon(ell, 6, turn);
        CHECK(r.taken && r.n == 1 && r.corners == 1);
        CHECK_RANGE(r.length[0], 4.25 + 2.75 - .5, 4.25 + 2.75 + .1);
    }
}

static void a_v_runs_into_its_point(void)
{
    result r = polygon((const double[]){0, 0, .5, 0, 1.75, 3.8, 3, 0, 3.5, 0, 2, 4.5, 1.5, 4.5}, 7, 0);
    CHECK(r.taken && r.n == 1 && r.corners == 1);
    CHECK_RANGE(r.bounds.y1, 3.9, 4.5);
    CHECK_RANGE(r.bounds.x0, 0, .5);
    CHECK_RANGE(r.bounds.x1, 3, 3.5);
}

static const double tee[] = {0, 0, 3, 0, 3, .5, 1.75, .5, 1.75, 4, 1.25, 4, 1.25, .5, 0, .5};

static void a_t_has_a_straight_bar(void)
{
    result r = polygon(tee, 8, 0);
    CHECK(r.taken && r.n == 2 && r.corners == 0);
    int bar = r.length[0] < r.length[1] ? 0 : 1; /* 2.8 against 3.6 */
    CHECK_RANGE(r.length[bar], 2.7, 3.0);
    CHECK_RANGE(r.first[bar].y, .2, .3);
    CHECK_RANGE(r.middle[bar].y, .2, .3);
    CHECK_RANGE(r.last[bar].y, .2, .3);
    CHECK_RANGE(r.first[!bar].y, .15, .35); /* the stem starts on the bar, */
    CHECK_RANGE(r.last[!bar].y, 3.8, 4);    /* downwards */
    CHECK_RANGE(r.last[!bar].x, 1.45, 1.55);
}

static void a_cross_is_two_straight_strokes(void)
{
    for (int turn = 0; turn < 90; turn += 5) {
        result r = polygon((const double[]){2, 0, 2.5, 0, 2.5, 2, 4.5, 2, 4.5, 2.5, 2.5, 2.5, 2.5, 4.5, 2, 4.5, 2, 2.5, 0, 2.5, 0, 2, 2, 2}, 12, turn);
        CHECK(r.taken && r.n == 2 && r.corners == 0);
        CHECK_RANGE(r.length[0], 4.2, 4.5);
        CHECK_RANGE(r.length[1], 4.2, 4.5);
    }
}

static void an_x_is_two_straight_strokes(void)
{
    result r = polygon((const double[]){0, 0, .6, 0, 1.5, 1.5, 2.4, 0, 3, 0, 1.8, 2, 3, 4, 2.4, 4, 1.5, 2.5, .6, 4, 0, 4, 1.2, 2}, 12, 0);
    CHECK(r.taken && r.n == 2 && r.corners == 0);
    for (int i = 0; i < 2; i++)
        CHECK_RANGE(r.length[i], 4.3, 4.9);
}

static void a_ring_is_one_closed_stroke_against_the_clock(void)
{
    for (int rule = 0; rule < 2; rule++) { /* a hole by direction, or by the rule */
        result ring = {.even_odd = rule};
        add_circle(&ring, 5, 5, 2, false);
        add_circle(&ring, 5, 5, 1.5, !rule);
        result r = letter(&ring, 0);
        CHECK(r.taken && r.n == 1 && r.closed[0] && r.corners == 0);
        CHECK_RANGE(r.length[0], 2 * PLB_PI * 1.7, 2 * PLB_PI * 1.8);
        CHECK_RANGE(r.bounds.x1, 6.68, 6.82);
        CHECK_RANGE(r.bounds.y0, 3.18, 3.32);
    }
}

static void short_serifs_are_not_drawn(void)
{
    /* a stem 0.5 wide with serifs that stick out by 0.4 on each side at both ends */
    result r = polygon((const double[]){0, 0, 1.3, 0, 1.3, .2, .9, .35, .9, 4.15, 1.3, 4.3, 1.3, 4.5, 0, 4.5, 0, 4.3, .4, 4.15, .4, .35, 0, .2}, 12, 0);
    CHECK(r.taken && r.n == 1 && r.corners == 0);
    CHECK_RANGE(r.length[0], 4, 4.5);
    CHECK_RANGE(r.first[0].x, .58, .72);
    CHECK_RANGE(r.last[0].x, .58, .72);
}

static void overlapping_contours_are_one_shape(void)
{
    result t = {0};
    add_polygon(&t, (const double[]){0, 0, 3, 0, 3, .5, 0, .5}, 4);
    add_polygon(&t, (const double[]){1.25, .1, 1.75, .1, 1.75, 4, 1.25, 4}, 4);
    result r = letter(&t, 0);
    CHECK(r.taken && r.n == 2 && r.corners == 0);
}

static void dots_among_letters_are_touches(void)
{
    result i = {0};
    add_polygon(&i, (const double[]){0, 1, .35, 1, .35, 3.5, 0, 3.5}, 4);
    add_circle(&i, .175, .3, .2, false);
    result r = letter(&i, 0);
    CHECK(r.taken && r.n == 2);
    CHECK_RANGE(r.length[1], .1, .5);
}

static void solid_shapes_are_left_alone(void)
{
    result disc = {0};
    add_circle(&disc, 5, 5, 1, false);
    CHECK(!letter(&disc, 0).taken);
    CHECK(!polygon((const double[]){0, 0, 2, 1, 0, 2}, 3, 10).taken);        /* arrowheads */
    CHECK(!polygon((const double[]){0, 0, 4, .5, 0, 1}, 3, 10).taken);
    CHECK(!polygon((const double[]){0, 0, 3, 1, 0, 2, .8, 1}, 4, 10).taken);
    CHECK(!polygon((const double[]){0, 0, 2, 0, 2, 2, 0, 2}, 4, 0).taken);   /* a square */
    CHECK(!polygon((const double[]){0, 0, 40, 0, 40, 3, 0, 3}, 4, 0).taken); /* a thick bar */
    result fat = {0}; /* letters 30 mm high with stems of 5 */
    for (int i = 0; i < 12; i += 2)
        CHECK(i ? plb_path_line(&fat.path, (point){ell[i] * 10, ell[i + 1] * 10}) : plb_path_move(&fat.path, (point){ell[i] * 10, ell[i + 1] * 10}));
    CHECK(plb_path_close(&fat.path) && !letter(&fat, 0).taken);
}

static void small_letters_are_drawn_lightly(void)
{
    result big = polygon(tee, 8, 0), small = {0};
    for (int i = 0; i < 16; i += 2) /* 1.2 mm high */
        CHECK(i ? plb_path_line(&small.path, (point){tee[i] * .3, tee[i + 1] * .3}) : plb_path_move(&small.path, (point){tee[i] * .3, tee[i + 1] * .3}));
    small = letter(&small, 0);
    CHECK(small.taken && small.n == 2);
    CHECK(small.pressure < big.pressure);
    CHECK_RANGE(small.pressure, 1.2, 1.5); /* but firmly against a line: letters are to be read */
}

static result stem_in_run(double stem, double of_run, bool bold)
{
    result r = {.run = {.fills = 5, .stem = of_run, .size = 4, .is_bold = bold}};
    add_polygon(&r, (const double[]){10, 10, 10 + stem, 10, 10 + stem, 14, 10, 14}, 4);
    add_polygon(&r, (const double[]){12, 10, 12 + stem, 10, 12 + stem, 14, 12, 14}, 4);
    return letter(&r, 0);
}

/* The limit between one stroke and passes side by side is 1.6 widths of the line, .56 mm: letters on either side of it follow their word. */
static void letters_of_a_word_have_one_weight(void)
{
    result thin = stem_in_run(.50, .52, false), broad = stem_in_run(.62, .52, false);
    CHECK(thin.taken && broad.taken && thin.n == 2 && broad.n == 2 && thin.pressure == broad.pressure);
    thin = stem_in_run(.50, .6, false);
    broad = stem_in_run(.62, .6, false);
    CHECK(thin.n > 2 && thin.n == broad.n);
}

static void bold_words_are_darker_and_broader(void)
{
    result usual = stem_in_run(.45, .45, false), bold = stem_in_run(.45, .45, true), fine = stem_in_run(.3, .3, true);
    CHECK(bold.n > usual.n && bold.pressure > usual.pressure);
    CHECK(fine.n == 2 && fine.pressure > stem_in_run(.3, .3, false).pressure);
}

/* A comb of many teeth, a star of 100,000 points, points that are all one: they end, quickly. */
static void huge_and_degenerate_shapes_end(void)
{
    result star = {0};
    for (int i = 0; i < 100000; i++) {
        double radius = i & 1 ? 50 : 20, a = i * 2 * PLB_PI / 100000;
        point p = {60 + radius * cos(a), 60 + radius * sin(a)};
        CHECK(i ? plb_path_line(&star.path, p) : plb_path_move(&star.path, p));
    }
    CHECK(!letter(&star, 0).taken);
    CHECK(!polygon((const double[]){1, 1, 1, 1, 1, 1}, 3, 0).taken);
    CHECK(!polygon((const double[]){0, 0, 5, 0, 10, 0}, 3, 0).taken);
    CHECK(!polygon((const double[]){0, 0, 1e6, 1e-9, 1e6, 1e-7}, 3, 0).taken);
    result nothing = {0};
    CHECK(!letter(&nothing, 0).taken);
    result many = {0}; /* contours that all overlap each other */
    for (int i = 0; i < 5000; i++)
        add_polygon(&many, (const double[]){i * .001, 0, 30 + i * .001, 0, 30 + i * .001, .3, i * .001, .3}, 4);
    letter(&many, 0);
}

int main(void)
{
    RUN(bars_become_their_centre_lines);
    RUN(a_short_hook_is_followed_to_its_end);
    RUN(an_l_is_one_stroke_with_a_corner);
    RUN(a_v_runs_into_its_point);
    RUN(a_t_has_a_straight_bar);
    RUN(a_cross_is_two_straight_strokes);
    RUN(an_x_is_two_straight_strokes);
    RUN(a_ring_is_one_closed_stroke_against_the_clock);
    RUN(short_serifs_are_not_drawn);
    RUN(overlapping_contours_are_one_shape);
    RUN(dots_among_letters_are_touches);
    RUN(solid_shapes_are_left_alone);
    RUN(small_letters_are_drawn_lightly);
    RUN(letters_of_a_word_have_one_weight);
    RUN(bold_words_are_darker_and_broader);
    RUN(huge_and_degenerate_shapes_end);
    CHECK_EXIT;
}
