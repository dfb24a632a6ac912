/* SPDX-License-Identifier: MIT
 *
 * The reader of what cairo's script surface writes: hand-written scripts, right and wrong ones, and the list that comes of
 * them.
 */
#include "check.h"

#include "list/text/list_read.h"
#include "tap/svg/cairoscript.h"

#include <string.h>

#define HEAD "%!CairoScript\n<< /content //COLOR_ALPHA /width 1000 /height 500 >> surface context\n"

typedef struct {
    ARRAY(char) text;
    bool is_given;
} list_text;

static bool keep(void *closure, const char *data, size_t n)
{
    list_text *t = closure;
    CHECK(array_reserve(&t->text, n));
    memcpy(t->text.v + t->text.n, data, n);
    t->text.n += n;
    return true;
}

static bool give(void *closure, const char **data, size_t *size)
{
    list_text *t = closure;
    if (t->is_given)
        return false;
    *data = t->text.v;
    *size = t->text.n;
    return t->is_given = true;
}

/* The script in pieces, as cairo gives it, becomes the text of a list. */
static bool convert(const char *script, size_t piece, matrix to_page, list_text *text, error *err)
{
    static list_writer out;
    omissions lost = {.n = {0}};
    plb_list_writer_init(&out, keep, text);
    plb_list_writer_page(&out, 100, 50);
    plb_list_writer_matrix(&out, to_page);
    cairoscript *s = plb_cairoscript_new(&out, 100, 50, to_page);
    bool ok = s != NULL;
    for (size_t left = strlen(script), n; ok && left; left -= n, script += n) {
        n = left < piece ? left : piece;
        ok = plb_cairoscript_feed(s, script, n, err);
    }
    ok = ok && plb_cairoscript_end(s, &lost, err);
    plb_cairoscript_free(s);
    for (int k = 0; k < OMISSION_KINDS; k++)
        if (lost.n[k])
            plb_list_writer_omission(&out, (omission_kind)k, lost.n[k], NULL);
    return plb_list_writer_end(&out) && ok;
}

static bool read_onto(matrix to_page, const char *script, size_t piece, display_list *list, error *err)
{
    list_text text = {.is_given = false};
    list_source from = {.refill = give, .closure = &text, .name = "list"};
    plb_list_init(list);
    *err = (error){0};
    bool ok = convert(script, piece, to_page, &text, err);
    if (ok != (err->kind == ERROR_NONE))
        printf("FAIL read_onto: result and error disagree\n");
    if (ok && !plb_list_read(&from, list, err))
        printf("FAIL read_onto: the list is wrong, line %lu: %s\n", from.line, err->text);
    array_free(&text.text);
    return ok && from.complete;
}

/* Ten units of the script are a millimetre. */
static bool read_in_pieces(const char *text, size_t piece, display_list *list, error *err)
{
    return read_onto(plb_matrix_scale(0.1, 0.1), text, piece, list, err);
}

static bool read_script(const char *text, display_list *list)
{
    error err;
    return read_in_pieces(text, 1 << 16, list, &err);
}

static bool is_near(double a, double b) { return fabs(a - b) < 1e-9; }

static bool is_point(const path *p, size_t i, double x, double y)
{
    return i < p->points.n && is_near(p->points.v[i].x, x) && is_near(p->points.v[i].y, y);
}

static void page_and_stroke(void)
{
    display_list list;
    CHECK(read_script(HEAD "n 100 200 m 300 200 l\n1 0 0 rgb set-source\n[2 0 0 8 0 0] set-matrix\n5 set-line-width\n"
                      "//LINE_CAP_ROUND set-line-cap\n[3 4 5] 1 set-dash\nstroke+\npop\n", &list));
    CHECK(is_near(list.width, 100) && is_near(list.height, 50));
    CHECK(list.items.n == 1);
    const item *it = list.items.v;
    CHECK(it->kind == ITEM_STROKE && it->cap == LINE_CAP_ROUND && it->clip == NO_CLIP);
    CHECK(it->path.ops.n == 2 && is_point(&it->path, 0, 10, 20) && is_point(&it->path, 1, 30, 20));
    CHECK(is_near(it->width, 5 * 4 * 0.1)); /* the pen's mean scale is sqrt(2 * 8) */
    CHECK(it->dash.n == 6 && is_near(it->dash.v[0], 1.2) && is_near(it->dash.v[5], 2) && is_near(it->dash_offset, 0.4));
    CHECK(it->paint.kind == PAINT_SOLID && it->paint.red == 1 && it->paint.green == 0 && it->paint.alpha == 1);
    plb_list_free(&list);
}

