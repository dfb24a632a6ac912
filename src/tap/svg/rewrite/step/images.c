/* SPDX-License-Identifier: MIT
 *
 * Turns images that are SVG themselves, given in the document as data URIs (RFC 2397), into nested drawings. Names and
 * style sheets of such a drawing hold inside it alone, so its styles go into the elements and its ids get a prefix. A picture of
 * pixels stays, to be counted as left out, and gets paper below.
 */
#include "tap/svg/rewrite/document/outline.h"
#include "tap/svg/rewrite/document/render.h"
#include "tap/svg/rewrite/steps.h"

#include "tap/common/tap_page.h"

#include <libxml/parser.h>
#include <string.h>

#define MAX_IMAGES 200 /* in one document, nested ones counted */

/* Gives the bytes of a data URI of type image/svg+xml; NULL: the text is something else. */
static char *decode(const char *uri, gsize *size)
{
    const char *comma = strchr(uri, ',');
    if (strncmp(uri, "data:image/svg", 14) != 0 || !comma)
        return NULL;
    bool is_base64 = g_strstr_len(uri, comma - uri, ";base64") != NULL;
    char *plain = g_uri_unescape_string(comma + 1, NULL);
    if (!plain && !is_base64)
        return NULL;
    if (!is_base64) {
        *size = strlen(plain);
        return plain;
    }
    char *bytes = (char *)g_base64_decode(plain ? plain : comma + 1, size);
    g_free(plain);
    return bytes;
}

/* ---- names and styles --------------------------------------------------------------------------------------- */

/* Turns every "#name" of the text into "#prefix-name" where the drawing has such an id. */
static char *with_prefix(const char *text, GHashTable *ids, const char *prefix)
{
    GString *out = g_string_new(NULL);
    for (const char *hash; (hash = strchr(text, '#'));) {
        size_t length = strcspn(hash + 1, ")'\" ;,\t\r\n");
        char *name = g_strndup(hash + 1, length);
        g_string_append_len(out, text, hash + 1 - text);
        if (g_hash_table_contains(ids, name))
            g_string_append_printf(out, "%s-", prefix);
        g_string_append(out, name);
        g_free(name);
        text = hash + 1 + length;
    }
    g_string_append(out, text);
    return g_string_free(out, FALSE);
}

static void rename_ids(xmlNode *top, GHashTable *ids, const char *prefix)
{
    for (xmlNode *n = top; n; n = plb_node_next(n, top))
        for (xmlAttr *a = n->properties; a; a = a->next) {
            char *value = (char *)xmlNodeListGetString(n->doc, a->children, 1), *made = NULL;
            if (value && !strcmp((const char *)a->name, "id"))
                made = g_strdup_printf("%s-%s", prefix, value);
            else if (value && strchr(value, '#'))
                made = with_prefix(value, ids, prefix);
            if (made) {
                xmlNodeSetContent((xmlNode *)a, NULL);
                xmlNode *text = xmlNewDocText(n->doc, (const xmlChar *)made);
                a->children = a->last = text;
                text->parent = (xmlNode *)a;
            }
            g_free(made);
            xmlFree(value);
        }
}

/* Puts what the style sheets say of each element into its style attribute, then drops the sheets. */
static void inline_styles(xmlDoc *doc)
{
    css_sheet *sheet = plb_css_new(doc);
    xmlNode *top = xmlDocGetRootElement(doc);
    for (xmlNode *n = top; n; n = plb_node_next(n, top)) {
        GHashTable *declared = plb_css_declared(sheet, n);
        GHashTableIter i;
        gpointer name, value;
        g_hash_table_iter_init(&i, declared);
        while (g_hash_table_iter_next(&i, &name, &value)) {
            char *now = plb_node_get(n, name);
            if (!now || strcmp(now, value) != 0)
                plb_css_set(n, name, value);
            g_free(now);
        }
        g_hash_table_destroy(declared);
    }
    for (xmlNode *n = top, *next; n; n = next) {
        next = plb_node_next(n, top);
        plb_node_remove(n, "class");
        if (plb_node_is(n, "style") && n->children) {
            xmlFreeNodeList(n->children);
            n->children = n->last = NULL;
        }
    }
    plb_css_free(sheet);
}

/* ---- placing ------------------------------------------------------------------------------------------------ */

static void copy_attribute(const xmlNode *from, xmlNode *to, const char *name)
{
    char *value = plb_node_get(from, name);
    if (value)
        plb_node_set(to, name, value);
    g_free(value);
}

