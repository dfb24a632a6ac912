/* SPDX-License-Identifier: MIT
 *
 * Reads the words and numbers of an SVG document's attributes, with the values that librsvg gives them: numbers of path
 * data are double precision, all others are CSS's and pass through single precision.
 */
#ifndef PLB_TAP_PLAIN_PLAIN_TEXT_H
#define PLB_TAP_PLAIN_PLAIN_TEXT_H

#include <stdbool.h>
#include <stddef.h>

/* A plain_text is at[0..end), borrowed; reading moves `at`. */
typedef struct {
    const char *at, *end;
} plain_text;

bool plb_plain_is(plain_text t, const char *word);
bool plb_plain_is_any(plain_text t, const char *const words[]); /* ... NULL */
plain_text plb_plain_trim(plain_text t);

/* Skips blanks; false: there are none. */
bool plb_plain_blank(plain_text *t);
/* Skips blanks and at most one comma. */
void plb_plain_comma(plain_text *t);

/* Reads a number of path data at once (no blanks before it); false: there is none, or it is not finite. */
bool plb_plain_number(plain_text *t, double *v);
/* Reads a CSS number, which may start with a sign or a point but not end in a point. */
bool plb_plain_css_number(plain_text *t, double *v);

typedef enum { PLAIN_PX, PLAIN_MM, PLAIN_CM, PLAIN_IN, PLAIN_PT, PLAIN_PC, PLAIN_SHARE } plain_unit;

/* Reads a number and its unit, which ends with the text or before a blank or comma. */
bool plb_plain_dimension(plain_text *t, double *v, plain_unit *unit);
/* Reads the whole text as a length in px, with blanks around it and nothing else; no percentage. */
bool plb_plain_length(plain_text t, double *px);
/* Reads a part of the text as a length in px. */
bool plb_plain_next_length(plain_text *t, double *px);

#endif
