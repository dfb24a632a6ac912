/* SPDX-License-Identifier: MIT
 *
 * Tells what the comments of a PostScript file say about its page: the Document Structuring Conventions (Adobe, version
 * 3.0, 1992) and the binary header of DOS EPS files.
 */
#ifndef PLB_TAP_PS_PS_DSC_H
#define PLB_TAP_PS_PS_DSC_H

#include "base/geometry/geom.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    bool is_eps;
    bool has_box;   /* a BoundingBox of four numbers was there */
    bool box_sane;  /* … and is one a page can have */
    box box;        /* points; the HiResBoundingBox where it agrees */
    bool has_media;
    double media_width, media_height; /* points */
    int pages;      /* 0: not said */
} ps_dsc;

void plb_dsc_read(const char *program, size_t length, double largest, ps_dsc *out);

#endif
