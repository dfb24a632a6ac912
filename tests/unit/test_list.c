/* SPDX-License-Identifier: MIT
 *
 * The list's text form: what is written is read back the same, in pieces of any size; what is wrong is told with its line;
 * no limit is passed.
 */
#include "check.h"

#include "list/text/list_read.h"
#include "list/text/list_write.h"

#define HEAD "plumbago-list 1\npage 100 50\n"

/* Text that arrives in pieces: `head` once, then `again` so many times, then `tail`. */
typedef struct {
    const char *head, *again, *tail;
    size_t piece; /* 0: as they are */
    long times;
    size_t at; /* in `head` */
} source;

static bool refill(void *closure, const char **data, size_t *size)
{
    source *s = closure;
    if (s->head[s->at]) {
        size_t left = strlen(s->head + s->at);
        *data = s->head + s->at;
        *size = s->piece && left > s->piece ? s->piece : left;
        s->at += *size;
        return true;
    }
    if (s->times-- > 0) {
        *data = s->again;
        *size = strlen(s->again);
        return true;
    }
    *data = s->tail ? s->tail : "";
    *size = strlen(*data);
    s->tail = NULL;
    return *size > 0;
}

static char said[600];
static int messages;

static void hear(void *closure, message_level level, const char *text)
{
    (void)closure;
    messages++;
    snprintf(said, sizeof said, "%s%s", level == MESSAGE_WARNING ? "warning " : "", text);
}

static bool read_source(source *s, display_list *list, list_source *from, error *err)
{
    *from = (list_source){.refill = refill, .closure = s, .name = "it", .say = {hear, NULL}};
    *err = (error){ERROR_NONE, ""};
    plb_list_init(list);
    return plb_list_read(from, list, err);
}

/* Reads a text that is good, into `list`. */
static bool reads(const char *text, display_list *list)
{
    source s = {.head = text};
    list_source from;
    error err;
    bool good = read_source(&s, list, &from, &err) && from.complete;
    if (!good)
        printf("# %lu: %s\n", from.line, err.text);
    return good;
}

static bool is_refused(source *s, unsigned long line, error_kind kind, const char *part)
{
    display_list list;
    list_source from;
    error err;
    bool refused = !read_source(s, &list, &from, &err) && !from.complete && err.kind == kind && from.line == line && strstr(err.text, part);
    if (!refused)
        printf("# %.60s…: %lu: %s (kind %d)\n", s->head, from.line, err.text, err.kind);
    plb_list_free(&list);
    return refused;
}

/* The text stops at `line` of it with an error that holds `part`. */
static bool fails(const char *text, unsigned long line, const char *part)
{
    source s = {.head = text};
    return is_refused(&s, line, ERROR_SYNTAX, part);
}

typedef struct {
    char text[20000];
    size_t n, room;
} sink;

static bool put(void *closure, const char *data, size_t n)
{
    sink *s = closure;
    if (n > s->room - s->n)
        return false;
    memcpy(s->text + s->n, data, n);
    s->n += n;
    return true;
}

static const char whole[] =
    "plumbago-list 1\n"
    "page 100 50.5\n"
    "scale 0.02\n"
    "omit image 3 a word of advice\n"
    "omit off-page 1 a word of advice\n"
    "gradient linear pad 1 0.01 0 0 0.01 -0.3 1e-17 0 0 1 0 0 0 0 0 1 1 1 1 1 0.25\n"
    "gradient radial reflect 0.5 1 0 0 1 0 0 5 5 0 5 6 12.5\n"
    "clip - nonzero M 0 0 L 10 0 L 10 10 Z\n"
    "clip 0 evenodd\n"
    "fill 1 gradient@1 0.5 0.5 0.5 1 evenodd M 1 1 C 2 2 3 3 4 4 Z L 5 5\n"
    "fill - gradient 0.5 0.5 0.5 1 nonzero M 1 1 L 2 2\n"
    "fill - pattern 0.5 0.5 0.5 1 nonzero M 1 1 M -0 3\n"
    "fill - colour 0 0 0 1 nonzero text 3.5 -90.00000000000001 U+41 1 1 2 U+66+66+69 2 3 4 U+10ffff 1 5 6 M 1 1 L 2 2 M 3 3 M 4 4 M 5 5 M 6 6\n"
    "stroke 0 colour 0 0.1 1 0.30000000000000004 width 0.2 round M 1 2 L 3.0000000000000004 4\n"
    "stroke - colour 0 0 0 1 width 0 square dash 1 2 3 4.5 @ -2 M 1 2 L 5e-324 4\n"
    "end\n";

