/* SPDX-License-Identifier: MIT
 *
 * Losses in words: a table of kinds.
 */
#include "list/omissions.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *one, *many, *fate;
    bool matters;
} kinds[OMISSION_KINDS] = {
    [OMISSION_IMAGE] = {"raster image", "raster images", "left out", true},
    [OMISSION_TEXT] = {"text string", "text strings", "left out", true},
    [OMISSION_PIXEL_TEXT] = {"text string of pixels", "text strings of pixels", "left out: the font has no outlines", true},
    [OMISSION_FOREIGN] = {"foreign object", "foreign objects", "left out: no part of SVG", true},
    [OMISSION_FAR] = {"shape at an impossible place", "shapes at impossible places", "left out", true},
    [OMISSION_MASK] = {"mask", "masks", "left out: what it covers is drawn whole", true},
    [OMISSION_FILTER] = {"filter", "filters", "left out: what it changes is drawn as it was", true},
    [OMISSION_BLEND] = {"blend mode", "blend modes", "left out: painted as if there were none", true},
    [OMISSION_PATTERN] = {"pattern", "patterns", "left out: an even grey in its place", true},
    [OMISSION_SHADING] = {"shading", "shadings", "left out: an even grey in its place", true},
    [OMISSION_INVISIBLE] = {"invisible shape", "invisible shapes", "left out", false},
    [OMISSION_OFF_PAGE] = {"shape off the page", "shapes off the page", "left out", false},
};

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
        plb_log(say, MESSAGE_WARNING, "%s: left out: %s%s%s", name, all, l->advice ? "; " : "", l->advice ? l->advice : "");
    for (int k = 0; k < OMISSION_KINDS; k++)
        if (l->n[k])
            plb_log(say, MESSAGE_DETAIL, "%s: %s: %lu, %s", name, kinds[k].many, l->n[k], kinds[k].fate);
}
