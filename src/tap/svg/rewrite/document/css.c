/* SPDX-License-Identifier: MIT */
#include "tap/svg/rewrite/document/css.h"

#include "tap/svg/rewrite/document/node.h"

#include <string.h>

#define BLANKS " \t\r\n\f"
#define NAME_CHARACTERS "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_\\"
#define MAX_RULES 20000
#define MAX_PARTS 16 /* compounds of one selector */

typedef struct {
    char combinator; /* towards the part before: ' ' '>' '+' '~'; 0: the first */
    char *text;      /* the compound, as "rect.a:not(.b)" */
} selector_part;

typedef struct {
    selector_part parts[MAX_PARTS];
    int n;
    unsigned specificity; /* ids, classes, types, eight bits each */
    const char *block;    /* its declarations; of the sheet's blocks */
} css_rule;

struct css_sheet {
    GArray *rules;     /* css_rule, in the order of the document */
    GHashTable *index; /* by what a rule asks of the element itself, ".class", "#id", "name" or "" (none of these): its rules */
    GPtrArray *blocks; /* the texts between braces, and the selectors' */
};

/* ---- reading ------------------------------------------------------------------------------------------------ */

static char *without_comments(const char *text)
{
    GString *out = g_string_new(NULL);
    while (*text) {
        const char *open = strstr(text, "/*");
        g_string_append_len(out, text, open ? open - text : (gssize)strlen(text));
        if (!open)
            break;
        const char *close = strstr(open + 2, "*/");
        text = close ? close + 2 : open + strlen(open);
    }
    return g_string_free(out, FALSE);
}

/* Gives the end of a compound that starts at `at`: brackets may hold anything. */
static const char *end_of_compound(const char *at)
{
    int depth = 0;
    for (; *at && (depth || !strchr(BLANKS ">+~,", *at)); at++)
        depth += (*at == '(' || *at == '[') - (*at == ')' || *at == ']');
    return at;
}

/* Counts the parts of a compound (Selectors 3, section 9). */
static unsigned weigh(const char *compound)
{
    unsigned ids = 0, classes = 0, types = strspn(compound, NAME_CHARACTERS) > 0;
    for (const char *at = compound; *at; at++) {
        ids += *at == '#';
        classes += *at == '.' || *at == '[' || (*at == ':' && at[1] != ':' && strncmp(at, ":not(", 5) != 0);
    }
    return ids << 16 | classes << 8 | types;
}

/* Reads one selector, without commas, into a rule; false: the selector is empty or too long. */
static bool read_selector(css_sheet *sheet, const char *text, css_rule *rule)
{
    char combinator = 0;
    for (;;) {
        size_t blanks = strspn(text, BLANKS);
        text += blanks;
        if (*text && strchr(">+~", *text)) {
            combinator = *text++;
            continue;
        }
        if (!*text)
            return rule->n > 0;
        if (rule->n == MAX_PARTS)
            return false;
        const char *end = end_of_compound(text);
        if (end == text)
            return false;
        char *compound = g_strndup(text, (gsize)(end - text));
        g_ptr_array_add(sheet->blocks, compound);
        rule->parts[rule->n] = (selector_part){rule->n && !combinator ? ' ' : combinator, compound};
        rule->n++;
        rule->specificity += weigh(compound);
        combinator = 0;
        text = end;
    }
}

/* Makes a rule of each selector before a block. */
static void add_rules(css_sheet *sheet, const char *selectors, size_t length, const char *block)
{
    char *text = g_strndup(selectors, length);
    char **each = g_strsplit(text, ",", 0);
    for (char **s = each; *s && sheet->rules->len < MAX_RULES; s++) {
        css_rule rule = {.block = block};
        if (read_selector(sheet, *s, &rule))
            g_array_append_val(sheet->rules, rule);
    }
    g_strfreev(each);
    g_free(text);
}

/* Gives the place behind the block that opens at `at`. */
static const char *end_of_block(const char *at)
{
    int depth = 0;
    for (; *at; at++) {
        depth += (*at == '{') - (*at == '}');
        if (depth == 0)
            return at + 1;
    }
    return at;
}

/* Reads the rules at the top; those within @media and the like are passed over, as librsvg passes them over. */
static void read_sheet(css_sheet *sheet, const char *text)
{
    for (;;) {
        text += strspn(text, BLANKS);
        size_t before = strcspn(text, "{;");
        if (!text[before])
            return;
        if (text[before] == ';') {
            text += before + 1;
            continue;
        }
        const char *open = text + before, *end = end_of_block(open);
        if (*text != '@') {
            gssize inside = end - open - 2;
            char *block = g_strndup(open + 1, inside > 0 ? (gsize)inside : 0);
            g_ptr_array_add(sheet->blocks, block);
            add_rules(sheet, text, before, block);
        }
        text = end;
    }
}

