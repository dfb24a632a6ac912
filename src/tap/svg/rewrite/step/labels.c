/* SPDX-License-Identifier: MIT
 *
 * Rewrites labels in HTML, such as draw.io and Mermaid make. A switch shows its first child that can be shown; a
 * foreignObject of one line becomes a text, unless a text for programs without HTML stands beside it, which then is
 * drawn.
 */
#include "tap/svg/rewrite/steps.h"

#include <math.h>
#include <string.h>

#define USUAL_FONT_PX 16.0 /* CSS 2.1: a browser's medium */
#define LETTER_EM 0.6      /* a letter's breadth at most on average; chosen by eye: wider labels would have been wrapped */
#define MIDDLE_EM 0.35     /* from a line's middle down to its baseline; half a capital's height */

/* A label holds what HTML says: the text, where its middle or edge lies, how large it is. */
typedef struct {
    char *text;
    double x, y, width, height; /* of the box, px */
    double font;
    const char *anchor;
    bool bold, several_lines;
    char *colour;
} label;

/* ---- what the HTML says ------------------------------------------------------------------------------------- */

/* Gives a property that `n` or the nearest element above it, up to `top`, has in its style. */
static char *said_above(const xmlNode *n, const xmlNode *top, const char *property)
{
    for (; n; n = n == top ? NULL : n->parent) {
        char *value = n->type == XML_ELEMENT_NODE ? plb_css_in_style(n, property) : NULL;
        if (value)
            return value;
    }
    return NULL;
}

static bool breaks_line(const xmlNode *n)
{
    static const char *const blocks[] = {"br", "p", "li", "tr", "h1", "h2", "h3", "h4", "hr", NULL};
    return plb_node_is_any(n, blocks);
}

/* Finds the first piece of text that is more than blanks; counts pieces that stand on lines of their own. */
static const xmlNode *find_text(const xmlNode *top, bool *several)
{
    const xmlNode *first = NULL;
    bool broken = false;
    for (const xmlNode *n = top; n;) {
        bool is_text = n->type == XML_TEXT_NODE || n->type == XML_CDATA_SECTION_NODE;
        if (is_text && n->content && strspn((const char *)n->content, " \t\r\n") < strlen((const char *)n->content)) {
            *several = *several || (first && broken);
            first = first ? first : n;
            broken = false;
        }
        broken = broken || (first && breaks_line(n));
        if (n->type == XML_ELEMENT_NODE && n->children) {
            n = n->children;
            continue;
        }
        while (n && n != top && !n->next)
            n = n->parent;
        n = n && n != top ? n->next : NULL;
    }
    return first;
}

/* Gathers all text below; blanks run together. */
static char *plain_text(const xmlNode *n)
{
    xmlChar *content = xmlNodeGetContent(n);
    char **words = g_strsplit_set(content ? (const char *)content : "", " \t\r\n", 0);
    GString *out = g_string_new(NULL);
    for (char **w = words; *w; w++)
        if (**w)
            g_string_append_printf(out, out->len ? " %s" : "%s", *w);
    g_strfreev(words);
    xmlFree(content);
    return g_string_free(out, FALSE);
}

static double number_in(const xmlNode *from, const xmlNode *top, const char *property, double otherwise)
{
    char *text = said_above(from, top, property), *end = NULL;
    double v = text ? g_ascii_strtod(text, &end) : otherwise;
    v = text && end == text ? otherwise : v;
    g_free(text);
    return v;
}

/* Gives the box of a foreignObject. draw.io gives it the whole page and places the label by margins inside it. */
static void find_box(const xmlNode *n, const xmlNode *at, label *l)
{
    char *width = plb_node_get(n, "width");
    l->x = plb_node_length(n, "x", 0, 0);
    l->y = plb_node_length(n, "y", 0, 0);
    l->width = plb_node_length(n, "width", 0, 0);
    l->height = plb_node_length(n, "height", 0, 0);
    if (width && strchr(width, '%')) {
        l->x += number_in(at, n, "margin-left", 0);
        l->y += number_in(at, n, "padding-top", 0);
        l->width = number_in(at, n, "width", 0);
        l->height = 0;
    }
    g_free(width);
}

static void find_anchor(const xmlNode *n, const xmlNode *at, label *l)
{
    char *justify = said_above(at, n, "justify-content"), *align = said_above(at, n, "text-align");
    const char *said = justify ? justify : align;
    bool is_end = said && (strstr(said, "end") || strstr(said, "right")), is_start = said && (strstr(said, "start") || strstr(said, "left"));
    l->anchor = is_end ? "end" : is_start ? "start" : "middle";
    g_free(justify);
    g_free(align);
}

