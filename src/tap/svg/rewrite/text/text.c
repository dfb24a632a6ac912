/* SPDX-License-Identifier: MIT
 *
 * Places text whose characters have places of their own (SVG 2, chapter 11): lists of places, turned characters, a
 * given length, text on a path. The element becomes a group of texts, each at the place where it belongs.
 */
#include "tap/svg/rewrite/text/text.h"

#include "tap/svg/rewrite/document/outline.h"

#include <math.h>
#include <string.h>

/* A guide holds the points of the path that a textPath names, and their distance from its start. */
typedef struct {
    point *at;
    bool *jump;
    size_t n;
    double length;
} guide;

/* ---- new elements ------------------------------------------------------------------------------------------- */

/* Copies what holds for `source` into the new element, wherever in the document it stands. */
static void copy_style(rewriting *r, const xmlNode *source, xmlNode *to)
{
    static const char *const properties[] = {"font-family", "font-size", "font-style", "font-variant", "font-weight", "font-stretch",
                                             "fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "letter-spacing",
                                             "text-decoration", "visibility"};
    for (size_t i = 0; i < G_N_ELEMENTS(properties); i++) {
        char *value = plb_css_inherited(r->sheet, source, properties[i]);
        if (value)
            plb_css_set(to, properties[i], value);
        g_free(value);
    }
    plb_css_set(to, "text-anchor", "start");
}

/* Makes a text with its start on the origin of `map`. */
static void emit(rewriting *r, xmlNode *group, const xmlNode *source, const char *text, matrix map)
{
    xmlNode *made = plb_node_new(group, "text");
    char *transform = plb_node_matrix_text(map);
    plb_node_set(made, "xml:space", "preserve");
    copy_style(r, source, made);
    plb_node_set(made, "transform", transform);
    xmlNodeAddContent(made, (const xmlChar *)text);
    xmlAddChild(group, made);
    g_free(transform);
}

static matrix turned_at(point at, double degrees)
{
    matrix m = plb_matrix_rotate(degrees * PLB_PI / 180);
    m.x0 = at.x;
    m.y0 = at.y;
    return m;
}

/* ---- on a path ---------------------------------------------------------------------------------------------- */

static bool find_guide(rewriting *r, const xmlNode *on_path, guide *g)
{
    char *href = plb_node_get(on_path, "href"), *transform;
    const xmlNode *n = plb_node_referred(r->ids, href);
    g_free(href);
    if (!n || !plb_node_is_shape(n))
        return false;
    path p = plb_outline(n);
    matrix m;
    transform = plb_node_get(n, "transform");
    if (plb_node_transform(transform, &m))
        plb_path_transform(&p, m);
    g->n = plb_outline_points(&p, &g->at, &g->jump);
    g->length = plb_outline_length(&p);
    g_free(transform);
    plb_path_free(&p);
    return g->length > 0;
}

/* Gives the place `s` px along the guide, and the direction there in degrees; false: beyond an end. */
static bool place_on(const guide *g, double s, point *at, double *degrees)
{
    for (size_t i = 1; i < g->n && s >= 0; i++) {
        double piece = g->jump[i] ? 0 : plb_point_distance(g->at[i - 1], g->at[i]);
        if (piece > 0 && s <= piece) {
            *at = point_mix(g->at[i - 1], g->at[i], s / piece);
            *degrees = atan2(g->at[i].y - g->at[i - 1].y, g->at[i].x - g->at[i - 1].x) * 180 / PLB_PI;
            return true;
        }
        s -= piece;
    }
    return false;
}

static double anchor_share(rewriting *r, const xmlNode *n)
{
    char *anchor = plb_css_inherited(r->sheet, n, "text-anchor");
    double share = anchor && !strcmp(anchor, "middle") ? 0.5 : anchor && !strcmp(anchor, "end") ? 1 : 0;
    g_free(anchor);
    return share;
}

/* Places the characters from..to, which stand on one path, each with its middle on the path. */
static bool set_on_path(rewriting *r, xmlNode *group, const text_line *line, size_t from, size_t to)
{
    guide g = {0};
    const xmlNode *on_path = line->v[from].on_path;
    bool there = find_guide(r, on_path, &g);
    double width = 0, s, across = 0;
    for (size_t i = from; i < to; i++)
        width += line->v[i].advance + line->v[i].dx;
    s = plb_node_length(on_path, "startOffset", g.length, 0) - anchor_share(r, line->v[from].source) * width;
    for (size_t i = from; there && i < to; i++) {
        const text_character *c = &line->v[i];
        point at;
        double degrees;
        s += c->dx;
        across += c->dy;
        if (place_on(&g, s + c->advance / 2, &at, &degrees)) {
            matrix m = turned_at(at, degrees + c->rotate);
            emit(r, group, c->source, c->utf8, plb_matrix_multiply((matrix){1, 0, 0, 1, -c->advance / 2, across}, m));
        }
        s += c->advance;
    }
    g_free(g.at);
    g_free(g.jump);
    return there;
}

