/* SPDX-License-Identifier: MIT
 *
 * Replaces filters: an element whose filter changes its colour gets the colour and opacity that it has, on the average,
 * when it is rendered. A filter that leaves the element itself unchanged, like a shadow, is left out.
 */
#include "tap/svg/rewrite/document/outline.h"
#include "tap/svg/rewrite/document/render.h"
#include "tap/svg/rewrite/steps.h"

#include <math.h>
#include <string.h>

#define SAME 0.06     /* colours that differ by less in each channel are the same; chosen by eye */
#define FAINTEST 0.02 /* an opacity below this leaves no mark; chosen by eye */

static bool is_same(const double a[4], const double b[4])
{
    for (int k = 0; k < 4; k++)
        if (fabs(a[k] - b[k]) > SAME)
            return false;
    return true;
}

/* Gives all paints of an element and its contents one colour. */
static void repaint(rewriting *r, xmlNode *top, const double colour[4])
{
    static const char *const paints[] = {"fill", "stroke"};
    char *text = g_strdup_printf("rgb(%d,%d,%d)", (int)lround(255 * colour[0]), (int)lround(255 * colour[1]), (int)lround(255 * colour[2]));
    for (xmlNode *n = top; n; n = plb_node_next(n, top))
        for (size_t i = 0; i < G_N_ELEMENTS(paints); i++) {
            char *said = n == top ? plb_css_inherited(r->sheet, n, paints[i]) : plb_css_value(r->sheet, n, paints[i]);
            bool is_painted = said ? strcmp(said, "none") != 0 : n == top && i == 0;
            if (is_painted)
                plb_css_set(n, paints[i], text);
            g_free(said);
        }
    g_free(text);
}

static void rewrite(rewriting *r, xmlNode *n)
{
    double before[4], after[4];
    char number[G_ASCII_DTOSTR_BUF_SIZE];
    box view = plb_outline_box(n);
    if (plb_box_is_empty(view) || !plb_render_filtered(r, n, view, before, after) || is_same(before, after))
        return;
    r->changed = true;
    bool other_colour = after[3] > FAINTEST;
    for (int k = 0; k < 3 && other_colour; k++)
        other_colour = fabs(before[k] - after[k]) > SAME;
    if (other_colour)
        repaint(r, n, after);
    double share = before[3] > 0 ? after[3] / before[3] : 1;
    xmlNode *group = plb_rewrite_wrap(r, n, true);
    plb_css_set(group, "filter", "none");
    if (after[3] < FAINTEST)
        plb_css_set(group, "display", "none");
    else if (share < 1)
        plb_css_set(plb_node_wrap(n), "opacity", g_ascii_formatd(number, sizeof number, "%.4f", share));
}

void plb_rewrite_filters(rewriting *r)
{
    xmlNode *top = xmlDocGetRootElement(r->doc);
    for (xmlNode *n = top, *next; n; n = next) {
        next = plb_node_next(n, top);
        char *filter = plb_css_value(r->sheet, n, "filter");
        if (filter && *filter && strcmp(filter, "none") != 0 && n != top)
            rewrite(r, n);
        g_free(filter);
    }
}
