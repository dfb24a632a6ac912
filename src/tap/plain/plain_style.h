/* SPDX-License-Identifier: MIT
 *
 * Reads the properties of plain SVG: colours, pens, dashes; and transforms.
 */
#ifndef PLB_TAP_PLAIN_PLAIN_STYLE_H
#define PLB_TAP_PLAIN_PLAIN_STYLE_H

#include "tap/plain/plain_text.h"
#include "tap/common/tap_page.h"

#include <stdbool.h>

#define PLAIN_DASHES 32 /* most in a pattern */

typedef struct {
    bool is_none, is_current; /* is_current: the property "color" says it */
    unsigned char red, green, blue;
    unsigned char alpha; /* of what is drawn, from 255, opaque */
} plain_paint;

typedef enum { PLAIN_BUTT, PLAIN_ROUND, PLAIN_SQUARE } plain_cap;
typedef enum { PLAIN_MITER, PLAIN_ROUNDED, PLAIN_BEVEL } plain_join;

/* The pen, in user units. */
typedef struct {
    double width, miter_limit;
    plain_cap cap;
    plain_join join;
    double dashes[PLAIN_DASHES], dash_offset;
    int n_dashes; /* 0: a whole line */
} plain_pen;

typedef struct {
    plain_paint fill, stroke, colour;
    double fill_opacity, stroke_opacity;
    plain_pen pen;
    bool even_odd;
    bool is_hidden; /* by visibility */
    bool is_gone;   /* by display: with all that is in it; not inherited */
} plain_style;

/* Gives the style of the root: black and without a line. */
plain_style plb_plain_style(void);

/* Sets one property or presentation attribute; those without effect on plain drawings are passed over. False: not
 * plain, because the value is not well-formed, or has more effect than a plain reader knows. */
bool plb_plain_property(plain_style *s, plain_text name, plain_text value);
/* Sets what a style attribute says. */
bool plb_plain_declarations(plain_style *s, plain_text style);

/* Gives the paint: the colour and how much it covers. */
plain_paint plb_plain_fill(const plain_style *s);
plain_paint plb_plain_stroke(const plain_style *s);

/* A transform attribute: from the element's units to its parent's; can be inverted. */
bool plb_plain_transform(plain_text t, matrix *m);

/* Turns degrees into radians in librsvg's way. */
double plb_plain_radians(double degrees);

#endif
