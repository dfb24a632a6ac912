/* SPDX-License-Identifier: MIT
 *
 * This file turns rows of the page into bytes of a picture.
 */
#include "surface/page.h"

#include <string.h>

int plb_page_channels(page_background background, bool colour)
{
    return (colour ? PIGMENT_PLANES : 1) + (background == PAGE_TRANSPARENT);
}

/* Returns the opacity at which graphite or pigment that comes to `darkest` darkens white to `grey`. */
static int alpha_of(int darkest, int grey)
{
    int depth = 255 - darkest;
    return ((255 - grey) * 255 + depth / 2) / depth;
}

/* Returns the grey of two layers, each of which lets so much of the light pass; 255 is all. */
static int grey_of_both(int a, int b)
{
    return (a * b + 127) / 255;
}

/* Darkens what of a white row is marked. Most of a row lies bare, even between its first and its last mark: pixels are asked for four at a time. */
static void darken(const graphite *ink, const uint16_t *deposit, row_extent e, uint8_t *out)
{
    int x = e.from;
    for (uint64_t four; x + 4 <= e.to; x += 4) {
        memcpy(&four, deposit + x, sizeof four);
        for (int k = 0; four && k < 4; k++)
            out[x + k] = ink->grey[deposit[x + k]];
    }
    for (; x < e.to; x++)
        out[x] = ink->grey[deposit[x]];
}

static void grey_row(const page *p, int y, uint8_t *out)
{
    row_extent e = p->marked[y - p->top];
    const uint16_t *from = plb_page_deposits(p, 0, y);
    memset(out, 255, (size_t)p->width);
    darken(p->ink, from, e, out);
    if (!p->soft)
        return;
    from = plb_page_deposits(p, 1, y);
    for (int x = e.from; x < e.to; x++)
        out[x] = (uint8_t)grey_of_both(out[x], p->soft->grey[from[x]]);
}

static void grey_alpha_row(const page *p, int y, uint8_t *out)
{
    const uint16_t *from = plb_page_deposits(p, 0, y), *soft = p->soft ? plb_page_deposits(p, 1, y) : NULL;
    int darkest = soft ? grey_of_both(p->ink->darkest, p->soft->darkest) : p->ink->darkest;
    for (int x = 0; x < p->width; x++) {
        int grey = p->ink->grey[from[x]];
        out[2 * x] = (uint8_t)darkest;
        out[2 * x + 1] = (uint8_t)alpha_of(darkest, soft ? grey_of_both(grey, p->soft->grey[soft[x]]) : grey);
    }
}

static void colour_row(const page *p, int y, uint8_t *out)
{
    row_extent e = p->marked[y - p->top];
    memset(out, 255, (size_t)p->width * PIGMENT_PLANES);
    for (int k = 0; k < PIGMENT_PLANES; k++) {
        const uint16_t *from = plb_page_deposits(p, k, y);
        for (int x = e.from; x < e.to; x++)
            out[PIGMENT_PLANES * x + k] = p->ink->grey[from[x]];
    }
}

/* Gives the opacity that the darkest component needs, and colours that look over white as the page does. */
static void colour_alpha_pixel(const graphite *ink, const uint8_t opaque[PIGMENT_PLANES], uint8_t out[PIGMENT_PLANES + 1])
{
    int darkest = 255;
    for (int k = 0; k < PIGMENT_PLANES; k++)
        darkest = opaque[k] < darkest ? opaque[k] : darkest;
    int alpha = alpha_of(ink->darkest, darkest);
    for (int k = 0; k < PIGMENT_PLANES; k++) {
        int taken = alpha ? ((255 - opaque[k]) * 255 + alpha / 2) / alpha : 255 - ink->darkest;
        out[k] = (uint8_t)(taken < 255 ? 255 - taken : 0);
    }
    out[PIGMENT_PLANES] = (uint8_t)alpha;
}

static void colour_alpha_row(const page *p, int y, uint8_t *out)
{
    for (int x = 0; x < p->width; x++) {
        uint8_t opaque[PIGMENT_PLANES];
        for (int k = 0; k < PIGMENT_PLANES; k++)
            opaque[k] = p->ink->grey[plb_page_deposits(p, k, y)[x]];
        colour_alpha_pixel(p->ink, opaque, out + (PIGMENT_PLANES + 1) * x);
    }
}

/* Lays the opaque row on the page's sheet, which returns less of the light. */
static void lay_on_sheet(const page *p, int y, uint8_t *row)
{
    int channels = p->planes == PIGMENT_PLANES ? PIGMENT_PLANES : 1;
    float light[GROUND_PIECE];
    for (int first = 0; first < p->width; first += GROUND_PIECE) {
        int n = p->width - first < GROUND_PIECE ? p->width - first : GROUND_PIECE;
        plb_ground_row(p->sheet, (first + 0.5) * p->pixel, (y + 0.5) * p->pixel, p->pixel, n, light);
        for (int x = 0; x < n; x++)
            for (int k = 0; k < channels; k++, row++)
                *row = (uint8_t)((float)*row * light[x] * (channels > 1 ? plb_ground_tint[k] : 1) + 0.5F);
    }
}

void plb_page_row(const page *p, page_background background, int y, uint8_t *out)
{
    static void (*const rows[2][2])(const page *, int, uint8_t *) = {{grey_row, grey_alpha_row}, {colour_row, colour_alpha_row}};
    rows[p->planes == PIGMENT_PLANES][background == PAGE_TRANSPARENT](p, y, out);
    if (background == PAGE_PAPER && p->sheet)
        lay_on_sheet(p, y, out);
}
