/* SPDX-License-Identifier: MIT */
#include "tap/svg/rewrite/document/render.h"

#include <librsvg/rsvg.h>
#include <string.h>

#define RASTER 64          /* px along each side: a mean needs no more */
#define MAX_RENDERS 200    /* each parses the whole document again */
#define MAX_RENDER_BYTES (4u << 20) /* of the document; larger ones would take seconds */

/* Makes a document of its own: the definitions of `r` and an empty view for what is to be looked at. The caller frees
 * it with xmlFreeDoc. */
static xmlDoc *start_document(rewriting *r, xmlNode **root)
{
    const xmlNode *old = xmlDocGetRootElement(r->doc);
    xmlDoc *doc = xmlNewDoc((const xmlChar *)"1.0");
    *root = xmlDocCopyNode((xmlNode *)(guintptr)old, doc, 2); /* the element with its attributes alone */
    xmlDocSetRootElement(doc, *root);
    xmlNode *defs = xmlNewChild(*root, (*root)->ns, (const xmlChar *)"defs", NULL);
    for (const xmlNode *c = old->children; c; c = c->next)
        xmlAddChild(defs, xmlDocCopyNode((xmlNode *)(guintptr)c, doc, 1));
    return doc;
}

static RsvgHandle *load(xmlDoc *doc)
{
    xmlChar *text = NULL;
    int size = 0;
    xmlDocDumpMemoryEnc(doc, &text, &size, "UTF-8");
    RsvgHandle *svg = text && (unsigned)size < MAX_RENDER_BYTES ? rsvg_handle_new_from_data(text, (gsize)size, NULL) : NULL;
    xmlFree(text);
    return svg;
}

static guint32 pixel_at(const cairo_surface_t *image, int x, int y)
{
    cairo_surface_t *s = (cairo_surface_t *)(guintptr)image;
    guint32 pixel;
    memcpy(&pixel, cairo_image_surface_get_data(s) + (size_t)y * (size_t)cairo_image_surface_get_stride(s) + 4 * (size_t)x, 4);
    return pixel;
}

/* Gives the mean colour of an image's pixels, of those that are mostly covered in `where` (NULL: of all), and their share of the raster. */
static double average(const cairo_surface_t *image, const cairo_surface_t *where, double mean[4])
{
    double sum[4] = {0}, n = 0;
    for (int y = 0; y < RASTER; y++)
        for (int x = 0; x < RASTER; x++) {
            if (where && pixel_at(where, x, y) >> 24 < 128)
                continue;
            guint32 pixel = pixel_at(image, x, y);
            for (int k = 0; k < 4; k++)
                sum[k] += pixel >> (k == 3 ? 24 : 16 - 8 * k) & 255;
            n++;
        }
    for (int k = 0; k < 3; k++)
        mean[k] = sum[3] > 0 ? sum[k] / sum[3] : 0;
    mean[3] = n > 0 ? sum[3] / 255 / n : 0;
    return n / RASTER / RASTER;
}

/* Renders the document, squeezed into the raster; NULL: librsvg refused. The caller destroys the result. */
static cairo_surface_t *rasterize(xmlDoc *doc)
{
    RsvgHandle *svg = load(doc);
    if (!svg)
        return NULL;
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, RASTER, RASTER);
    cairo_t *cr = cairo_create(image);
    RsvgRectangle viewport = {0, 0, RASTER, RASTER};
    bool done = rsvg_handle_render_document(svg, cr, &viewport, NULL) && cairo_status(cr) == CAIRO_STATUS_SUCCESS;
    cairo_destroy(cr);
    cairo_surface_flush(image);
    g_object_unref(svg);
    if (done)
        return image;
    cairo_surface_destroy(image);
    return NULL;
}

/* Shows `view` alone. */
static void set_view(xmlNode *root, box view)
{
    static const char *const dropped[] = {"transform", "style", "class", "opacity"};
    char *text = g_strdup_printf("%.9g %.9g %.9g %.9g", view.x0, view.y0, view.x1 - view.x0, view.y1 - view.y0);
    plb_node_set(root, "viewBox", text);
    plb_node_set(root, "preserveAspectRatio", "none");
    plb_node_set_number(root, "width", RASTER);
    plb_node_set_number(root, "height", RASTER);
    for (size_t i = 0; i < G_N_ELEMENTS(dropped); i++)
        plb_node_remove(root, dropped[i]);
    g_free(text);
}

static bool may_render(rewriting *r, box view) { return r->renders++ < MAX_RENDERS && view.x1 > view.x0 && view.y1 > view.y0; }

