/* SPDX-License-Identifier: MIT
 *
 * PNG (RFC 2083): 8 bits of grey, or of red, green and blue, with alpha or without. Written here rather than by libpng, which
 * takes one row after the other.
 */
#include "surface/picture/formats.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <zlib.h>

static void store32(uint8_t out[4], uint32_t v)
{
    for (int k = 0; k < 4; k++)
        out[k] = (uint8_t)(v >> (24 - 8 * k));
}

static bool put_chunk(picture *p, const char type[4], const void *data, size_t n)
{
    uint8_t word[4];
    uLong crc = crc32_z(crc32_z(0, (const Bytef *)type, 4), data, n);
    store32(word, (uint32_t)n);
    if (!plb_picture_put(p, word, 4) || !plb_picture_put(p, type, 4) || !plb_picture_put(p, data, n))
        return false;
    store32(word, (uint32_t)crc);
    return plb_picture_put(p, word, 4);
}

static bool put_texts(picture *p, const char *const *pairs)
{
    for (; pairs && pairs[0]; pairs += 2) {
        char text[512];
        int n = snprintf(text, sizeof text, "%.79s%c%s", pairs[0], '\0', pairs[1]);
        if (!put_chunk(p, "tEXt", text, n < (int)sizeof text ? (size_t)n : sizeof text - 1))
            return false;
    }
    return true;
}

static bool put_head(picture *p)
{
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, colour_types[] = {0, 0, 4, 2, 6};
    uint8_t head[13] = {0}, physical[9] = {0};
    store32(head, (uint32_t)p->page->width);
    store32(head + 4, (uint32_t)p->page->height);
    head[8] = 8;
    head[9] = colour_types[p->channels];
    uint32_t per_metre = (uint32_t)floor(p->page->dpi / 0.0254 + 0.5);
    store32(physical, per_metre);
    store32(physical + 4, per_metre);
    physical[8] = 1; /* per metre */
    return plb_picture_put(p, signature, sizeof signature) && put_chunk(p, "IHDR", head, sizeof head) &&
           put_chunk(p, "pHYs", physical, sizeof physical) && put_texts(p, p->page->text);
}

static bool put_data(picture *p, const void *data, size_t n)
{
    return put_chunk(p, "IDAT", data, n);
}

static bool begin_page(picture *p, error *err)
{
    return (put_head(p) || plb_picture_fail(p, err)) && plb_deflated_rows_begin(p, put_data, err);
}

static bool end_page(picture *p, error *err)
{
    return plb_deflated_rows_end(p, err) && (put_chunk(p, "IEND", "", 0) || plb_picture_fail(p, err));
}

const picture_format plb_png_format = {
    .name = "PNG", .suffixes = "png", .built = true, .see_through = true,
    .begin_page = begin_page, .add = plb_deflated_rows_add, .end_page = end_page, .drop = plb_deflated_rows_drop,
};
