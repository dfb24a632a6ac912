/* SPDX-License-Identifier: MIT
 *
 * Characters that no font at hand can draw: Pango would letter them as boxes with their numbers.
 */
#ifndef PLB_TAP_SVG_LOSSES_MISSING_GLYPHS_H
#define PLB_TAP_SVG_LOSSES_MISSING_GLYPHS_H

#include <stddef.h>

/* Gives a sentence for the user about the characters of the document's text that no font has; NULL: there are none. The caller frees the
 * sentence with g_free. */
char *plb_tap_missing_glyphs(const char *text, size_t size);

#endif
