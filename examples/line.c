/* SPDX-License-Identifier: MIT
 *
 * Lines drawn by a program: straight lines of which each is tangent to a curve nobody draws. Writes line.png.
 * Build: cc line.c $(pkg-config --cflags --libs plumbago) -o line
 */
#include <plumbago.h>

int main(void)
{
    cairo_surface_t *paper = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1240, 1240);
    cairo_t *cr = cairo_create(paper);
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);

    plb_error error = {PLB_ERROR_MEMORY, "out of memory"};
    plb_options *options = plb_options_new();
    bool ok = options && plb_options_set(options, "pencil", "2H", &error);
    for (unsigned i = 0; ok && i <= 20; i++) {
        double a = 120 + i * 50.0, b = 1120 - i * 50.0;
        ok = plb_draw_line(paper, a, 120, 1120, a, i, options, &error) && plb_draw_line(paper, b, 1120, 120, b, i, options, &error);
    }
    if (!ok)
        fprintf(stderr, "line: %s\n", error.text);
    else if (cairo_surface_write_to_png(paper, "line.png") != CAIRO_STATUS_SUCCESS)
        ok = false;
    plb_options_free(options);
    cairo_destroy(cr);
    cairo_surface_destroy(paper);
    return !ok;
}