static void the_text_comes_back_in_pieces_of_any_size(void)
{
    for (size_t piece = 1; piece < 90; piece++) {
        source s = {.head = whole, .piece = piece};
        static sink to;
        display_list list;
        list_source from;
        error err;
        to.n = 0;
        to.room = sizeof to.text;
        CHECK(read_source(&s, &list, &from, &err));
        CHECK(plb_list_write(&list, put, &to));
        CHECK(to.n == strlen(whole) && !memcmp(to.text, whole, to.n));
        plb_list_free(&list);
    }
}

static void all_is_read_as_it_is_meant(void)
{
    display_list l;
    CHECK(reads(whole, &l));
    CHECK(l.width == 100 && l.height == 50.5 && l.paper_scale == 0.02);
    CHECK(l.omissions.n[OMISSION_IMAGE] == 3 && l.omissions.n[OMISSION_OFF_PAGE] == 1 && !strcmp(l.omissions.advice, "a word of advice"));
    CHECK(l.items.n == 6 && l.clips.n == 2 && l.gradients.n == 2 && l.dashes == 4 && l.points == 22 && l.characters == 3);
    CHECK(l.clips.v[0].parent == NO_CLIP && l.clips.v[1].parent == 0 && l.clips.v[1].even_odd && l.clips.v[1].path.ops.n == 0);
    const gradient *g = &l.gradients.v[1];
    CHECK(g->radial && g->extend == GRADIENT_REFLECT && g->opacity == 0.5 && g->to_radius == 12.5 && g->to.y == 6 && g->n == 0);
    CHECK(l.gradients.v[0].n == 2 && l.gradients.v[0].to_space.y0 == 1e-17 && l.gradients.v[0].stops[1].alpha == 0.25f);
    const item *it = l.items.v;
    CHECK(it[0].kind == ITEM_FILL && it[0].clip == 1 && it[0].even_odd && it[0].paint.kind == PAINT_GRADIENT && it[0].gradient == 2);
    CHECK(it[1].paint.kind == PAINT_GRADIENT && it[1].gradient == 0 && it[2].paint.kind == PAINT_PATTERN);
    CHECK(it[4].kind == ITEM_STROKE && it[4].cap == LINE_CAP_ROUND && it[4].width == 0.2 && it[4].paint.alpha == 0.1 + 0.2);
    CHECK(it[3].text && it[3].text->em == 3.5 && it[3].text->characters.v[1].code[2] == 0x69 && it[3].text->characters.v[1].subpaths == 2);
    CHECK(it[5].dash.n == 4 && it[5].dash.v[3] == 4.5 && it[5].dash_offset == -2 && it[5].cap == LINE_CAP_SQUARE);
    plb_list_free(&l);
}

static void blanks_comments_and_other_line_ends_do_no_harm(void)
{
    display_list l;
    CHECK(reads("plumbago-list\t1 # mine\r\n\r\n  # nothing\n\tpage   100\t50#here\r\nstroke - colour 0 0 0 1 width 1 butt M 1 1 L 2 +2.5 # \xc3\xa9\nend", &l));
    CHECK(l.items.n == 1 && l.items.v[0].path.points.v[1].y == 2.5);
    plb_list_free(&l);
}

