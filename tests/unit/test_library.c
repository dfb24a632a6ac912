/* SPDX-License-Identifier: MIT
 *
 * The library as a program meets it: through plumbago.h alone. Misuse is an error that says why; success leaves none.
 */
#include "check.h"

#include "api/plumbago.h"

#include <errno.h>
#include <math.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* A coarse page, for speed. */
static plb_options *options_at(double dpi)
{
    plb_options *o = plb_options_new();
    CHECK(o && plb_options_set_number(o, "dpi", dpi, NULL));
    return o;
}

/* Returns the smallest byte of a surface's rows. */
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

/* ---- drawings of a program's own ---- */

#define WIDTH 60
#define HEIGHT 40

static plb_canvas *canvas_with_lines(void)
{
    plb_canvas *c = plb_canvas_new(WIDTH, HEIGHT, NULL);
    plb_canvas_move_to(c, 5, 5);
    plb_canvas_line_to(c, 55, 5);
    plb_canvas_curve_to(c, 60, 15, 40, 25, 55, 35);
    plb_canvas_stroke(c);
    plb_canvas_set_colour(c, 0.8, 0.1, 0.1, 1);
    plb_canvas_arc(c, 20, 22, 8, 0, 2 * 3.14159265358979);
    plb_canvas_close_path(c);
    plb_canvas_stroke(c);
    return c;
}

static plb_drawing *drawing_of_lines(void)
{
    plb_canvas *c = canvas_with_lines();
    plb_options *o = options_at(100);
    plb_drawing *d = plb_canvas_draw(c, o, NULL);
    plb_canvas_free(c);
    plb_options_free(o);
    return d;
}

/* Draws the lines on a sheet that is so many times larger than the page. */
static plb_drawing *drawing_reduced(double factor)
{
    plb_canvas *c = canvas_with_lines();
    plb_options *o = options_at(100);
    CHECK(plb_options_set_number(o, "reduction", factor, NULL) && plb_options_set_number(o, "squiggle", 0, NULL) && plb_options_set(o, "point", "blunt", NULL));
    plb_drawing *d = plb_canvas_draw(c, o, NULL);
    plb_canvas_free(c);
    plb_options_free(o);
    return d;
}

/* The library gives a stroke as it lies on the page, however large the hand's sheet is; only the pencil is finer. */
static void reduced_strokes_lie_on_the_page(void)
{
    plb_drawing *d = drawing_reduced(3), *plain = drawing_reduced(1);
    plb_stroke s, p;
    int width, height;
    CHECK(d && plain && plb_drawing_strokes(d) == plb_drawing_strokes(plain) && plb_drawing_width(d) == WIDTH && plb_drawing_height(d) == HEIGHT);
    CHECK(plb_drawing_size(d, &width, &height, NULL, NULL) && abs(width - (int)(WIDTH / 25.4 * 100)) <= 1);
    for (size_t i = 0; plb_drawing_stroke(d, i, &s) && plb_drawing_stroke(plain, i, &p); i++) {
        size_t traced;
        plb_point *path = plb_drawing_trace(d, i, &traced, NULL, NULL);
        CHECK_RANGE(s.width / p.width, 0.3333, 0.3334);
        CHECK_RANGE(s.points[0].x - p.points[0].x, -1e-6, 1e-6);
        CHECK(path && (s.closed || hypot(path[0].x - s.points[0].x, path[0].y - s.points[0].y) < 0.5));
        plb_memory_free(path);
    }
    plb_drawing_free(d);
    plb_drawing_free(plain);
}

