/* SPDX-License-Identifier: MIT
 *
 * From strip to page: mapping covers each pixel once, deposits darken and saturate in any order, surfaces agree.
 */
#include "check.h"

#include "api/plumbago.h"
#include "base/number/random.h"
#include "stat/pencil_for_tests.h"
#include "surface/page.h"

typedef struct {
    int covered[200][200];
    long darkness;
} canvas;

static bool count(void *closure, const patch *p)
{
    canvas *c = closure;
    for (int y = 0; y < p->height; y++)
        for (int x = 0; x < p->width; x++) {
            int px = p->x + x, py = p->y + y, dark = 255 - p->grey[y * p->width + x];
            c->darkness += dark;
            if (dark && px >= 0 && py >= 0 && px < 200 && py < 200)
                c->covered[py][px]++;
        }
    return true;
}

/* A strip of even darkness along a path: no pixel twice, and as much darkness as the path is long. */
static void map_even_strip(const point *base, size_t n, bool closed, double dpi, canvas *c, double *length_mm)
{
    stroke s = {.style = STROKE_STYLE_USUAL, .identity = 1, .n = n, .closed = closed};
    stroke_list list = {.strokes = {&s, 1, 1}, .points = {(point *)(uintptr_t)base, n, n}};
    stroke_options o = {.seed = 1, .squiggle = 0, .dpi = dpi};
    path_samples path = {0};
    CHECK(plb_path_sample(&list, &s, &o, &path, NULL));
    *length_mm = path.v[path.n - 1].along;
    int columns = (int)(*length_mm / 25.4 * 300 + 0.5) + 2 * STRIP_MARGIN, rows = 9 + 2 * STRIP_MARGIN;
    strip even = {columns, rows, (size_t)(columns * rows), malloc((size_t)(columns * rows)), NULL};
    memset(even.grey, 255, even.capacity);
    for (int y = STRIP_MARGIN; y < rows - STRIP_MARGIN; y++)
        memset(even.grey + y * columns + STRIP_MARGIN, 155, (size_t)(columns - 2 * STRIP_MARGIN));
    if (closed)
        plb_texture_wrap(&even);
    map_buffer buffer = {0};
    memset(c, 0, sizeof *c);
    shading texture = plb_strip_shading(&even, 300);
    CHECK(plb_strip_map(&texture, &(map_page){.dpi = dpi}, &path, closed, &buffer, count, c));
    free(even.grey);
    plb_free(buffer.fine);
    array_free(&path);
}

static long most_covered(const canvas *c)
{
    long most = 0;
    for (int y = 0; y < 200; y++)
        for (int x = 0; x < 200; x++)
            most = c->covered[y][x] > most ? c->covered[y][x] : most;
    return most;
}

static void lines_cover_each_pixel_once(void)
{
    static canvas c;
    for (int degrees = 0; degrees < 360; degrees += 7) {
        double a = degrees * PLB_PI / 180, length;
        point ends[2] = {{8, 8}, {8 + 6 * cos(a), 8 + 6 * sin(a)}};
        map_even_strip(ends, 2, false, 300, &c, &length);
        CHECK(most_covered(&c) == 1);
        CHECK_RANGE((double)c.darkness / (100.0 * 9 * (length / 25.4 * 300)), 0.98, 1.02);
    }
}

static void curves_cover_each_pixel_once(void)
{
    static canvas c;
    point ring[65];
    double length;
    for (int i = 0; i <= 64; i++)
        ring[i] = (point){8 + 4 * cos(i % 64 * PLB_PI / 32), 8 + 4 * sin(i % 64 * PLB_PI / 32)};
    map_even_strip(ring, 65, true, 300, &c, &length);
    long twice = 0, all = 0;
    for (int y = 0; y < 200; y++)
        for (int x = 0; x < 200; x++) {
            twice += c.covered[y][x] > 1;
            all += c.covered[y][x] > 0;
        }
    CHECK_RANGE((double)twice / (double)all, 0, 0.01);
    CHECK_RANGE((double)c.darkness / (100.0 * 9 * (length / 25.4 * 300)), 0.97, 1.03);
}