static void page_is_turned_back(void)
{
    display_list list;
    error err;
    CHECK(read_onto((matrix){0, -0.5, 0.5, 0, 1, 2}, "<< >> surface context n 10 20 m 30 20 l 2 set-line-width stroke+", 100, &list, &err));
    CHECK(is_point(&list.items.v[0].path, 0, 0.5 * 20 + 1, -0.5 * 10 + 2));
    CHECK(is_near(list.items.v[0].width, 1));
    plb_list_free(&list);
}

static void path_stays_after_painting(void)
{
    display_list list;
    CHECK(read_script(HEAD "n 0 0 m 10 0 l 10 10 l h 0 0 m\n//EVEN_ODD set-fill-rule fill+ stroke+ n 5 5 10 20 rectangle fill+ pop", &list));
    CHECK(list.items.n == 3);
    CHECK(list.items.v[0].kind == ITEM_FILL && list.items.v[0].even_odd && list.items.v[1].kind == ITEM_STROKE);
    CHECK(plb_path_equal(&list.items.v[0].path, &list.items.v[1].path));
    CHECK(list.items.v[0].path.ops.n == 4); /* the move after the close is gone */
    CHECK(list.items.v[2].path.ops.n == 5 && is_point(&list.items.v[2].path, 2, 1.5, 2.5));
    plb_list_free(&list);
}

static void lines_have_no_area(void)
{
    display_list list;
    CHECK(read_script(HEAD "n 0 0 m 10 10 l fill+ n 0 0 m 5 5 l 100 100 l h 0 0 m 7 0 m 9 9 l fill+ n fill+ stroke+ pop", &list));
    CHECK(list.items.n == 0);
    plb_list_free(&list);
}

static void clips_narrow_and_are_shared(void)
{
    display_list list;
    CHECK(read_script(HEAD "n 0 0 100 100 rectangle clip+ n 10 10 m 20 10 l 20 30 l h clip+ n 0 0 m 9 9 l stroke+\n"
                      "reset-clip n 0 0 100 100 rectangle clip+ n 1 1 m 9 9 l stroke+ reset-clip n 2 2 m 9 9 l stroke+", &list));
    CHECK(list.clips.n == 2 && list.clips.v[0].parent == NO_CLIP && list.clips.v[1].parent == 0);
    CHECK(list.items.n == 3 && list.items.v[0].clip == 1 && list.items.v[1].clip == 0 && list.items.v[2].clip == NO_CLIP);
    plb_list_free(&list);
}

static void groups_are_spliced(void)
{
    display_list list;
    CHECK(read_script(HEAD "n 0 0 500 500 rectangle clip+\ndup 100 100 //COLOR_ALPHA similar dup /s7 exch def context\n"
                      "n 0 0 50 50 rectangle clip+ n 0 0 m 10 0 l 0.5 a set-source 2 set-line-width stroke+ pop\n"
                      "s7 pattern [0.5 0 0 0.5 -10 0] set-matrix set-source 0.25 a mask /s7 undef pop", &list));
    CHECK(list.items.n == 1 && list.clips.n == 2);
    const item *it = list.items.v;
    CHECK(is_near(it->paint.alpha, 0.125));
    CHECK(is_point(&it->path, 0, 2, 0) && is_point(&it->path, 1, 4, 0)); /* the pattern's matrix goes the other way */
    CHECK(is_near(it->width, 0.4));
    CHECK(it->clip == 1 && list.clips.v[1].parent == 0);
    CHECK(list.omissions.n[OMISSION_MASK] == 0);
    plb_list_free(&list);
}

