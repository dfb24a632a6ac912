/* SPDX-License-Identifier: MIT
 *
 * Capture from scans: lines drawn here, with statistics known beforehand, at angles, among other marks, in all kinds of
 * PNG.
 */
#include "check.h"

#include "base/array.h"
#include "base/number/random.h"
#include "profile/histogram.h"
#include "profile/profile.h"

#include <png.h>
#include <stdint.h>

/* ---- scans made here ---- */

typedef struct {
    int width, height;
    uint8_t *grey;
} picture;

static picture paper(int width, int height, int grey)
{
    picture p = {width, height, malloc((size_t)(width * height))};
    memset(p.grey, grey, (size_t)(width * height));
    return p;
}

static uint8_t *at(const picture *p, int x, int y)
{
    return &p->grey[y * p->width + x];
}

/* Capture reads the kinds of PNG that a scanner or a program may write. */
typedef enum { PNG_GREY, PNG_GREY16, PNG_RGB, PNG_RGB16, PNG_RGBA, PNG_GREY_ALPHA, PNG_PALETTE, PNG_INTERLACED } png_kind;

static const struct {
    int colour, depth, channels, interlace;
} kinds[] = {
    [PNG_GREY] = {PNG_COLOR_TYPE_GRAY, 8, 1, PNG_INTERLACE_NONE},
    [PNG_GREY16] = {PNG_COLOR_TYPE_GRAY, 16, 2, PNG_INTERLACE_NONE},
    [PNG_RGB] = {PNG_COLOR_TYPE_RGB, 8, 3, PNG_INTERLACE_NONE},
    [PNG_RGB16] = {PNG_COLOR_TYPE_RGB, 16, 6, PNG_INTERLACE_NONE},
    [PNG_RGBA] = {PNG_COLOR_TYPE_RGB_ALPHA, 8, 4, PNG_INTERLACE_NONE},
    [PNG_GREY_ALPHA] = {PNG_COLOR_TYPE_GRAY_ALPHA, 8, 2, PNG_INTERLACE_NONE},
    [PNG_PALETTE] = {PNG_COLOR_TYPE_PALETTE, 8, 1, PNG_INTERLACE_NONE},
    [PNG_INTERLACED] = {PNG_COLOR_TYPE_GRAY, 8, 1, PNG_INTERLACE_ADAM7},
};

/* The bytes of one pixel; alpha kinds: the paper (255) is transparent black. */
static void fill_pixel(png_bytep out, png_kind kind, uint8_t grey)
{
    memset(out, grey, (size_t)kinds[kind].channels);
    if (kind == PNG_RGBA || kind == PNG_GREY_ALPHA) {
        bool bare = grey == 255;
        memset(out, bare ? 0 : grey, (size_t)kinds[kind].channels - 1);
        out[kinds[kind].channels - 1] = bare ? 0 : 255;
    }
}

