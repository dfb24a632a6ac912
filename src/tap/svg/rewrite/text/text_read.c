/* SPDX-License-Identifier: MIT */
#include "tap/svg/rewrite/text/text.h"

#include "tap/svg/rewrite/document/render.h"

#include <math.h>
#include <string.h>

/* A number_list holds the numbers of one attribute for the characters of one element. */
typedef struct {
    double *v;
    size_t n;
} number_list;

enum { LIST_X, LIST_Y, LIST_DX, LIST_DY, LIST_ROTATE, LISTS };
static const char *const list_names[LISTS] = {"x", "y", "dx", "dy", "rotate"};

/* A level is an element on the way down, with the count of its characters so far. */
typedef struct level {
    xmlNode *n;
    const struct level *outer;
    number_list lists[LISTS];
    size_t *passed; /* of this level and its inner ones */
} level;

static number_list read_list(const xmlNode *n, const char *name)
{
    GArray *all = g_array_new(FALSE, FALSE, sizeof(double));
    char *text = plb_node_get(n, name);
    char **words = g_strsplit_set(text ? text : "", " ,\t\r\n", 0);
    for (char **w = words; *w; w++) {
        char *end;
        double v = g_ascii_strtod(*w, &end);
        double unit = !strncmp(end, "mm", 2) ? 96 / 25.4 : !strncmp(end, "pt", 2) ? 96.0 / 72 : !strncmp(end, "em", 2) ? 16 : 1;
        if (**w && end > *w) {
            v *= unit;
            g_array_append_val(all, v);
        }
    }
    g_strfreev(words);
    g_free(text);
    number_list list = {.n = all->len};
    list.v = (double *)(void *)g_array_free(all, FALSE);
    return list;
}

/* Gives what the innermost element that speaks of this character says; NAN: nobody does. Of rotate the last number goes on. */
static double said_for(const level *l, int which)
{
    for (; l; l = l->outer) {
        const number_list *list = &l->lists[which];
        size_t at = *l->passed;
        if (which == LIST_ROTATE && list->n)
            return list->v[at < list->n ? at : list->n - 1];
        if (at < list->n)
            return list->v[at];
    }
    return NAN;
}

static bool is_from_right(gunichar c) { return (c >= 0x590 && c < 0x900) || (c >= 0xfb1d && c < 0xfe00) || (c >= 0xfe70 && c < 0xff00); }

static xmlNode *path_around(xmlNode *n)
{
    while (n && !plb_node_is(n, "textPath"))
        n = n->parent && n->parent->type == XML_ELEMENT_NODE ? n->parent : NULL;
    return n;
}

static void count_character(const level *l)
{
    for (; l; l = l->outer)
        ++*l->passed;
}

static bool add_character(text_line *line, GArray *all, const level *l, const char *at)
{
    gunichar c = g_utf8_get_char(at);
    text_character made = {.source = l->n, .on_path = path_around(l->n), .x = said_for(l, LIST_X), .y = said_for(l, LIST_Y)};
    double dx = said_for(l, LIST_DX), dy = said_for(l, LIST_DY), rotate = said_for(l, LIST_ROTATE);
    made.dx = isnan(dx) ? 0 : dx;
    made.dy = isnan(dy) ? 0 : dy;
    made.rotate = isnan(rotate) ? 0 : rotate;
    made.utf8[g_unichar_to_utf8(c, made.utf8)] = '\0';
    line->needs_places = line->needs_places || made.rotate != 0 || made.on_path;
    g_array_append_val(all, made);
    count_character(l);
    return all->len <= TEXT_MAX_CHARACTERS && !is_from_right(c);
}

/* Reads the text of one node; blanks run together with those before. */
static bool add_text(text_line *line, GArray *all, const level *l, const char *text, bool preserve)
{
    if (!g_utf8_validate(text, -1, NULL))
        return false;
    for (const char *at = text; *at; at = g_utf8_next_char(at)) {
        bool blank = strchr(" \t\r\n", *at) != NULL;
        bool after_blank = !all->len || g_array_index(all, text_character, all->len - 1).utf8[0] == ' ';
        if (blank && !preserve && after_blank)
            continue;
        if (!add_character(line, all, l, blank ? " " : at))
            return false;
    }
    return true;
}

static bool read_element(rewriting *r, text_line *line, GArray *all, xmlNode *n, const level *outer, int depth)
{
    static const char *const silent[] = {"title", "desc", "metadata", NULL};
    size_t passed = 0;
    level l = {.n = n, .outer = outer, .passed = &passed};
    bool ok = depth < NODE_MAX_DEPTH, preserve = xmlNodeGetSpacePreserve(n) == 1;
    for (int i = 0; i < LISTS; i++) {
        l.lists[i] = read_list(n, list_names[i]);
        line->needs_places = line->needs_places || l.lists[i].n > 1;
    }
    char *length = plb_node_get(n, "textLength");
    line->needs_places = line->needs_places || length;
    g_free(length);
    for (xmlNode *c = n->children; ok && c; c = c->next) {
        if (c->type == XML_TEXT_NODE || c->type == XML_CDATA_SECTION_NODE)
            ok = add_text(line, all, &l, (const char *)c->content, preserve);
        else if (c->type == XML_ELEMENT_NODE && !plb_node_is_any(c, silent))
            ok = read_element(r, line, all, c, &l, depth + 1);
    }
    for (int i = 0; i < LISTS; i++)
        g_free(l.lists[i].v);
    return ok;
}

bool plb_text_read(rewriting *r, xmlNode *text, text_line *line)
{
    GArray *all = g_array_new(FALSE, FALSE, sizeof(text_character));
    line->needs_places = false;
    bool ok = read_element(r, line, all, text, NULL, 0);
    if (all->len && g_array_index(all, text_character, all->len - 1).utf8[0] == ' ' && xmlNodeGetSpacePreserve(text) != 1)
        g_array_set_size(all, all->len - 1);
    line->n = all->len;
    line->v = (text_character *)(void *)g_array_free(all, FALSE);
    return ok;
}

bool plb_text_measure(rewriting *r, text_line *line)
{
    for (size_t from = 0, to; from < line->n; from = to) {
        GString *run = g_string_new(NULL);
        for (to = from; to < line->n && line->v[to].source == line->v[from].source; to++)
            g_string_append(run, line->v[to].utf8);
        double *ends = g_new0(double, to - from);
        bool ok = plb_render_advances(r, line->v[from].source, run->str, to - from, ends);
        for (size_t i = from; ok && i < to; i++)
            line->v[i].advance = ends[i - from] - (i > from ? ends[i - from - 1] : 0);
        g_free(ends);
        g_string_free(run, TRUE);
        if (!ok)
            return false;
    }
    return true;
}
