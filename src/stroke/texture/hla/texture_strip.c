/* SPDX-License-Identifier: MIT
 *
 * This file gives the papers' strip as a texture to map: greys, read between their pixels by bilinear interpolation. Half a pixel of its
 * margin, into which the blur has run, and one more belong to the line's ends.
 */
#include "stroke/texture/hla/strip.h"

#include <math.h>

/* Darkness (255 - grey), 8 fractional bits, at a place in strip pixels; nothing outside. */
static inline int read_strip(const strip *s, double x, double y)
{
    if (!(x >= 0 && y >= 0 && x < s->columns - 1 && y < s->rows - 1))
        return 0;
    int ix = (int)x, iy = (int)y;
    int fx = (int)((x - ix) * 256), fy = (int)((y - iy) * 256);
    const uint8_t *p = s->grey + (size_t)iy * (size_t)s->columns + ix, *q = p + s->columns;
    int top = p[0] * (256 - fx) + p[1] * fx, bottom = q[0] * (256 - fx) + q[1] * fx;
    return 255 * 256 - ((top * (256 - fy) + bottom * fy + 128) >> 8);
}

static void shade(const void *texture, const sample_row *rows, int n, uint8_t *out)
{
    const strip *s = texture;
    for (const sample_row *at = rows; at < rows + n; at++)
        for (int i = 0; i < at->n; i++) {
            double x = at->along + i * at->along_step + STRIP_MARGIN - 0.5; /* sample 0 is the middle of its pixel */
            double y = at->across + i * at->across_step + (s->rows - 1) / 2.0;
            *out++ = (uint8_t)((read_strip(s, x, y) + 128) >> 8);
        }
}

/* The papers have no pressure: the powers of it are the graphite model's, for light lines and for heavy ones
 * (texture_grain.c). */
#define LIGHT_POWER 0.8
#define HEAVY_POWER 0.5

void plb_strip_press(strip *s, double pressure)
{
    double darker = pow(pressure, pressure < 1 ? LIGHT_POWER : HEAVY_POWER);
    uint8_t grey[256];
    for (int k = 0; k < 256; k++)
        grey[k] = (uint8_t)(255 - fmin(255, floor((255 - k) * darker + 0.5)));
    for (size_t i = 0; i < (size_t)s->columns * (size_t)s->rows; i++)
        s->grey[i] = grey[s->grey[i]];
}

shading plb_strip_shading(const strip *s, double dpi)
{
    shading r = {s, shade, true, (s->rows - 1) / 2.0, STRIP_MARGIN - 0.5, dpi, false};
    return r;
}