static void groups_in_groups(void)
{
    display_list list;
    CHECK(read_script(HEAD "dup 9 9 //COLOR_ALPHA similar dup /s2 exch def context\n"
                      "dup 9 9 //COLOR_ALPHA similar dup /s3 exch def context n 1 1 m 2 2 l stroke+ pop\n"
                      "s3 pattern set-source 0.5 a mask s3 pattern [1 0 0 1 5 5] set-matrix set-source paint pop\n"
                      "s2 pattern set-source 0.5 a mask /s3 undef /s2 undef pop", &list));
    CHECK(list.items.n == 2);
    CHECK(is_near(list.items.v[0].paint.alpha, 0.25) && is_near(list.items.v[1].paint.alpha, 0.5));
    CHECK(is_point(&list.items.v[1].path, 0, -0.4, -0.4));
    plb_list_free(&list);
}

static void paints_of_all_kinds(void)
{
    display_list list;
    CHECK(read_script(HEAD "n 0 0 10 10 rectangle\n"
                      "0 0 9 9 linear\n 0 1 0 0 1 add-color-stop\n 1 0 0 1 0.5 add-color-stop\n [1 0 0 1 3 3] set-matrix //EXTEND_PAD set-extend set-source fill+\n"
                      "dup 5 5 //COLOR_ALPHA similar dup /s4 exch def context n 0 0 m 1 1 l stroke+ pop s4 pattern //EXTEND_REPEAT set-extend set-source fill+\n"
                      "<< /width 2 /height 2 /format //ARGB32 /source <~zzzz~> >> image pattern set-source paint fill+\n"
                      "0.2 0.4 0.6 0.8 rgba set-source 0 0 1 0 0 5 radial 0 0 0 0 1 add-color-stop mask\n"
                      "//CLEAR set-operator fill+ //OVER set-operator 0.5 g set-source fill+ pop", &list));
    CHECK(list.items.n == 4);
    const item *it = list.items.v;
    CHECK(it[0].paint.kind == PAINT_GRADIENT && is_near(it[0].paint.red, 0.5) && is_near(it[0].paint.alpha, 0.75));
    CHECK(it[1].paint.kind == PAINT_PATTERN);
    CHECK(is_near(it[2].paint.blue, 0.6) && is_near(it[2].paint.alpha, 0.8) && is_point(&it[2].path, 2, 100, 50));
    CHECK(is_near(it[3].paint.green, 0.5));
    CHECK(list.omissions.n[OMISSION_IMAGE] == 2 && list.omissions.n[OMISSION_MASK] == 1);
    plb_list_free(&list);
}

static void stack_operators(void)
{
    display_list list;
    CHECK(read_script(HEAD "dup 5 5 //COLOR similar dup /s2 exch def context exch n 0 0 m 5 5 l stroke+\n"
                      "1 index /target get exch pop pop 2 -1 roll n 0 0 m 6 6 l stroke+ pop /source get pop pop", &list));
    CHECK(list.items.n == 1 && is_point(&list.items.v[0].path, 1, 0.5, 0.5));
    plb_list_free(&list);
}

/* The list is the same however the text is cut up. */
static void pieces_of_any_size(void)
{
    static const char text[] = HEAD "n 123.456 7 m 8 9 10 11 12.125 -13 c h\n0 0.5 1 rgb set-source\nstroke+ [1 2] 0 set-dash stroke+\npop\n";
    display_list whole, cut;
    error err;
    CHECK(read_in_pieces(text, sizeof text, &whole, &err));
    for (size_t piece = 1; piece < 40; piece++) {
        CHECK(read_in_pieces(text, piece, &cut, &err));
        CHECK(cut.items.n == 2 && plb_path_equal(&cut.items.v[1].path, &whole.items.v[1].path));
        plb_list_free(&cut);
    }
    plb_list_free(&whole);
}

