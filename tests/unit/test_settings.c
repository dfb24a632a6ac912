/* SPDX-License-Identifier: MIT
 *
 * The table of settings as a program meets it: each row takes its default and gives it back, refuses what is out of its range in words
 * that say the range; settings that count for loading must not differ when a drawing is drawn; pages and pixels.
 */
#include "check.h"

#include "api/plumbago.h"
#include "api/settings/page_fit.h"

#include <math.h>
#include <unistd.h>

static void is_refused(plb_options *o, const char *name, const char *value, const char *why)
{
    char before[256], after[256];
    plb_error e = {PLB_OK, ""};
    CHECK(plb_options_get(o, name, before, sizeof before));
    CHECK(!plb_options_set(o, name, value, &e) && e.status == PLB_ERROR_ARGUMENT && !strncmp(e.text, name, strlen(name)) && strstr(e.text, why));
    CHECK(plb_options_get(o, name, after, sizeof after) && !strcmp(before, after));
}

static void each_row_takes_its_default_and_gives_it_back(void)
{
    plb_options *o = plb_options_new(), *copy = plb_options_copy(o);
    const plb_setting *s;
    char value[256];
    size_t n = 0;
    for (; (s = plb_setting_at(n)); n++) {
        CHECK(plb_options_get(o, s->name, value, sizeof value) && !strcmp(value, s->usual));
        CHECK(plb_options_set(o, s->name, value, NULL));
        CHECK(plb_options_get(copy, s->name, value, sizeof value) && !strcmp(value, s->usual));
        CHECK(!plb_options_get(o, s->name, value, strlen(s->usual)) || !*s->usual); /* one byte too few */
        CHECK((s->calls & (PLB_COUNTS_LOADING | PLB_COUNTS_DRAWING)) != 0 && *s->help && *s->group);
    }
    CHECK(n > 25);
    plb_options_free(o);
    plb_options_free(copy);
}

static void choices_take_each_of_their_words(void)
{
    plb_options *o = plb_options_new();
    const plb_setting *s;
    const char *word;
    char value[256];
    for (size_t i = 0; (s = plb_setting_at(i)); i++) {
        size_t words = 0;
        for (; (word = plb_setting_word(s, words)); words++)
            CHECK(plb_options_set(o, s->name, word, NULL) && plb_options_get(o, s->name, value, sizeof value) && !strcmp(value, word));
        if (s->kind == PLB_SETTING_CHOICE) {
            CHECK(words >= 2);
            is_refused(o, s->name, "soup", plb_setting_word(s, 1));
        }
        if (s->kind == PLB_SETTING_FLAG)
            is_refused(o, s->name, "maybe", "on or off");
    }
    plb_options_free(o);
}

static void numbers_keep_to_their_range(void)
{
    plb_options *o = plb_options_new();
    const plb_setting *s;
    char text[64];
    for (size_t i = 0; (s = plb_setting_at(i)); i++) {
        bool is_length = s->kind == PLB_SETTING_LENGTH;
        if (!is_length && s->kind != PLB_SETTING_NUMBER && s->kind != PLB_SETTING_RATIO && s->kind != PLB_SETTING_WHOLE)
            continue;
        for (int end = 0; end < 2; end++) {
            double inside = end ? s->max : s->min, outside = end ? s->max * 2 + 1 : s->min - 1;
            snprintf(text, sizeof text, "%.10f%s", inside, is_length ? "mm" : "");
            if (s->kind != PLB_SETTING_WHOLE)
                CHECK(plb_options_set(o, s->name, text, NULL));
            CHECK(plb_options_set_number(o, s->name, inside, NULL) && !plb_options_set_number(o, s->name, outside, NULL));
            snprintf(text, sizeof text, "%.0f%s", outside, is_length ? "mm" : "");
            is_refused(o, s->name, text, "takes");
        }
        is_refused(o, s->name, "", "takes");
        is_refused(o, s->name, "nan", "takes");
        CHECK(!plb_options_set_number(o, s->name, NAN, NULL));
    }
    is_refused(o, "dpi", "5", "10 to 4800 pixels per inch");
    is_refused(o, "arm", "left", "hand, jerk, spring, lognormal or torque");
    is_refused(o, "pixels", "0x5", "as 1200 or 800x600");
    is_refused(o, "page-size", "A4-sideways", "-landscape");
    is_refused(o, "scale", "1/0", "1/2");
    plb_error e;
    CHECK(!plb_options_set(o, "dip", "300", &e) && !strcmp(e.text, "unknown setting 'dip'; did you mean 'dpi'?"));
    CHECK(!plb_options_set(o, "pencl", "HB", &e) && !strcmp(e.text, "unknown setting 'pencl'; did you mean 'pencil'?"));
    CHECK(!plb_options_set_number(o, "tone-of-voice", 1, &e) && !strcmp(e.text, "unknown setting 'tone-of-voice'"));
    CHECK(plb_name_distance("width", "widht and more", 5) == 1 && plb_name_distance("width", "height", 6) == PLB_NAME_FAR);
    CHECK(!plb_options_set_number(o, "arm", 1, &e) && !plb_options_set_number(o, "threads", 1.5, &e));
    plb_options_free(o);
}

