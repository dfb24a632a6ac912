/* SPDX-License-Identifier: MIT
 *
 * Does the display list that a tap writes show the whole drawing? Draws it by cairo and compares with a reference picture
 * of the same page.
 *
 *     tap_replay REFERENCE.png <LIST        prints RECALL PRECISION
 *
 * Recall: the part of the reference's ink that has ink of the list within a pixel (the turn moves what a raster makes of
 * an edge); precision the same the other way round. Exit status 0 when both are at least 0.99. The list does not know how
 * lines are joined: corners are drawn as SVG's are by default.
 */
#include "list/display_list.h"
#include "list/text/list_read.h"

#include <cairo.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ENOUGH 0.99
#define INK 96   /* alpha that surely is ink */
#define TRACE 16 /* alpha that may be the rim of ink */
#define MITER_LIMIT 4 /* SVG 1.1, section 11.4 */

static bool refill(void *closure, const char **data, size_t *size)
{
    static char part[1 << 16];
    size_t n = fread(part, 1, sizeof part, closure);
    if (!n)
        return false;
    *data = part;
    *size = n;
    return true;
}

/* ---- drawing ------------------------------------------------------------------------------------------------ */

static void make_path(cairo_t *cr, const path *p)
{
    const point *at = p->points.v;
    cairo_new_path(cr);
    for (size_t i = 0; i < p->ops.n; i++)
        switch ((path_op)p->ops.v[i]) {
        case PATH_MOVE: cairo_move_to(cr, at->x, at->y), at++; break;
        case PATH_LINE: cairo_line_to(cr, at->x, at->y), at++; break;
        case PATH_CURVE: cairo_curve_to(cr, at[0].x, at[0].y, at[1].x, at[1].y, at[2].x, at[2].y), at += 3; break;
        case PATH_CLOSE: cairo_close_path(cr); break;
        }
}