static void wrong_scripts_are_refused(void)
{
    static const char *const wrong[] = {
        HEAD "frobnicate", HEAD "1 l", HEAD "(a) 2 l", HEAD "pop pop", HEAD "pop n", HEAD "]", HEAD "[ 1 2", HEAD ">>", HEAD "}", HEAD "{ {",
        HEAD "[1 2 3] set-matrix", HEAD "pop [1 0 0 1 0 0] set-matrix", HEAD "[1 2] set-dash", HEAD "1 set-dash", HEAD "pop [1] 0 set-dash",
        HEAD "1 set-source", HEAD "pop 1 g set-source", HEAD "5 index", HEAD "-1 index", HEAD "1e99 index", HEAD "5 1 roll", HEAD "1 2 roll",
        HEAD "1 1 def", HEAD "1 undef", HEAD "/s2", HEAD "s2", HEAD "/s2 1 def s2", HEAD "surface", HEAD "similar", HEAD "dup 1 1 //A similar //B set-extend",
        HEAD "/target get pattern set-source paint", HEAD "1 mask", HEAD "1 set-operator", HEAD "(a", HEAD "<7", HEAD "1 2 3 4 5 add-color-stop",
        HEAD "exch", HEAD "record", HEAD "1 image", HEAD "context",
    };
    size_t accepted = 0;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        display_list list;
        error err;
        /* a bracket left open and a name left on the stack are harmless */
        bool harmless = !strcmp(wrong[i], HEAD "[ 1 2") || !strcmp(wrong[i], HEAD "/s2");
        if (read_in_pieces(wrong[i], 1000, &list, &err) != harmless) {
            printf("  wrongly taken: %s\n", wrong[i]);
            accepted++;
        }
        CHECK(harmless || (err.text[0] && !strchr(err.text, '\n')));
        plb_list_free(&list);
    }
    CHECK(accepted == 0);
}

static void unknown_operators_are_named(void)
{
    display_list list;
    error err;
    CHECK(!read_in_pieces(HEAD "\nn 1 2 m\nfrobnicate", 9, &list, &err));
    CHECK(err.kind == ERROR_SYNTAX && strstr(err.text, "frobnicate") && strstr(err.text, "line 5"));
    plb_list_free(&list);
}

/* A group painted twice in each group above it: 2^40 items unless a limit stops it. */
static void doubling_groups_meet_a_limit(void)
{
    static char text[1 << 14];
    int n = snprintf(text, sizeof text, "%s", HEAD "dup 9 9 //COLOR similar dup /s1 exch def context n 0 0 m 9 9 l 5 5 9 9 9 9 c stroke+ pop\n");
    for (int i = 2; i < 40; i++)
        n += snprintf(text + n, sizeof text - (size_t)n, "dup 9 9 //COLOR similar dup /s%d exch def context s%d pattern set-source paint paint pop\n", i, i - 1);
    display_list list;
    error err;
    CHECK(!read_in_pieces(text, 1 << 14, &list, &err));
    CHECK(err.kind == ERROR_LIMIT);
    plb_list_free(&list);
}

static void deep_stacks_meet_a_limit(void)
{
    enum { DEEP = 300000 };
    char *text = malloc(sizeof HEAD + 2 * DEEP);
    strcpy(text, HEAD);
    size_t n = strlen(text);
    for (int i = 0; i < DEEP; i++, n += 2)
        memcpy(text + n, "[ ", 3);
    display_list list;
    error err;
    CHECK(!read_in_pieces(text, 1 << 16, &list, &err));
    CHECK(err.kind == ERROR_LIMIT);
    plb_list_free(&list);
    free(text);
}

