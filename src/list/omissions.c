/* SPDX-License-Identifier: MIT
 *
 * This file puts omissions into words: a table of kinds.
 */
#include "list/omissions.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *name, *one, *many, *fate;
    bool matters;
} kinds[OMISSION_KINDS] = {
    [OMISSION_IMAGE] = {"image", "raster image", "raster images", "left out", true},
    [OMISSION_TEXT] = {"text", "text string", "text strings", "left out", true},
    [OMISSION_PIXEL_TEXT] = {"pixel-text", "text string of pixels", "text strings of pixels", "left out: the font has no outlines", true},
    [OMISSION_FOREIGN] = {"foreign", "foreign object", "foreign objects", "left out: no part of SVG", true},
    [OMISSION_FAR] = {"far", "shape at an impossible place", "shapes at impossible places", "left out", true},
    [OMISSION_MASK] = {"mask", "mask", "masks", "left out: what it covers is drawn whole", true},
    [OMISSION_FILTER] = {"filter", "filter", "filters", "left out: what it changes is drawn as it was", true},
    [OMISSION_BLEND] = {"blend", "blend mode", "blend modes", "left out: painted as if there were none", true},
    [OMISSION_PATTERN] = {"pattern", "pattern", "patterns", "left out: an even grey in its place", true},
    [OMISSION_SHADING] = {"shading", "shading", "shadings", "left out: an even grey in its place", true},
    [OMISSION_INVISIBLE] = {"invisible", "invisible shape", "invisible shapes", "left out", false},
    [OMISSION_OFF_PAGE] = {"off-page", "shape off the page", "shapes off the page", "left out", false},
};

const char *plb_omission_name(omission_kind kind)
{
    return kinds[kind].name;
}

bool plb_omission_find(const char *name, size_t n, omission_kind *kind)
{
    for (int k = 0; k < OMISSION_KINDS; k++)
        if (strlen(kinds[k].name) == n && !memcmp(kinds[k].name, name, n)) {
            *kind = (omission_kind)k;
            return true;
        }
    return false;
}

void plb_omissions_advise(omissions *l, const char *advice)
{
    snprintf(l->advice, sizeof l->advice, "%s", advice ? advice : "");
}

void plb_omissions_report(const omissions *l, const char *name, const log_sink *say)
{
    char all[600] = "";
    for (int k = 0; k < OMISSION_KINDS; k++) {
        unsigned long n = l->n[k];
        const char *what = n == 1 ? kinds[k].one : kinds[k].many;
        size_t used = strlen(all);
        if (n && kinds[k].matters)
            snprintf(all + used, sizeof all - used, "%s%lu %s", used ? ", " : "", n, what);
    }
    if (*all)
        plb_log(say, MESSAGE_WARNING, "%s: left out: %s%s%s", name, all, *l->advice ? "; " : "", l->advice);
    for (int k = 0; k < OMISSION_KINDS; k++)
        if (l->n[k])
            plb_log(say, MESSAGE_DETAIL, "%s: %s: %lu, %s", name, kinds[k].many, l->n[k], kinds[k].fate);
}
