/* SPDX-License-Identifier: MIT
 *
 * Rewrites strokes: widths that do not scale with the drawing (SVG 2, vector-effect), and dashes in units of pathLength
 * (SVG 2, section 9.6).
 */
#include "tap/svg/rewrite/document/outline.h"
#include "tap/svg/rewrite/steps.h"

#include <math.h>
#include <string.h>

/* Multiplies each number of a list by `factor`; percentages and words stay. */
static char *scaled_list(const char *text, double factor)
{
    GString *out = g_string_new(NULL);
    char **words = g_strsplit_set(text, " ,\t\r\n", 0);
    for (char **w = words; *w; w++) {
        char *end, number[G_ASCII_DTOSTR_BUF_SIZE];
        double v = g_ascii_strtod(*w, &end);
        if (!**w)
            continue;
        if (out->len)
            g_string_append_c(out, ' ');
        bool is_plain = end > *w && (!*end || !strcmp(end, "px"));
        g_string_append(out, is_plain ? g_ascii_dtostr(number, sizeof number, v * factor) : *w);
    }
    g_strfreev(words);
    return g_string_free(out, FALSE);
}

/* Multiplies an inherited property of the element itself; `otherwise` where nobody says anything. */
static void scale_property(rewriting *r, xmlNode *n, const char *property, const char *otherwise, double factor)
{
    char *text = plb_css_inherited(r->sheet, n, property);
    if ((text || otherwise) && !(text && !strcmp(text, "none"))) {
        char *scaled = scaled_list(text ? text : otherwise, factor);
        plb_css_set(n, property, scaled);
        g_free(scaled);
    }
    g_free(text);
}

/* Makes the pen narrower by as much as the user space grows, so that the pen has its width on the page. */
static void keep_width(rewriting *r, xmlNode *n)
{
    double grows = plb_matrix_expansion(plb_outline_to_root(n, true));
    r->changed = true;
    plb_css_set(n, "vector-effect", NULL);
    if (!(grows > 0) || !isfinite(grows))
        return;
    scale_property(r, n, "stroke-width", "1", 1 / grows);
    scale_property(r, n, "stroke-dasharray", NULL, 1 / grows);
    scale_property(r, n, "stroke-dashoffset", NULL, 1 / grows);
}

static void scale_dashes(rewriting *r, xmlNode *n)
{
    path p = plb_outline(n);
    double said = plb_node_length(n, "pathLength", 0, 0), length = plb_outline_length(&p);
    plb_path_free(&p);
    r->changed = true;
    plb_node_remove(n, "pathLength");
    if (!(said > 0 && length > 0))
        return;
    scale_property(r, n, "stroke-dasharray", NULL, length / said);
    scale_property(r, n, "stroke-dashoffset", NULL, length / said);
}

void plb_rewrite_strokes(rewriting *r)
{
    xmlNode *top = xmlDocGetRootElement(r->doc);
    for (xmlNode *n = top; n; n = plb_node_next(n, top)) {
        if (!plb_node_is_shape(n))
            continue;
        char *length = plb_node_get(n, "pathLength"), *effect = plb_css_value(r->sheet, n, "vector-effect");
        if (length)
            scale_dashes(r, n);
        if (effect && strstr(effect, "non-scaling-stroke"))
            keep_width(r, n);
        g_free(length);
        g_free(effect);
    }
}