static void a_canvas_becomes_strokes(void)
{
    plb_canvas *c = canvas_with_lines();
    plb_error e;
    plb_drawing *d = plb_canvas_draw(c, NULL, &e);
    CHECK(d && e.status == PLB_OK && plb_drawing_width(d) == WIDTH && plb_drawing_height(d) == HEIGHT);
    size_t n = plb_drawing_strokes(d);
    CHECK(n == 3); /* the line, the curve round the corner, the circle */
    plb_stroke s;
    double top = 1e9;
    for (size_t i = 0; plb_drawing_stroke(d, i, &s); i++) {
        CHECK(s.n >= 2 && s.kind == PLB_STROKE_LINE && s.pressure > 0 && s.colour == 0);
        CHECK_RANGE(s.width, 0.24, 0.4); /* a sharp point, more or less worn */
        for (size_t k = 0; k < s.n; k++)
            top = fmin(top, s.points[k].y);
        size_t traced;
        plb_point *path = plb_drawing_trace(d, i, &traced, NULL, &e);
        CHECK(path && traced >= 2 && (s.closed || hypot(path[0].x - s.points[0].x, path[0].y - s.points[0].y) < 3));
        plb_memory_free(path);
    }
    CHECK(fabs(top - 5) < 1e-9 && !plb_drawing_stroke(d, n, &s));
    size_t none;
    CHECK(!plb_drawing_trace(d, n, &none, NULL, &e) && e.status == PLB_ERROR_ARGUMENT);
    plb_drawing_free(d);
    d = plb_canvas_draw(c, NULL, &e); /* it is empty now */
    CHECK(d && plb_drawing_strokes(d) == 0);
    plb_drawing_free(d);
    plb_canvas_free(c);
}

/* The same drawing by way of a file, in which numbers are exact, is the same picture, byte for byte. */
static void a_canvas_draws_what_a_file_does(void)
{
    static const char text[] = "plumbago-list 1\npage 60 40\nstroke - colour 0 0 0 1 width 0.5 butt dash 4 2 @ 0 M 5 5 L 55 5\n"
                               "fill - colour 0.4 0.4 0.4 1 nonzero M 10 15 L 40 15 L 40 35 L 10 35 Z\nend\n";
    plb_options *o = options_at(100);
    plb_error e;
    plb_file *f = plb_file_from_memory(text, sizeof text - 1, "text", &e);
    plb_drawing *from_file = f ? plb_file_draw(f, o, &e) : NULL;
    plb_canvas *c = plb_canvas_new(WIDTH, HEIGHT, &e);
    plb_canvas_set_width(c, 0.5);
    plb_canvas_set_dash(c, (const double[]){4, 2}, 2, 0);
    plb_canvas_move_to(c, 5, 5);
    plb_canvas_line_to(c, 55, 5);
    plb_canvas_stroke(c);
    plb_canvas_set_colour(c, 0.4, 0.4, 0.4, 1);
    plb_canvas_move_to(c, 10, 15);
    plb_canvas_line_to(c, 40, 15);
    plb_canvas_line_to(c, 40, 35);
    plb_canvas_line_to(c, 10, 35);
    plb_canvas_close_path(c);
    plb_canvas_fill(c);
    plb_drawing *own = plb_canvas_draw(c, o, &e);
    CHECK(from_file && own && plb_drawing_strokes(own) > 10 && plb_drawing_strokes(own) == plb_drawing_strokes(from_file));
    size_t n = 0, m = 1;
    void *a = plb_drawing_write_memory(own, "png", &n, o, &e), *b = plb_drawing_write_memory(from_file, "png", &m, o, &e);
    CHECK(a && b && n == m && !memcmp(a, b, n));
    plb_memory_free(a);
    plb_memory_free(b);
    plb_drawing_free(own);
    plb_drawing_free(from_file);
    plb_canvas_free(c);
    plb_file_free(f);
    plb_options_free(o);
}

static void clips_hold_strokes_back(void)
{
    plb_canvas *c = plb_canvas_new(WIDTH, HEIGHT, NULL);
    plb_canvas_move_to(c, 0, 0);
    plb_canvas_line_to(c, 30, 0);
    plb_canvas_line_to(c, 30, 40);
    plb_canvas_line_to(c, 0, 40);
    plb_canvas_clip(c);
    plb_canvas_move_to(c, 5, 20);
    plb_canvas_line_to(c, 55, 20);
    plb_canvas_stroke(c);
    plb_drawing *d = plb_canvas_draw(c, NULL, NULL);
    plb_stroke s;
    CHECK(d && plb_drawing_strokes(d) == 1 && plb_drawing_stroke(d, 0, &s) && fmax(s.points[0].x, s.points[s.n - 1].x) < 30.5);
    plb_drawing_free(d);
    plb_canvas_free(c);
}

