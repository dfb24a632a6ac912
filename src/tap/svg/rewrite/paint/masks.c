/* SPDX-License-Identifier: MIT
 *
 * Replaces masks and clip paths. A mask of white shapes and black ones over them lets through a region with a sharp
 * edge: the same as clip paths, one for the white shapes and one for the outside of each black shape. Another mask clips
 * to where it lets something through, and acts there by its mean tone. A clip path that is itself clipped becomes two, one inside the other (CSS Masking 1).
 */
#include "tap/svg/rewrite/document/outline.h"
#include "tap/svg/rewrite/document/render.h"
#include "tap/svg/rewrite/steps.h"

#include <math.h>
#include <string.h>

#define MAX_SHAPES 64       /* of a mask that becomes clip paths: each black one is a group around the others */
#define NEARLY 0.02         /* a luminance this near to black or white is; chosen by eye */
#define FAR_AWAY 1e6        /* px: outside every drawing */
#define LINE_BREADTH 1.0    /* px: what a line is taken to cover at least */
#define FAINTEST 0.02       /* what is let through in a smaller part leaves no mark; chosen by eye */

typedef struct {
    const xmlNode *shapes[MAX_SHAPES];
    bool white[MAX_SHAPES];
    int n;
} stencil;

/* ---- what a mask is made of --------------------------------------------------------------------------------- */

/* Gives the luminance of a plain colour (CSS Masking 1, section 7.10.1); -1: the paint is something else. */
static double luminance(const char *text)
{
    if (!text)
        return 0; /* black is what a fill is where nothing is said */
    if (!g_ascii_strcasecmp(text, "white"))
        return 1;
    if (!g_ascii_strcasecmp(text, "black"))
        return 0;
    size_t length = *text == '#' ? strlen(text + 1) : 0;
    double v[3];
    if (length != 3 && length != 6)
        return -1;
    for (int i = 0; i < 3; i++) {
        int high = g_ascii_xdigit_value(text[1 + (length == 3 ? i : 2 * i)]), low = g_ascii_xdigit_value(text[1 + (length == 3 ? i : 2 * i + 1)]);
        if (high < 0 || low < 0)
            return -1;
        v[i] = (16 * high + low) / 255.0;
    }
    return 0.2125 * v[0] + 0.7154 * v[1] + 0.0721 * v[2];
}

/* Tells whether a property that makes paint paler is at its full value. */
static bool is_full(rewriting *r, const xmlNode *n, const char *property)
{
    char *text = plb_css_inherited(r->sheet, n, property);
    bool full = !text || g_ascii_strtod(text, NULL) >= 1;
    g_free(text);
    return full;
}

static bool is_none(rewriting *r, const xmlNode *n, const char *property)
{
    char *text = plb_css_inherited(r->sheet, n, property);
    bool none = !text || !strcmp(text, "none");
    g_free(text);
    return none;
}

/* Tells whether `n` has an outline and is black or white through and through, with a sharp edge. */
static bool read_shape(rewriting *r, const xmlNode *n, stencil *s)
{
    char *fill = plb_css_inherited(r->sheet, n, "fill");
    double light = luminance(fill);
    bool sharp = plb_node_is_shape(n) && (light >= 0 && (light <= NEARLY || light >= 1 - NEARLY)) && is_none(r, n, "stroke") &&
                 is_full(r, n, "opacity") && is_full(r, n, "fill-opacity") && is_none(r, n, "filter") && is_none(r, n, "clip-path");
    g_free(fill);
    if (!sharp || s->n == MAX_SHAPES)
        return false;
    s->shapes[s->n] = n;
    s->white[s->n++] = light >= 0.5;
    return true;
}

/* Finds white shapes, then black ones: false for all other masks. */
static bool read_stencil(rewriting *r, const xmlNode *mask, stencil *s)
{
    static const char *const silent[] = {"title", "desc", "metadata", "defs", NULL};
    s->n = 0;
    for (const xmlNode *n = plb_node_next(mask, mask); n; n = plb_node_next(n, mask))
        if (!plb_node_is(n, "g") && !plb_node_is_any(n, silent) && !read_shape(r, n, s))
            return false;
    for (int i = 1; i < s->n; i++)
        if (s->white[i] && !s->white[i - 1])
            return false;
    return s->n > 0 && s->white[0];
}

