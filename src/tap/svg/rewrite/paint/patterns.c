/* SPDX-License-Identifier: MIT
 *
 * Lays out the tiles of patterns one at a time within the shape that they fill, so that the pencil draws their lines
 * and dots (SVG 2, section 14.3). Shapes that would take too many tiles, and elements that are no shapes, get the
 * pattern's mean colour.
 */
#include "tap/svg/rewrite/document/outline.h"
#include "tap/svg/rewrite/document/render.h"
#include "tap/svg/rewrite/steps.h"

#include <math.h>
#include <string.h>

#define MAX_TILES 4000u      /* in one shape */
#define MAX_ELEMENTS 40000u  /* of all tiles of a document */
#define MAX_TEMPLATES 16     /* a pattern refers to a pattern that refers to ... */
#define HALVED_OPACITY "0.6" /* chosen by eye: a hatching of such lines is lighter than one of whole lines */
#define BEYOND 0.01          /* a part of the tile: content that reaches farther out is cut at the tile's edge */

/* A tiling is a pattern with all that the patterns it refers to say for it, for one shape. */
typedef struct {
    const xmlNode *content;
    double x, y, width, height; /* of the first tile, in pattern space */
    matrix transform;           /* from pattern space to the shape's user space */
    matrix inside;              /* from the content's space to the tile's corner */
    unsigned elements;          /* in one tile */
    box bounds;                 /* of the content, in pattern space about the tile's corner */
} tiling;

/* ---- what the pattern says ---------------------------------------------------------------------------------- */

/* Gives the pattern, or the first that it refers to, with that attribute (or with children: `name` NULL); NULL: none. */
static const xmlNode *find_saying(rewriting *r, const xmlNode *pattern, const char *name)
{
    for (int i = 0; pattern && plb_node_is(pattern, "pattern") && i < MAX_TEMPLATES; i++) {
        char *value = name ? plb_node_get(pattern, name) : NULL, *href;
        bool says = name ? value != NULL : xmlFirstElementChild((xmlNode *)(guintptr)pattern) != NULL;
        g_free(value);
        if (says)
            return pattern;
        href = plb_node_get(pattern, "href");
        pattern = plb_node_referred(r->ids, href);
        g_free(href);
    }
    return NULL;
}

static char *attribute(rewriting *r, const xmlNode *pattern, const char *name)
{
    const xmlNode *n = find_saying(r, pattern, name);
    return n ? plb_node_get(n, name) : NULL;
}

static double extent(rewriting *r, const xmlNode *pattern, const char *name, double whole)
{
    const xmlNode *n = find_saying(r, pattern, name);
    return n ? plb_node_length(n, name, whole, 0) : 0;
}

static bool says(rewriting *r, const xmlNode *pattern, const char *name, const char *value, bool otherwise)
{
    char *text = attribute(r, pattern, name);
    bool same = text ? !strcmp(text, value) : otherwise;
    g_free(text);
    return same;
}

/* Maps the content by a viewBox, fitted into the tile and centred; false: there is no viewBox. */
static bool map_view_box(rewriting *r, const xmlNode *pattern, tiling *t)
{
    char *text = attribute(r, pattern, "viewBox"), *at = text;
    double v[4] = {0};
    for (int i = 0; text && i < 4; i++)
        v[i] = g_ascii_strtod(at + strspn(at, " ,"), &at);
    g_free(text);
    if (!(v[2] > 0 && v[3] > 0))
        return false;
    double kx = t->width / v[2], ky = t->height / v[3];
    if (!says(r, pattern, "preserveAspectRatio", "none", false))
        kx = ky = fmin(kx, ky);
    t->inside = (matrix){kx, 0, 0, ky, (t->width - kx * v[2]) / 2 - kx * v[0], (t->height - ky * v[3]) / 2 - ky * v[1]};
    return true;
}

