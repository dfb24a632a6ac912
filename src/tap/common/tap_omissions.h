/* SPDX-License-Identifier: MIT
 *
 * What of an SVG document the tap leaves out on purpose, counted where it would be drawn.
 */
#ifndef PLB_TAP_COMMON_TAP_OMISSIONS_H
#define PLB_TAP_COMMON_TAP_OMISSIONS_H

#include <stddef.h>

typedef struct {
    unsigned long images;  /* <image>, of whatever kind */
    unsigned long masks;   /* elements that have one, and show something else than images */
    unsigned long filters; /* likewise */
    unsigned long foreign; /* <foreignObject> without a substitute */
} tap_omissions;

/* text[0..size): a document that librsvg has read. */
tap_omissions plb_tap_count_omissions(const char *text, size_t size);

#endif