/* Gives a class, id or name, as in the index, without which no element matches the compound; "": there is none that is seen at a glance. */
static char *key_of(const char *compound)
{
    size_t type = strspn(compound, NAME_CHARACTERS);
    const char *at = compound + type + (compound[type] == '*');
    size_t length = *at == '.' || *at == '#' ? strspn(at + 1, NAME_CHARACTERS) : 0;
    return length ? g_strndup(at, length + 1) : g_strndup(compound, type);
}

static void free_rules(gpointer rules) { g_ptr_array_free(rules, TRUE); }

static void make_index(css_sheet *sheet)
{
    sheet->index = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, free_rules);
    for (guint i = 0; i < sheet->rules->len; i++) {
        css_rule *rule = &g_array_index(sheet->rules, css_rule, i);
        char *key = key_of(rule->parts[rule->n - 1].text);
        GPtrArray *rules = g_hash_table_lookup(sheet->index, key);
        if (!rules)
            g_hash_table_insert(sheet->index, g_strdup(key), rules = g_ptr_array_new());
        g_ptr_array_add(rules, rule);
        g_free(key);
    }
}

css_sheet *plb_css_new(xmlDoc *doc)
{
    css_sheet *sheet = g_new0(css_sheet, 1);
    sheet->rules = g_array_new(FALSE, FALSE, sizeof(css_rule));
    sheet->blocks = g_ptr_array_new_with_free_func(g_free);
    xmlNode *top = xmlDocGetRootElement(doc);
    for (xmlNode *n = top; n; n = plb_node_next(n, top)) {
        if (!plb_node_is(n, "style"))
            continue;
        xmlChar *content = xmlNodeGetContent(n);
        char *text = without_comments(content ? (const char *)content : "");
        read_sheet(sheet, text);
        g_free(text);
        xmlFree(content);
    }
    make_index(sheet);
    return sheet;
}

void plb_css_free(css_sheet *sheet)
{
    g_hash_table_destroy(sheet->index);
    g_array_free(sheet->rules, TRUE);
    g_ptr_array_free(sheet->blocks, TRUE);
    g_free(sheet);
}

/* ---- matching ----------------------------------------------------------------------------------------------- */

static bool has_class(const xmlNode *n, const char *name, size_t length)
{
    char *text = plb_node_get(n, "class");
    bool found = false;
    for (const char *at = text; at && *at && !found; at += strcspn(at, BLANKS)) {
        at += strspn(at, BLANKS);
        found = strcspn(at, BLANKS) == length && !strncmp(at, name, length);
    }
    g_free(text);
    return found;
}

static bool has_id(const xmlNode *n, const char *name, size_t length)
{
    char *id = plb_node_get(n, "id");
    bool same = id && strlen(id) == length && !strncmp(id, name, length);
    g_free(id);
    return same;
}

/* Matches "[name]" or "[name OP value]"; `inside` stands between the brackets. */
static bool has_attribute(const xmlNode *n, const char *inside)
{
    size_t length = strcspn(inside, "~|^$*=" BLANKS);
    char *name = g_strndup(inside, length), *value = plb_node_get(n, name);
    const char *operator = inside + length + strspn(inside + length, BLANKS);
    bool has = value != NULL;
    if (has && *operator) {
        const char *at = strchr(operator, '=');
        char *asked = at ? g_strdup(at + 1) : g_strdup("");
        g_strstrip(g_strdelimit(g_strstrip(asked), "'\"", ' '));
        switch (*operator) {
        case '=': has = !strcmp(value, asked); break;
        case '^': has = *asked && g_str_has_prefix(value, asked); break;
        case '$': has = *asked && g_str_has_suffix(value, asked); break;
        case '*': has = *asked && strstr(value, asked); break;
        case '~': has = *asked && strstr(value, asked); break;
        default: has = g_str_has_prefix(value, asked); break;
        }
        g_free(asked);
    }
    g_free(name);
    g_free(value);
    return has;
}

static bool is_first_of_its_kin(const xmlNode *n, bool from_end)
{
    const xmlNode *other = from_end ? n->next : n->prev;
    while (other && other->type != XML_ELEMENT_NODE)
        other = from_end ? other->next : other->prev;
    return !other;
}

