/* SPDX-License-Identifier: MIT
 *
 * The page as PNG: 8-bit grey, or grey with alpha. Grain does not compress by prediction: no filter and a low level
 * are both faster and smaller than libpng's defaults.
 */
#include "surface/page.h"

#include "base/array.h"

#include <errno.h>
#include <math.h>
#include <png.h>
#include <string.h>

#define COMPRESSION_LEVEL 1

typedef struct {
    error *err;
    const char *name;
} complaint;

static void on_error(png_structp png, png_const_charp text)
{
    complaint *c = png_get_error_ptr(png);
    if (errno)
        plb_fail(c->err, ERROR_FILE, "%s: cannot be written: %s", c->name, strerror(errno));
    else
        plb_fail(c->err, ERROR_FILE, "%s: cannot be written: %s", c->name, text);
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp text)
{
    (void)png;
    (void)text;
}

static void write_text(png_structp png, png_infop info, const char *const *pairs)
{
    for (; pairs && pairs[0]; pairs += 2) {
        png_text t = {.compression = PNG_TEXT_COMPRESSION_NONE};
        char keyword[80];
        snprintf(keyword, sizeof keyword, "%s", pairs[0]);
        t.key = keyword;
        t.text = (char *)(uintptr_t)pairs[1]; /* libpng copies it; its type lacks a const */
        t.text_length = strlen(pairs[1]);
        png_set_text(png, info, &t, 1);
    }
}

static void write_head(png_structp png, png_infop info, const page *p, const png_options *o)
{
    int type = o->background == PAGE_WHITE ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_GRAY_ALPHA;
    png_set_user_limits(png, 0x7fffffff, 0x7fffffff);
    png_set_IHDR(png, info, (png_uint_32)p->width, (png_uint_32)p->height, 8, type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_uint_32 per_metre = (png_uint_32)floor(o->dpi / 0.0254 + 0.5);
    png_set_pHYs(png, info, per_metre, per_metre, PNG_RESOLUTION_METER);
    write_text(png, info, o->text);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_set_compression_level(png, COMPRESSION_LEVEL);
    png_write_info(png, info);
}

/* Graphite of one grey, the darkest, more or less opaque: over white it looks as the opaque page does. */
static void convert_row(const page *p, page_background background, int y, uint8_t *row)
{
    if (!p->touched[y]) {
        memset(row, background == PAGE_WHITE ? 255 : 0, (size_t)p->width * (background == PAGE_WHITE ? 1 : 2));
        return;
    }
    const uint16_t *from = p->deposit + (size_t)y * (size_t)p->width;
    int darkest = p->ink->darkest, depth = 255 - darkest;
    for (int x = 0; x < p->width; x++) {
        uint8_t grey = p->ink->grey[from[x]];
        if (background == PAGE_WHITE) {
            row[x] = grey;
        } else {
            row[2 * x] = (uint8_t)darkest;
            row[2 * x + 1] = (uint8_t)(((255 - grey) * 255 + depth / 2) / depth);
        }
    }
}

static bool write_all(png_structp png, png_infop info, const page *p, const png_options *o, FILE *to, uint8_t *row)
{
    if (setjmp(png_jmpbuf(png)))
        return false;
    errno = 0;
    png_init_io(png, to);
    write_head(png, info, p, o);
    for (int y = 0; y < p->height; y++) {
        convert_row(p, o->background, y, row);
        png_write_row(png, row);
    }
    png_write_end(png, info);
    return true;
}

bool plb_page_write_png(const page *p, const png_options *o, FILE *to, const char *name, error *err)
{
    complaint c = {err, name};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &c, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    uint8_t *row = plb_new((size_t)p->width, 2);
    bool ok = info && row ? write_all(png, info, p, o, to, row) : plb_fail_memory(err);
    png_destroy_write_struct(&png, &info);
    plb_free(row);
    return ok;
}