static void ratios_are_written_in_four_ways(void)
{
    static const char *const half[] = {"0.5", "50%", "1/2", "1:2"};
    plb_options *o = plb_options_new();
    char value[32];
    for (int i = 0; i < 4; i++)
        CHECK(plb_options_set(o, "scale", half[i], NULL) && plb_options_get(o, "scale", value, sizeof value) && !strcmp(value, "0.5"));
    plb_options_free(o);
}

/* ---- what counts when ---- */

static plb_drawing *small_drawing(const plb_options *o)
{
    FILE *f = fopen("small.list", "w");
    fputs("plumbago-list 1\npage 28 21\nstroke - colour 0 0 0 1 width 0.3 butt M 3 3 L 25 18\nend\n", f);
    fclose(f);
    plb_error e;
    plb_drawing *d = plb_drawing_load("small.list", o, &e);
    CHECK(d != NULL);
    unlink("small.list");
    return d;
}

static const char *another(const plb_setting *s)
{
    switch (s->kind) {
    case PLB_SETTING_CHOICE: return plb_setting_word(s, strcmp(plb_setting_word(s, 0), s->usual) ? 0 : 1);
    case PLB_SETTING_FLAG: return "on";
    case PLB_SETTING_TEXT: return "elsewhere";
    case PLB_SETTING_PENCIL: return "6B";
    case PLB_SETTING_PAGE: return "A5";
    case PLB_SETTING_PIXELS: return "200x150";
    case PLB_SETTING_ANGLES: return strchr(s->argument, ',') ? "40,30" : "perspective=55";
    case PLB_SETTING_LENGTH: return "9mm";
    case PLB_SETTING_WHOLE: return "2";
    case PLB_SETTING_SEED: return "2";
    case PLB_SETTING_NUMBER:
    case PLB_SETTING_RATIO: break;
    }
    return s->max <= 1 ? "0.5" : s->max < 10 ? "2" : "100";
}

static void what_counts_for_loading_must_not_differ(void)
{
    plb_options *o = plb_options_new();
    plb_drawing *d = small_drawing(o);
    const plb_setting *s;
    for (size_t i = 0; d && (s = plb_setting_at(i)); i++) {
        plb_options *other = plb_options_copy(o);
        plb_error e = {PLB_OK, ""};
        CHECK(plb_options_set(other, s->name, another(s), NULL));
        cairo_surface_t *drawn = plb_drawing_render(d, other, &e);
        bool must_agree = (s->calls & PLB_COUNTS_LOADING) && !(s->calls & PLB_COUNTS_FREELY);
        CHECK(!drawn == must_agree);
        CHECK(!must_agree || (e.status == PLB_ERROR_ARGUMENT && strstr(e.text, s->name)));
        cairo_surface_destroy(drawn);
        plb_options_free(other);
    }
    plb_drawing_free(d);
    plb_options_free(o);
}

/* A drawing keeps the options it was loaded with: whoever gives none gets these; the same pencil may be loaded twice. */
static void no_options_are_those_of_loading(void)
{
    plb_options *o = plb_options_new(), *same = plb_options_new();
    CHECK(plb_options_set(o, "width", "10mm", NULL) && plb_options_set(o, "dpi", "254", NULL));
    CHECK(plb_options_set(same, "width", "10mm", NULL) && plb_options_set(same, "pixels", "50", NULL));
    plb_drawing *d = small_drawing(o);
    plb_options_free(o);
    cairo_surface_t *drawn = plb_drawing_render(d, NULL, NULL), *again = plb_drawing_render(d, same, NULL);
    CHECK(drawn && cairo_image_surface_get_width(drawn) == 100);
    CHECK(again && cairo_image_surface_get_width(again) == 50);
    cairo_surface_destroy(drawn);
    cairo_surface_destroy(again);
    plb_drawing_free(d);
    plb_options_free(same);
}