bool plb_render_mean(rewriting *r, const xmlNode *content, box view, double mean[4])
{
    if (!may_render(r, view))
        return false;
    xmlNode *root;
    xmlDoc *doc = start_document(r, &root);
    set_view(root, view);
    for (const xmlNode *c = content->children; c; c = c->next)
        xmlAddChild(root, xmlDocCopyNode((xmlNode *)(guintptr)c, doc, 1));
    cairo_surface_t *image = rasterize(doc);
    if (image)
        average(image, NULL, mean);
    cairo_surface_destroy(image);
    xmlFreeDoc(doc);
    return image != NULL;
}

/* Copies `n` with what it inherits, alone in a document. */
static xmlNode *show_alone(rewriting *r, const xmlNode *n, xmlNode *root)
{
    static const char *const inherited[] = {"fill", "stroke", "stroke-width", "fill-opacity", "stroke-opacity", "font-family", "font-size",
                                            "font-weight", "font-style", "color"};
    xmlNode *group = plb_node_new(root, "g"), *copy = xmlDocCopyNode((xmlNode *)(guintptr)n, root->doc, 1);
    for (size_t i = 0; i < G_N_ELEMENTS(inherited); i++) {
        char *value = plb_css_inherited(r->sheet, n->parent, inherited[i]);
        if (value)
            plb_css_set(group, inherited[i], value);
        g_free(value);
    }
    plb_css_set(copy, "transform", NULL);
    xmlAddChild(group, copy);
    xmlAddChild(root, group);
    return copy;
}

bool plb_render_filtered(rewriting *r, const xmlNode *n, box view, double without[4], double with[4])
{
    if (!may_render(r, view))
        return false;
    xmlNode *root;
    xmlDoc *doc = start_document(r, &root);
    set_view(root, view);
    xmlNode *copy = show_alone(r, n, root);
    cairo_surface_t *filtered = rasterize(doc);
    plb_css_set(copy, "filter", "none");
    cairo_surface_t *plain = rasterize(doc);
    bool known = filtered && plain && average(plain, plain, without) > 0;
    if (known)
        average(filtered, plain, with);
    cairo_surface_destroy(filtered);
    cairo_surface_destroy(plain);
    xmlFreeDoc(doc);
    return known;
}

/* Gives a text element in another document the properties of text that `like` has. */
static void copy_style(rewriting *r, const xmlNode *like, xmlNode *to)
{
    static const char *const properties[] = {"font-family", "font-size", "font-style", "font-variant", "font-weight", "font-stretch",
                                             "letter-spacing", "word-spacing"};
    for (size_t i = 0; i < G_N_ELEMENTS(properties); i++) {
        char *value = plb_css_inherited(r->sheet, like, properties[i]);
        if (value)
            plb_css_set(to, properties[i], value);
        g_free(value);
    }
}

/* Makes a text element with an id of its own for each number. */
static void add_prefix(rewriting *r, xmlNode *root, const xmlNode *like, size_t number, const char *text)
{
    char *id = g_strdup_printf("t%zu", number);
    xmlNode *one = xmlNewTextChild(root, NULL, (const xmlChar *)"text", (const xmlChar *)text);
    plb_node_set(one, "id", id);
    plb_node_set(one, "xml:space", "preserve");
    copy_style(r, like, one);
    g_free(id);
}

static bool width_of(RsvgHandle *svg, size_t number, double *width)
{
    char id[32];
    RsvgRectangle ink, logical;
    g_snprintf(id, sizeof id, "#t%zu", number);
    bool done = rsvg_handle_get_geometry_for_element(svg, id, &ink, &logical, NULL);
    *width = logical.x + logical.width;
    return done;
}

/* Sets each beginning of the text with a stop behind it, since blanks at the end have no width of their own. */
bool plb_render_advances(rewriting *r, const xmlNode *like, const char *text, size_t n, double *ends)
{
    if (r->renders++ >= MAX_RENDERS)
        return false;
    xmlDoc *doc = xmlNewDoc((const xmlChar *)"1.0");
    xmlNode *root = xmlNewDocNode(doc, NULL, (const xmlChar *)"svg", NULL);
    xmlNewProp(root, (const xmlChar *)"xmlns", (const xmlChar *)"http://www.w3.org/2000/svg");
    xmlDocSetRootElement(doc, root);
    const char *end = text;
    for (size_t i = 0; i <= n; i++) {
        char *prefix = g_strdup_printf("%.*s.", (int)(end - text), text);
        add_prefix(r, root, like, i, prefix);
        g_free(prefix);
        end = i < n ? g_utf8_next_char(end) : end;
    }
    RsvgHandle *svg = load(doc);
    double stop = 0;
    bool done = svg && width_of(svg, 0, &stop);
    for (size_t i = 0; done && i < n; i++) {
        done = width_of(svg, i + 1, &ends[i]);
        ends[i] -= stop;
    }
    g_clear_object(&svg);
    xmlFreeDoc(doc);
    return done;
}
