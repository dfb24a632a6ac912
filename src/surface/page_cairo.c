/* SPDX-License-Identifier: MIT
 *
 * Pages and patches on cairo image surfaces.
 */
#include "surface/page.h"

#include <string.h>

cairo_surface_t *plb_page_to_cairo(const page *p, page_background background, error *err)
{
    cairo_surface_t *s = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, p->width, p->height);
    if (cairo_surface_status(s) != CAIRO_STATUS_SUCCESS) {
        plb_fail(err, ERROR_LIMIT, "cairo makes no surface of %d by %d pixels: %s", p->width, p->height,
                 cairo_status_to_string(cairo_surface_status(s)));
        cairo_surface_destroy(s);
        return NULL;
    }
    unsigned char *data = cairo_image_surface_get_data(s);
    size_t stride = (size_t)cairo_image_surface_get_stride(s);
    uint32_t darkest = (uint32_t)p->ink->darkest, depth = 255 - darkest;
    for (int y = 0; y < p->height; y++) {
        uint32_t *row = (uint32_t *)(void *)(data + (size_t)y * stride);
        for (int x = 0; x < p->width; x++) {
            uint32_t grey = p->ink->grey[p->deposit[(size_t)y * (size_t)p->width + (size_t)x]];
            uint32_t alpha = 255;
            if (background == PAGE_TRANSPARENT) {
                alpha = ((255 - grey) * 255 + depth / 2) / depth;
                grey = (darkest * alpha + 127) / 255; /* premultiplied */
            }
            row[x] = alpha << 24 | grey << 16 | grey << 8 | grey;
        }
    }
    cairo_surface_mark_dirty(s);
    return s;
}

bool plb_lay_on_cairo(cairo_surface_t *surface, const graphite *ink, const patch *from)
{
    cairo_surface_t *mask = cairo_image_surface_create(CAIRO_FORMAT_A8, from->width, from->height);
    cairo_t *cr = cairo_create(surface);
    unsigned char *data = cairo_image_surface_get_data(mask);
    if (data) {
        int stride = cairo_image_surface_get_stride(mask), depth = 255 - ink->darkest;
        for (int y = 0; y < from->height; y++)
            for (int x = 0; x < from->width; x++) {
                int alpha = ((255 - from->grey[y * from->width + x]) * 255 + depth / 2) / depth;
                data[y * stride + x] = (unsigned char)(alpha > 255 ? 255 : alpha);
            }
        cairo_surface_mark_dirty(mask);
        double grey = ink->darkest / 255.0;
        cairo_set_source_rgb(cr, grey, grey, grey);
        cairo_set_operator(cr, CAIRO_OPERATOR_DARKEN); /* graphite never lightens what is darker */
        cairo_mask_surface(cr, mask, from->x, from->y);
    }
    bool ok = data && cairo_status(cr) == CAIRO_STATUS_SUCCESS;
    cairo_destroy(cr);
    cairo_surface_destroy(mask);
    return ok;
}
