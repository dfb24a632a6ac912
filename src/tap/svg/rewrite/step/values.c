/* SPDX-License-Identifier: MIT
 *
 * Computes values: var() of custom properties (CSS Variables 1), colours newer than librsvg, and the property d. For
 * each element the step finds the declaration that wins and puts its value into the style attribute, where nothing else
 * wins over it.
 */
#include "tap/svg/rewrite/steps.h"

#include "tap/svg/rewrite/paint/colours.h"

#include <string.h>

#define MAX_VALUE 65536 /* bytes of a value after substitution: custom properties can double each other */
#define MAX_NESTING 32

/* The custom properties that an element sees are its own, then its ancestors'. */
typedef struct scope {
    GHashTable *own; /* all its declarations */
    const struct scope *outer;
} scope;

static const char *look_up(const scope *s, const char *name)
{
    for (; s; s = s->outer) {
        const char *value = g_hash_table_lookup(s->own, name);
        if (value)
            return value;
    }
    return NULL;
}

static bool substitute(const scope *s, const char *value, int depth, GString *out);

/* Adds the value of one var(), whose brackets hold a name and, behind a comma, what serves without it. */
static bool substitute_one(const scope *s, const char *inside, int depth, GString *out)
{
    const char *comma = strchr(inside, ',');
    char *name = g_strstrip(comma ? g_strndup(inside, (gsize)(comma - inside)) : g_strdup(inside));
    const char *value = look_up(s, name);
    bool ok = value && strcmp(value, "initial") != 0 ? substitute(s, value, depth + 1, out) : comma && substitute(s, comma + 1, depth + 1, out);
    g_free(name);
    return ok;
}

/* Adds `value` with every var() replaced; false: one has no value, or they go in circles. */
static bool substitute(const scope *s, const char *value, int depth, GString *out)
{
    for (const char *at; (at = strstr(value, "var("));) {
        g_string_append_len(out, value, at - value);
        const char *inside = at + 4, *end = inside;
        for (int open = 1; *end; end++) {
            open += (*end == '(') - (*end == ')');
            if (open == 0)
                break;
        }
        char *text = g_strndup(inside, (gsize)(end - inside));
        bool ok = depth < MAX_NESTING && out->len < MAX_VALUE && substitute_one(s, text, depth, out);
        g_free(text);
        if (!ok)
            return false;
        value = end + (*end == ')');
    }
    g_string_append(out, value);
    return out->len < MAX_VALUE;
}

/* Takes the wrapping off "path('M0 0')" and puts the data into the attribute d. */
static void set_path(xmlNode *n, const char *value)
{
    const char *open = strpbrk(value, "'\""), *close = open ? strrchr(value, *open) : NULL;
    if (strncmp(value, "path(", 5) || !close || close == open)
        return;
    char *data = g_strndup(open + 1, (gsize)(close - open - 1));
    plb_css_set(n, "d", NULL);
    plb_node_set(n, "d", data);
    g_free(data);
}

/* Rewrites one declaration of an element, where librsvg would not understand it. A value that cannot be computed counts
 * as absent: the parent's holds. */
static void rewrite_value(rewriting *r, xmlNode *n, const scope *s, const char *property, const char *value)
{
    bool has_var = strstr(value, "var(") != NULL;
    if (!strncmp(property, "--", 2) || (!has_var && !plb_colour_is_new(value) && !(!strcmp(property, "d") && !strncmp(value, "path(", 5))))
        return;
    r->changed = true;
    GString *plain = g_string_new(NULL);
    bool ok = substitute(s, value, 0, plain);
    char *known = ok ? g_strstrip(plb_colour_replace(plain->str)) : g_strdup("inherit");
    if (!strcmp(property, "d"))
        set_path(n, known);
    else
        plb_css_set(n, property, *known ? known : "inherit");
    g_free(known);
    g_string_free(plain, TRUE);
}

static void visit(rewriting *r, xmlNode *n, const scope *outer, int depth)
{
    scope s = {plb_css_declared(r->sheet, n), outer};
    GHashTableIter i;
    gpointer property, value;
    g_hash_table_iter_init(&i, s.own);
    while (g_hash_table_iter_next(&i, &property, &value))
        rewrite_value(r, n, &s, property, value);
    for (xmlNode *c = n->children; c && depth < NODE_MAX_DEPTH; c = c->next)
        if (c->type == XML_ELEMENT_NODE)
            visit(r, c, &s, depth + 1);
    g_hash_table_destroy(s.own);
}

void plb_rewrite_values(rewriting *r)
{
    visit(r, xmlDocGetRootElement(r->doc), NULL, 0);
}