/* ---- in lines ----------------------------------------------------------------------------------------------- */

/* Shares a given length out between the characters, or stretches all: gives the factor, and what is added to each advance. */
static double fit_length(const xmlNode *text, const text_line *line, double *added)
{
    double natural = 0, asked = plb_node_length(text, "textLength", 0, 0);
    char *adjust = plb_node_get(text, "lengthAdjust");
    for (size_t i = 0; i < line->n; i++)
        natural += line->v[i].advance;
    bool stretches = adjust && !strcmp(adjust, "spacingAndGlyphs");
    g_free(adjust);
    *added = asked > 0 && !stretches && line->n > 1 ? (asked - natural) / (double)(line->n - 1) : 0;
    return asked > 0 && stretches && natural > 0 ? asked / natural : 1;
}

/* Gives the first character behind `from` that starts a chunk of its own. */
static size_t end_of_chunk(const text_line *line, size_t from, size_t to)
{
    size_t end = from + 1;
    while (end < to && isnan(line->v[end].x) && isnan(line->v[end].y))
        end++;
    return end;
}

/* Gives the end of the characters that are set together, because the document says nothing about their places. */
static size_t end_of_run(const text_line *line, size_t from, size_t to, double added)
{
    size_t end = from + 1;
    const text_character *c = line->v;
    while (end < to && added == 0 && c[from].rotate == 0 && c[end].rotate == 0 && c[end].dx == 0 && c[end].dy == 0 && c[end].source == c[from].source)
        end++;
    return end;
}

/* Places one chunk, from the pen's place on, which moves. */
static void set_chunk(rewriting *r, xmlNode *group, const text_line *line, size_t from, size_t to, point *pen, double stretch, double added)
{
    double width = 0;
    for (size_t i = from; i < to; i++)
        width += line->v[i].advance * stretch + line->v[i].dx + (i + 1 < to ? added : 0);
    pen->x = isnan(line->v[from].x) ? pen->x : line->v[from].x;
    pen->y = isnan(line->v[from].y) ? pen->y : line->v[from].y;
    pen->x -= anchor_share(r, line->v[from].source) * width;
    for (size_t i = from, end; i < to; i = end) {
        end = end_of_run(line, i, to, added);
        GString *run = g_string_new(NULL);
        double advance = 0;
        for (size_t k = i; k < end; k++) {
            g_string_append(run, line->v[k].utf8);
            advance += line->v[k].advance * stretch + added;
        }
        pen->x += line->v[i].dx;
        pen->y += line->v[i].dy;
        emit(r, group, line->v[i].source, run->str, plb_matrix_multiply(plb_matrix_scale(stretch, 1), turned_at(*pen, line->v[i].rotate)));
        pen->x += advance;
        g_string_free(run, TRUE);
    }
}

static void set_line(rewriting *r, xmlNode *text, xmlNode *group, const text_line *line)
{
    double added, stretch = fit_length(text, line, &added);
    point pen = {0, 0};
    for (size_t i = 0, end; i < line->n; i = end) {
        if (line->v[i].on_path) {
            for (end = i; end < line->n && line->v[end].on_path == line->v[i].on_path; end++)
                ;
            r->report->text += !set_on_path(r, group, line, i, end);
            continue;
        }
        end = end_of_chunk(line, i, line->n);
        for (size_t k = i; k < end; k++)
            if (line->v[k].on_path)
                end = k;
        set_chunk(r, group, line, i, end, &pen, stretch, added);
    }
}

static void rewrite(rewriting *r, xmlNode *text)
{
    static const char *const kept[] = {"transform", "opacity", "clip-path", "mask", "filter", "display"};
    text_line line = {0};
    bool known = plb_text_read(r, text, &line);
    if (line.needs_places && line.n && known && plb_text_measure(r, &line)) {
        xmlNode *group = plb_node_new(text, "g");
        for (size_t i = 0; i < G_N_ELEMENTS(kept); i++) {
            char *value = plb_css_value(r->sheet, text, kept[i]);
            if (value && i == 0)
                plb_node_set(group, kept[i], value);
            else if (value)
                plb_css_set(group, kept[i], value);
            g_free(value);
        }
        xmlAddNextSibling(text, group);
        set_line(r, text, group, &line);
        plb_node_drop(text);
        r->changed = true;
    } else if (line.needs_places && line.n) {
        r->report->text++;
    }
    g_free(line.v);
}

void plb_rewrite_text(rewriting *r)
{
    xmlNode *top = xmlDocGetRootElement(r->doc);
    GPtrArray *texts = g_ptr_array_new();
    for (xmlNode *n = top; n; n = plb_node_next(n, top)) {
        if (plb_node_is(n, "text") && !plb_node_is_definition(n))
            g_ptr_array_add(texts, n);
    }
    for (guint i = 0; i < texts->len; i++)
        rewrite(r, texts->pdata[i]);
    g_ptr_array_free(texts, TRUE);
}