static bool matches_compound(const xmlNode *n, const char *compound);

static bool matches_pseudo(const xmlNode *n, const char *name, size_t length, const char *argument)
{
    if (length == 4 && !strncmp(name, "root", 4))
        return !n->parent || n->parent->type != XML_ELEMENT_NODE;
    if (length == 11 && !strncmp(name, "first-child", 11))
        return is_first_of_its_kin(n, false);
    if (length == 10 && !strncmp(name, "last-child", 10))
        return is_first_of_its_kin(n, true);
    return length == 3 && !strncmp(name, "not", 3) && argument && !matches_compound(n, argument);
}

/* Matches one simple selector at `*at`, which moves behind it. */
static bool matches_simple(const xmlNode *n, const char **at)
{
    char sign = **at;
    const char *name = *at + 1;
    size_t length = strspn(name, NAME_CHARACTERS);
    *at = name + length;
    if (sign == '.')
        return has_class(n, name, length);
    if (sign == '#')
        return has_id(n, name, length);
    bool bracket = sign == '[' || (sign == ':' && **at == '(');
    const char *inside = sign == '[' ? name : *at + 1;
    const char *end = bracket ? strchr(inside, sign == '[' ? ']' : ')') : NULL;
    char *argument = end ? g_strndup(inside, (gsize)(end - inside)) : NULL;
    if (end)
        *at = end + 1;
    bool matches = sign == ':' ? matches_pseudo(n, name, length, argument) : sign == '[' && argument && has_attribute(n, argument);
    g_free(argument);
    if (!length && !end)
        *at = name + strlen(name); /* nothing known: the rest is not looked at */
    return matches;
}

static bool matches_compound(const xmlNode *n, const char *compound)
{
    const char *at = compound;
    size_t type = strspn(at, NAME_CHARACTERS);
    if (type && (strlen((const char *)n->name) != type || strncmp((const char *)n->name, at, type) != 0))
        return false;
    at += type + (*at == '*');
    bool matches = true;
    while (matches && *at)
        matches = matches_simple(n, &at);
    return matches;
}

static const xmlNode *element_before(const xmlNode *n)
{
    do
        n = n->prev;
    while (n && n->type != XML_ELEMENT_NODE);
    return n;
}

static const xmlNode *element_above(const xmlNode *n)
{
    return n->parent && n->parent->type == XML_ELEMENT_NODE ? n->parent : NULL;
}

/* Tells whether the parts up to `last` match with `n` as the last one. */
static bool matches_parts(const xmlNode *n, const css_rule *rule, int last)
{
    if (!matches_compound(n, rule->parts[last].text))
        return false;
    if (last == 0)
        return true;
    char combinator = rule->parts[last].combinator;
    bool beside = combinator == '+' || combinator == '~', once = combinator == '+' || combinator == '>';
    const xmlNode *other = beside ? element_before(n) : element_above(n);
    while (other && !matches_parts(other, rule, last - 1))
        other = once ? NULL : beside ? element_before(other) : element_above(other);
    return other != NULL;
}

/* ---- the cascade -------------------------------------------------------------------------------------------- */

static bool is_important(const char *value) { return strstr(value, "!important") || strstr(value, "! important"); }

/* Takes over the declarations of a block, later over earlier; important ones stay. */
static void declare(GHashTable *all, const char *block)
{
    int depth = 0;
    for (const char *at = block; *at;) {
        const char *end = at;
        for (; *end && (depth || *end != ';'); end++)
            depth += (*end == '(') - (*end == ')' && depth);
        const char *colon = memchr(at, ':', (size_t)(end - at));
        if (colon) {
            char *name = g_strstrip(g_strndup(at, (gsize)(colon - at))), *value = g_strstrip(g_strndup(colon + 1, (gsize)(end - colon - 1)));
            const char *now = g_hash_table_lookup(all, name);
            if (*name && (!now || !is_important(now) || is_important(value)))
                g_hash_table_insert(all, name, value);
            else
                g_free(name), g_free(value);
        }
        at = *end ? end + 1 : end;
    }
}

static int by_specificity(gconstpointer a, gconstpointer b)
{
    const css_rule *const *one = a, *const *other = b;
    if ((*one)->specificity != (*other)->specificity)
        return (*one)->specificity < (*other)->specificity ? -1 : 1;
    return *one < *other ? -1 : *one > *other; /* both lie in the array of rules, in the document's order */
}