static bool read_tiling(rewriting *r, const xmlNode *pattern, box b, tiling *t)
{
    *t = (tiling){.content = find_saying(r, pattern, NULL), .inside = MATRIX_IDENTITY, .bounds = BOX_EMPTY};
    double bw = b.x1 - b.x0, bh = b.y1 - b.y0;
    bool in_box = says(r, pattern, "patternUnits", "objectBoundingBox", true);
    t->x = in_box ? b.x0 + bw * extent(r, pattern, "x", 1) : extent(r, pattern, "x", bw);
    t->y = in_box ? b.y0 + bh * extent(r, pattern, "y", 1) : extent(r, pattern, "y", bh);
    t->width = extent(r, pattern, "width", 1) * (in_box ? bw : 1);
    t->height = extent(r, pattern, "height", 1) * (in_box ? bh : 1);
    char *transform = attribute(r, pattern, "patternTransform");
    bool ok = t->content && t->width > 0 && t->height > 0 && plb_node_transform(transform, &t->transform);
    g_free(transform);
    if (!ok)
        return false;
    if (!map_view_box(r, pattern, t) && says(r, pattern, "patternContentUnits", "objectBoundingBox", false))
        t->inside = plb_matrix_scale(bw, bh);
    box own = plb_outline_box(t->content);
    point corners[4] = {{own.x0, own.y0}, {own.x1, own.y0}, {own.x0, own.y1}, {own.x1, own.y1}};
    for (int i = 0; i < 4 && !plb_box_is_empty(own); i++)
        plb_box_add(&t->bounds, plb_matrix_apply(t->inside, corners[i]));
    for (const xmlNode *n = plb_node_next(t->content, t->content); n; n = plb_node_next(n, t->content))
        t->elements++;
    return true;
}

/* Tells whether the content can be laid out: lines and shapes can; of pictures, gradients and text only the tone counts. */
static bool is_drawable(rewriting *r, const tiling *t)
{
    static const char *const known[] = {"g", "path", "rect", "circle", "ellipse", "line", "polyline", "polygon", "title", "desc", NULL};
    for (const xmlNode *n = plb_node_next(t->content, t->content); n; n = plb_node_next(n, t->content)) {
        char *fill = plb_css_value(r->sheet, n, "fill");
        bool plain = plb_node_is_any(n, known) && !(fill && !strncmp(fill, "url", 3));
        g_free(fill);
        if (!plain)
            return false;
    }
    return true;
}

/* ---- laying out --------------------------------------------------------------------------------------------- */

/* Gives the box of the shape in pattern space. */
static bool range_of(const tiling *t, box b, int first[2], int last[2])
{
    matrix back;
    box in = BOX_EMPTY;
    point corners[4] = {{b.x0, b.y0}, {b.x1, b.y0}, {b.x0, b.y1}, {b.x1, b.y1}};
    if (!plb_matrix_invert(t->transform, &back))
        return false;
    for (int i = 0; i < 4; i++)
        plb_box_add(&in, plb_matrix_apply(back, corners[i]));
    double low[2] = {floor((in.x0 - t->x) / t->width), floor((in.y0 - t->y) / t->height)};
    double high[2] = {ceil((in.x1 - t->x) / t->width), ceil((in.y1 - t->y) / t->height)};
    double n = (high[0] - low[0]) * (high[1] - low[1]);
    if (!(n >= 1 && n <= MAX_TILES))
        return false;
    for (int k = 0; k < 2; k++) {
        first[k] = (int)low[k];
        last[k] = (int)high[k];
    }
    return true;
}

/* Makes a clip path of the tile's own rectangle about its corner. */
static char *clip_of_tile(rewriting *r, xmlNode *before, const tiling *t)
{
    xmlNode *clip = plb_node_new(before, "clipPath"), *rect = plb_node_new(before, "rect");
    plb_node_set_number(rect, "width", t->width);
    plb_node_set_number(rect, "height", t->height);
    xmlAddChild(clip, rect);
    xmlAddPrevSibling(before, clip);
    char *id = plb_node_name(clip, r->ids, "plumbago-tile"), *reference = g_strdup_printf("url(#%s)", id);
    g_free(id);
    return reference;
}

static bool reaches_out(const tiling *t)
{
    double dx = BEYOND * t->width, dy = BEYOND * t->height;
    return !plb_box_is_empty(t->bounds) && (t->bounds.x0 < -dx || t->bounds.y0 < -dy || t->bounds.x1 > t->width + dx || t->bounds.y1 > t->height + dy);
}

/* Tells on which sides of the tile the piece from a to b lies: bits for left, right, top, bottom. */
static unsigned sides_of(const tiling *t, point a, point b)
{
    double dx = BEYOND * t->width, dy = BEYOND * t->height;
    bool upright = fabs(a.x - b.x) < dx, level = fabs(a.y - b.y) < dy;
    return (upright && fabs(a.x) < dx ? 1u : 0) | (upright && fabs(a.x - t->width) < dx ? 2u : 0) | (level && fabs(a.y) < dy ? 4u : 0) |
           (level && fabs(a.y - t->height) < dy ? 8u : 0);
}