/* The same strip at half and at twice the resolution puts down the same darkness on paper. */
static void resolutions_agree(void)
{
    static canvas c;
    point ends[2] = {{2, 3}, {11, 7.5}};
    double length, at_300;
    map_even_strip(ends, 2, false, 300, &c, &length);
    at_300 = (double)c.darkness;
    map_even_strip(ends, 2, false, 150, &c, &length);
    CHECK_RANGE(4 * (double)c.darkness / at_300, 0.97, 1.03);
    map_even_strip(ends, 2, false, 600, &c, &length);
    CHECK_RANGE((double)c.darkness / 4 / at_300, 0.97, 1.03);
}

static void deposits_darken_and_saturate(void)
{
    profile *f = profile_for_tests();
    graphite ink;
    page p;
    plb_graphite_init(&ink, f);
    CHECK(ink.darkest < 90);
    for (int g = ink.darkest + 1; g < 256; g++)
        CHECK(ink.grey[ink.deposit[g]] == g); /* a stroke alone looks as its texture says */
    CHECK(plb_page_init(&p, 8, 8, 8, false, &ink, NULL, NULL));
    static patch dot = {.x = -1, .y = 6, .width = 3, .height = 3};
    memset(dot.grey, 170, 9);
    memset(dot.to, 3, 3);
    int before = 255;
    for (int k = 0; k < 50; k++) {
        plb_page_lay(&p, &dot, NULL);
        int now = ink.grey[p.deposit[6 * p.stride]];
        CHECK(now <= before && (now < before || k > 3));
        before = now;
    }
    CHECK(before == ink.darkest && p.deposit[5 * p.stride] == 0 && p.deposit[6 * p.stride + 2] == 0);
    plb_page_free(&p);
    int w, h;
    CHECK(!plb_page_size(1e9, 1e9, &w, &h, NULL));
    CHECK(!plb_page_size((double)NAN, 5, &w, &h, NULL));
    free_profile_for_tests(f);
}

/* Rows are worked on in whole registers: the sums are those of each pixel by itself, and beside the page there is nothing. */
static void sums_are_those_of_each_pixel(void)
{
    enum { SIDE = 37 };
    profile *f = profile_for_tests();
    graphite ink;
    page p;
    plb_graphite_init(&ink, f);
    CHECK(plb_page_init(&p, SIDE, SIDE, SIDE, false, &ink, NULL, NULL));
    static uint32_t sums[SIDE][SIDE];
    static patch one;
    for (uint64_t k = 0; k < 60; k++) {
        int bits = (int)(random_bits(k, 0) >> 40), side = 1 + bits % 50;
        one = (patch){.x = bits / 50 % 57 - 20, .y = bits / 3000 % 57 - 20, .width = side, .height = side};
        for (int y = 0; y < side; y++) {
            one.from[y] = (uint8_t)(random_bits(k, (uint64_t)(1 + y)) % (uint64_t)(side + 1));
            one.to[y] = (uint8_t)(random_bits(k, (uint64_t)(100 + y)) % (uint64_t)(side + 1));
        }
        for (int i = 0; i < side * side; i++) {
            int x = i % side, y = i / side, px = one.x + x, py = one.y + y;
            one.grey[i] = (uint8_t)random_bits(k, (uint64_t)(200 + i));
            if (x >= one.from[y] && x < one.to[y] && px >= 0 && px < SIDE && py >= 0 && py < SIDE)
                sums[py][px] += ink.deposit[one.grey[i]];
        }
        plb_page_lay(&p, &one, NULL);
    }
    for (size_t y = 0; y < SIDE; y++)
        for (size_t x = 0; x < p.stride; x++)
            CHECK(p.deposit[y * p.stride + x] == (x >= SIDE ? 0 : sums[y][x] > 65535 ? 65535 : sums[y][x]));
    plb_page_free(&p);
    free_profile_for_tests(f);
}

