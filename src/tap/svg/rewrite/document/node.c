/* SPDX-License-Identifier: MIT */
#include "tap/svg/rewrite/document/node.h"

#include "base/number/number.h"

#include <string.h>

bool plb_node_is(const xmlNode *n, const char *name)
{
    return n && n->type == XML_ELEMENT_NODE && !strcmp((const char *)n->name, name);
}

bool plb_node_is_any(const xmlNode *n, const char *const names[])
{
    while (*names && !plb_node_is(n, *names))
        names++;
    return *names != NULL;
}

bool plb_node_is_shape(const xmlNode *n)
{
    static const char *const shapes[] = {"path", "rect", "circle", "ellipse", "line", "polyline", "polygon", NULL};
    return plb_node_is_any(n, shapes);
}

bool plb_node_is_definition(const xmlNode *n)
{
    static const char *const definitions[] = {"clipPath", "mask", "pattern", "marker", NULL};
    while (n && !plb_node_is_any(n, definitions))
        n = n->parent;
    return n != NULL;
}

static xmlAttr *find_attribute(const xmlNode *n, const char *name)
{
    xmlAttr *a = n->type == XML_ELEMENT_NODE ? n->properties : NULL;
    while (a && strcmp((const char *)a->name, name) != 0)
        a = a->next;
    return a;
}

char *plb_node_get(const xmlNode *n, const char *name)
{
    const xmlAttr *a = find_attribute(n, name);
    char *text = a ? (char *)xmlNodeListGetString(n->doc, a->children, 1) : NULL, *copy = a ? g_strdup(text ? text : "") : NULL;
    xmlFree(text);
    return copy;
}

void plb_node_set(xmlNode *n, const char *name, const char *value)
{
    plb_node_remove(n, name);
    xmlNewProp(n, (const xmlChar *)name, (const xmlChar *)value);
}

void plb_node_set_number(xmlNode *n, const char *name, double value)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    plb_node_set(n, name, g_ascii_dtostr(text, sizeof text, value));
}

void plb_node_remove(xmlNode *n, const char *name)
{
    for (xmlAttr *a; (a = find_attribute(n, name));)
        xmlRemoveProp(a);
}

double plb_node_length(const xmlNode *n, const char *name, double share_of, double otherwise)
{
    static const struct {
        const char *unit;
        double px;
    } units[] = {{"px", 1}, {"pt", 96.0 / 72}, {"pc", 16}, {"mm", 96 / 25.4}, {"cm", 96 / 2.54}, {"in", 96}, {"em", 16}, {"ex", 8}};
    char *text = plb_node_get(n, name), *end = NULL;
    double v = text ? g_ascii_strtod(text, &end) : otherwise;
    if (!text || end == text)
        v = otherwise;
    else if (*end == '%')
        v *= share_of / 100;
    for (size_t i = 0; end && i < G_N_ELEMENTS(units); i++)
        if (!strncmp(end, units[i].unit, 2))
            v *= units[i].px;
    g_free(text);
    return v;
}

xmlNode *plb_node_next(const xmlNode *n, const xmlNode *top)
{
    xmlNode *next = n->type == XML_ELEMENT_NODE ? n->children : NULL;
    while (!next && n && n != top) {
        next = n->next;
        n = n->parent;
    }
    while (next && next->type != XML_ELEMENT_NODE) {
        xmlNode *after = next;
        while (after && after != top && !after->next)
            after = after->parent;
        next = after && after != top ? after->next : NULL;
    }
    return next;
}

xmlNode *plb_node_new(const xmlNode *like, const char *name)
{
    return xmlNewDocNode(like->doc, like->ns, (const xmlChar *)name, NULL);
}

xmlNode *plb_node_wrap(xmlNode *n)
{
    xmlNode *group = plb_node_new(n, "g");
    xmlReplaceNode(n, group);
    xmlAddChild(group, n);
    return group;
}

void plb_node_drop(xmlNode *n)
{
    xmlUnlinkNode(n);
    xmlFreeNode(n);
}

xmlNode *plb_node_referred(GHashTable *ids, const char *text)
{
    const char *hash = text ? strchr(text, '#') : NULL;
    char *name = hash ? g_strndup(hash + 1, strcspn(hash + 1, ")'\" \t\r\n")) : NULL;
    xmlNode *n = name ? g_hash_table_lookup(ids, name) : NULL;
    g_free(name);
    return n;
}

GHashTable *plb_node_ids(xmlDoc *doc)
{
    GHashTable *ids = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    xmlNode *top = xmlDocGetRootElement(doc);
    for (xmlNode *n = top; n; n = plb_node_next(n, top)) {
        char *id = plb_node_get(n, "id");
        if (id && *id && !g_hash_table_contains(ids, id))
            g_hash_table_insert(ids, g_strdup(id), n);
        g_free(id);
    }
    return ids;
}

