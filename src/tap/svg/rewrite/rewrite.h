/* SPDX-License-Identifier: MIT
 *
 * Rewrites an SVG document that uses what librsvg 2.54 does not know, or would draw as pixels, into one that it draws
 * right as lines and fills. What cannot be rewritten is counted.
 */
#ifndef PLB_TAP_SVG_REWRITE_REWRITE_H
#define PLB_TAP_SVG_REWRITE_REWRITE_H

#include <glib.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct {
    unsigned long text;     /* pieces of text that are set in another way than they should be */
    char *style_sheet;      /* the name of a style sheet in a file of its own, which is not read; NULL: none */
} rewrite_report;

/* Tells whether the document, as text, holds anything for the steps: a search for words. */
bool plb_rewrite_is_due(const char *text, size_t size);
/* Gives the rewritten document; NULL where there was nothing to rewrite, or the document is not well-formed (librsvg says so better). */
GByteArray *plb_rewrite(const char *text, size_t size, rewrite_report *report);

#endif
