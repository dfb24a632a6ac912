/* SPDX-License-Identifier: MIT
 *
 * The library as a program meets it: through plumbago.h alone. Misuse is an error that says why; success leaves none.
 */
#include "check.h"

#include "api/plumbago.h"

#include <math.h>

/* A coarse page, for speed. */
static plb_options *options_at(double dpi)
{
    plb_options *o = plb_options_new();
    CHECK(o && plb_options_set_number(o, "dpi", dpi, NULL));
    return o;
}

/* The smallest byte of a surface's rows. */
static int darkest_of(cairo_surface_t *s)
{
    int darkest = 255, stride = cairo_image_surface_get_stride(s);
    cairo_surface_flush(s);
    const unsigned char *v = cairo_image_surface_get_data(s);
    for (int i = 0; i < stride * cairo_image_surface_get_height(s); i += 4)
        darkest = v[i] < darkest ? v[i] : darkest;
    return darkest;
}

static cairo_surface_t *white_surface(void)
{
    cairo_surface_t *s = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 60, 60);
    cairo_t *cr = cairo_create(s);
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    cairo_destroy(cr);
    return s;
}

static bool line_on(cairo_surface_t *s, plb_error *e)
{
    plb_options *o = options_at(100);
    bool drawn = plb_draw_line(s, 5, 5, 55, 50, 1, o, e);
    plb_options_free(o);
    return drawn;
}

static void surfaces_that_cannot_be_drawn_on(void)
{
    static const cairo_format_t formats[] = {CAIRO_FORMAT_A1, CAIRO_FORMAT_RGB16_565, CAIRO_FORMAT_RGB30};
    plb_error e;
    for (int i = 0; i < 3; i++) {
        cairo_surface_t *s = cairo_image_surface_create(formats[i], 60, 60);
        CHECK(!line_on(s, &e) && e.status == PLB_ERROR_ARGUMENT && strstr(e.text, "format ARGB32"));
        cairo_surface_destroy(s);
    }
    cairo_surface_t *s = white_surface();
    cairo_surface_finish(s);
    CHECK(!line_on(s, &e) && e.status == PLB_ERROR_ARGUMENT && strstr(e.text, "finished"));
    cairo_surface_destroy(s);
    s = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, -1, 1000000);
    CHECK(!line_on(s, &e) && e.status == PLB_ERROR_ARGUMENT);
    cairo_surface_destroy(s);
    s = cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &(cairo_rectangle_t){0, 0, 9, 9});
    CHECK(!line_on(s, &e) && e.status == PLB_ERROR_ARGUMENT);
    cairo_surface_destroy(s);
    CHECK(!line_on(NULL, &e) && e.status == PLB_ERROR_ARGUMENT);
}

static void lines_with_impossible_ends(void)
{
    static const double ends[] = {NAN, INFINITY, 1e308, -1e7};
    plb_options *o = options_at(100);
    cairo_surface_t *s = white_surface();
    plb_error e;
    for (int i = 0; i < 4; i++)
        CHECK(!plb_draw_line(s, ends[i], 0, 20, 20, 1, o, &e) && e.status == PLB_ERROR_ARGUMENT && strstr(e.text, "million"));
    CHECK(plb_draw_line(s, 5, 5, 5, 5, 1, o, &e) && darkest_of(s) == 255);
    cairo_surface_destroy(s);
    plb_options_free(o);
}

static void success_clears_an_old_error(void)
{
    plb_error e = {PLB_ERROR_SYNTAX, "old"};
    cairo_surface_t *s = white_surface();
    CHECK(line_on(s, &e) && e.status == PLB_OK && !e.text[0] && darkest_of(s) < 200);
    cairo_surface_destroy(s);
    e = (plb_error){PLB_ERROR_SYNTAX, "old"};
    plb_profile *p = plb_profile_load("HB", &e);
    CHECK(p && e.status == PLB_OK && !e.text[0]);
    FILE *nowhere = fopen("/dev/null", "w");
    e = (plb_error){PLB_ERROR_SYNTAX, "old"};
    CHECK(nowhere && plb_profile_show(p, nowhere, &e) && e.status == PLB_OK && !e.text[0]);
    fclose(nowhere);
    plb_profile_free(p);
}

static void errors_are_one_line(void)
{
    plb_error e;
    CHECK(!plb_profile_load("no\nsuch\tpencil", &e) && e.status == PLB_ERROR_FILE);
    CHECK(!strpbrk(e.text, "\n\t") && strstr(e.text, "no?such?pencil"));
}

int main(void)
{
    RUN(surfaces_that_cannot_be_drawn_on);
    RUN(lines_with_impossible_ends);
    RUN(success_clears_an_old_error);
    RUN(errors_are_one_line);
    CHECK_EXIT;
}