/* Tells whether the line runs along the tile's sides and the tiles beyond have none there: so half its width is cut off. */
static bool is_halved(const xmlNode *n, const tiling *t)
{
    path p = plb_outline(n);
    point *at;
    bool *jump, all = true;
    unsigned used = 0;
    plb_path_transform(&p, t->inside);
    size_t count = plb_outline_points(&p, &at, &jump);
    for (size_t i = 1; i < count && all; i++) {
        unsigned sides = jump[i] ? 0 : sides_of(t, at[i - 1], at[i]);
        all = jump[i] || sides;
        used |= sides;
    }
    g_free(at);
    g_free(jump);
    plb_path_free(&p);
    return all && used && (used & 3) != 3 && (used & 12) != 12;
}

/* Gives lines along the tile's sides the width that is seen. A pencil cannot draw them so fine: they are paler, too. */
static void thin_halved_lines(rewriting *r, xmlNode *content, const tiling *t)
{
    for (xmlNode *n = content; n; n = plb_node_next(n, content)) {
        char *own = plb_node_get(n, "transform"), *width = plb_css_inherited(r->sheet, n, "stroke-width"), number[G_ASCII_DTOSTR_BUF_SIZE];
        double breadth = width ? g_ascii_strtod(width, NULL) : 1;
        if (!own && plb_node_is_shape(n) && is_halved(n, t))
            plb_css_set(n, "stroke-width", g_ascii_formatd(number, sizeof number, "%.6g", breadth / 2)), plb_css_set(n, "stroke-opacity", HALVED_OPACITY);
        g_free(own);
        g_free(width);
    }
}

/* Makes one tile: a group at its corner, with the pattern's content. */
static void add_tile(rewriting *r, xmlNode *group, const tiling *t, int i, int j, const char *clip)
{
    xmlNode *tile = plb_node_new(group, "g"), *inner = plb_node_new(group, "g");
    char *place = g_strdup_printf("translate(%.12g %.12g)", t->x + i * t->width, t->y + j * t->height), *map = plb_node_matrix_text(t->inside);
    plb_node_set(tile, "transform", place);
    plb_node_set(inner, "transform", map);
    if (clip)
        plb_css_set(tile, "clip-path", clip);
    for (const xmlNode *c = t->content->children; c; c = c->next) {
        xmlNode *copy = xmlDocCopyNode((xmlNode *)(guintptr)c, group->doc, 1);
        for (xmlNode *n = copy; n; n = plb_node_next(n, copy))
            plb_node_remove(n, "id");
        xmlAddChild(inner, copy);
    }
    xmlAddChild(tile, inner);
    xmlAddChild(group, tile);
    thin_halved_lines(r, inner, t);
    g_free(place);
    g_free(map);
}

/* Makes a clip path of the shape itself. */
static char *clip_of_shape(rewriting *r, xmlNode *shape)
{
    static const char *const dropped[] = {"id", "transform", "fill", "stroke", "opacity", "mask", "filter", "clip-path", "class"};
    char *rule = plb_css_inherited(r->sheet, shape, "fill-rule");
    xmlNode *clip = plb_node_new(shape, "clipPath"), *copy = xmlDocCopyNode(shape, shape->doc, 1);
    for (size_t i = 0; i < G_N_ELEMENTS(dropped); i++)
        plb_node_remove(copy, dropped[i]);
    plb_node_remove(copy, "style");
    if (rule)
        plb_node_set(copy, "clip-rule", rule);
    xmlAddChild(clip, copy);
    xmlAddPrevSibling(shape, clip);
    char *id = plb_node_name(clip, r->ids, "plumbago-shape"), *reference = g_strdup_printf("url(#%s)", id);
    g_free(rule);
    g_free(id);
    return reference;
}

/* Lays the tiles under the shape's own outline. */
static void lay_out(rewriting *r, xmlNode *shape, const tiling *t, const int first[2], const int last[2])
{
    char *alpha = plb_css_inherited(r->sheet, shape, "fill-opacity"), *map = plb_node_matrix_text(t->transform);
    plb_rewrite_wrap(r, shape, true);
    char *outline = clip_of_shape(r, shape);
    xmlNode *clipped = plb_node_new(shape, "g"), *tiles = plb_node_new(shape, "g");
    plb_css_set(clipped, "clip-path", outline);
    /* The content has the pattern's surroundings, not the shape's: what it inherits are the initial values. */
    plb_css_set(clipped, "fill", "#000");
    plb_css_set(clipped, "stroke", "none");
    plb_css_set(clipped, "stroke-width", "1");
    plb_css_set(clipped, "stroke-dasharray", "none");
    if (alpha)
        plb_css_set(clipped, "opacity", alpha);
    plb_node_set(tiles, "transform", map);
    xmlAddChild(clipped, tiles);
    xmlAddPrevSibling(shape, clipped);
    bool several = (last[0] - first[0]) * (last[1] - first[1]) > 1;
    char *clip = several && reaches_out(t) ? clip_of_tile(r, clipped, t) : NULL;
    for (int j = first[1]; j < last[1]; j++)
        for (int i = first[0]; i < last[0]; i++)
            add_tile(r, tiles, t, i, j, clip);
    plb_css_set(shape, "fill", "none");
    g_free(clip);
    g_free(outline);
    g_free(alpha);
    g_free(map);
}