static void save_as(const picture *p, const char *file, png_kind kind, int per_metre)
{
    FILE *to = fopen(file, "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, to);
    png_set_IHDR(png, info, (png_uint_32)p->width, (png_uint_32)p->height, kinds[kind].depth, kinds[kind].colour, kinds[kind].interlace,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_color colours[256];
    for (int i = 0; i < 256; i++)
        colours[i] = (png_color){(png_byte)i, (png_byte)i, (png_byte)i};
    if (kind == PNG_PALETTE)
        png_set_PLTE(png, info, colours, 256);
    if (per_metre)
        png_set_pHYs(png, info, (png_uint_32)per_metre, (png_uint_32)per_metre, PNG_RESOLUTION_METER);
    png_write_info(png, info);
    size_t stride = (size_t)(p->width * kinds[kind].channels);
    png_bytep all = malloc(stride * (size_t)p->height), *rows = malloc((size_t)p->height * sizeof *rows);
    for (int y = 0; y < p->height; y++) {
        rows[y] = all + (size_t)y * stride;
        for (int x = 0; x < p->width; x++)
            fill_pixel(rows[y] + x * kinds[kind].channels, kind, *at(p, x, y));
    }
    png_write_image(png, rows);
    png_write_end(png, NULL);
    png_destroy_write_struct(&png, &info);
    free(rows);
    free(all);
    fclose(to);
}

static void save(const picture *p, const char *file)
{
    save_as(p, file, PNG_GREY, 0);
}

static double uniform(int x, int y)
{
    return random_unit(random_mix((uint64_t)(x + 4096)), (uint64_t)(y + 4096));
}

#define LINE_TOP 28
#define LINE_ROWS 5

/* A level line of five rows from end to end, the grey of each column drawn from 100 to 149. */
static int column_grey(int x)
{
    return 100 + (int)(50 * uniform(x, 0));
}
static picture known_line(int width)
{
    picture p = paper(width, 61, 255);
    for (int x = 0; x < width; x++)
        for (int y = LINE_TOP; y < LINE_TOP + LINE_ROWS; y++)
            *at(&p, x, y) = (uint8_t)column_grey(x);
    return p;
}

/* A line through the middle of the picture at an angle: depth 120 with a Gaussian flank, grain of +-20. */
static picture slanting_line(int side, double degrees, double half_width, double unit)
{
    picture p = paper(side, side, 252);
    double c = cos(degrees * 3.14159265358979 / 180), s = sin(degrees * 3.14159265358979 / 180);
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side; x++) {
            double u = (x - side / 2) * c + (y - side / 2) * s, v = fabs((y - side / 2 - 0.3) * c - (x - side / 2) * s);
            double shape = 1 / (1 + exp((v - half_width) / (0.45 * unit)));
            if (fabs(u) < 0.45 * side)
                *at(&p, x, y) = (uint8_t)(252 - shape * (120 + 40 * (uniform(x, y) - 0.5)) + 0.5);
        }
    return p;
}

/* ---- capturing them ---- */

static profile *capture_with(const char *file, const capture_options *o, error *err)
{
    const char *const files[] = {file};
    *err = (error){0};
    return plb_capture(files, 1, o, err);
}

static profile *capture_one(const char *file)
{
    error err;
    capture_options o = plb_capture_defaults();
    profile *p = capture_with(file, &o, &err);
    if (!p)
        printf("# %s\n", err.text);
    return p;
}

static profile *capture_picture(picture p)
{
    save(&p, "scan.png");
    free(p.grey);
    return capture_one("scan.png");
}

static bool same(const profile *a, const profile *b)
{
    size_t n = 0, m = 0;
    unsigned char *x = a ? plb_profile_serialise(a, &n, NULL) : NULL, *y = b ? plb_profile_serialise(b, &m, NULL) : NULL;
    bool equal = x && y && n == m && !memcmp(x, y, n);
    plb_free(x);
    plb_free(y);
    return equal;
}

/* ---- known statistics ---- */

/* Paper 255: no scaling, every count is known. Fourteen columns at either end are left out, and the rows of the line
 * are 28 to 32. */
static void counts_are_exact(void)
{
    enum { WIDTH = 700, FIRST = 14, LAST = WIDTH - 15 };
    uint32_t mid[256] = {0};
    uint32_t *ccm = plb_new(65536, sizeof *ccm);
    for (int x = FIRST; x <= LAST; x++) {
        mid[column_grey(x)]++;
        if (x < LAST)
            ccm[column_grey(x) * 256 + column_grey(x + 1)] += LINE_ROWS;
    }
    profile *p = capture_picture(known_line(WIDTH));
    CHECK(p != NULL);
    if (p) {
        CHECK(p->pixels == LAST - FIRST + 1 && p->lines == 1 && p->paper == 255 && p->dpi == 300);
        CHECK(!memcmp(mid, p->mid, sizeof mid));
        CHECK(!memcmp(ccm, p->ccm, 65536 * sizeof *ccm));
        for (int g = 0; g < 256; g++)
            CHECK(p->range[g] == LINE_ROWS * mid[g]);
        CHECK_RANGE(p->width_half, 4.75, 5.25);
        CHECK_RANGE(p->section_mean[0], 122, 127);
        CHECK_RANGE(p->section_mean[20], 255, 255);
        CHECK(p->min_mid == 100 && p->max_mid >= 148 && p->max_range == p->max_mid);
    }
    plb_profile_release(p);
    plb_free(ccm);
}

/* The mean of greys stays when they are scaled to paper 255, and none is left without pixels. */
static void scaling_keeps_the_mean(void)
{
    picture p = paper(6000, 61, 240);
    double sum = 0;
    for (int x = 0; x < 6000; x++)
        for (int y = LINE_TOP; y < LINE_TOP + LINE_ROWS; y++) {
            *at(&p, x, y) = (uint8_t)(100 + 60 * uniform(x, y));
            sum += *at(&p, x, y);
        }
    profile *f = capture_picture(p);
    CHECK(f && f->paper == 240);
    if (f) {
        CHECK_RANGE(plb_histogram_mean(f->range, 255) / (sum / (6000 * LINE_ROWS) * 255 / 240), 0.998, 1.002);
        for (int g = 110; g < 165; g++)
            CHECK(f->range[g] > 200);
    }
    plb_profile_release(f);
}

/* ---- where the line runs ---- */

static void an_upright_line_is_the_same(void)
{
    picture p = known_line(500), turned = paper(61, 500, 255);
    for (int y = 0; y < p.height; y++)
        for (int x = 0; x < p.width; x++)
            *at(&turned, y, x) = *at(&p, x, y);
    profile *a = capture_picture(p), *b = capture_picture(turned);
    CHECK(same(a, b));
    plb_profile_release(a);
    plb_profile_release(b);
}

/* Every direction gives the same width and greys; whole pixels are shifted, nothing is resampled. */
static void slanting_lines(void)
{
    static const double degrees[] = {0, 3, 12, 27, 40, 45, 50, 66, 87, 90, 105, 135, 160, 179};
    for (size_t i = 0; i < sizeof degrees / sizeof *degrees; i++) {
        profile *p = capture_picture(slanting_line(500, degrees[i], 2.6, 1));
        CHECK(p != NULL);
        if (p) {
            CHECK_RANGE(p->width_half, 4.95, 5.45);
            CHECK_RANGE(plb_profile_centre(p), 132, 138);
            CHECK(p->pixels > 260);
        }
        plb_profile_release(p);
    }
}

static void resolution_only_scales(void)
{
    picture coarse = slanting_line(500, 8, 2.6, 1), fine = slanting_line(1000, 8, 5.2, 2);
    save_as(&coarse, "coarse.png", PNG_GREY, 11811);
    save_as(&fine, "fine.png", PNG_GREY, 23622);
    profile *a = capture_one("coarse.png"), *b = capture_one("fine.png");
    CHECK(a && b && a->dpi == 300 && b->dpi == 600);
    if (a && b) {
        CHECK_RANGE(b->width_half / a->width_half, 1.95, 2.05);
        CHECK_RANGE(plb_profile_centre(b) - plb_profile_centre(a), -2, 2);
        CHECK(a->grain.present && b->grain.present); /* the grain is at 300 dpi whatever the scan */
        CHECK_RANGE(b->grain.reference_width / a->grain.reference_width, 0.95, 1.05);
        CHECK_RANGE(b->grain.line_mean[0] - a->grain.line_mean[0], -0.03, 0.03);
    }
    plb_profile_release(a);
    plb_profile_release(b);
    free(coarse.grey);
    free(fine.grey);
}

/* ---- other marks ---- */

static void crossing_marks_are_left_out(void)
{
    picture plain = known_line(900), crossed = known_line(900);
    for (int x = 300; x < 306; x++)
        for (int y = 0; y < 61; y++)
            *at(&crossed, x, y) = 40;
    profile *a = capture_picture(plain), *b = capture_picture(crossed);
    CHECK(a && b);
    if (a && b) {
        CHECK(b->pixels < a->pixels && b->pixels > a->pixels - 60);
        CHECK(plb_histogram_total(b->mid, 100) == 0); /* nothing of the mark, which is darker than the line … */
        CHECK(plb_histogram_total(b->range, 100) == 0);
        for (int g = 0; g < 256; g++)
            CHECK(b->mid[g] <= a->mid[g]); /* … and both sides of it */
    }
    plb_profile_release(a);
    plb_profile_release(b);
}

static void a_printed_grid_is_left_out(void)
{
    picture p = known_line(900);
    for (int x = 20; x < 900; x += 48)
        for (int y = 0; y < 61; y++)
            for (int w = 0; w < 2; w++)
                if (*at(&p, x + w, y) == 255)
                    *at(&p, x + w, y) = 225;
                else
                    *at(&p, x + w, y) = 90;
    profile *f = capture_picture(p);
    CHECK(f && plb_histogram_total(f->mid, 100) == 0);
    if (f)
        for (int g = 150; g < 255; g++)
            CHECK(f->range[g] == 0);
    plb_profile_release(f);
}

/* Among several marks capture takes the line with the most darkness. */
static void the_line_is_found_among_marks(void)
{
    picture p = paper(700, 400, 250);
    for (int x = 0; x < 700; x++)
        *at(&p, x, 380) = 215; /* a long faint rule */
    for (int y = 40; y < 140; y++)
        for (int x = 100; x < 104; x++)
            *at(&p, x, y) = 60; /* short and dark */
    for (int y = 150; y < 190; y++)
        for (int x = 500; x < 540; x++)
            *at(&p, x, y) = 20; /* a blot */
    for (int x = 60; x < 640; x++)
        for (int w = 0; w < 4; w++)
            *at(&p, x, 250 + x / 10 + w) = 140;
    profile *f = capture_picture(p);
    CHECK(f != NULL);
    if (f) {
        CHECK_RANGE(plb_profile_centre(f), 141, 145);
        CHECK(f->pixels > 500);
    }
    plb_profile_release(f);
}

static void noise_of_the_paper_is_paper(void)
{
    picture p = known_line(900);
    for (int y = 0; y < 61; y++)
        for (int x = 0; x < 900; x++)
            if (*at(&p, x, y) == 255)
                *at(&p, x, y) = (uint8_t)(249 + 6 * uniform(x, y));
    profile *f = capture_picture(p);
    CHECK(f != NULL);
    if (f) {
        CHECK(f->section_mean[30] == 255 && f->section_sd[30] == 0);
        for (int g = 160; g < 255; g++)
            CHECK(f->range[g] == 0);
    }
    plb_profile_release(f);
}

/* ---- kinds of PNG ---- */

static void every_kind_of_png_is_the_same(void)
{
    profile *first = NULL;
    for (size_t kind = 0; kind < sizeof kinds / sizeof *kinds; kind++) {
        picture p = known_line(400);
        save_as(&p, "kind.png", (png_kind)kind, 0);
        free(p.grey);
        profile *f = capture_one("kind.png");
        CHECK(f != NULL);
        if (!first)
            first = f;
        CHECK(same(first, f));
        if (f != first)
            plb_profile_release(f);
    }
    plb_profile_release(first);
}

static void bad_scans(void)
{
    static const unsigned char huge[] = "\211PNG\r\n\032\n\0\0\0\15IHDR\0\0\x75\x30\0\0\x75\x30\10\0\0\0\0";
    error err;
    capture_options o = plb_capture_defaults();
    CHECK(!capture_with("no-such.png", &o, &err) && err.kind == ERROR_FILE && strstr(err.text, "no-such.png"));
    FILE *f = fopen("bad.png", "wb");
    fputs("no picture", f);
    fclose(f);
    CHECK(!capture_with("bad.png", &o, &err) && err.kind == ERROR_SYNTAX && strstr(err.text, "bad.png"));
    f = fopen("bad.png", "wb");
    fwrite(huge, 1, sizeof huge - 1, f);
    fwrite("\x43\x4c\xa7\x66\0\0\0\0IDAT", 1, 12, f); /* the header's checksum is right: 30000 x 30000 it is */
    fclose(f);
    CHECK(!capture_with("bad.png", &o, &err) && err.kind == ERROR_LIMIT);
}

/* Every PNG cut short is refused. */
static void cut_scans(void)
{
    picture p = known_line(300);
    save(&p, "whole.png");
    free(p.grey);
    FILE *f = fopen("whole.png", "rb");
    unsigned char data[20000];
    size_t n = fread(data, 1, sizeof data, f);
    fclose(f);
    capture_options o = plb_capture_defaults();
    bool all = n > 100;
    for (size_t cut = 0; cut + 12 < n; cut += 17) { /* the last 12 bytes only say that it ends */
        error err;
        f = fopen("cut.png", "wb");
        fwrite(data, 1, cut, f);
        fclose(f);
        profile *q = capture_with("cut.png", &o, &err);
        all = all && !q && err.kind == ERROR_SYNTAX;
        plb_profile_release(q);
    }
    CHECK(all);
}

static void scans_without_a_line(void)
{
    error err;
    capture_options o = plb_capture_defaults();
    picture p[] = {paper(400, 60, 255), paper(400, 60, 30), paper(1, 1, 255), paper(400, 60, 250)};
    for (int x = 100; x < 130; x++)
        *at(&p[3], x, 30) = 60; /* too short */
    for (size_t i = 0; i < sizeof p / sizeof *p; i++) {
        save(&p[i], "empty.png");
        CHECK(!capture_with("empty.png", &o, &err) && err.kind == ERROR_ARGUMENT && strstr(err.text, "no usable line"));
        free(p[i].grey);
    }
}

/* ---- options ---- */

static void lines_are_pooled_and_chosen(void)
{
    picture dark = known_line(400), light = known_line(500);
    for (int i = 0; i < 500 * 61; i++)
        light.grey[i] = (uint8_t)(light.grey[i] == 255 ? 255 : light.grey[i] + 60);
    save(&dark, "dark.png");
    save(&light, "light.png");
    const char *const files[] = {"dark.png", "light.png"};
    error err = {0};
    capture_options o = plb_capture_defaults();
    profile *both = plb_capture(files, 2, &o, &err);
    CHECK(both && both->lines == 2 && both->pixels == 400 + 500 - 4 * 14);
    o.centre_min = 160, o.centre_max = 200;
    profile *one = plb_capture(files, 2, &o, &err);
    CHECK(one && one->lines == 1 && one->pixels == 500 - 2 * 14 && one->min_mid == 160);
    o.centre_min = 230, o.centre_max = 240;
    CHECK(!plb_capture(files, 2, &o, &err) && err.kind == ERROR_ARGUMENT);
    plb_profile_release(both);
    plb_profile_release(one);
    free(dark.grey);
    free(light.grey);
}

static void resolutions_must_agree(void)
{
    picture p = known_line(400);
    save_as(&p, "a.png", PNG_GREY, 11811);
    save_as(&p, "b.png", PNG_GREY, 23622);
    const char *const files[] = {"a.png", "b.png"};
    error err = {0};
    capture_options o = plb_capture_defaults();
    CHECK(!plb_capture(files, 2, &o, &err) && err.kind == ERROR_ARGUMENT && strstr(err.text, "b.png"));
    err = (error){0};
    o.dpi = 300;
    profile *f = plb_capture(files, 2, &o, &err);
    CHECK(f && f->dpi == 300 && f->lines == 2);
    plb_profile_release(f);
    free(p.grey);
}

static void width_stretches_only_the_section(void)
{
    picture p = slanting_line(500, 5, 2.6, 1);
    save(&p, "scan.png");
    free(p.grey);
    error err;
    capture_options o = plb_capture_defaults();
    profile *plain = capture_with("scan.png", &o, &err);
    o.width = 0.8;
    profile *wide = capture_with("scan.png", &o, &err);
    CHECK(plain && wide);
    if (plain && wide) {
        CHECK_RANGE(wide->width_half / 300 * 25.4, 0.799, 0.801);
        CHECK_RANGE(exp((double)wide->grain.line_mean[1]) / 300 * 25.4, 0.799, 0.801);
        CHECK(wide->grain.reference_width == plain->grain.reference_width);
        CHECK_RANGE(plain->grain.reference_width / plain->width_half, 0.93, 1.07);
        CHECK_RANGE(wide->width_tenth / plain->width_tenth / (wide->width_half / plain->width_half), 0.97, 1.03);
        CHECK(!memcmp(plain->range, wide->range, sizeof plain->range));
        CHECK(!memcmp(plain->ccm, wide->ccm, 65536 * sizeof *plain->ccm));
    }
    plb_profile_release(plain);
    plb_profile_release(wide);
}

static void wrong_options(void)
{
    picture p = known_line(400);
    save(&p, "scan.png");
    free(p.grey);
    for (int i = 0; i < 8; i++) {
        capture_options o = plb_capture_defaults();
        error err;
        if (i == 0) o.name = "";
        if (i == 1) o.name = "a name of more than thirty-one bytes";
        if (i == 2) o.name = "tab\t";
        if (i == 3) o.provenance = "\377";
        if (i == 4) o.centre_min = 200, o.centre_max = 100;
        if (i == 5) o.width = -1;
        if (i == 6) o.width = NAN;
        if (i == 7) o.dpi = 1e9;
        CHECK(!capture_with("scan.png", &o, &err) && err.kind == ERROR_ARGUMENT);
    }
}

/* A file of the profile holds what was captured. */
static void captured_is_saved(void)
{
    profile *p = capture_picture(slanting_line(500, 5, 2.6, 1)), *q = NULL;
    error err = {0};
    CHECK(p && plb_profile_write(p, "p.pencil", &err) && (q = plb_profile_read("p.pencil", &err)));
    CHECK(q && same(p, q) && p->width_half == q->width_half && !memcmp(p->section_mean, q->section_mean, sizeof p->section_mean));
    plb_profile_release(p);
    plb_profile_release(q);
}

int main(void)
{
    RUN(counts_are_exact);
    RUN(scaling_keeps_the_mean);
    RUN(an_upright_line_is_the_same);
    RUN(slanting_lines);
    RUN(resolution_only_scales);
    RUN(crossing_marks_are_left_out);
    RUN(a_printed_grid_is_left_out);
    RUN(the_line_is_found_among_marks);
    RUN(noise_of_the_paper_is_paper);
    RUN(every_kind_of_png_is_the_same);
    RUN(bad_scans);
    RUN(cut_scans);
    RUN(scans_without_a_line);
    RUN(lines_are_pooled_and_chosen);
    RUN(resolutions_must_agree);
    RUN(width_stretches_only_the_section);
    RUN(wrong_options);
    RUN(captured_is_saved);
    CHECK_EXIT;
}
