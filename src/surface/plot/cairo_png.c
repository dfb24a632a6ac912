/* SPDX-License-Identifier: MIT
 *
 * See cairo_png.h.
 */
#include "surface/plot/cairo_png.h"

static cairo_status_t write_bytes(void *closure, const unsigned char *data, unsigned int n)
{
    return fwrite(data, 1, n, closure) == n ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

cairo_status_t plb_cairo_write_png(cairo_surface_t *surface, FILE *to)
{
    return cairo_surface_write_to_png_stream(surface, write_bytes, to);
}