static void narrow(cairo_t *cr, const display_list *list, int index)
{
    for (; index != NO_CLIP; index = list->clips.v[index].parent) {
        const clip *c = &list->clips.v[index];
        cairo_set_fill_rule(cr, c->even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
        make_path(cr, &c->path);
        cairo_clip(cr);
    }
}

static void set_gradient(cairo_t *cr, const gradient *g)
{
    static const cairo_extend_t extends[] = {CAIRO_EXTEND_NONE, CAIRO_EXTEND_PAD, CAIRO_EXTEND_REPEAT, CAIRO_EXTEND_REFLECT};
    const matrix *m = &g->to_space;
    cairo_matrix_t to_space = {m->xx, m->yx, m->xy, m->yy, m->x0, m->y0};
    cairo_pattern_t *p = g->radial ? cairo_pattern_create_radial(g->from.x, g->from.y, g->from_radius, g->to.x, g->to.y, g->to_radius)
                                   : cairo_pattern_create_linear(g->from.x, g->from.y, g->to.x, g->to.y);
    for (unsigned i = 0; i < g->n; i++) {
        const gradient_stop *s = &g->stops[i];
        cairo_pattern_add_color_stop_rgba(p, s->offset, (double)s->red, (double)s->green, (double)s->blue, (double)s->alpha * g->opacity);
    }
    cairo_pattern_set_extend(p, extends[g->extend]);
    cairo_pattern_set_matrix(p, &to_space);
    cairo_set_source(cr, p);
    cairo_pattern_destroy(p);
}

static void draw_item(cairo_t *cr, const display_list *list, const item *it)
{
    static const cairo_line_cap_t caps[] = {CAIRO_LINE_CAP_BUTT, CAIRO_LINE_CAP_ROUND, CAIRO_LINE_CAP_SQUARE};
    const gradient *g = plb_item_gradient(list, it);
    cairo_save(cr);
    narrow(cr, list, it->clip);
    if (g)
        set_gradient(cr, g);
    else
        cairo_set_source_rgba(cr, it->paint.red, it->paint.green, it->paint.blue, it->paint.alpha);
    make_path(cr, &it->path);
    cairo_set_fill_rule(cr, it->even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
    cairo_set_line_width(cr, it->width);
    cairo_set_line_cap(cr, caps[it->cap]);
    cairo_set_miter_limit(cr, MITER_LIMIT);
    cairo_set_dash(cr, it->dash.v, (int)it->dash.n, it->dash_offset);
    if (it->kind == ITEM_FILL)
        cairo_fill(cr);
    else
        cairo_stroke(cr);
    cairo_restore(cr);
}

static cairo_surface_t *draw(const display_list *list, int width, int height)
{
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    cairo_t *cr = cairo_create(image);
    cairo_scale(cr, width / list->width, height / list->height);
    for (size_t i = 0; i < list->items.n; i++)
        draw_item(cr, list, &list->items.v[i]);
    cairo_destroy(cr);
    cairo_surface_flush(image);
    return image;
}

/* ---- comparing ---------------------------------------------------------------------------------------------- */

static int alpha_at(cairo_surface_t *image, int x, int y)
{
    const unsigned char *row = cairo_image_surface_get_data(image) + (ptrdiff_t)y * cairo_image_surface_get_stride(image);
    uint32_t pixel;
    memcpy(&pixel, row + 4 * (ptrdiff_t)x, sizeof pixel);
    return (int)(pixel >> 24);
}

static bool has_trace_near(cairo_surface_t *image, int x, int y)
{
    int w = cairo_image_surface_get_width(image), h = cairo_image_surface_get_height(image);
    for (int v = y - 1; v <= y + 1; v++)
        for (int u = x - 1; u <= x + 1; u++)
            if (u >= 0 && v >= 0 && u < w && v < h && alpha_at(image, u, v) >= TRACE)
                return true;
    return false;
}

/* The part of `a`'s ink that `b` has too. */
static double share(cairo_surface_t *a, cairo_surface_t *b)
{
    long ink = 0, found = 0;
    for (int y = 0; y < cairo_image_surface_get_height(a); y++)
        for (int x = 0; x < cairo_image_surface_get_width(a); x++)
            if (alpha_at(a, x, y) >= INK) {
                ink++;
                found += has_trace_near(b, x, y);
            }
    return ink ? (double)found / (double)ink : 1;
}

static cairo_surface_t *read_reference(const char *file)
{
    cairo_surface_t *png = cairo_image_surface_create_from_png(file);
    if (cairo_surface_status(png)) {
        fprintf(stderr, "%s: %s\n", file, cairo_status_to_string(cairo_surface_status(png)));
        exit(2);
    }
    cairo_surface_t *reference = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, cairo_image_surface_get_width(png), cairo_image_surface_get_height(png));
    cairo_t *cr = cairo_create(reference);
    cairo_set_source_surface(cr, png, 0, 0);
    cairo_paint(cr);
    cairo_destroy(cr);
    cairo_surface_destroy(png);
    cairo_surface_flush(reference);
    return reference;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: tap_replay REFERENCE.png <LIST\n");
        return 2;
    }
    display_list list;
    error err = {ERROR_NONE, ""};
    list_source from = {.refill = refill, .closure = stdin, .name = "list"};
    plb_list_init(&list);
    if (!plb_list_read(&from, &list, &err)) {
        fprintf(stderr, "line %lu: %s\n", from.line, err.text);
        return 1;
    }
    cairo_surface_t *reference = read_reference(argv[1]);
    cairo_surface_t *image = draw(&list, cairo_image_surface_get_width(reference), cairo_image_surface_get_height(reference));
    double recall = share(reference, image), precision = share(image, reference);
    printf("%.4f %.4f\n", recall, precision);
    cairo_surface_destroy(image);
    cairo_surface_destroy(reference);
    plb_list_free(&list);
    return recall >= ENOUGH && precision >= ENOUGH ? 0 : 1;
}
