/* SPDX-License-Identifier: MIT
 *
 * The CairoScript that cairo's script surface would write for paths that are filled and stroked, kept in memory until it
 * is whole. cairo leaves out what a context has already; so does this, and the same numbers have the same digits.
 */
#ifndef PLB_TAP_PLAIN_PLAIN_SCRIPT_H
#define PLB_TAP_PLAIN_PLAIN_SCRIPT_H

#include "tap/plain/plain_digits.h"
#include "tap/plain/plain_path.h"
#include "tap/plain/plain_style.h"

typedef struct plain_block plain_block; /* of text */

/* What the context has by now. */
typedef struct {
    plain_paint source;
    bool even_odd;
    bool is_turned;        /* its matrix is not the identity */
    tap_matrix pen_matrix; /* of the last line */
    plain_pen pen;
} plain_context;

typedef struct {
    plain_path path;           /* to be made, then drawn */
    plain_path written;        /* the context's */
    plain_context now;
    plain_digits digits;
    plain_block *first, *last;
    size_t size;               /* bytes in all blocks */
    double width, height;      /* of the surface */
    tap_matrix matrix;         /* that matrix_text is the text of */
    char matrix_text[4 * PLAIN_DIGITS_MAX + 40];
    bool is_begun;             /* the surface is there */
    bool failed;
} plain_script;

/* Starts with the head line of the page. */
void plb_plain_script_begin(plain_script *s, const tap_page *p);
/* Fills and strokes s->path as the style says. False: beyond limits, or something that cairo has ways of its own with. */
bool plb_plain_draw(plain_script *s, const plain_style *style);
bool plb_plain_script_end(plain_script *s);
void plb_plain_script_free(plain_script *s);

/* All of the script, piece by piece, to `put`. */
void plb_plain_script_write(const plain_script *s, void (*put)(const char *text, size_t size));

#endif
