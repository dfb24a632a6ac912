/* SPDX-License-Identifier: MIT
 *
 * This file puts pages and patches on cairo image surfaces.
 */
#include "surface/page.h"

#include "base/array.h"

#include <string.h>

cairo_surface_t *plb_page_surface_new(int width, int height, error *err)
{
    cairo_surface_t *s = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    if (cairo_surface_status(s) == CAIRO_STATUS_SUCCESS)
        return s;
    plb_fail(err, ERROR_LIMIT, "cairo makes no surface of %d by %d pixels: %s", width, height,
             cairo_status_to_string(cairo_surface_status(s)));
    cairo_surface_destroy(s);
    return NULL;
}

/* Returns a pixel of a picture's row as cairo stores it, premultiplied. */
static uint32_t pixel_of(const uint8_t *from, int channels)
{
    bool grey = channels < PIGMENT_PLANES;
    uint32_t alpha = channels % 2 ? 255 : from[channels - 1], v = alpha;
    for (int k = 0; k < PIGMENT_PLANES; k++)
        v = v << 8 | (from[grey ? 0 : k] * alpha + 127) / 255;
    return v;
}

bool plb_page_to_cairo(const page *p, page_background background, cairo_surface_t *to)
{
    unsigned char *data = cairo_image_surface_get_data(to);
    size_t stride = (size_t)cairo_image_surface_get_stride(to);
    int channels = plb_page_channels(background, p->planes == PIGMENT_PLANES);
    uint8_t *bytes = plb_new((size_t)p->width, (size_t)channels);
    for (int y = 0; bytes && y < p->rows; y++) {
        uint32_t *row = (uint32_t *)(void *)(data + (size_t)(p->top + y) * stride);
        plb_page_row(p, background, p->top + y, bytes);
        for (int x = 0; x < p->width; x++)
            row[x] = pixel_of(bytes + channels * x, channels);
    }
    cairo_surface_mark_dirty(to);
    plb_free(bytes);
    return bytes != NULL;
}

/* Lays graphite of grey `g` and opacity `t` over one premultiplied channel `c` of a pixel with opacity `a`, all 0 to 255, by
 * "darken" of the compositing model, so that graphite never lightens what is darker. The result is rounded once. */
static uint32_t darken(uint32_t c, uint32_t a, uint32_t g, uint32_t t)
{
    uint32_t both = g * a < 255 * c ? g * a : 255 * c;
    return (t * both + (255 - t) * 255 * c + g * t * (255 - a) + 65025 / 2) / 65025;
}

static void lay_pixel(unsigned char *at, cairo_format_t format, uint32_t g, uint32_t t)
{
    if (format == CAIRO_FORMAT_A8) { /* a mask: coverage alone */
        *at = (unsigned char)(*at + t - (*at * t + 127) / 255);
        return;
    }
    uint32_t *pixel = (uint32_t *)(void *)at, v = *pixel;
    uint32_t a = format == CAIRO_FORMAT_RGB24 ? 255 : v >> 24, out = 0;
    for (int shift = 0; shift < 24; shift += 8)
        out |= darken(v >> shift & 255, a, g, t) << shift;
    *pixel = out | (a + t - (a * t + 127) / 255) << 24;
}

void plb_lay_on_cairo(cairo_surface_t *surface, const graphite *ink, const patch *from)
{
    cairo_format_t format = cairo_image_surface_get_format(surface);
    size_t bytes = format == CAIRO_FORMAT_A8 ? 1 : 4, stride = (size_t)cairo_image_surface_get_stride(surface);
    int width = cairo_image_surface_get_width(surface), height = cairo_image_surface_get_height(surface);
    unsigned char *data = cairo_image_surface_get_data(surface);
    uint32_t g = (uint32_t)ink->darkest, depth = 255 - g;
    for (int y = 0; y < from->height; y++)
        for (int x = 0; x < from->width; x++) {
            uint32_t dark = 255u - from->grey[y * from->width + x], t = (dark * 255 + depth / 2) / depth;
            int px = from->x + x, py = from->y + y;
            if (t && px >= 0 && py >= 0 && px < width && py < height)
                lay_pixel(data + (size_t)py * stride + (size_t)px * bytes, format, g, t > 255 ? 255 : t);
        }
}
