/* SPDX-License-Identifier: MIT
 *
 * The page is graphite on paper. Strokes that cross add up as optical densities do and saturate at the darkest grey the
 * pencil has; nothing ever gets lighter. Deposits are whole numbers, so the sum is the same in any order, and several
 * threads may lay patches at once. Only a band of the page, some whole rows, is in memory at a time.
 */
#ifndef PLB_SURFACE_PAGE_H
#define PLB_SURFACE_PAGE_H

#include "base/error.h"
#include "base/patch.h"
#include "profile/profile.h"
#include "surface/ground.h"

#include <cairo.h>
#include <pthread.h>
#include <stddef.h>
#include <stdint.h>

/* A graphite turns greys into deposits and back, in the same way for all that one pencil draws. */
typedef struct {
    int darkest;           /* the grey that overlaid strokes come to */
    uint16_t deposit[256]; /* of a grey */
    uint8_t grey[65536];   /* of a deposit; grey[deposit[g]] == g for all g above darkest */
} graphite;

void plb_graphite_init(graphite *g, const profile *p);

/* A pigment is a coloured pencil: the deposits that a grey of the texture leaves in red, green and blue. Each layer takes
 * light away, so yellow over blue is green. */
#define PIGMENT_PLANES 3
typedef struct {
    uint32_t colour; /* 0xRRGGBB; 0: graphite */
    bool is_soft;    /* the page's other graphite */
    uint16_t deposit[PIGMENT_PLANES][256];
} pigment;

/* The share of the light that a grey of the texture takes of what a full cover takes: 0 to 1. */
double plb_pigment_cover(const graphite *g, uint32_t colour, int grey);
void plb_pigment_init(pigment *p, const graphite *g, uint32_t colour);

/* Columns [from, to) of a row may hold graphite, others hold none. */
typedef struct {
    int from, to;
} row_extent;

/* So many deposits lie behind each row, so that loops may work on it in whole registers. */
#define PAGE_ROW_PAD 8

typedef struct {
    int width, height;   /* of the whole page, pixels */
    int top, rows;       /* the band in memory: rows [top, top + rows) */
    int most_rows;       /* that a band can have */
    int planes;          /* 1: grey, 2: grey of two pencils, 3: red, green, blue */
    size_t stride, plane; /* of a row, and of all rows of a plane */
    uint16_t *deposit;   /* plane by plane, row by row; those of the pad stay 0 */
    row_extent *marked;  /* of each row */
    pthread_mutex_t *lock; /* of each stripe of rows */
    int locks;
    const ground *sheet; /* borrowed; NULL: white */
    double pixel;        /* mm; where there is a sheet */
    const graphite *ink, *soft; /* borrowed; soft: the other pencil's, NULL where there is none */
} page;

/* A page may have so many pixels at the most: A0 at 3600 dpi fits. */
#define PAGE_MAX_PIXELS ((double)20e9)

/* Gives the whole pixels of a page of so many; false and `err` when the page is too large. */
bool plb_page_size(double width_px, double height_px, int *width, int *height, error *err);
/* Makes a page, grey or in colour, with a first blank band of at most `rows`. `soft` is the graphite of a second pencil, for grey pages, or NULL. False and `err` when out of memory; the caller frees
 * the page then, too. */
bool plb_page_init(page *p, int width, int height, int rows, bool colour, const graphite *ink, const graphite *soft, error *err);
void plb_page_free(page *p);
/* Returns the deposits of row y of the page, which lies in the band. */
static inline uint16_t *plb_page_deposits(const page *p, int plane, int y)
{
    return p->deposit + (size_t)plane * p->plane + (size_t)(y - p->top) * p->stride;
}
/* Begins at row `top` instead of the first one. */
void plb_page_start_at(page *p, int top);
/* On to the band below, blank; false at the foot of the page. */
bool plb_page_next_band(page *p);
/* Lays a patch of the pigment, on a grey page of graphite; what lies outside the band is lost. May be called by several
 * threads. */
void plb_page_lay(page *p, const patch *from, const pigment *with);

/* White, nothing, or the page's sheet. */
typedef enum { PAGE_WHITE, PAGE_TRANSPARENT, PAGE_PAPER } page_background;

/* Returns the number of bytes of a pixel in pictures with this background: grey or red, green and blue; and alpha. */
int plb_page_channels(page_background background, bool colour);
/* Gives row y of the page, which lies in the band, as such bytes. Graphite on nothing is of one grey, the darkest, more or less opaque: over
 * white the row looks as the opaque page does. Colours are as opaque as their strongest component needs. */
void plb_page_row(const page *p, page_background background, int y, uint8_t *out);

/* Returns a cairo image surface, ARGB32, for the page. The caller destroys it. NULL and `err` when cairo makes none so large. */
cairo_surface_t *plb_page_surface_new(int width, int height, error *err);
/* Copies the band in memory to its place on the surface. False when out of memory. */
bool plb_page_to_cairo(const page *p, page_background background, cairo_surface_t *to);
/* Lays a patch straight onto a cairo image surface of format ARGB32, RGB24 or A8, darkening it. */
void plb_lay_on_cairo(cairo_surface_t *surface, const graphite *ink, const patch *from);

#endif
