/* SPDX-License-Identifier: MIT
 *
 * The colours that all SVG documents know: the names of SVG 1.1 (section 4.4), #rgb, #rrggbb, rgb(r, g, b) of whole numbers.
 */
#ifndef PLB_TAP_COMMON_TAP_COLOUR_H
#define PLB_TAP_COMMON_TAP_COLOUR_H

#include <stdbool.h>

/* Reads the colour that the text at[0..end) consists of, with nothing around it; `rgb` is 0xRRGGBB. False: the text is none. */
bool plb_tap_colour(const char *at, const char *end, unsigned *rgb);

#endif
