/* SPDX-License-Identifier: MIT
 *
 * Counts what is left out as a reader sees the drawing: definitions count where they are used and as often, a picture
 * that serves as a mask counts as the mask, and a mask upon nothing but a picture does not count beside it.
 */
#include "tap/svg/losses/tap_omissions.h"

#include "tap/common/tap_page.h"
#include "tap/svg/rewrite/document/css.h"
#include "tap/svg/rewrite/document/node.h"

#include <glib.h>
#include <libxml/parser.h>
#include <libxml/tree.h>

#include <stdbool.h>
#include <string.h>

/* librsvg stops beyond 500,000 elements; its documents are no deeper than a few hundred. */
#define MAX_VISITS 1000000ul
#define MAX_DEPTH 1000

typedef struct {
    omissions lost;
    GHashTable *by_id; /* of names to nodes, both the document's */
    unsigned long visits;
} walk;

/* Gives the value of a property, by style or attribute; to be freed; NULL: not said. */
static char *property(const xmlNode *n, const char *name)
{
    char *value = plb_css_in_style(n, name);
    return value ? value : plb_node_get(n, name);
}

/* Tells whether the element has a mask or a filter (`kind`) that the document defines. */
static bool has(const walk *w, const xmlNode *n, const char *kind)
{
    char *text = property(n, kind);
    const xmlNode *target = text && !strncmp(text, "url", 3) ? plb_node_referred(w->by_id, text) : NULL;
    g_free(text);
    return target && plb_node_is(target, kind);
}

static bool is_displayed(const xmlNode *n)
{
    char *text = property(n, "display");
    bool shown = !text || strncmp(text, "none", 4) != 0;
    g_free(text);
    return shown;
}

/* Tells whether a switch passes the element over, because the element asks for what librsvg does not have. */
static bool is_passed_over(const xmlNode *n)
{
    char *features = plb_node_get(n, "requiredFeatures"), *extensions = plb_node_get(n, "requiredExtensions");
    bool passed = (features && strstr(features, "Extensibility")) || extensions;
    g_free(features);
    g_free(extensions);
    return n->type != XML_ELEMENT_NODE || passed;
}

static bool visit(walk *w, xmlNode *n, int depth);

static bool visit_children(walk *w, xmlNode *n, int depth)
{
    bool shows = false, one = plb_node_is(n, "switch");
    for (xmlNode *c = n->children; c; c = c->next) {
        if (is_passed_over(c))
            continue;
        shows = visit(w, c, depth + 1) || shows;
        if (one)
            break;
    }
    return shows;
}

static bool visit_used(walk *w, const xmlNode *n, int depth)
{
    char *href = plb_node_get(n, "href");
    xmlNode *target = plb_node_referred(w->by_id, href);
    g_free(href);
    if (!target)
        return false;
    return plb_node_is(target, "symbol") ? visit_children(w, target, depth + 1) : visit(w, target, depth + 1);
}

/* Counts the omissions of an element without its own mask and filter. */
static bool visit_inside(walk *w, xmlNode *n, int depth)
{
    static const char *const groups[] = {"svg", "g", "a", "switch", NULL};
    if (plb_node_is(n, "image"))
        w->lost.n[OMISSION_IMAGE]++;
    else if (plb_node_is(n, "foreignObject"))
        w->lost.n[OMISSION_FOREIGN]++;
    else if (plb_node_is(n, "use"))
        return visit_used(w, n, depth);
    else
        return !plb_node_is_any(n, groups) || visit_children(w, n, depth);
    return false;
}

/* Counts the omissions in what is drawn for `n`; true: something is drawn all the same. */
static bool visit(walk *w, xmlNode *n, int depth)
{
    static const char *const unseen[] = {"defs", "symbol", "clipPath", "mask", "pattern", "marker", "filter", "linearGradient",
                                         "radialGradient", "style", "script", "title", "desc", "metadata", "namedview", NULL};
    if (depth > MAX_DEPTH || ++w->visits > MAX_VISITS || n->type != XML_ELEMENT_NODE || plb_node_is_any(n, unseen) || !is_displayed(n))
        return false;
    if (!visit_inside(w, n, depth))
        return false;
    w->lost.n[OMISSION_MASK] += has(w, n, "mask");
    w->lost.n[OMISSION_FILTER] += has(w, n, "filter");
    return true;
}

/* Counts how often a style sheet has "property:url" or "property: url". */
static unsigned long rules(const char *sheet, const char *property)
{
    unsigned long n = 0;
    for (const char *at = sheet; (at = strstr(at, property));) {
        at += strlen(property);
        const char *text = at + strspn(at, " \t");
        n += *text == ':' && !strncmp(text + 1 + strspn(text + 1, " \t"), "url", 3);
    }
    return n;
}

/* Counts what style sheets ask for; a rule counts once, whatever it applies to. */
static void look_through_sheets(walk *w, xmlDoc *doc)
{
    xmlNode *top = xmlDocGetRootElement(doc);
    for (xmlNode *n = top; n; n = plb_node_next(n, top)) {
        char *sheet = plb_node_is(n, "style") ? (char *)xmlNodeGetContent(n) : NULL;
        w->lost.n[OMISSION_MASK] += sheet ? rules(sheet, "mask") : 0;
        w->lost.n[OMISSION_FILTER] += sheet ? rules(sheet, "filter") : 0;
        xmlFree(sheet);
    }
}

static bool may_lose(const char *text, size_t size)
{
    return g_strstr_len(text, (gssize)size, "image") || g_strstr_len(text, (gssize)size, "mask") ||
           g_strstr_len(text, (gssize)size, "filter") || g_strstr_len(text, (gssize)size, "foreignObject");
}

omissions plb_tap_count_omissions(const char *text, size_t size)
{
    walk w = {.visits = 0};
    int options = XML_PARSE_RECOVER | XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | (size > TAP_LIBXML_TEXT ? XML_PARSE_HUGE : 0);
    xmlDoc *doc = may_lose(text, size) ? xmlReadMemory(text, (int)size, NULL, NULL, options) : NULL;
    if (!doc)
        return w.lost;
    w.by_id = plb_node_ids(doc);
    look_through_sheets(&w, doc);
    if (xmlDocGetRootElement(doc))
        visit(&w, xmlDocGetRootElement(doc), 0);
    g_hash_table_destroy(w.by_id);
    xmlFreeDoc(doc);
    return w.lost;
}