/* ---- mean tones --------------------------------------------------------------------------------------------- */

/* Gives the mean colour that the pattern has in a box, as a paint; NULL: not known. */
static char *mean_paint(rewriting *r, const xmlNode *pattern, box b)
{
    char *id = plb_node_get(pattern, "id"), *reference = g_strdup_printf("url(#%s)", id ? id : ""), *paint = NULL;
    xmlNode *holder = plb_node_new(pattern, "g"), *rect = plb_node_new(pattern, "rect");
    double mean[4];
    plb_node_set_number(rect, "x", b.x0);
    plb_node_set_number(rect, "y", b.y0);
    plb_node_set_number(rect, "width", b.x1 - b.x0);
    plb_node_set_number(rect, "height", b.y1 - b.y0);
    plb_node_set(rect, "fill", reference);
    xmlAddChild(holder, rect);
    if (plb_render_mean(r, holder, b, mean)) {
        char alpha[G_ASCII_DTOSTR_BUF_SIZE];
        paint = g_strdup_printf("rgba(%d,%d,%d,%s)", (int)lround(255 * mean[0]), (int)lround(255 * mean[1]), (int)lround(255 * mean[2]),
                                g_ascii_formatd(alpha, sizeof alpha, "%.4f", mean[3]));
    }
    xmlFreeNode(holder);
    g_free(reference);
    g_free(id);
    return paint;
}

static void use_mean(rewriting *r, xmlNode *n, const char *property, const xmlNode *pattern)
{
    box b = plb_outline_box(n);
    if (plb_box_is_empty(b) || !(b.x1 > b.x0 && b.y1 > b.y0))
        b = plb_outline_viewport(n);
    char *paint = mean_paint(r, pattern, b);
    if (paint) {
        r->changed = true;
        plb_css_set(n, property, paint);
    }
    g_free(paint);
}

/* ---- all shapes --------------------------------------------------------------------------------------------- */

static const xmlNode *pattern_of(rewriting *r, const xmlNode *n, const char *property)
{
    char *paint = plb_css_inherited(r->sheet, n, property);
    const xmlNode *pattern = paint && !strncmp(paint, "url", 3) ? plb_node_referred(r->ids, paint) : NULL;
    g_free(paint);
    return pattern && plb_node_is(pattern, "pattern") ? pattern : NULL;
}

static void rewrite_fill(rewriting *r, xmlNode *n, const xmlNode *pattern, unsigned *elements)
{
    box b = plb_outline_box(n);
    tiling t;
    int first[2], last[2];
    bool fits = plb_node_is_shape(n) && b.x1 > b.x0 && b.y1 > b.y0 && read_tiling(r, pattern, b, &t) && is_drawable(r, &t) && range_of(&t, b, first, last);
    unsigned needed = fits ? (unsigned)((last[0] - first[0]) * (last[1] - first[1])) * (t.elements + 2) : 0;
    if (fits && *elements + needed <= MAX_ELEMENTS) {
        *elements += needed;
        lay_out(r, n, &t, first, last);
    } else {
        use_mean(r, n, "fill", pattern);
    }
}

void plb_rewrite_patterns(rewriting *r)
{
    unsigned elements = 0;
    xmlNode *top = xmlDocGetRootElement(r->doc);
    GPtrArray *painted = g_ptr_array_new();
    for (xmlNode *n = top; n; n = plb_node_next(n, top)) {
        if ((plb_node_is_shape(n) || plb_node_is(n, "text") || plb_node_is(n, "tspan")) && !plb_node_is_definition(n))
            g_ptr_array_add(painted, n);
    }
    for (guint i = 0; i < painted->len; i++) {
        xmlNode *n = painted->pdata[i];
        const xmlNode *of_stroke = pattern_of(r, n, "stroke"), *of_fill = pattern_of(r, n, "fill");
        if (of_stroke)
            use_mean(r, n, "stroke", of_stroke);
        if (of_fill)
            rewrite_fill(r, n, of_fill, &elements);
    }
    g_ptr_array_free(painted, TRUE);
}
