/* SPDX-License-Identifier: MIT
 *
 * Moves the origin of transformations (CSS Transforms 1, sections 6 and 7): a transform about another point becomes one
 * about the user space's own origin.
 */
#include "tap/svg/rewrite/document/outline.h"
#include "tap/svg/rewrite/steps.h"

#include <string.h>

/* Reads one coordinate of an origin: a keyword, a share of the box's extent, or a length. */
static double place_of(const char *word, double extent)
{
    if (!strcmp(word, "left") || !strcmp(word, "top"))
        return 0;
    if (!strcmp(word, "right") || !strcmp(word, "bottom"))
        return extent;
    if (!strcmp(word, "center"))
        return extent / 2;
    char *end;
    double v = g_ascii_strtod(word, &end);
    return *end == '%' ? v * extent / 100 : !strncmp(end, "mm", 2) ? v * 96 / 25.4 : !strncmp(end, "pt", 2) ? v * 96 / 72 : v;
}

static bool is_vertical(const char *word) { return !strcmp(word, "top") || !strcmp(word, "bottom"); }

/* Gives the place of `origin` in the reference box; a second word that is missing means the middle. */
static point find_origin(const char *origin, box b)
{
    char **words = g_strsplit_set(origin, " \t\r\n", 3);
    const char *x = words[0] ? words[0] : "center", *y = words[0] && words[1] && *words[1] ? words[1] : "center";
    if (is_vertical(x) || !strcmp(y, "left") || !strcmp(y, "right")) {
        const char *other = x;
        x = y;
        y = other;
    }
    point at = {b.x0 + place_of(x, b.x1 - b.x0), b.y0 + place_of(y, b.y1 - b.y0)};
    g_strfreev(words);
    return at;
}

static void rewrite(rewriting *r, xmlNode *n, const char *origin, const char *kind)
{
    char *text = plb_css_value(r->sheet, n, "transform"), *boxed = NULL;
    matrix m;
    bool fill_box = kind && (!strcmp(kind, "fill-box") || !strcmp(kind, "content-box") || !strcmp(kind, "stroke-box") || !strcmp(kind, "border-box"));
    box b = fill_box ? plb_outline_box(n) : plb_outline_viewport(n);
    if (text && !plb_box_is_empty(b) && plb_node_transform(text, &m)) {
        point at = find_origin(origin ? origin : fill_box ? "50% 50%" : "0 0", b);
        m = plb_matrix_multiply(plb_matrix_multiply((matrix){1, 0, 0, 1, -at.x, -at.y}, m), (matrix){1, 0, 0, 1, at.x, at.y});
        r->changed = true;
        boxed = plb_node_matrix_text(m);
        plb_css_set(n, "transform", NULL);
        plb_css_set(n, "transform-origin", NULL);
        plb_css_set(n, "transform-box", NULL);
        plb_node_set(n, "transform", boxed);
    }
    g_free(boxed);
    g_free(text);
}

void plb_rewrite_transforms(rewriting *r)
{
    xmlNode *top = xmlDocGetRootElement(r->doc);
    for (xmlNode *n = top; n; n = plb_node_next(n, top)) {
        char *origin = plb_css_value(r->sheet, n, "transform-origin"), *kind = plb_css_value(r->sheet, n, "transform-box");
        char *units = plb_node_get(n, "clipPathUnits");
        bool in_box = units && !strcmp(units, "objectBoundingBox"); /* of each element that it clips */
        g_free(units);
        if ((origin || kind) && !in_box)
            rewrite(r, n, origin, kind);
        g_free(origin);
        g_free(kind);
    }
}
