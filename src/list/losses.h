/* SPDX-License-Identifier: MIT
 *
 * What a drawing holds and the pencil does not draw, or not as it is: how often each kind was met. Every reader fills
 * it; nothing is left out silently.
 */
#ifndef PLB_LIST_LOSSES_H
#define PLB_LIST_LOSSES_H

#include "base/error.h"

typedef enum {
    LOSS_IMAGE,      /* raster images and stencils */
    LOSS_TEXT,       /* strings without outlines at hand */
    LOSS_PIXEL_TEXT, /* strings in fonts made of pixels */
    LOSS_FOREIGN,    /* foreignObject */
    LOSS_FAR,        /* shapes at impossible places */
    LOSS_MASK,
    LOSS_FILTER,
    LOSS_BLEND,
    LOSS_PATTERN,    /* fills with tiles */
    LOSS_SHADING,
    LOSS_INVISIBLE,  /* nobody sees these: no cause for a warning */
    LOSS_OFF_PAGE,
    LOSS_KINDS
} loss_kind;

typedef struct {
    unsigned long n[LOSS_KINDS];
    const char *advice; /* what would help against it, lives forever; NULL: nothing known */
} losses;

/* One warning with all that matters, and a detail for each kind with what became of it. */
void plb_losses_report(const losses *l, const char *name, const messenger *say);

#endif