/* Adds the rules under `sign` and the name that match the element. */
static void add_fitting(const css_sheet *sheet, const xmlNode *n, const char *sign, const char *name, size_t length, GPtrArray *fitting)
{
    char *key = g_strdup_printf("%s%.*s", sign, (int)length, name);
    GPtrArray *rules = g_hash_table_lookup(sheet->index, key);
    for (guint i = 0; rules && i < rules->len; i++) {
        css_rule *rule = rules->pdata[i];
        if (matches_parts(n, rule, rule->n - 1))
            g_ptr_array_add(fitting, rule);
    }
    g_free(key);
}

/* Gives the rules that match the element, the strongest last: only those are tried that ask for its name, its id, one of its classes, or none of these. */
static GPtrArray *find_fitting(const css_sheet *sheet, const xmlNode *n)
{
    GPtrArray *fitting = g_ptr_array_new();
    char *id = plb_node_get(n, "id"), *classes = plb_node_get(n, "class");
    add_fitting(sheet, n, "", "", 0, fitting);
    add_fitting(sheet, n, "", (const char *)n->name, strlen((const char *)n->name), fitting);
    if (id)
        add_fitting(sheet, n, "#", id, strlen(id), fitting);
    for (const char *at = classes; at && *at; at += strcspn(at, BLANKS)) {
        at += strspn(at, BLANKS);
        if (*at)
            add_fitting(sheet, n, ".", at, strcspn(at, BLANKS), fitting);
    }
    g_free(id);
    g_free(classes);
    g_ptr_array_sort(fitting, by_specificity);
    return fitting;
}

GHashTable *plb_css_declared(const css_sheet *sheet, const xmlNode *n)
{
    GHashTable *all = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free);
    for (const xmlAttr *a = n->properties; a; a = a->next) {
        char *value = strcmp((const char *)a->name, "style") ? plb_node_get(n, (const char *)a->name) : NULL;
        if (value)
            g_hash_table_insert(all, g_strdup((const char *)a->name), value);
    }
    GPtrArray *fitting = find_fitting(sheet, n);
    for (guint i = 0; i < fitting->len; i++)
        declare(all, ((const css_rule *)fitting->pdata[i])->block);
    g_ptr_array_free(fitting, TRUE);
    char *style = plb_node_get(n, "style");
    if (style)
        declare(all, style);
    g_free(style);
    return all;
}

/* Copies a value of the table, without "!important"; NULL: none. */
static char *copy_value(GHashTable *all, const char *property)
{
    const char *value = g_hash_table_lookup(all, property);
    const char *mark = value ? strchr(value, '!') : NULL;
    return value ? g_strstrip(mark ? g_strndup(value, (gsize)(mark - value)) : g_strdup(value)) : NULL;
}

char *plb_css_value(const css_sheet *sheet, const xmlNode *n, const char *property)
{
    GHashTable *all = plb_css_declared(sheet, n);
    char *copy = copy_value(all, property);
    g_hash_table_destroy(all);
    return copy;
}

char *plb_css_in_style(const xmlNode *n, const char *property)
{
    char *style = plb_node_get(n, "style");
    if (!style)
        return NULL;
    GHashTable *all = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free);
    declare(all, style);
    char *copy = copy_value(all, property);
    g_hash_table_destroy(all);
    g_free(style);
    return copy;
}

char *plb_css_inherited(const css_sheet *sheet, const xmlNode *n, const char *property)
{
    for (; n && n->type == XML_ELEMENT_NODE; n = n->parent) {
        char *value = plb_css_value(sheet, n, property);
        if (value && strcmp(value, "inherit") != 0)
            return value;
        g_free(value);
    }
    return NULL;
}

void plb_css_set(xmlNode *n, const char *property, const char *value)
{
    char *style = plb_node_get(n, "style");
    GString *out = g_string_new(NULL);
    char **each = g_strsplit(style ? style : "", ";", 0);
    size_t length = strlen(property);
    for (char **one = each; *one; one++) {
        const char *at = *one + strspn(*one, BLANKS);
        bool same = !strncmp(at, property, length) && at[length + strspn(at + length, BLANKS)] == ':';
        if (*at && !same)
            g_string_append_printf(out, "%s;", at);
    }
    if (value)
        g_string_append_printf(out, "%s:%s", property, value);
    else
        plb_node_remove(n, property);
    if (out->len || style)
        plb_node_set(n, "style", out->str);
    g_strfreev(each);
    g_string_free(out, TRUE);
    g_free(style);
}