static void a_canvas_remembers_what_failed(void)
{
    plb_error e;
    CHECK(!plb_canvas_new(-1, 40, &e) && e.status == PLB_ERROR_ARGUMENT);
    CHECK(!plb_canvas_new(NAN, 40, &e) && e.status == PLB_ERROR_ARGUMENT);
    plb_canvas *c = canvas_with_lines();
    plb_canvas_line_to(c, NAN, 2);
    plb_canvas_line_to(c, 3, 2);
    CHECK(!plb_canvas_draw(c, NULL, &e) && e.status == PLB_ERROR_ARGUMENT && strstr(e.text, "no number"));
    plb_canvas_free(c);
    c = canvas_with_lines();
    plb_canvas_set_dash(c, (const double[]){0, 0}, 2, 0);
    CHECK(!plb_canvas_draw(c, NULL, &e) && e.status == PLB_ERROR_ARGUMENT && strstr(e.text, "dashes"));
    plb_canvas_free(c);
}

/* ---- what comes out ---- */

static void pixels_of_a_part_are_those_of_the_page(void)
{
    static const plb_pixel_format formats[] = {PLB_PIXELS_GREY, PLB_PIXELS_GREY_ALPHA, PLB_PIXELS_RGB, PLB_PIXELS_RGBA};
    plb_drawing *d = drawing_of_lines();
    plb_options *o = options_at(100);
    plb_error e;
    int w, h;
    CHECK(d && plb_drawing_size(d, &w, &h, o, &e) && w == 236 && h == 157);
    uint8_t *page = malloc((size_t)w * (size_t)h);
    plb_pixels whole = {page, (size_t)w, PLB_PIXELS_GREY, 0, 0, w, h};
    CHECK(plb_drawing_render_pixels(d, &whole, o, &e));
    for (int f = 0; f < 4; f++) {
        enum { W = 90, H = 70, X = 170, Y = -9 };
        size_t channels = (size_t)f + 1, stride = W * channels + 5;
        uint8_t *part = malloc(stride * H);
        memset(part, 7, stride * H);
        plb_pixels to = {part, stride, formats[f], X, Y, W, H};
        CHECK(plb_drawing_render_pixels(d, &to, o, &e));
        int wrong = 0;
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++) {
                bool on = X + x < w && Y + y >= 0 && Y + y < h;
                wrong += part[(size_t)y * stride + (size_t)x * channels] != (on ? page[(size_t)(Y + y) * (size_t)w + (size_t)(X + x)] : 7);
            }
        CHECK(wrong == 0);
        free(part);
    }
    plb_pixels narrow = {page, 10, PLB_PIXELS_RGB, 0, 0, 20, 20};
    CHECK(!plb_drawing_render_pixels(d, &narrow, o, &e) && e.status == PLB_ERROR_ARGUMENT);
    free(page);
    plb_options_free(o);
    plb_drawing_free(d);
}

/* A cairo surface shows what pixels show: of a dark that a second pencil shades, on white and on paper. */
static void a_surface_shows_the_pixels(void)
{
    static const char text[] = "plumbago-list 1\npage 60 40\nstroke - colour 0 0 0 1 width 0.5 butt M 5 5 L 55 5\n"
                               "fill - colour 0 0 0 1 nonzero M 10 15 L 40 15 L 40 35 L 10 35 Z\nend\n";
    plb_options *o = options_at(100);
    plb_error e;
    plb_file *f = plb_file_from_memory(text, sizeof text - 1, "text", &e);
    plb_drawing *d = f ? plb_file_draw(f, o, &e) : NULL;
    uint8_t page[2][157][236];
    for (int paper = 0; paper < 2; paper++) {
        CHECK(plb_options_set(o, "background", paper ? "paper" : "white", &e));
        plb_pixels to = {page[paper], 236, PLB_PIXELS_GREY, 0, 0, 236, 157};
        CHECK(d && plb_drawing_render_pixels(d, &to, o, &e));
        cairo_surface_t *s = plb_drawing_render(d, o, &e);
        CHECK(s && cairo_image_surface_get_width(s) == 236 && cairo_image_surface_get_height(s) == 157);
        int wrong = 0;
        for (int y = 0; s && y < 157; y++) {
            const uint32_t *row = (const uint32_t *)(const void *)(cairo_image_surface_get_data(s) + y * cairo_image_surface_get_stride(s));
            for (int x = 0; x < 236; x++)
                wrong += (row[x] & 255) != page[paper][y][x];
        }
        CHECK(wrong == 0);
        cairo_surface_destroy(s);
    }
    CHECK(page[0][100][100] < 80 && page[0][2][2] == 255 && page[1][2][2] < 255 && page[1][2][2] > 225);
    plb_drawing_free(d);
    plb_file_free(f);
    plb_options_free(o);
}

