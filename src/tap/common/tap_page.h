/* SPDX-License-Identifier: MIT
 *
 * Gives the page of a drawing, and how the page lies on the surface that is written down: magnified, turned (tap_svg.c
 * says why), moved right so that all coordinates are positive. Both taps for SVG place their drawing by this file.
 */
#ifndef PLB_TAP_COMMON_TAP_PAGE_H
#define PLB_TAP_COMMON_TAP_PAGE_H

#include "base/geometry/geom.h"

#include <stdbool.h>
#include <stddef.h>

#define TAP_TURN_DEGREES 19.3717       /* no drawing is likely to hold this angle */
#define TAP_MM_PER_PX (25.4 / 96)      /* CSS Values 3, section 6.2 */
#define TAP_PX_MAX (100e3 / TAP_MM_PER_PX) /* 100 m */
#define TAP_LIBXML_TEXT ((size_t)10000000) /* libxml2 refuses longer attributes unless told otherwise */

typedef struct {
    double width, height; /* px */
    double x, y;          /* px: the page's corner, when the size is that of the drawn parts */
    double units;         /* of the script surface, on the longer side */
    bool by_extents;
} tap_page;

/* A tap_extent is a width or height as the document says it: px, or (is_share) a part of the viewBox's. */
typedef struct {
    double value;
    bool is_share;
} tap_extent;

typedef struct {
    matrix turn; /* page units (px times scale) to the surface */
    double scale;
    double width, height; /* of the turned page */
    double fit;           /* librsvg's viewport holds the turned page: it is so much larger than the page */
} tap_placing;

/* Gives a page without a size. */
tap_page plb_tap_page(void);

/* Finds the page's size from width, height and the size of the viewBox (NULL: none). False: only what is drawn can tell. */
bool plb_tap_page_size(tap_page *p, tap_extent w, tap_extent h, const double *view);

/* Tells whether the page is neither empty nor too large. */
bool plb_tap_page_is_there(const tap_page *p);
bool plb_tap_page_is_fit(const tap_page *p);

tap_placing plb_tap_place(const tap_page *p);

/* Gives the page on paper, mm, and the map from the script surface to the page. */
typedef struct {
    double width, height;
    matrix to_page;
} tap_sheet;
tap_sheet plb_tap_sheet(const tap_page *p);

#endif
