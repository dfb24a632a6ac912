/* SPDX-License-Identifier: MIT
 *
 * A picture on its way into a file, band by band: PNG, or PDF with the page at its true size. Both hold the same rows,
 * compressed in the same way.
 */
#ifndef PLB_SURFACE_PICTURE_PICTURE_H
#define PLB_SURFACE_PICTURE_PICTURE_H

#include "base/error.h"
#include "surface/page.h"

#include <stdio.h>

typedef enum { PICTURE_PNG, PICTURE_PDF } picture_format;

typedef struct {
    picture_format format;
    page_background background;
    bool colour;
    double dpi, width_mm, height_mm;
    int level;   /* of compression, 0 to 9 */
    int members; /* threads that may compress */
    /* Pairs keyword, text; ends with NULL. What the file says of itself. */
    const char *const *text;
} picture_options;

typedef struct picture picture;

/* The rows of a page's bands must be a multiple of this, except the last band's. */
int plb_picture_rows(int width, const picture_options *o);
/* Begins to write. `name` is for messages; it, `o` and what that points to are borrowed. NULL and `err` on failure. */
picture *plb_picture_new(int width, int height, const picture_options *o, FILE *to, const char *name, error *err);
/* Writes the band at hand: the next rows. */
bool plb_picture_add(picture *p, const page *band, error *err);
/* Writes what is left, after the last band. */
bool plb_picture_end(picture *p, error *err);
/* May be NULL. */
void plb_picture_free(picture *p);

#endif