char *plb_node_name(xmlNode *n, GHashTable *ids, const char *stem)
{
    char *id = plb_node_get(n, "id");
    for (unsigned i = 1; !id || !*id; i++) {
        g_free(id);
        id = g_strdup_printf("%s-%u", stem, i);
        if (g_hash_table_contains(ids, id))
            *id = '\0';
        else
            plb_node_set(n, "id", id);
    }
    g_hash_table_insert(ids, g_strdup(id), n);
    return id;
}

/* ---- transformations ---------------------------------------------------------------------------------------- */

/* Reads the numbers in one function's brackets, at most six; angles become degrees, lengths px. Gives their count; -1: not well-formed. */
static int read_arguments(const char **at, double v[6])
{
    int n = 0;
    const char *p = *at + 1;
    for (;;) {
        p += strspn(p, " \t\r\n,");
        if (*p == ')')
            break;
        char *end;
        double number = n < 6 ? g_ascii_strtod(p, &end) : 0;
        if (n == 6 || end == p)
            return -1;
        p = end;
        double unit = !strncmp(p, "rad", 3) ? 180 / PLB_PI : !strncmp(p, "turn", 4) ? 360 : !strncmp(p, "grad", 4) ? 0.9 : !strncmp(p, "pt", 2) ? 96.0 / 72 : 1;
        p += strspn(p, "abcdefghijklmnopqrstuvwxyz");
        v[n++] = number * unit;
    }
    *at = p + 1;
    return n;
}

static matrix translation(double x, double y) { return (matrix){1, 0, 0, 1, x, y}; }

/* Makes the matrix of one function by its name and `n` arguments; false: there is no such function. */
static bool make_function(const char *name, size_t length, int n, const double v[6], matrix *m)
{
    double angle = v[0] * PLB_PI / 180;
    bool is = false;
#define IS(word, low, high) (is = length == sizeof word - 1 && !strncmp(name, word, length) && n >= (low) && n <= (high))
    if (IS("matrix", 6, 6))
        *m = (matrix){v[0], v[1], v[2], v[3], v[4], v[5]};
    else if (IS("translate", 1, 2))
        *m = translation(v[0], n > 1 ? v[1] : 0);
    else if (IS("translateX", 1, 1))
        *m = translation(v[0], 0);
    else if (IS("translateY", 1, 1))
        *m = translation(0, v[0]);
    else if (IS("scale", 1, 2))
        *m = plb_matrix_scale(v[0], n > 1 ? v[1] : v[0]);
    else if (IS("scaleX", 1, 1))
        *m = plb_matrix_scale(v[0], 1);
    else if (IS("scaleY", 1, 1))
        *m = plb_matrix_scale(1, v[0]);
    else if (IS("rotate", 1, 1))
        *m = plb_matrix_rotate(angle);
    else if (IS("rotate", 3, 3))
        *m = plb_matrix_multiply(plb_matrix_multiply(translation(-v[1], -v[2]), plb_matrix_rotate(angle)), translation(v[1], v[2]));
    else if (IS("skewX", 1, 1))
        *m = (matrix){1, 0, tan(angle), 1, 0, 0};
    else if (IS("skewY", 1, 1))
        *m = (matrix){1, tan(angle), 0, 1, 0, 0};
#undef IS
    return is;
}

bool plb_node_transform(const char *text, matrix *m)
{
    *m = MATRIX_IDENTITY;
    if (!text || !strcmp(text, "none"))
        return true;
    for (const char *at = text + strspn(text, " \t\r\n,"); *at; at += strspn(at, " \t\r\n,")) {
        const char *name = at;
        size_t length = strspn(at, "abcdefghijklmnopqrstuvwxyzXY");
        at += length + strspn(at + length, " \t\r\n");
        double v[6];
        matrix one;
        int n = *at == '(' ? read_arguments(&at, v) : -1;
        if (n < 1 || !make_function(name, length, n, v, &one))
            return false;
        *m = plb_matrix_multiply(one, *m);
    }
    return true;
}

char *plb_node_matrix_text(matrix m)
{
    double v[6] = {m.xx, m.yx, m.xy, m.yy, m.x0, m.y0};
    GString *text = g_string_new("matrix(");
    for (int i = 0; i < 6; i++) {
        char number[G_ASCII_DTOSTR_BUF_SIZE];
        g_string_append(text, g_ascii_dtostr(number, sizeof number, v[i]));
        g_string_append(text, i < 5 ? " " : ")");
    }
    return g_string_free(text, FALSE);
}