static bool read_label(rewriting *r, const xmlNode *n, label *l)
{
    const xmlNode *first = find_text(n, &l->several_lines), *at = first ? first->parent : NULL;
    if (!at)
        return false;
    char *inherited = plb_css_inherited(r->sheet, n, "font-size"), *weight = said_above(at, n, "font-weight");
    l->text = plain_text(n);
    l->font = number_in(at, n, "font-size", inherited ? g_ascii_strtod(inherited, NULL) : USUAL_FONT_PX);
    l->bold = (weight && (!strcmp(weight, "bold") || g_ascii_strtod(weight, NULL) > 500)) || plb_node_is(at, "b") || plb_node_is(at, "strong");
    l->colour = said_above(at, n, "color");
    find_box(n, at, l);
    find_anchor(n, at, l);
    g_free(inherited);
    g_free(weight);
    return true;
}

/* ---- what becomes of it ------------------------------------------------------------------------------------- */

static xmlNode *make_text(const xmlNode *like, const label *l)
{
    xmlNode *text = plb_node_new(like, "text");
    double share = !strcmp(l->anchor, "middle") ? 0.5 : !strcmp(l->anchor, "end") ? 1 : 0;
    plb_node_set_number(text, "x", l->x + share * l->width);
    plb_node_set_number(text, "y", l->y + l->height / 2 + MIDDLE_EM * l->font);
    plb_node_set_number(text, "font-size", l->font);
    plb_node_set(text, "text-anchor", l->anchor);
    plb_node_set(text, "fill", l->colour && !strchr(l->colour, '(') ? l->colour : "#000");
    plb_node_set(text, "stroke", "none");
    if (l->bold)
        plb_node_set(text, "font-weight", "bold");
    xmlNodeAddContent(text, (const xmlChar *)l->text);
    return text;
}

/* Tells whether a label is one line, which a browser would not have wrapped. */
static bool fits(const label *l)
{
    double breadth = LETTER_EM * l->font * (double)g_utf8_strlen(l->text, -1);
    return !l->several_lines && (l->width <= 1 || breadth <= fmax(l->width, 4 * l->font));
}

/* Puts a text in the place of a foreignObject. `picture` is the image that is to stand for it where there is one: the
 * image's box is the label's. False: the label is more than a line of text, or has no place. */
static bool replace_foreign(rewriting *r, xmlNode *n, const xmlNode *picture)
{
    label l = {0};
    bool there = read_label(r, n, &l);
    if (there && picture)
        find_box(picture, picture, &l);
    bool done = there && fits(&l) && (l.width > 0 || l.x != 0 || l.y != 0);
    if (done) {
        r->changed = true;
        xmlNode *text = make_text(n, &l);
        xmlReplaceNode(n, text);
        xmlFreeNode(n);
    }
    g_free(l.text);
    g_free(l.colour);
    return done || !there;
}

static xmlNode *first_element(const xmlNode *n)
{
    xmlNode *c = n->children;
    while (c && c->type != XML_ELEMENT_NODE)
        c = c->next;
    return c;
}

static xmlNode *next_element(const xmlNode *n)
{
    xmlNode *c = n->next;
    while (c && c->type != XML_ELEMENT_NODE)
        c = c->next;
    return c;
}

static bool holds_text(const xmlNode *n)
{
    for (const xmlNode *c = n; c; c = plb_node_next(c, n))
        if (plb_node_is(c, "text"))
            return true;
    return false;
}

static void drop_after(xmlNode *n)
{
    for (xmlNode *other; (other = next_element(n));)
        plb_node_drop(other);
}

/* Tells whether an element asks for programs that show HTML, in draw.io's words. */
static bool asks_for_html(const xmlNode *n)
{
    char *features = plb_node_get(n, "requiredFeatures");
    bool asks = plb_node_is(n, "foreignObject") || (features && strstr(features, "Extensibility"));
    g_free(features);
    return asks;
}

/* Decides a switch between HTML and its substitute. Other switches are librsvg's affair. */
static void rewrite_switch(rewriting *r, xmlNode *n)
{
    xmlNode *first = first_element(n), *second = first ? next_element(first) : NULL;
    if (!first || !asks_for_html(first))
        return;
    r->changed = true;
    plb_node_remove(first, "requiredFeatures");
    if (!plb_node_is(first, "foreignObject")) {
        drop_after(first);
    } else if (second && (holds_text(second) || !plb_node_is(second, "image"))) {
        drop_after(second);
        plb_node_drop(first);
        plb_node_remove(second, "requiredFeatures");
    } else {
        bool replaced = replace_foreign(r, first, plb_node_is(second, "image") ? second : NULL);
        drop_after(replaced ? first_element(n) : first);
    }
}

void plb_rewrite_labels(rewriting *r)
{
    xmlNode *top = xmlDocGetRootElement(r->doc);
    for (xmlNode *n = top; n; n = plb_node_next(n, top))
        if (plb_node_is(n, "switch"))
            rewrite_switch(r, n);
    for (xmlNode *n = top, *next; n; n = next) {
        next = plb_node_next(n, top);
        if (!plb_node_is(n, "foreignObject") || plb_node_is(n->parent, "switch"))
            continue;
        /* Goes on behind a foreignObject, whose contents are no SVG. */
        while (next && next != n) {
            xmlNode *up = next;
            while (up && up != n)
                up = up->parent;
            if (up != n)
                break;
            next = plb_node_next(next, top);
        }
        replace_foreign(r, n, NULL);
    }
}
