/* SPDX-License-Identifier: MIT
 *
 * The omissions count, by kind, things of a drawing that the pencil does not draw, or draws otherwise. Every reader fills
 * them; nothing is left out silently.
 */
#ifndef PLB_LIST_OMISSIONS_H
#define PLB_LIST_OMISSIONS_H

#include "base/error.h"

#include <stddef.h>

typedef enum {
    OMISSION_IMAGE,      /* raster images and stencils */
    OMISSION_TEXT,       /* strings without outlines at hand */
    OMISSION_PIXEL_TEXT, /* strings in fonts made of pixels */
    OMISSION_FOREIGN,    /* foreignObject */
    OMISSION_FAR,        /* shapes at impossible places */
    OMISSION_MASK,
    OMISSION_FILTER,
    OMISSION_BLEND,
    OMISSION_PATTERN,    /* fills with tiles */
    OMISSION_SHADING,
    OMISSION_INVISIBLE,  /* nobody sees these: no cause for a warning */
    OMISSION_OFF_PAGE,
    OMISSION_KINDS
} omission_kind;

#define OMISSION_ADVICE_MAX 200 /* bytes */

typedef struct {
    unsigned long n[OMISSION_KINDS];
    char advice[OMISSION_ADVICE_MAX]; /* what would help against it; empty: nothing known */
} omissions;

/* Returns the kind's name in the list's text form, plumbago-list(5). */
const char *plb_omission_name(omission_kind kind);
/* Gives the kind that the n bytes name; false when they name none. */
bool plb_omission_find(const char *name, size_t n, omission_kind *kind);
/* Keeps the advice, cut to OMISSION_ADVICE_MAX; NULL is no advice. */
void plb_omissions_advise(omissions *l, const char *advice);

/* Says one warning with all that matters, and a detail for each kind with what became of it. */
void plb_omissions_report(const omissions *l, const char *name, const log_sink *say);

#endif
