/* SPDX-License-Identifier: MIT
 *
 * Describes a text element character by character: where each comes from, what its attributes say of its place, how
 * wide it is. text_read.c fills the description, text.c places the characters.
 */
#ifndef PLB_TAP_SVG_REWRITE_TEXT_TEXT_H
#define PLB_TAP_SVG_REWRITE_TEXT_TEXT_H

#include "tap/svg/rewrite/steps.h"

typedef struct {
    char utf8[8];          /* one character, ended by NUL */
    xmlNode *source;       /* the element whose text it is */
    xmlNode *on_path;      /* the textPath around it; NULL: none */
    double x, y;           /* px, where the document says so; NAN: it goes on from the one before */
    double dx, dy, rotate; /* px, degrees */
    double advance;        /* px */
} text_character;

typedef struct {
    text_character *v;
    size_t n;
    bool needs_places; /* librsvg would not place the characters as the attributes say */
} text_line;

#define TEXT_MAX_CHARACTERS 5000

/* Reads a text element; blanks run together unless they are to be preserved. The caller frees `line->v` with g_free. False:
 * it is longer than TEXT_MAX_CHARACTERS, or written from right to left. */
bool plb_text_read(rewriting *r, xmlNode *text, text_line *line);
/* Measures all advances. False: librsvg could not tell. */
bool plb_text_measure(rewriting *r, text_line *line);

#endif
