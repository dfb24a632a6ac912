/* SPDX-License-Identifier: MIT
 *
 * A picture on its way into a file, band by band. Formats are rows of one table (picture.c), each with a file of its own.
 */
#ifndef PLB_SURFACE_PICTURE_PICTURE_H
#define PLB_SURFACE_PICTURE_PICTURE_H

#include "base/byte_sink.h"
#include "base/error.h"
#include "base/geometry/path.h"
#include "surface/page.h"

typedef struct picture_format picture_format; /* see formats.h */

/* The formats in the table's order; NULL past the last one. The first one is the usual. */
const picture_format *plb_picture_format_at(size_t index);
/* The format of that name, "png"; NULL: there is none. */
const picture_format *plb_picture_format_named(const char *name);
/* The format that a file's suffix asks for, in upper or lower case; the usual one where the name has no suffix; NULL and `err`
 * where no format has such a suffix. */
const picture_format *plb_picture_format_of(const char *file, error *err);
/* Whether a file of the format may have that name: one that promises another format is refused, one without suffix is not. */
bool plb_picture_format_suits(const picture_format *f, const char *file, error *err);
const char *plb_picture_format_name(const picture_format *f);
/* Its suffixes without the dot, as "jpg jpeg". */
const char *plb_picture_format_suffixes(const picture_format *f);
/* Whether its files may hold several pages; whether they hold paths instead of pixels; whether this build writes them. */
bool plb_picture_format_has_pages(const picture_format *f);
bool plb_picture_format_has_paths(const picture_format *f);
bool plb_picture_format_is_built(const picture_format *f);

/* One page of the file. */
typedef struct {
    int width, height; /* pixels; of no account for formats of paths */
    page_background background;
    bool colour;
    double dpi, width_mm, height_mm;
    int level;   /* of compression, 0 to 9 */
    int members; /* threads that may compress */
    /* Pairs keyword, text; ends with NULL. What the file says of itself; the first page's. */
    const char *const *text;
} picture_page;

typedef struct picture picture;

/* The rows of a page's bands must be a multiple of this, except the last band's. */
int plb_picture_rows(const picture_format *f, const picture_page *sheet);
/* Begins a file. `name` is for messages; it and the sink are borrowed. `several`: more pages than one may follow. NULL and `err`
 * when out of memory, or when this build does not write the format. */
picture *plb_picture_new(const picture_format *f, const byte_sink *to, const char *name, bool several, error *err);
/* Begins a page; `sheet` and what that points to are borrowed until its end. */
bool plb_picture_begin_page(picture *p, const picture_page *sheet, error *err);
/* Writes the band at hand: the next rows. */
bool plb_picture_add(picture *p, const page *band, error *err);
bool plb_picture_end_page(picture *p, error *err);
/* Writes what is left, after the last page. */
bool plb_picture_end(picture *p, error *err);
/* May be NULL. */
void plb_picture_free(picture *p);

/* Formats of paths get, between a page's begin and end, layers and their paths instead of bands. */
typedef struct {
    const char *label;
    uint32_t colour; /* 0xRRGGBB, of all its paths */
    double width;    /* of its paths, mm, but for those that say another */
} picture_layer;
bool plb_picture_begin_layer(picture *p, const picture_layer *layer, error *err);
/* A path of lines and curves, `width` mm wide, of an opacity from 0 to 1. */
bool plb_picture_add_path(picture *p, const path *drawn, double width, double opacity, error *err);

#endif
