/* SPDX-License-Identifier: MIT
 *
 * What a picture in progress is, and what a format of files must do; for this folder only.
 */
#ifndef PLB_SURFACE_PICTURE_PICTURE_FORMATS_H
#define PLB_SURFACE_PICTURE_PICTURE_FORMATS_H

#include "system/thread_team.h"
#include "surface/picture/deflate.h"
#include "surface/picture/picture.h"

/* Pieces that are compressed before they are written. */
#define PICTURE_PIECES 32
/* Objects of a PDF, with the one that is none. */
#define PICTURE_OBJECTS 8

struct picture {
    const picture_options *o;
    int width, height;
    int channels, piece_rows;
    FILE *to;
    const char *name;
    size_t written;    /* bytes so far */
    size_t data_size;  /* of them compressed rows */
    uint32_t checksum; /* Adler-32 of all rows, zlib's */
    byte_buffer piece[PICTURE_PIECES];
    uint32_t piece_sum[PICTURE_PIECES];
    uint8_t *raw[THREAD_TEAM_MAX]; /* a piece's rows, for each member */
    size_t object_at[PICTURE_OBJECTS]; /* of a PDF: where in the file */
    const page *band;       /* being written, from row `first` on */
    int first;
};

/* All return false when out of memory or when writing fails, which errno then tells. */
static inline bool picture_put(picture *p, const void *data, size_t n)
{
    p->written += n;
    return fwrite(data, 1, n, p->to) == n;
}

bool plb_png_head(picture *p);
bool plb_png_data(picture *p, const void *data, size_t n); /* some of the zlib stream */
bool plb_png_tail(picture *p);

bool plb_pdf_head(picture *p);
bool plb_pdf_data(picture *p, const void *data, size_t n);
bool plb_pdf_tail(picture *p);

#endif
