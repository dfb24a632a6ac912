/* SPDX-License-Identifier: MIT
 *
 * A cairo surface as PNG on a stream.
 */
#ifndef PLB_SURFACE_PLOT_CAIRO_PNG_H
#define PLB_SURFACE_PLOT_CAIRO_PNG_H

#include <cairo.h>
#include <stdio.h>

/* CAIRO_STATUS_WRITE_ERROR, with errno, when the stream fails. */
cairo_status_t plb_cairo_write_png(cairo_surface_t *surface, FILE *to);

#endif
