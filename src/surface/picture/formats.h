/* SPDX-License-Identifier: MIT
 *
 * Describes a picture in progress, and what a format of files must do; for this folder only.
 */
#ifndef PLB_SURFACE_PICTURE_FORMATS_H
#define PLB_SURFACE_PICTURE_FORMATS_H

#include "surface/picture/picture.h"

struct picture {
    const picture_format *format;
    byte_sink to;
    const char *name;
    bool several;             /* pages */
    unsigned pages;           /* begun so far */
    size_t written;           /* bytes so far */
    const picture_page *page; /* at hand */
    int channels;             /* bytes of its pixels: page.h */
    const page *band;         /* being written */
    void *rows;               /* deflated_rows.c keeps its state here, */
    void *own;                /* and the format its own */
};

/* A row of the table. All functions but `drop` return false with `err` filled; NULL: nothing to do. */
struct picture_format {
    const char *name, *suffixes; /* the suffixes without dots, with blanks between them */
    const char *package;         /* Debian's, without which a build does not write it; NULL: needs none */
    bool built, has_pages, has_paths;
    bool see_through;            /* pixels may have alpha; a format without lays the page over what is below in another way … */
    bool multiplies;             /* … or else refuses a page without background */
    int max_side;                /* pixels; 0: any */
    bool (*begin)(picture *p, error *err);
    bool (*begin_page)(picture *p, error *err);
    bool (*add)(picture *p, error *err); /* p->band */
    bool (*begin_layer)(picture *p, const picture_layer *layer, error *err);
    bool (*add_path)(picture *p, const path *drawn, double width, double opacity, error *err);
    bool (*end_page)(picture *p, error *err);
    bool (*end)(picture *p, error *err);
    void (*drop)(picture *p);    /* frees p->own, also half made */
};

extern const picture_format plb_png_format, plb_pdf_format, plb_svg_format, plb_jpeg_format, plb_webp_format, plb_tiff_format;

/* Gives what lies behind the graphite: the page's own background, or white in formats whose pixels have no alpha. */
page_background plb_picture_background(const picture_format *f, const picture_page *sheet);
/* Writes bytes; false when the sink fails, which errno then tells. */
bool plb_picture_put(picture *p, const void *data, size_t n);
/* Writes a text made as by printf, of up to 1,023 bytes. */
bool plb_picture_print(picture *p, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Fills `err` for a write that failed, as errno tells. Returns false. */
bool plb_picture_fail(const picture *p, error *err);
/* Row y of the page at hand, in its band, as p->channels bytes for each pixel. */
void plb_picture_row(const picture *p, int y, uint8_t *out);
/* The texts of a page as lines "Keyword: text\n"; the caller frees; NULL: out of memory. */
char *plb_picture_lines(const picture_page *page);
/* How a quality from 0 to 100 follows from the level of compression, for formats that lose something. */
int plb_picture_quality(int level);

/* Rows compressed with deflate, as PNG and PDF hold them (deflated_rows.c). `data` writes some of the zlib stream. */
typedef bool (*data_function)(picture *p, const void *data, size_t n);
bool plb_deflated_rows_begin(picture *p, data_function data, error *err);
bool plb_deflated_rows_add(picture *p, error *err);
bool plb_deflated_rows_end(picture *p, error *err);
/* Bytes of the zlib stream so far. */
size_t plb_deflated_rows_size(const picture *p);
void plb_deflated_rows_drop(picture *p);

#endif