static bool refuse(void *closure, const void *data, size_t n)
{
    (void)data;
    (void)n;
    return --*(int *)closure > 0;
}

static void sinks_may_refuse(void)
{
    static const char *const formats[] = {"png", "pdf", "svg", "jpeg", "webp", "tiff"};
    plb_drawing *d = drawing_of_lines();
    plb_error e;
    for (int i = 0; i < 6; i++)
        for (int after = 1; after < 4; after++) {
            int left = after;
            bool ok = plb_drawing_write_to(d, formats[i], refuse, &left, NULL, &e);
            CHECK(ok || e.status == PLB_ERROR_FILE || e.status == PLB_ERROR_UNSUPPORTED);
            CHECK(!ok || left > 0);
        }
    size_t n;
    CHECK(!plb_drawing_write_memory(d, "gif", &n, NULL, &e) && e.status == PLB_ERROR_ARGUMENT);
    CHECK(!plb_drawing_write(d, "x.gif", NULL, &e) && e.status == PLB_ERROR_ARGUMENT && strstr(e.text, ".gif"));
    CHECK(!plb_drawing_write_png(d, "x.pdf", NULL, &e) && e.status == PLB_ERROR_ARGUMENT);
    CHECK(!plb_document_new("x.png", &e) && e.status == PLB_ERROR_ARGUMENT);
    plb_drawing_free(d);
}

static void many_lines_in_one_call(void)
{
    static const double ends[][4] = {{5, 5, 55, 50}, {50, 5, 5, 55}, {5, 30, 5, 30}};
    plb_options *o = options_at(100);
    cairo_surface_t *a = white_surface(), *b = white_surface();
    plb_error e;
    CHECK(plb_draw_lines(a, ends, 3, 4, o, &e));
    for (unsigned i = 0; i < 3; i++)
        CHECK(plb_draw_line(b, ends[i][0], ends[i][1], ends[i][2], ends[i][3], 4 + i, o, &e));
    cairo_surface_flush(a);
    cairo_surface_flush(b);
    CHECK(darkest_of(a) < 200 && !memcmp(cairo_image_surface_get_data(a), cairo_image_surface_get_data(b), 60 * 4 * 60));
    cairo_surface_destroy(a);
    cairo_surface_destroy(b);
    plb_options_free(o);
}

static void profiles_come_from_bytes(void)
{
    static char bytes[1 << 20];
    char file[] = "/tmp/plumbago-test-XXXXXX";
    int fd = mkstemp(file);
    plb_error e;
    plb_profile *p = plb_profile_load("2H", &e);
    CHECK(fd >= 0 && p && plb_profile_save(p, file, &e));
    FILE *from = fopen(file, "rb");
    size_t n = from ? fread(bytes, 1, sizeof bytes, from) : 0;
    plb_profile *q = plb_profile_from_memory(bytes, n, "bytes", &e);
    CHECK(q && !strcmp(plb_profile_name(q), plb_profile_name(p)) && plb_profile_width(q) == plb_profile_width(p));
    CHECK(!plb_profile_from_memory(bytes, n / 2, NULL, &e) && e.status != PLB_OK && strstr(e.text, "memory"));
    fclose(from);
    remove(file);
    plb_profile_free(p);
    plb_profile_free(q);
}

/* ---- progress ---- */

typedef struct {
    double last;
    int calls, stop_at;
    bool back;
} told;

static bool hear(void *closure, double done)
{
    told *t = closure;
    t->back = t->back || done < t->last || done > 1;
    t->last = done;
    return ++t->calls != t->stop_at;
}