static void a_matrix_maps_what_follows(void)
{
    display_list l;
    CHECK(reads(HEAD "clip - nonzero M 1 1\nmatrix 2 0 0 -2 10 40\nclip - nonzero M 1 1\ngradient linear pad 1 1 0 0 1 0 0 0 0 1 0\n"
                     "stroke - colour 0 0 0 1 width 3 butt dash 1 1 @ 0 M 1 1 L 2 2\nmatrix 1 0 0 1 0 0\nstroke - colour 0 0 0 1 width 3 butt M 1 1 L 2 2\nend\n", &l));
    CHECK(l.clips.v[0].path.points.v[0].x == 1 && l.clips.v[1].path.points.v[0].x == 12 && l.clips.v[1].path.points.v[0].y == 38);
    CHECK(l.items.v[0].width == 3 && l.items.v[0].dash.v[0] == 1 && l.items.v[0].path.points.v[1].x == 14 && l.items.v[1].path.points.v[1].x == 2);
    point in_gradient = plb_matrix_apply(l.gradients.v[0].to_space, (point){12, 38});
    CHECK(fabs(in_gradient.x - 1) < 1e-12 && fabs(in_gradient.y - 1) < 1e-12);
    plb_list_free(&l);
}

static void letters_are_mapped_unless_turned_over(void)
{
    display_list list;
    CHECK(reads(HEAD "matrix 0 2 -2 0 50 0\nfill - colour 0 0 0 1 nonzero text 3 10 U+41 1 5 25 M 1 1 L 2 2\n"
                "matrix -1 0 0 1 50 0\nfill - colour 0 0 0 1 nonzero text 3 10 U+41 1 5 25 M 1 1 L 2 2\nend\n", &list));
    bool is_there = list.items.n == 2 && list.items.v[0].text;
    CHECK(is_there);
    if (is_there) {
        const text_run *t = list.items.v[0].text;
        CHECK(t->em == 3 && fabs(t->degrees - 100) < 1e-9 && t->characters.n == 1 && t->characters.v[0].at.x == 0 && t->characters.v[0].at.y == 10);
        CHECK(!list.items.v[1].text && list.characters == 1);
        plb_list_transform(&list, plb_matrix_scale(2, 2));
        CHECK(t->em == 6 && t->characters.v[0].at.y == 20);
    }
    plb_list_free(&list);
}

static void shapes_far_away_and_empty_ones_are_left_out(void)
{
    display_list l;
    CHECK(reads(HEAD "fill - colour 0 0 0 1 nonzero M 1e300 1 L 2 2\nfill - colour 0 0 0 1 nonzero\nfill - colour 0 0 0 1 nonzero M 1 1 L 2 2\nend\n", &l));
    CHECK(l.items.n == 1 && l.omissions.n[OMISSION_FAR] == 1);
    plb_list_free(&l);
}

static void messages_are_passed_on(void)
{
    display_list l;
    CHECK(reads("plumbago-list 1\nwarning   two # words\x01 \npage 1 1\nend\n", &l) && !strcmp(said, "warning it: two # words?"));
    plb_list_free(&l);
    CHECK(reads(HEAD "detail fine\nend\n", &l) && !strcmp(said, "it: fine"));
    plb_list_free(&l);
    source s = {.head = HEAD, .again = "detail so it goes\n", .times = 2000};
    messages = 0;
    CHECK(is_refused(&s, 1003, ERROR_LIMIT, "more than 1000 messages") && messages == 1000);
}

static void pages_are_told(void)
{
    display_list l;
    list_source from;
    error err;
    source s = {.head = "plumbago-list 1\npages 12\npage 1 1\nend\n"}, none = {.head = HEAD "end\n"};
    CHECK(read_source(&s, &l, &from, &err) && from.pages == 12);
    plb_list_free(&l);
    CHECK(read_source(&none, &l, &from, &err) && from.pages == 0);
    plb_list_free(&l);
}

