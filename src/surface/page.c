/* SPDX-License-Identifier: MIT
 *
 * The page: see page.h.
 */
#include "surface/page.h"

#include "base/array.h"

#include <math.h>
#include <string.h>

/* Deposits are natural densities in this unit: 65535 of them are a density of 16, which is darkness to 1e-7. */
#define DEPOSIT_UNIT (1.0 / 4096)
/* How much darker than a single stroke's darkest pixels graphite laid over graphite gets, in grey levels (solid
 * patches of one scanned pencil have a mean of 80 where its lines' darkest hundredth is 96 to 116). */
#define BELOW_DARKEST 20
/* Graphite shines: it is never black (natural graphite reflects; darkest patch pixels scanned are about 60). */
#define DARKEST_POSSIBLE 24

/* From the bounds, not from the darkest pixel ever scanned: that may be a speck of dust. */
static int darkest_of(const profile *p)
{
    int low = p->min_range < p->min_mid ? p->min_range : p->min_mid;
    int darkest = low - BELOW_DARKEST;
    return darkest < DARKEST_POSSIBLE ? DARKEST_POSSIBLE : darkest;
}

void plb_graphite_init(graphite *g, const profile *p)
{
    int darkest = darkest_of(p);
    double depth = 255.0 - darkest;
    g->darkest = darkest;
    for (int v = 0; v < 256; v++) {
        double left = 1 - (255.0 - v) / depth; /* the share of light that still comes back */
        double units = left > 0 ? -log(left) / DEPOSIT_UNIT : 65535;
        g->deposit[v] = (uint16_t)(units > 65535 ? 65535 : floor(units + 0.5));
    }
    for (int d = 0; d < 65536; d++)
        g->grey[d] = (uint8_t)floor(darkest + depth * exp(-d * DEPOSIT_UNIT) + 0.5);
}

bool plb_page_init(page *p, double width_px, double height_px, const graphite *ink, error *err)
{
    memset(p, 0, sizeof *p);
    double w = floor(width_px + 0.5), h = floor(height_px + 0.5);
    w = w < 1 ? 1 : w;
    h = h < 1 ? 1 : h;
    if (!(w * h <= PAGE_MAX_PIXELS && w < 1e6 && h < 1e6))
        return plb_fail(err, ERROR_LIMIT, "a page of %.0f by %.0f pixels is too large", w, h);
    p->width = (int)w;
    p->height = (int)h;
    p->ink = ink;
    p->deposit = plb_new((size_t)w * (size_t)h, sizeof *p->deposit);
    p->touched = plb_new((size_t)h, sizeof *p->touched);
    return (p->deposit && p->touched) || plb_fail(err, ERROR_MEMORY, "out of memory for a page of %.0f by %.0f pixels", w, h);
}

void plb_page_free(page *p)
{
    plb_free(p->deposit);
    plb_free(p->touched);
    memset(p, 0, sizeof *p);
}

void plb_page_lay(page *p, const patch *from)
{
    int x0 = from->x < 0 ? -from->x : 0, y0 = from->y < 0 ? -from->y : 0;
    int x1 = from->x + from->width > p->width ? p->width - from->x : from->width;
    int y1 = from->y + from->height > p->height ? p->height - from->y : from->height;
    for (int y = y0; y < y1; y++) {
        const uint8_t *grey = from->grey + (size_t)y * (size_t)from->width;
        p->touched[from->y + y] = true;
        uint16_t *to = p->deposit + (size_t)(from->y + y) * (size_t)p->width + from->x;
        for (int x = x0; x < x1; x++) {
            unsigned sum = to[x] + (unsigned)p->ink->deposit[grey[x]];
            to[x] = (uint16_t)(sum > 65535 ? 65535 : sum);
        }
    }
}