static void settings_that_do_not_go_together(void)
{
    plb_options *o = plb_options_new();
    plb_error e;
    CHECK(plb_options_check(o, &e) && plb_options_set(o, "scale", "2", NULL) && plb_options_check(o, &e));
    CHECK(plb_options_set(o, "height", "20mm", NULL) && !plb_options_check(o, &e) && strstr(e.text, "scale") && strstr(e.text, "height"));
    CHECK(!plb_drawing_load("none.svg", o, &e) && e.status == PLB_ERROR_ARGUMENT);
    plb_options_free(o);
}

/* ---- sizes ---- */

/* Settings as "NAME=VALUE NAME=VALUE", and what becomes of a drawing of 200 by 100 mm. */
static page_fit fit(const char *settings, bool *ok, double *dpi)
{
    plb_options *o = plb_options_new();
    page_fit p = {0};
    char text[256], *next = text;
    snprintf(text, sizeof text, "%s", settings);
    for (char *name; next && *next;) {
        name = next;
        next = strchr(name, ' ');
        if (next)
            *next++ = '\0';
        char *value = strchr(name, '=');
        *value++ = '\0';
        CHECK(plb_options_set(o, name, value, NULL));
    }
    *ok = plb_options_check(o, NULL) && plb_page_fit(o, 200, 100, 1, &p, NULL) && plb_page_dpi(o, p.width, p.height, dpi, NULL);
    plb_options_free(o);
    return p;
}

static void pages_get_their_size(void)
{
    static const struct {
        const char *settings;
        double width, height, factor, x0, y0, dpi;
    } rows[] = {
        {"", 200, 100, 1, 0, 0, 300},
        {"width=100mm", 100, 50, 0.5, 0, 0, 300},
        {"width=100mm height=100mm", 100, 100, 0.5, 0, 25, 300},
        {"scale=50%", 100, 50, 0.5, 0, 0, 300},
        {"margin=10mm", 220, 120, 1, 10, 10, 300},
        {"width=120mm margin=10mm", 120, 70, 0.5, 10, 10, 300},
        {"page-size=A4", 297, 210, 1.485, 0, 30.75, 300},
        {"page-size=a4-portrait", 210, 297, 1.05, 0, 96, 300},
        {"page-size=A4-landscape margin=48.5mm", 297, 210, 1, 48.5, 55, 300},
        {"page-size=A3 scale=1/2", 420, 297, 0.5, 160, 123.5, 300},
        {"page-size=letter", 279.4, 215.9, 1.397, 0, 38.1, 300},
        {"pixels=1000", 200, 100, 1, 0, 0, 127},
        {"pixels=1000x500", 200, 100, 1, 0, 0, 127},
        {"pixels=1000x1000", 200, 200, 1, 0, 50, 127},
        {"pixels=1600x400", 400, 100, 1, 100, 0, 101.6},
        {"pixels=800x600 width=100mm", 100, 75, 0.5, 0, 12.5, 203.2},
        {"pixels=800x600 page-size=A4", 297, 210, 1.485, 0, 30.75, 800 * 25.4 / 297},
        {"pixels=600x1200 width=100mm height=50mm", 100, 50, 0.5, 0, 0, 152.4},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double dpi = 0;
        bool ok;
        page_fit p = fit(rows[i].settings, &ok, &dpi);
        CHECK(ok && fabs(p.width - rows[i].width) < 1e-9 && fabs(p.height - rows[i].height) < 1e-9 && fabs(p.factor - rows[i].factor) < 1e-9);
        CHECK(fabs(p.x0 - rows[i].x0) < 1e-9 && fabs(p.y0 - rows[i].y0) < 1e-9 && fabs(dpi - rows[i].dpi) < 1e-9);
    }
    static const char *const refused[] = {"page-size=A4 width=10mm", "page-size=A6 margin=60mm", "pixels=10", "pixels=1000000", "pixels=100 dpi=72", "width=10mm margin=5mm"};
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        double dpi;
        bool ok;
        fit(refused[i], &ok, &dpi);
        CHECK(!ok);
    }
}

int main(void)
{
    RUN(each_row_takes_its_default_and_gives_it_back);
    RUN(choices_take_each_of_their_words);
    RUN(numbers_keep_to_their_range);
    RUN(ratios_are_written_in_four_ways);
    RUN(what_counts_for_loading_must_not_differ);
    RUN(no_options_are_those_of_loading);
    RUN(settings_that_do_not_go_together);
    RUN(pages_get_their_size);
    CHECK_EXIT;
}