/* ---- clip paths --------------------------------------------------------------------------------------------- */

static void add_data(GString *out, const path *p)
{
    static const struct {
        char letter;
        int points;
    } form[] = {[PATH_MOVE] = {'M', 1}, [PATH_LINE] = {'L', 1}, [PATH_CURVE] = {'C', 3}, [PATH_CLOSE] = {'Z', 0}};
    size_t k = 0;
    for (size_t i = 0; i < p->ops.n; i++) {
        g_string_append_c(out, form[p->ops.v[i]].letter);
        for (int j = 0; j < form[p->ops.v[i]].points; j++, k++) {
            char x[G_ASCII_DTOSTR_BUF_SIZE], y[G_ASCII_DTOSTR_BUF_SIZE];
            g_string_append_printf(out, "%s %s ", g_ascii_dtostr(x, sizeof x, p->points.v[k].x), g_ascii_dtostr(y, sizeof y, p->points.v[k].y));
        }
    }
}

/* Gives the map from the shape's user space to that of the mask's content. */
static matrix to_mask(const xmlNode *n, const xmlNode *mask)
{
    matrix m = MATRIX_IDENTITY;
    for (; n && n != mask; n = n->parent) {
        char *text = plb_node_get(n, "transform");
        matrix own;
        if (plb_node_transform(text, &own))
            m = plb_matrix_multiply(m, own);
        g_free(text);
    }
    return m;
}

/* Adds one shape's outline as a path to a clip path; of a black shape all that lies outside. */
static void add_clip_shape(xmlNode *clip, const xmlNode *shape, const xmlNode *mask, bool white)
{
    path p = plb_outline(shape);
    GString *data = g_string_new(NULL);
    plb_path_transform(&p, to_mask(shape, mask));
    if (!white)
        g_string_append_printf(data, "M%.0f %.0fH%.0fV%.0fH%.0fZ", -FAR_AWAY, -FAR_AWAY, FAR_AWAY, FAR_AWAY, -FAR_AWAY);
    add_data(data, &p);
    xmlNode *outline = plb_node_new(clip, "path");
    plb_node_set(outline, "d", data->str);
    if (!white)
        plb_node_set(outline, "clip-rule", "evenodd");
    xmlAddChild(clip, outline);
    g_string_free(data, TRUE);
    plb_path_free(&p);
}

/* Makes a new, empty clip path with the units of the mask; `*reference` gets "url(#...)", to be freed. */
static xmlNode *new_clip(rewriting *r, xmlNode *mask, char **reference)
{
    xmlNode *clip = plb_node_new(mask, "clipPath");
    char *units = plb_node_get(mask, "maskContentUnits");
    if (units)
        plb_node_set(clip, "clipPathUnits", units);
    xmlAddNextSibling(mask, clip);
    char *id = plb_node_name(clip, r->ids, "plumbago-clip");
    *reference = g_strdup_printf("url(#%s)", id);
    g_free(id);
    g_free(units);
    return clip;
}

static void clip_by(xmlNode *n, const char *reference)
{
    plb_css_set(n, "clip-path", reference);
}

static void apply_stencil(rewriting *r, xmlNode *n, xmlNode *mask, const stencil *s)
{
    char *reference;
    xmlNode *group = plb_rewrite_wrap(r, n, true), *clip = new_clip(r, mask, &reference);
    plb_css_set(group, "mask", "none");
    group = plb_node_wrap(n);
    for (int i = 0; i < s->n && s->white[i]; i++)
        add_clip_shape(clip, s->shapes[i], mask, true);
    clip_by(group, reference);
    g_free(reference);
    for (int i = 0; i < s->n; i++) {
        if (s->white[i])
            continue;
        group = plb_node_wrap(n);
        add_clip_shape(new_clip(r, mask, &reference), s->shapes[i], mask, false);
        clip_by(group, reference);
        g_free(reference);
    }
}

/* ---- soft masks --------------------------------------------------------------------------------------------- */