static void gradients_have_colours_at_places(void)
{
    display_list list;
    /* 10 units are a millimetre: black at x = 10 mm, white at 30 mm; then circles around (50, 20) mm, stretched twofold */
    CHECK(read_script(HEAD "100 0 300 0 linear\n0 0 0 0 1 add-color-stop\n1 1 1 1 .5 add-color-stop\nset-source\n"
                      "n 0 0 m 900 0 l 900 400 l h fill+\n"
                      "0 0 0 0 0 10 radial\n0 1 0 0 1 add-color-stop\n1 0 0 1 1 add-color-stop\n//EXTEND_NONE set-extend\n"
                      "[.05 0 0 .1 -25 -20] set-matrix\nset-source\nn 0 0 m 900 0 l 900 400 l h fill+\npop\n", &list));
    const gradient *g = list.items.n == 2 ? plb_item_gradient(&list, &list.items.v[0]) : NULL;
    CHECK(g && !g->radial);
    paint at = plb_gradient_at(g, (point){20, 7});
    CHECK(is_near(at.red, 0.5) && is_near(at.alpha, 0.75));
    CHECK(plb_gradient_at(g, (point){-5, 0}).red == 0 && plb_gradient_at(g, (point){95, 0}).red == 1);
    g = plb_item_gradient(&list, &list.items.v[1]);
    CHECK(g && g->radial);
    CHECK(is_near(plb_gradient_at(g, (point){60, 20}).blue, 0.5) && is_near(plb_gradient_at(g, (point){50, 25}).blue, 0.5));
    CHECK(plb_gradient_at(g, (point){50, 31}).alpha == 0 && plb_gradient_at(g, (point){69, 20}).alpha == 1);
    plb_list_transform(&list, plb_matrix_scale(2, 2));
    g = plb_item_gradient(&list, &list.items.v[1]);
    CHECK(is_near(plb_gradient_at(g, (point){120, 40}).blue, 0.5));
    plb_list_free(&list);
}

/* A gradient in a group that is painted half transparent somewhere else. */
static void gradients_move_with_their_group(void)
{
    display_list list;
    CHECK(read_script(HEAD "dup 1000 500 //COLOR_ALPHA similar dup /s2 exch def context\n"
                      "0 0 100 0 linear\n0 0 0 0 1 add-color-stop\n1 1 1 1 1 add-color-stop\nset-source\n"
                      "n 0 0 m 100 0 l 100 100 l h fill+\npop\n"
                      "s2 pattern [1 0 0 1 -200 0] set-matrix set-source 0.5 a mask /s2 undef pop", &list));
    const gradient *g = list.items.n == 1 ? plb_item_gradient(&list, &list.items.v[0]) : NULL;
    CHECK(g != NULL);
    paint at = g ? plb_gradient_at(g, (point){25, 0}) : (paint){.kind = PAINT_SOLID};
    CHECK(is_near(at.red, 0.5) && is_near(at.alpha, 0.5));
    plb_list_free(&list);
}

/* Copies of one gradient need not agree in the bytes between members. */
static void equal_gradients_are_kept_once(void)
{
    static gradient made[2];
    unsigned index[3] = {0};
    display_list list;
    error err = {ERROR_NONE, ""};
    for (int i = 0; i < 2; i++) {
        memset(&made[i], i ? 0xff : 0, sizeof made[i]);
        gradient *g = &made[i];
        g->radial = false, g->extend = GRADIENT_PAD, g->n = 0, g->opacity = 1;
        g->to_space = (matrix){0}, g->from = g->to = (point){0, 0}, g->from_radius = g->to_radius = 0;
        plb_gradient_add_stop(g, (gradient_stop){0, 1, 0, 0, 1});
    }
    plb_list_init(&list);
    CHECK(plb_list_add_gradient(&list, &made[0], &index[0], &err) && plb_list_add_gradient(&list, &made[1], &index[1], &err));
    made[1].stops[0].red = 0.5f;
    CHECK(plb_list_add_gradient(&list, &made[1], &index[2], &err));
    CHECK(index[0] == 1 && index[1] == 1 && index[2] == 2);
    plb_list_free(&list);
}

int main(void)
{
    RUN(page_and_stroke);
    RUN(page_is_turned_back);
    RUN(path_stays_after_painting);
    RUN(lines_have_no_area);
    RUN(clips_narrow_and_are_shared);
    RUN(groups_are_spliced);
    RUN(groups_in_groups);
    RUN(paints_of_all_kinds);
    RUN(stack_operators);
    RUN(pieces_of_any_size);
    RUN(wrong_scripts_are_refused);
    RUN(unknown_operators_are_named);
    RUN(doubling_groups_meet_a_limit);
    RUN(deep_stacks_meet_a_limit);
    RUN(gradients_have_colours_at_places);
    RUN(gradients_move_with_their_group);
    RUN(equal_gradients_are_kept_once);
    CHECK_EXIT;
}
