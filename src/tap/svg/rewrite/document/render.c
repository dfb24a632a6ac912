/* SPDX-License-Identifier: MIT */
#include "tap/svg/rewrite/document/render.h"

#include <librsvg/rsvg.h>
#include <string.h>

#define RASTER 64          /* px along each side: a mean needs no more */
#define MAX_RENDERS 200    /* each parses the whole document again */
#define MAX_RENDER_BYTES (4u << 20) /* of the document; larger ones would take seconds */

/* Makes a document of its own: the definitions of `r` and an empty view for what is to be looked at. The caller frees
 * it with xmlFreeDoc. */
static xmlDoc *start_document(rewriting *r, bool is_alone, xmlNode **root)
{
    const xmlNode *old = xmlDocGetRootElement(r->doc);
    xmlDoc *doc = xmlNewDoc((const xmlChar *)"1.0");
    *root = xmlDocCopyNode((xmlNode *)(guintptr)old, doc, 2); /* the element with its attributes alone */
    xmlDocSetRootElement(doc, *root);
    if (is_alone)
        return doc;
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

/* Renders the children of `content`; NULL: nothing could be rendered. The caller destroys the result. */
static cairo_surface_t *rasterize_content(rewriting *r, const xmlNode *content, box view, bool is_alone)
{
    if (!may_render(r, view))
        return NULL;
    xmlNode *root;
    xmlDoc *doc = start_document(r, is_alone, &root);
    set_view(root, view);
    for (const xmlNode *c = content->children; c; c = c->next)
        xmlAddChild(root, xmlDocCopyNode((xmlNode *)(guintptr)c, doc, 1));
    cairo_surface_t *image = rasterize(doc);
    xmlFreeDoc(doc);
    return image;
}

bool plb_render_mean(rewriting *r, const xmlNode *content, box view, double mean[4])
{
    cairo_surface_t *image = rasterize_content(r, content, view, false);
    if (image)
        average(image, NULL, mean);
    cairo_surface_destroy(image);
    return image != NULL;
}

/* ---- outlines ----------------------------------------------------------------------------------------------- */

/* A stencil says which pixels of the raster are inside, with a rim of pixels that are not. */
typedef struct {
    bool in[RASTER + 2][RASTER + 2];   /* [y][x] */
    bool seen[RASTER + 2][RASTER + 2]; /* the upper side of the pixel has been followed */
    box view;
} stencil;

/* Finds the pixels that are strong enough, counts them and gives their mean. */
static int find_strong(const cairo_surface_t *image, bool by_alpha, double least, stencil *s, double *mean)
{
    int n = 0;
    *mean = 0;
    for (int y = 0; y < RASTER; y++)
        for (int x = 0; x < RASTER; x++) {
            guint32 pixel = pixel_at(image, x, y); /* premultiplied */
            double alpha = (pixel >> 24) / 255.0, light = (0.2125 * (pixel >> 16 & 255) + 0.7154 * (pixel >> 8 & 255) + 0.0721 * (pixel & 255)) / 255;
            double strength = by_alpha ? alpha : light;
            s->in[y + 1][x + 1] = strength >= least;
            n += strength >= least;
            *mean += strength >= least ? strength : 0;
        }
    *mean = n ? *mean / n : 0;
    return n;
}

/* A corner of an outline, in half pixels. */
typedef struct {
    int x, y;
} corner;

/* Adds a corner; one that lies on the way from the one before to this goes. */
static void add_corner(GArray *out, int x, int y)
{
    corner c = {x, y}, *v = (corner *)(void *)out->data;
    guint n = out->len;
    bool is_straight = n > 1 && (v[n - 1].x - v[n - 2].x) * (y - v[n - 1].y) == (v[n - 1].y - v[n - 2].y) * (x - v[n - 1].x);
    if (is_straight || (n && v[n - 1].x == x && v[n - 1].y == y))
        v[n - 1] = c;
    else
        g_array_append_val(out, c);
}

static void write_outline(const stencil *s, const GArray *corners, GString *out)
{
    for (guint i = 0; i < corners->len; i++) {
        corner c = g_array_index(corners, corner, i);
        double x = s->view.x0 + c.x / 2.0 / RASTER * (s->view.x1 - s->view.x0), y = s->view.y0 + c.y / 2.0 / RASTER * (s->view.y1 - s->view.y0);
        char text[2][G_ASCII_DTOSTR_BUF_SIZE];
        g_string_append_printf(out, "%c%s %s ", i ? 'L' : 'M', g_ascii_formatd(text[0], sizeof text[0], "%.9g", x), g_ascii_formatd(text[1], sizeof text[1], "%.9g", y));
    }
    g_string_append_c(out, 'Z');
}

/* Follows an outline from the upper side of pixel (x, y) on, the inside at its right hand, through the middles of the pixels' sides: so
 * the stairs of a slanting edge become an even line. At the raster's border the outline goes through the corners. */
static void follow(stencil *s, GString *out, int x, int y)
{
    static const int step[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    static const int right[4][2] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}; /* the pixel ahead at the right, from the corner, for each way */
    static const int left[4][2] = {{0, -1}, {0, 0}, {-1, 0}, {-1, -1}};
    GArray *corners = g_array_new(FALSE, FALSE, sizeof(corner));
    int cx = x, cy = y, way = 0; /* the corner that the side starts at, upper left of pixel (cx, cy) */
    do {
        int nx = cx + step[way][0], ny = cy + step[way][1];
        bool is_border = way % 2 ? cx == 1 || cx == RASTER + 1 : cy == 1 || cy == RASTER + 1;
        s->seen[cy][cx] = s->seen[cy][cx] || way == 0;
        if (is_border)
            add_corner(corners, 2 * cx - 2, 2 * cy - 2);
        add_corner(corners, is_border ? 2 * nx - 2 : cx + nx - 2, is_border ? 2 * ny - 2 : cy + ny - 2);
        cx = nx;
        cy = ny;
        bool is_in_right = s->in[cy + right[way][1]][cx + right[way][0]], is_in_left = s->in[cy + left[way][1]][cx + left[way][0]];
        way = !is_in_right ? (way + 1) % 4 : is_in_left ? (way + 3) % 4 : way;
    } while (cx != x || cy != y || way != 0);
    add_corner(corners, g_array_index(corners, corner, 0).x, g_array_index(corners, corner, 0).y);
    g_array_set_size(corners, corners->len - 1);
    write_outline(s, corners, out);
    g_array_free(corners, TRUE);
}

char *plb_render_outline(rewriting *r, const xmlNode *content, box view, bool is_alone, bool by_alpha, double least, double *mean)
{
    cairo_surface_t *image = rasterize_content(r, content, view, is_alone);
    stencil s = {.view = view};
    int n = image ? find_strong(image, by_alpha, least, &s, mean) : 0;
    cairo_surface_destroy(image);
    if (!n)
        return NULL;
    GString *out = g_string_new(NULL);
    for (int y = 1; y <= RASTER; y++)
        for (int x = 1; x <= RASTER; x++)
            if (s.in[y][x] && !s.in[y - 1][x] && !s.seen[y][x])
                follow(&s, out, x, y);
    return g_string_free(out, FALSE);
}

/* ---- one element -------------------------------------------------------------------------------------------- */

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
    xmlDoc *doc = start_document(r, false, &root);
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
