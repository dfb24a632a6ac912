/* SPDX-License-Identifier: MIT
 *
 * Losses in words: a table of kinds.
 */
#include "list/losses.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *one, *many, *fate;
    bool matters;
} kinds[LOSS_KINDS] = {
    [LOSS_IMAGE] = {"raster image", "raster images", "left out", true},
    [LOSS_TEXT] = {"text string", "text strings", "left out", true},
    [LOSS_PIXEL_TEXT] = {"text string of pixels", "text strings of pixels", "left out: the font has no outlines", true},
    [LOSS_FOREIGN] = {"foreign object", "foreign objects", "left out: no part of SVG", true},
    [LOSS_FAR] = {"shape at an impossible place", "shapes at impossible places", "left out", true},
    [LOSS_MASK] = {"mask", "masks", "left out: what it covers is drawn whole", true},
    [LOSS_FILTER] = {"filter", "filters", "left out: what it changes is drawn as it was", true},
    [LOSS_BLEND] = {"blend mode", "blend modes", "left out: painted as if there were none", true},
    [LOSS_PATTERN] = {"pattern", "patterns", "left out: an even grey in its place", true},
    [LOSS_SHADING] = {"shading", "shadings", "left out: an even grey in its place", true},
    [LOSS_INVISIBLE] = {"invisible shape", "invisible shapes", "left out", false},
    [LOSS_OFF_PAGE] = {"shape off the page", "shapes off the page", "left out", false},
};

void plb_losses_report(const losses *l, const char *name, const messenger *say)
{
    char all[600] = "";
    for (int k = 0; k < LOSS_KINDS; k++) {
        unsigned long n = l->n[k];
        const char *what = n == 1 ? kinds[k].one : kinds[k].many;
        size_t used = strlen(all);
        if (n && kinds[k].matters)
            snprintf(all + used, sizeof all - used, "%s%lu %s", used ? ", " : "", n, what);
    }
    if (*all)
        plb_say(say, MESSAGE_WARNING, "%s: left out: %s%s%s", name, all, l->advice ? "; " : "", l->advice ? l->advice : "");
    for (int k = 0; k < LOSS_KINDS; k++)
        if (l->n[k])
            plb_say(say, MESSAGE_DETAIL, "%s: %s: %lu, %s", name, kinds[k].many, l->n[k], kinds[k].fate);
}
