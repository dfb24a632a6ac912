/* SPDX-License-Identifier: MIT
 *
 * What of an SVG document the tap leaves out on purpose, counted where it would be drawn.
 */
#ifndef PLB_TAP_TAP_LOSSES_H
#define PLB_TAP_TAP_LOSSES_H

#include <stddef.h>

typedef struct {
    unsigned long images;  /* <image>, of whatever kind */
    unsigned long masks;   /* elements that have one, and show something else than images */
    unsigned long filters; /* likewise */
    unsigned long foreign; /* <foreignObject> without a substitute */
} tap_losses;

/* text[0..size): a document that librsvg has read. */
tap_losses plb_tap_count_losses(const char *text, size_t size);

#endif