static void progress_can_say_stop(void)
{
    plb_canvas *c = canvas_with_lines();
    plb_options *o = options_at(100);
    plb_error e;
    size_t n;
    told all = {0};
    plb_options_set_progress(o, hear, &all);
    plb_drawing *d = plb_canvas_draw(c, o, &e);
    void *png = plb_drawing_write_memory(d, "png", &n, o, &e);
    CHECK(d && png && all.calls >= 3 && all.last == 1 && !all.back);
    plb_memory_free(png);
    static const char *const formats[] = {"png", "svg"};
    for (int f = 0; f < 2; f++) {
        told stop = {.stop_at = 1};
        plb_options_set_progress(o, hear, &stop);
        CHECK(!plb_drawing_write_memory(d, formats[f], &n, o, &e) && e.status == PLB_ERROR_CANCELLED && n == 0);
    }
    plb_drawing_free(d);
    plb_canvas_free(c);
    plb_options_free(o);
}

/* The folder of the taps: that of the build, two above this program's. */
static void find_taps(char folder[4096])
{
    ssize_t n = readlink("/proc/self/exe", folder, 4000);
    folder[n > 0 ? n : 0] = '\0';
    for (int i = 0; i < 3 && strrchr(folder, '/'); i++)
        *strrchr(folder, '/') = '\0';
}

/* A program that never ends reads for us: the caller hears of it all the while, and ends it long before its limit. */
static void a_tap_can_be_stopped(void)
{
    static const char endless[] = "%!PS\n{} loop\nshowpage\n", square[] = "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0L9 9' stroke='#000'/></svg>";
    char taps[4096];
    plb_error e;
    find_taps(taps);
    plb_options *o = options_at(100);
    CHECK(plb_options_set(o, "helper-dir", taps, &e) && plb_options_set(o, "limit-time", "60", &e));
    plb_file *loop = plb_file_from_memory(endless, sizeof endless - 1, "loop.ps", &e), *lines = plb_file_from_memory(square, sizeof square - 1, NULL, &e);
    told stop = {.stop_at = 12};
    plb_options_set_progress(o, hear, &stop);
    struct timespec begin, end;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    CHECK(!plb_file_draw(loop, o, &e) && e.status == PLB_ERROR_CANCELLED && stop.calls == 12 && !stop.back && stop.last > 0 && stop.last < 0.1);
    stop = (told){.stop_at = 3};
    CHECK(!plb_file_pages(loop, o, &e) && e.status == PLB_ERROR_CANCELLED && stop.calls == 3);
    clock_gettime(CLOCK_MONOTONIC, &end);
    CHECK(end.tv_sec - begin.tv_sec < 30);
    CHECK(waitpid(-1, NULL, WNOHANG) < 0 && errno == ECHILD);
    /* At the first question tap-plain is ended, and librsvg is not tried after it. */
    stop = (told){.stop_at = 2};
    CHECK(!plb_file_draw(lines, o, &e) && e.status == PLB_ERROR_CANCELLED && stop.calls == 2);
    told all = {0};
    plb_options_set_progress(o, hear, &all);
    plb_drawing *d = plb_file_draw(lines, o, &e);
    CHECK(d && !all.back && all.calls >= 3);
    plb_drawing_free(d);
    plb_file_free(loop);
    plb_file_free(lines);
    plb_options_free(o);
}

int main(void)
{
    RUN(surfaces_that_cannot_be_drawn_on);
    RUN(lines_with_impossible_ends);
    RUN(success_clears_an_old_error);
    RUN(errors_are_one_line);
    RUN(a_canvas_becomes_strokes);
    RUN(reduced_strokes_lie_on_the_page);
    RUN(a_canvas_draws_what_a_file_does);
    RUN(clips_hold_strokes_back);
    RUN(a_canvas_remembers_what_failed);
    RUN(pixels_of_a_part_are_those_of_the_page);
    RUN(a_surface_shows_the_pixels);
    RUN(sinks_may_refuse);
    RUN(many_lines_in_one_call);
    RUN(profiles_come_from_bytes);
    RUN(progress_can_say_stop);
    RUN(a_tap_can_be_stopped);
    CHECK_EXIT;
}
