/* SPDX-License-Identifier: MIT
 *
 * SVG 1.1 for editors and for plotters that hold a real pencil: the hand's paths as strokes. A unit is a millimetre, the
 * viewBox is the page at its true size, and each pencil has a layer, as Inkscape marks them and vpype reads them. Coordinates are
 * relative, in steps of a micrometre: each is rounded against the rounded place before, so that roundings do not add up.
 */
#include "surface/picture/formats.h"

#include "base/array.h"
#include "base/number/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Widths that differ by less, mm, are written as one. */
#define SAME_WIDTH 0.005

typedef struct {
    int layers;      /* begun in this page */
    double width;    /* the open layer's, mm */
    bool layer_open;
    long long x, y;  /* the current place, micrometres */
    long long from_x, from_y; /* where the subpath began */
} svg_file;

static bool put_escaped(picture *p, const char *text)
{
    for (; *text; text++) {
        const char *as = *text == '<' ? "&lt;" : *text == '>' ? "&gt;" : *text == '&' ? "&amp;" : *text == '"' ? "&quot;" : NULL;
        if (as ? !plb_picture_print(p, "%s", as) : !plb_picture_put(p, text, 1))
            return false;
    }
    return true;
}

static bool put_texts(picture *p)
{
    char *lines = plb_picture_lines(p->page);
    bool ok = lines && plb_picture_print(p, "<desc>") && put_escaped(p, lines) && plb_picture_print(p, "</desc>\n");
    plb_free(lines);
    return ok;
}

static bool begin_page(picture *p, error *err)
{
    char w[48], h[48];
    svg_file *f = p->own = plb_new(1, sizeof *f);
    if (!f)
        return plb_fail_memory(err);
    plb_format_number(w, p->page->width_mm, 6);
    plb_format_number(h, p->page->height_mm, 6);
    bool ok = plb_picture_print(p, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                   "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
                                   "     width=\"%smm\" height=\"%smm\" viewBox=\"0 0 %s %s\"%s>\n",
                                w, h, w, h, p->page->background == PAGE_WHITE ? " style=\"background:#fff\"" : p->page->background == PAGE_PAPER ? " style=\"background:#f4f2ec\"" : "") &&
              put_texts(p);
    return ok || plb_picture_fail(p, err);
}

static bool end_layer(picture *p)
{
    svg_file *f = p->own;
    bool was_open = f->layer_open;
    f->layer_open = false;
    return !was_open || plb_picture_print(p, "</g>\n");
}

static bool begin_layer(picture *p, const picture_layer *layer, error *err)
{
    svg_file *f = p->own;
    char width[48];
    plb_format_number(width, layer->width, 3);
    bool ok = end_layer(p) && plb_picture_print(p, "<g id=\"layer%d\" inkscape:groupmode=\"layer\" inkscape:label=\"", ++f->layers) && put_escaped(p, layer->label) &&
              plb_picture_print(p, "\" fill=\"none\" stroke=\"#%06x\" stroke-width=\"%s\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n", (unsigned)layer->colour, width);
    f->layer_open = ok;
    f->width = layer->width;
    return ok || plb_picture_fail(p, err);
}

/* A length in micrometres as millimetres, as short as that is; returns its end. */
static char *put_length(char *to, long long v, bool first)
{
    if (v < 0)
        *to++ = '-';
    else if (!first)
        *to++ = ' ';
    v = v < 0 ? -v : v;
    if (v >= 1000 || v == 0)
        to += sprintf(to, "%lld", v / 1000);
    if (v % 1000) {
        to += sprintf(to, ".%03lld", v % 1000);
        while (to[-1] == '0')
            to--;
    }
    return to;
}

/* Writes an operator and its `n` points, relative to the current place. */
static bool put_points(picture *p, char op, const point *v, int n)
{
    svg_file *f = p->own;
    char text[256] = {op}, *to = text + 1;
    long long x = f->x, y = f->y;
    for (int k = 0; k < n; k++) {
        x = llround(v[k].x * 1000);
        y = llround(v[k].y * 1000);
        to = put_length(to, x - f->x, k == 0);
        to = put_length(to, y - f->y, false);
    }
    f->x = x;
    f->y = y;
    return plb_picture_put(p, text, (size_t)(to - text));
}

static bool put_path(picture *p, const path *drawn)
{
    svg_file *f = p->own;
    const point *at = drawn->points.v;
    bool ok = true;
    f->x = f->y = 0;
    for (size_t i = 0; ok && i < drawn->ops.n; i++)
        switch (drawn->ops.v[i]) {
        case PATH_MOVE:
            ok = put_points(p, 'm', at++, 1);
            f->from_x = f->x;
            f->from_y = f->y;
            break;
        case PATH_LINE:
            ok = put_points(p, 'l', at++, 1);
            break;
        case PATH_CURVE:
            ok = put_points(p, 'c', at, 3);
            at += 3;
            break;
        default:
            f->x = f->from_x;
            f->y = f->from_y;
            ok = plb_picture_print(p, "z");
        }
    return ok;
}

static bool add_path(picture *p, const path *drawn, double width, double opacity, error *err)
{
    char text[48];
    svg_file *f = p->own;
    bool ok = plb_picture_print(p, "<path d=\"") && put_path(p, drawn) && plb_picture_print(p, "\"");
    if (ok && fabs(width - f->width) >= SAME_WIDTH)
        ok = plb_picture_print(p, " stroke-width=\"%s\"", plb_format_number(text, width, 2));
    if (ok && opacity < 0.995)
        ok = plb_picture_print(p, " stroke-opacity=\"%s\"", plb_format_number(text, opacity, 2));
    return (ok && plb_picture_print(p, "/>\n")) || plb_picture_fail(p, err);
}

static bool end_page(picture *p, error *err)
{
    return (end_layer(p) && plb_picture_print(p, "</svg>\n")) || plb_picture_fail(p, err);
}

static void drop(picture *p)
{
    plb_free(p->own);
}

const picture_format plb_svg_format = {
    .name = "SVG", .suffixes = "svg", .built = true, .has_paths = true, .see_through = true,
    .begin_page = begin_page, .begin_layer = begin_layer, .add_path = add_path, .end_page = end_page, .drop = drop,
};
