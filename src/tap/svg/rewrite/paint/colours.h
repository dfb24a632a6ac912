/* SPDX-License-Identifier: MIT
 *
 * Replaces colours that are newer than librsvg 2.54 (CSS colour modules 4 and 5): oklch, oklab, lch, lab, hwb, color(), color-mix
 * and light-dark become rgba().
 */
#ifndef PLB_TAP_SVG_REWRITE_PAINT_COLOURS_H
#define PLB_TAP_SVG_REWRITE_PAINT_COLOURS_H

#include <glib.h>
#include <stdbool.h>

/* Tells whether a text holds such a colour. */
bool plb_colour_is_new(const char *text);
/* Replaces each such colour of the text; one that cannot be read stays. The caller frees the result with g_free. */
char *plb_colour_replace(const char *text);

#endif
