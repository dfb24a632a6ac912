/* SPDX-License-Identifier: MIT
 *
 * Counts what the tap leaves out of an SVG document on purpose, where the document would draw it.
 */
#ifndef PLB_TAP_SVG_LOSSES_TAP_OMISSIONS_H
#define PLB_TAP_SVG_LOSSES_TAP_OMISSIONS_H

#include "list/omissions.h"

#include <stddef.h>

/* Counts the omissions in text[0..size), a document that librsvg has read. Images are of whatever kind; masks and
 * filters count on elements that show something else than images; a foreignObject counts where it has no substitute. */
omissions plb_tap_count_omissions(const char *text, size_t size);

#endif
