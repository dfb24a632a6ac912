/* SPDX-License-Identifier: MIT
 *
 * The page: graphite on paper. Strokes that cross add up as optical densities do and saturate at the darkest grey the
 * pencil has; nothing ever gets lighter. Deposits are whole numbers, so the sum is the same in any order.
 */
#ifndef PLB_SURFACE_PAGE_H
#define PLB_SURFACE_PAGE_H

#include "base/error.h"
#include "base/patch.h"
#include "profile/profile.h"

#include <cairo.h>
#include <stdint.h>
#include <stdio.h>

/* How grey becomes deposit and back: fixed for one pencil. */
typedef struct {
    int darkest;           /* the grey that overlaid strokes come to */
    uint16_t deposit[256]; /* of a grey */
    uint8_t grey[65536];   /* of a deposit; grey[deposit[g]] == g for all g above darkest */
} graphite;

void plb_graphite_init(graphite *g, const profile *p);

typedef struct {
    int width, height;   /* pixels */
    uint16_t *deposit;   /* row by row */
    bool *touched;       /* per row: whether anything was laid there */
    const graphite *ink; /* borrowed */
} page;

/* The most pixels a page may have (two bytes each): A0 at 600 dpi fits. */
#define PAGE_MAX_PIXELS ((double)600e6)

/* False and `err` when too large or out of memory. */
bool plb_page_init(page *p, double width_px, double height_px, const graphite *ink, error *err);
void plb_page_free(page *p);
/* Lays a patch; what lies outside the page is lost. */
void plb_page_lay(page *p, const patch *from);

typedef enum { PAGE_WHITE, PAGE_TRANSPARENT } page_background;
typedef struct {
    page_background background;
    double dpi;
    /* Pairs keyword, text; ends with NULL. For the PNG's text chunks. */
    const char *const *text;
} png_options;

/* As 8-bit grey PNG, with alpha when the background is transparent (page_png.c). `name` is for messages. */
bool plb_page_write_png(const page *p, const png_options *o, FILE *to, const char *name, error *err);
/* As a new cairo image surface, ARGB32 (page_cairo.c). The caller destroys it. */
cairo_surface_t *plb_page_to_cairo(const page *p, page_background background, error *err);
/* Lays a patch straight onto a cairo image surface, darkening it. */
bool plb_lay_on_cairo(cairo_surface_t *surface, const graphite *ink, const patch *from);

#endif
