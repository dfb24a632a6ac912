/* SPDX-License-Identifier: MIT
 *
 * A scan as 8-bit grey, from a PNG by libpng.
 */
#include "profile/capture/scan_png.h"

#include "base/array.h"
#include "base/number/units.h"

#include <errno.h>
#include <math.h>
#include <png.h>
#include <setjmp.h>
#include <stdio.h>
#include <string.h>

/* These have to outlive a longjmp out of libpng. */
typedef struct {
    const char *file;
    FILE *from;
    error *err;
    png_structp png;
    png_infop info;
    png_bytep pixels;
    png_bytep *rows;
} png_source;

static void on_error(png_structp png, png_const_charp text)
{
    png_source *r = png_get_error_ptr(png);
    plb_fail(r->err, ERROR_SYNTAX, "%s: not a readable PNG: %s", r->file, text);
    longjmp(png_jmpbuf(png), 1);
}

static void on_warning(png_structp png, png_const_charp text)
{
    (void)png;
    (void)text;
}

static bool check_size(png_source *r, scan *s)
{
    png_uint_32 w = png_get_image_width(r->png, r->info), h = png_get_image_height(r->png, r->info);
    if (w > SCAN_MAX_SIDE || h > SCAN_MAX_SIDE || (double)w * h > SCAN_MAX_PIXELS)
        return plb_fail(r->err, ERROR_LIMIT, "%s: scan too large: %u x %u pixels, at most %d a side and %d in all", r->file, (unsigned)w, (unsigned)h, SCAN_MAX_SIDE, SCAN_MAX_PIXELS);
    s->width = (int)w;
    s->height = (int)h;
    return true;
}

static double resolution(png_structp png, png_infop info)
{
    double x = png_get_x_pixels_per_meter(png, info), y = png_get_y_pixels_per_meter(png, info);
    if (x <= 0 || fabs(x - y) > 0.01 * x)
        return 0;
    double dpi = x * MM_PER_INCH / 1000;
    double whole = floor(dpi + 0.5); /* 300 dpi are 11811.02 pixels a metre */
    return fabs(dpi - whole) < 0.02 ? whole : dpi;
}

/* Whatever it was: 8-bit RGBA, not premultiplied. */
static bool read_rgba(png_source *r, scan *s)
{
    if (setjmp(png_jmpbuf(r->png)))
        return false;
    png_set_user_limits(r->png, PNG_UINT_31_MAX, PNG_UINT_31_MAX); /* check_size has its own, with its own words */
    png_init_io(r->png, r->from);
    png_read_info(r->png, r->info);
    if (!check_size(r, s))
        return false;
    s->dpi = resolution(r->png, r->info);
    png_set_expand(r->png);
    png_set_scale_16(r->png);
    png_set_gray_to_rgb(r->png);
    png_set_add_alpha(r->png, 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(r->png);
    png_read_update_info(r->png, r->info);
    size_t stride = png_get_rowbytes(r->png, r->info);
    r->pixels = plb_new((size_t)s->height, stride);
    r->rows = plb_new((size_t)s->height, sizeof *r->rows);
    if (stride != (size_t)s->width * 4 || !r->pixels || !r->rows)
        return plb_fail_memory(r->err);
    for (int y = 0; y < s->height; y++)
        r->rows[y] = r->pixels + (size_t)y * stride;
    png_read_image(r->png, r->rows);
    png_read_end(r->png, NULL);
    return true;
}

/* Gives the luma of ITU-R BT.601 in 1/1000, on white; exact for a grey that is opaque. */
static uint8_t grey_of(const png_byte *rgba)
{
    int luma = (299 * rgba[0] + 587 * rgba[1] + 114 * rgba[2] + 500) / 1000, alpha = rgba[3];
    return (uint8_t)((luma * alpha + 255 * (255 - alpha) + 127) / 255);
}

static bool read_open_file(png_source *r, scan *s)
{
    r->png = png_create_read_struct(PNG_LIBPNG_VER_STRING, r, on_error, on_warning);
    r->info = r->png ? png_create_info_struct(r->png) : NULL;
    bool good = r->info ? read_rgba(r, s) : plb_fail_memory(r->err);
    size_t n = good ? (size_t)s->width * (size_t)s->height : 0;
    s->grey = good ? plb_new(n, 1) : NULL;
    if (good && !s->grey)
        good = plb_fail_memory(r->err);
    for (size_t i = 0; i < n && s->grey; i++)
        s->grey[i] = grey_of(r->pixels + 4 * i);
    plb_free(r->pixels);
    plb_free(r->rows);
    png_destroy_read_struct(&r->png, &r->info, NULL);
    return good;
}

bool plb_scan_png_read(scan *s, const char *file, error *err)
{
    *s = (scan){0};
    png_source r = {.file = file, .from = fopen(file, "rb"), .err = err};
    if (!r.from)
        return plb_fail(err, ERROR_FILE, "%s: cannot be opened: %s", file, strerror(errno));
    bool good = read_open_file(&r, s);
    fclose(r.from);
    return good;
}

bool plb_scan_png_transpose(const scan *s, scan *out, error *err)
{
    *out = (scan){.width = s->height, .height = s->width, .dpi = s->dpi};
    out->grey = plb_new((size_t)s->width * (size_t)s->height, 1);
    if (!out->grey)
        return plb_fail_memory(err);
    for (int y = 0; y < s->height; y++)
        for (int x = 0; x < s->width; x++)
            out->grey[(size_t)x * (size_t)s->height + (size_t)y] = s->grey[(size_t)y * (size_t)s->width + (size_t)x];
    return true;
}

void plb_scan_png_free(scan *s)
{
    plb_free(s->grey);
    s->grey = NULL;
}