/* Gives the part of the user space that the mask is looked at in: the element's box. */
static box view_of(const xmlNode *n, const xmlNode *mask)
{
    char *units = plb_node_get(mask, "maskContentUnits");
    bool in_box = units && !strcmp(units, "objectBoundingBox");
    box view = in_box ? (box){0, 0, 1, 1} : plb_outline_box(n);
    g_free(units);
    if (plb_box_is_empty(view))
        view = plb_outline_viewport(n);
    if (!in_box) /* a line has no breadth of its own */
        view = (box){view.x0 - LINE_BREADTH / 2, view.y0 - LINE_BREADTH / 2, view.x1 + LINE_BREADTH / 2, view.y1 + LINE_BREADTH / 2};
    return view;
}

/* Gives the outline of what the mask lets through, as path data, and how much it lets through there; NULL: nothing. */
static char *find_window(rewriting *r, const xmlNode *n, const xmlNode *mask, double *mean)
{
    char *type = plb_css_value(r->sheet, mask, "mask-type");
    bool by_alpha = type && !strcmp(type, "alpha");
    g_free(type);
    return plb_render_outline(r, mask, view_of(n, mask), false, by_alpha, FAINTEST, mean);
}

static void apply_window(rewriting *r, xmlNode *n, xmlNode *mask)
{
    double mean;
    char number[G_ASCII_DTOSTR_BUF_SIZE], *data = find_window(r, n, mask, &mean), *reference;
    xmlNode *group = plb_rewrite_wrap(r, n, true);
    plb_css_set(group, "mask", "none");
    if (!data) {
        plb_css_set(group, "display", "none");
        return;
    }
    xmlNode *clip = new_clip(r, mask, &reference), *outline = plb_node_new(clip, "path"), *clipped = plb_node_wrap(n);
    plb_node_set(outline, "d", data);
    xmlAddChild(clip, outline);
    clip_by(clipped, reference);
    plb_css_set(clipped, "opacity", g_ascii_formatd(number, sizeof number, "%.4f", mean));
    g_free(reference);
    g_free(data);
}

static void rewrite_mask(rewriting *r, xmlNode *n, xmlNode *mask)
{
    stencil s;
    if (read_stencil(r, mask, &s))
        apply_stencil(r, n, mask, &s);
    else
        apply_window(r, n, mask);
}

/* ---- clipped clip paths ------------------------------------------------------------------------------------- */

/* Whether clip paths clip each other in a circle: librsvg then draws nothing. */
static bool goes_in_circles(rewriting *r, const xmlNode *clip)
{
    int depth = 0;
    for (; clip && depth < MAX_SHAPES; depth++) {
        char *outer = plb_css_value(r->sheet, clip, "clip-path");
        clip = plb_node_referred(r->ids, outer);
        g_free(outer);
    }
    return depth == MAX_SHAPES;
}

static void rewrite_clip(rewriting *r, xmlNode *n, xmlNode *clip)
{
    char *outer = plb_css_value(r->sheet, clip, "clip-path");
    if (goes_in_circles(r, clip)) {
        g_free(outer);
        return;
    }
    for (int depth = 0; outer && strncmp(outer, "url", 3) == 0 && depth < MAX_SHAPES; depth++) {
        xmlNode *next = plb_node_referred(r->ids, outer);
        if (!next || !plb_node_is(next, "clipPath"))
            break;
        xmlNode *group = plb_rewrite_wrap(r, n, false);
        clip_by(group, outer);
        g_free(outer);
        outer = plb_css_value(r->sheet, next, "clip-path");
    }
    g_free(outer);
}

void plb_rewrite_masks(rewriting *r)
{
    static const char *const definitions[] = {"clipPath", "mask", "pattern", "marker", NULL};
    xmlNode *top = xmlDocGetRootElement(r->doc);
    for (xmlNode *n = top, *next; n; n = next) {
        next = plb_node_next(n, top);
        if (n == top || plb_node_is_any(n, definitions))
            continue;
        char *mask = plb_css_value(r->sheet, n, "mask"), *clip = plb_css_value(r->sheet, n, "clip-path");
        xmlNode *by = plb_node_referred(r->ids, clip), *through = plb_node_referred(r->ids, mask);
        if (by && plb_node_is(by, "clipPath"))
            rewrite_clip(r, n, by);
        if (through && plb_node_is(through, "mask"))
            rewrite_mask(r, n, through);
        g_free(mask);
        g_free(clip);
    }
}