static void what_is_wrong_is_told_with_its_line(void)
{
    static const struct {
        const char *text;
        unsigned long line;
        const char *part;
    } cases[] = {
        {"", 1, "first line"},
        {"list 100 50\n", 1, "first line"},
        {"plumbago-list\n", 1, "version"},
        {"plumbago-list 1 1\n", 1, "end of the line"},
        {"plumbago-list 1\nend\n", 2, "without a page"},
        {"plumbago-list 1\nfill - colour 0 0 0 1 nonzero M 1 1\n", 2, "before the page"},
        {HEAD, 3, "stops before its end"},
        {HEAD "end\nend\n", 4, "follows the end"},
        {HEAD "page 1 1\n", 3, "second page"},
        {"plumbago-list 1\npage 0 1\n", 2, "without a size"},
        {"plumbago-list 1\npage 1 -1\n", 2, "without a size"},
        {"plumbago-list 1\npage 1e999 1\n", 2, "out of range"},
        {"plumbago-list 1\npage nan 1\n", 2, "'nan'"},
        {"plumbago-list 1\npage 10mm 1\n", 2, "'10mm'"},
        {HEAD "fill - colour 0 0 0 1 nonzero text 0 0 U+41 1 0 0 M 1 1\n", 3, "size of the text out of range"},
        {HEAD "fill - colour 0 0 0 1 nonzero text 1 400 U+41 1 0 0 M 1 1\n", 3, "direction of the text out of range"},
        {HEAD "fill - colour 0 0 0 1 nonzero text 1 0 M 1 1\n", 3, "'M' stands where a character"},
        {HEAD "fill - colour 0 0 0 1 nonzero text 1 0 U+ 1 0 0 M 1 1\n", 3, "'U+' stands where a character"},
        {HEAD "fill - colour 0 0 0 1 nonzero text 1 0 U+0 1 0 0 M 1 1\n", 3, "'U+0' stands"},
        {HEAD "fill - colour 0 0 0 1 nonzero text 1 0 U+41+ 1 0 0 M 1 1\n", 3, "'U+41+' stands"},
        {HEAD "fill - colour 0 0 0 1 nonzero text 1 0 U+110000 1 0 0 M 1 1\n", 3, "'U+110000' stands"},
        {HEAD "fill - colour 0 0 0 1 nonzero text 1 0 U+0000041 1 0 0 M 1 1\n", 3, "'U+0000041' stands"},
        {HEAD "fill - colour 0 0 0 1 nonzero text 1 0 U+1+2+3+4+5 1 0 0 M 1 1\n", 3, "stands where a character"},
        {HEAD "fill - colour 0 0 0 1 nonzero text 1 0 U+41 0 0 0 M 1 1\n", 3, "without a subpath"},
        {HEAD "fill - colour 0 0 0 1 nonzero text 1 0 U+41 1 0 0 U+42 1 0 0 M 1 1\n", 3, "2 subpaths, the path has 1"},
        {HEAD "stroke - colour 0 0 0 1 width 1 butt text 1 0 U+41 1 0 0 M 1 1\n", 3, "'text' stands"},
        {"plumbago-list 1\npage 10\n", 2, "ends where"},
        {HEAD "draw me\n", 3, "'draw'"},
        {HEAD "scale 0\n", 3, "out of range"},
        {HEAD "scale 1\nscale 1\n", 4, "second scale"},
        {HEAD "pages 0\n", 3, "without pages"},
        {HEAD "pages 1\npages 1\n", 4, "twice"},
        {HEAD "matrix 1 2 3\n", 3, "ends where"},
        {HEAD "omit dreams 1\n", 3, "'dreams'"},
        {HEAD "omit image -1\n", 3, "'-1'"},
        {HEAD "omit image 99999999999\n", 3, "'99999999999'"},
        {HEAD "gradient conical pad\n", 3, "'conical'"},
        {HEAD "gradient linear pad 2 1 0 0 1 0 0 0 0 1 1\n", 3, "opacity out of range"},
        {HEAD "gradient radial pad 1 1 0 0 1 0 0 0 0 -1 1 1 1\n", 3, "radius out of range"},
        {HEAD "gradient linear pad 1 1 0 0 1 0 0 0 0 1 1 0.5 0 0 0 1 0.4 0 0 0 1\n", 3, "below the one before"},
        {HEAD "gradient linear pad 1 1 0 0 1 0 0 0 0 1 1 0.5 0 0 0\n", 3, "ends where"},
        {HEAD "matrix 0 0 0 0 0 0\ngradient linear pad 1 1 0 0 1 0 0 0 0 1 1\n", 4, "no inverse"},
        {HEAD "clip 0 nonzero M 1 1\n", 3, "no clip 0"},
        {HEAD "clip -1 nonzero M 1 1\n", 3, "'-1'"},
        {HEAD "clip - nonzero M 1 1e16\n", 3, "farther"},
        {HEAD "matrix 1e200 0 0 1e200 0 0\nclip - nonzero M 1e200 1\n", 4, "farther"},
        {HEAD "matrix 1e-100 0 0 1e-100 0 0\ngradient linear pad 1 1e300 0 0 1 0 0 0 0 1 1\n", 4, "not finite"},
        {HEAD "clip - odd M 1 1\n", 3, "'odd'"},
        {HEAD "fill - gradient@0 0 0 0 1 nonzero M 1 1\n", 3, "no gradient 0"},
        {HEAD "fill - gradient@ 0 0 0 1 nonzero M 1 1\n", 3, "number of a gradient"},
        {HEAD "fill - gradient@99999999999999999999 0 0 0 1 nonzero M 1 1\n", 3, "number of a gradient"},
        {HEAD "fill - colour 0 0 0 1.5 nonzero M 1 1\n", 3, "out of range: 1.5"},
        {HEAD "fill - color 0 0 0 1 nonzero M 1 1\n", 3, "'color'"},
        {HEAD "fill - colour 0 0 0 1 M 1 1\n", 3, "'M'"},
        {HEAD "fill - colour 0 0 0 1 nonzero L 1 1\n", 3, "begin with M"},
        {HEAD "fill - colour 0 0 0 1 nonzero M 1 1 Z Z\n", 3, "closed twice"},
        {HEAD "fill - colour 0 0 0 1 nonzero Z\n", 3, "begin with M"},
        {HEAD "fill - colour 0 0 0 1 nonzero M 1 1 C 1 2 3\n", 3, "ends where"},
        {HEAD "fill - colour 0 0 0 1 nonzero M 1 1 Q 1 2 3 4\n", 3, "'Q'"},
        {HEAD "fill - colour 0 0 0 1 nonzero M 1 1 2 2\n", 3, "'2'"},
        {HEAD "stroke - colour 0 0 0 1 M 1 1\n", 3, "'M' stands where width"},
        {HEAD "stroke - colour 0 0 0 1 width -1 butt M 1 1\n", 3, "width out of range"},
        {HEAD "stroke - colour 0 0 0 1 width 1 flat M 1 1\n", 3, "'flat'"},
        {HEAD "stroke - colour 0 0 0 1 width 1 butt dash 1 @ 0 M 1 1\n", 3, "no pairs"},
        {HEAD "stroke - colour 0 0 0 1 width 1 butt dash @ 0 M 1 1\n", 3, "no pairs"},
        {HEAD "stroke - colour 0 0 0 1 width 1 butt dash 1 -2 @ 0 M 1 1\n", 3, "out of range"},
        {HEAD "stroke - colour 0 0 0 1 width 1 butt dash 1 2 M 1 1\n", 3, "'M'"},
        {HEAD "stroke - colour 0 0 0 1 width 1 butt dash 1 2", 3, "ends where"},
        {HEAD "stroke\xc3\xa9 - colour\n", 3, "ASCII"},
        {HEAD "\x01", 3, "ASCII"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        CHECK(fails(cases[i].text, cases[i].line, cases[i].part));
    source newer = {.head = "plumbago-list 2\npage 1 1\nend\n"};
    CHECK(is_refused(&newer, 1, ERROR_UNSUPPORTED, "version 2"));
}

static void no_word_is_longer_than_its_room(void)
{
    source digits = {.head = HEAD "fill - colour 0 0 0 1 nonzero M ", .again = "0123456789", .times = 1000, .tail = " 1\nend\n"};
    CHECK(is_refused(&digits, 3, ERROR_SYNTAX, "a word of more than 1200 bytes"));
    source fits = {.head = HEAD "fill - colour 0 0 0 1 nonzero M 0.", .again = "0123456789", .times = 100, .tail = " 1\nend\n"};
    display_list l;
    list_source from;
    error err;
    CHECK(read_source(&fits, &l, &from, &err) && l.items.v[0].path.points.v[0].x == 0.01234567890123456789);
    plb_list_free(&l);
    source comment = {.head = HEAD "# ", .again = "any length ", .times = 100000, .tail = "\nend\n"};
    CHECK(read_source(&comment, &l, &from, &err));
    plb_list_free(&l);
}

static void no_limit_is_passed(void)
{
    source gradients = {.head = HEAD, .again = "gradient linear pad 1 1 0 0 1 0 0 0 0 1 1\n", .times = LIST_MAX_GRADIENTS + 1};
    CHECK(is_refused(&gradients, 3 + LIST_MAX_GRADIENTS, ERROR_LIMIT, "gradients"));
}

static void a_full_disk_is_told(void)
{
    static sink small;
    display_list l;
    CHECK(reads(whole, &l));
    small.room = 100;
    CHECK(!plb_list_write(&l, put, &small));
    plb_list_free(&l);
}

/* A ramp of 200 steps with a black band keeps its ends, its slope and the band. */
static void stops_that_matter_least_go(void)
{
    gradient g = {.to_space = MATRIX_IDENTITY, .to = {1, 0}, .opacity = 1, .extend = GRADIENT_PAD};
    for (int i = 0; i <= 200; i++) {
        float v = i < 100 || i > 120 ? (float)i / 200 : 0;
        plb_gradient_add_stop(&g, (gradient_stop){i / 200., v, v, v, 1});
    }
    CHECK(g.n == GRADIENT_MAX_STOPS && g.stops[0].red == 0 && g.stops[g.n - 1].red == 1);
    CHECK(fabs(plb_gradient_at(&g, (point){.25, 0}).red - .25) < .02 && fabs(plb_gradient_at(&g, (point){.8, 0}).red - .8) < .02);
    CHECK(plb_gradient_at(&g, (point){.55, 0}).red < .02);
    CHECK(plb_gradient_is_opaque(&g, .95));
    g.stops[3].alpha = 0;
    CHECK(!plb_gradient_is_opaque(&g, .95));
}

int main(void)
{
    RUN(the_text_comes_back_in_pieces_of_any_size);
    RUN(all_is_read_as_it_is_meant);
    RUN(blanks_comments_and_other_line_ends_do_no_harm);
    RUN(a_matrix_maps_what_follows);
    RUN(letters_are_mapped_unless_turned_over);
    RUN(shapes_far_away_and_empty_ones_are_left_out);
    RUN(messages_are_passed_on);
    RUN(pages_are_told);
    RUN(what_is_wrong_is_told_with_its_line);
    RUN(no_word_is_longer_than_its_room);
    RUN(no_limit_is_passed);
    RUN(a_full_disk_is_told);
    RUN(stops_that_matter_least_go);
    CHECK_EXIT;
}
