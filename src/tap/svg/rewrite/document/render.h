/* SPDX-License-Identifier: MIT
 *
 * Asks librsvg itself how a part of the document looks on the average, and how wide text is set.
 */
#ifndef PLB_TAP_SVG_REWRITE_DOCUMENT_RENDER_H
#define PLB_TAP_SVG_REWRITE_DOCUMENT_RENDER_H

#include "tap/svg/rewrite/steps.h"

/* Gives the mean of what the children of `content` paint within `view`, a part of its user space: red, green, blue (not
 * premultiplied) and alpha, each 0 to 1. False: nothing could be rendered, or librsvg was asked too often. */
bool plb_render_mean(rewriting *r, const xmlNode *content, box view, double mean[4]);

/* Gives the outline of where what the children of `content` paint is strong enough, as path data in their user space, within `view`; NULL:
 * nowhere, or as above. Strength is alpha times the luminance (`by_alpha`: alpha alone), and at least `least`; *mean gets its mean inside
 * the outline. `is_alone`: the content needs nothing of the document's definitions. The caller frees the result with g_free. */
char *plb_render_outline(rewriting *r, const xmlNode *content, box view, bool is_alone, bool by_alpha, double least, double *mean);

/* Gives the mean of one element with what it inherits, where it is opaque without its filter: without its filter, and
 * with it. False as above, or where the element is nowhere opaque. */
bool plb_render_filtered(rewriting *r, const xmlNode *n, box view, double without[4], double with[4]);

/* Gives the ends of the characters of `text` (UTF-8, `n` characters) along the line, set like the text element `like`:
 * `ends` gets n values in px of the user space. False: the text could not be set. */
bool plb_render_advances(rewriting *r, const xmlNode *like, const char *text, size_t n, double *ends);

#endif