/* Puts the drawing `svg` in the place of `image`, as large as it. */
static void place(xmlNode *image, xmlNode *svg)
{
    static const char *const taken[] = {"x", "y", "width", "height", "preserveAspectRatio"};
    static const char *const kept[] = {"transform", "style", "opacity", "clip-path", "mask", "class"};
    char *view = plb_node_get(svg, "viewBox");
    if (!view) {
        char *made = g_strdup_printf("0 0 %d %d", (int)plb_node_length(svg, "width", 100, 100), (int)plb_node_length(svg, "height", 100, 100));
        plb_node_set(svg, "viewBox", made);
        g_free(made);
    }
    g_free(view);
    for (size_t i = 0; i < G_N_ELEMENTS(taken); i++) {
        char *own = plb_node_get(image, taken[i]);
        bool is_extent = i == 2 || i == 3;
        if (own || !is_extent)
            plb_node_remove(svg, taken[i]);
        if (own)
            plb_node_set(svg, taken[i], own);
        g_free(own);
    }
    xmlNode *group = plb_node_new(image, "g");
    for (size_t i = 0; i < G_N_ELEMENTS(kept); i++)
        copy_attribute(image, group, kept[i]);
    xmlAddChild(group, svg);
    xmlReplaceNode(image, group);
    xmlFreeNode(image);
}

/* Replaces one image; false: the image is no SVG, and stays. */
static bool rewrite_image(rewriting *r, xmlNode *image, unsigned number)
{
    char *uri = plb_node_get(image, "href");
    gsize size = 0;
    char *text = uri ? decode(g_strstrip(uri), &size) : NULL;
    xmlDoc *doc = text && size < TAP_LIBXML_TEXT ? xmlReadMemory(text, (int)size, NULL, NULL, XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING) : NULL;
    xmlNode *top = doc ? xmlDocGetRootElement(doc) : NULL;
    bool is_svg = top && plb_node_is(top, "svg");
    if (is_svg) {
        r->changed = true;
        GHashTable *ids = plb_node_ids(doc);
        char *prefix = g_strdup_printf("image-%u", number);
        inline_styles(doc);
        rename_ids(top, ids, prefix);
        place(image, xmlDocCopyNode(top, r->doc, 1));
        g_hash_table_destroy(ids);
        g_free(prefix);
    }
    if (doc)
        xmlFreeDoc(doc);
    g_free(text);
    g_free(uri);
    return is_svg;
}

/* ---- pictures of pixels ------------------------------------------------------------------------------------- */

/* A picture hides what lies below where it is at least so opaque. */
#define OPAQUE 0.95

/* Puts a shape of paper below an opaque picture, as large as its opaque part: the picture is left out, what it hides is so, too. */
static void lay_paper(rewriting *r, xmlNode *image)
{
    box b = {plb_node_length(image, "x", 100, 0), plb_node_length(image, "y", 100, 0), 0, 0};
    b.x1 = b.x0 + plb_node_length(image, "width", 100, 0);
    b.y1 = b.y0 + plb_node_length(image, "height", 100, 0);
    xmlNode *holder = plb_node_new(image, "g"), *copy = xmlDocCopyNode(image, image->doc, 1);
    plb_node_remove(copy, "transform");
    xmlAddChild(holder, copy);
    double mean;
    char *data = b.x1 > b.x0 && b.y1 > b.y0 ? plb_render_outline(r, holder, b, true, true, OPAQUE, &mean) : NULL;
    xmlFreeNode(holder);
    if (!data)
        return;
    r->changed = true;
    xmlNode *group = plb_rewrite_wrap(r, image, true), *paper = plb_node_new(group, "path");
    char *id = plb_node_get(image, "id");
    if (id) { /* others that use the picture use both */
        plb_node_remove(image, "id");
        plb_node_set(group, "id", id);
    }
    plb_node_set(paper, "d", data);
    plb_node_set(paper, "style", "fill:#fff;fill-opacity:1;stroke:none");
    xmlAddPrevSibling(image, paper);
    g_free(id);
    g_free(data);
}

void plb_rewrite_images(rewriting *r)
{
    unsigned number = 0;
    xmlNode *top = xmlDocGetRootElement(r->doc);
    /* Looks from the start until there are no images left: a drawing that has been put in may hold images of its own. */
    for (bool again = true; again && number < MAX_IMAGES;) {
        again = false;
        for (xmlNode *n = top; n && !again; n = again ? NULL : plb_node_next(n, top)) /* an image that is replaced has gone */
            again = plb_node_is(n, "image") && rewrite_image(r, n, number++);
    }
    for (xmlNode *n = top; n; n = plb_node_next(n, top))
        if (plb_node_is(n, "image") && !plb_node_is_definition(n))
            lay_paper(r, n);
    g_hash_table_destroy(r->ids);
    r->ids = plb_node_ids(r->doc);
}
