/* SPDX-License-Identifier: MIT
 *
 * See controls.h.
 */
#include "surface/plot/controls.h"

#include "base/array.h"
#include "base/number/units.h"
#include "surface/plot/cairo_png.h"

#include <cairo.h>
#include <errno.h>
#include <math.h>
#include <string.h>

/* Chosen by eye, after the papers' figure. */
#define LINE_MM 0.12
#define DOT_RADIUS_MM 0.45

struct controls_picture {
    cairo_surface_t *surface;
    cairo_t *cr;
};

controls_picture *plb_controls_new(double width, double height, double dpi, error *err)
{
    controls_picture *c = plb_new(1, sizeof *c);
    double px = dpi / MM_PER_INCH, w = floor(width * px + 0.5), h = floor(height * px + 0.5);
    if (!c || !(w <= 32767 && h <= 32767)) {
        plb_free(c);
        plb_fail(err, ERROR_LIMIT, "a picture of %.0f by %.0f pixels is too large", w, h);
        return NULL;
    }
    c->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, w < 1 ? 1 : (int)w, h < 1 ? 1 : (int)h);
    c->cr = cairo_create(c->surface);
    if (cairo_status(c->cr) != CAIRO_STATUS_SUCCESS) {
        plb_controls_free(c);
        plb_fail_memory(err);
        return NULL;
    }
    cairo_set_source_rgb(c->cr, 1, 1, 1);
    cairo_paint(c->cr);
    cairo_scale(c->cr, px, px);
    cairo_set_line_join(c->cr, CAIRO_LINE_JOIN_ROUND);
    return c;
}

void plb_controls_free(controls_picture *c)
{
    if (!c)
        return;
    cairo_destroy(c->cr);
    cairo_surface_destroy(c->surface);
    plb_free(c);
}

void plb_controls_add_path(controls_picture *c, const point *at, size_t n)
{
    for (size_t i = 0; i < n; i++)
        cairo_line_to(c->cr, at[i].x, at[i].y);
    cairo_set_source_rgb(c->cr, 0.25, 0.25, 0.25);
    cairo_set_line_width(c->cr, LINE_MM);
    cairo_stroke(c->cr);
}

void plb_controls_add_dots(controls_picture *c, const point *at, size_t n)
{
    cairo_set_source_rgb(c->cr, 0.85, 0.05, 0.05);
    for (size_t i = 0; i < n; i++) {
        cairo_arc(c->cr, at[i].x, at[i].y, DOT_RADIUS_MM, 0, 2 * PLB_PI);
        cairo_fill(c->cr);
    }
}

bool plb_controls_write(controls_picture *c, FILE *to, const char *name, error *err)
{
    errno = 0;
    cairo_status_t status = plb_cairo_write_png(c->surface, to);
    if (status == CAIRO_STATUS_SUCCESS)
        return true;
    return plb_fail(err, ERROR_FILE, "%s: cannot be written: %s", name, errno ? strerror(errno) : cairo_status_to_string(status));
}