static void order_does_not_matter(void)
{
    profile *f = profile_for_tests();
    graphite ink;
    page a, b;
    plb_graphite_init(&ink, f);
    CHECK(plb_page_init(&a, 60, 60, 60, false, &ink, NULL, NULL) && plb_page_init(&b, 60, 60, 60, false, &ink, NULL, NULL));
    static patch patches[40];
    for (int k = 0; k < 40; k++) {
        patches[k] = (patch){.x = k, .y = 40 - k, .width = 20, .height = 20};
        memset(patches[k].to, 20, 20);
        for (int i = 0; i < 400; i++)
            patches[k].grey[i] = (uint8_t)random_bits((uint64_t)k, (uint64_t)i);
    }
    for (int k = 0; k < 40; k++) {
        plb_page_lay(&a, &patches[k], NULL);
        plb_page_lay(&b, &patches[(k * 7 + 3) % 40], NULL);
    }
    CHECK(!memcmp(a.deposit, b.deposit, a.plane * sizeof *a.deposit));
    plb_page_free(&a);
    plb_page_free(&b);
    free_profile_for_tests(f);
}

/* One line drawn onto a cairo surface: it darkens, never lightens, keeps to its place, and another number is another line. */
static void a_line_on_a_cairo_surface(void)
{
    plb_options *o = plb_options_new();
    plb_error e = {PLB_OK, ""};
    uint32_t sums[3] = {0};
    unsigned char first[400 * 60 * 4];
    for (int k = 0; k < 3; k++) {
        cairo_surface_t *s = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, 400, 60);
        cairo_t *cr = cairo_create(s);
        double paper = k == 2 ? 0.05 : 1; /* the third on a surface darker than any graphite */
        cairo_set_source_rgb(cr, paper, paper, paper);
        cairo_paint(cr);
        cairo_destroy(cr);
        cairo_surface_flush(s);
        CHECK(plb_draw_line(s, 20, 30, 380, 30, (uint64_t)k, o, &e));
        cairo_surface_flush(s);
        const unsigned char *data = cairo_image_surface_get_data(s);
        for (int y = 0; y < 60; y++)
            for (int x = 0; x < 400; x++) {
                int grey = data[y * 1600 + 4 * x], paper_grey = data[0];
                sums[k] += grey < paper_grey;
                CHECK(grey <= paper_grey);
                CHECK(grey == paper_grey || (abs(y - 30) < 16 && x > 15 && x < 385));
            }
        if (k == 0)
            memcpy(first, data, sizeof first);
        if (k == 1)
            CHECK(memcmp(first, data, sizeof first));
        cairo_surface_destroy(s);
    }
    CHECK(sums[0] > 1000 && sums[1] > 1000 && sums[2] == 0);
    plb_options_free(o);
}

static void wrong_calls_are_refused(void)
{
    plb_options *o = plb_options_new();
    plb_error e = {PLB_OK, ""};
    cairo_surface_t *s = cairo_image_surface_create(CAIRO_FORMAT_A8, 10, 10);
    CHECK(!plb_draw_line(s, 0, 0, (double)NAN, 5, 0, o, &e) && e.status == PLB_ERROR_ARGUMENT);
    cairo_surface_destroy(s);
    CHECK(!plb_drawing_load("there/is/no/such.svg", o, &e) && e.status == PLB_ERROR_FILE && strstr(e.text, "such.svg"));
    CHECK(!plb_profile_load("5H", &e) && e.status != PLB_OK);
    plb_options_free(o);
}

int main(void)
{
    RUN(lines_cover_each_pixel_once);
    RUN(curves_cover_each_pixel_once);
    RUN(resolutions_agree);
    RUN(deposits_darken_and_saturate);
    RUN(sums_are_those_of_each_pixel);
    RUN(order_does_not_matter);
    RUN(a_line_on_a_cairo_surface);
    RUN(wrong_calls_are_refused);
    CHECK_EXIT;
}
