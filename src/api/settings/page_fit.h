/* SPDX-License-Identifier: MIT
 *
 * What the settings of size make of a drawing: its page, its place on it, the pixels of the picture.
 */
#ifndef PLB_API_SETTINGS_PAGE_FIT_H
#define PLB_API_SETTINGS_PAGE_FIT_H

#include "api/settings/settings.h"

typedef struct {
    double width, height; /* of the page, mm */
    double factor;        /* by which the drawing grows */
    double x0, y0;        /* where its top left corner comes to lie, mm */
} page_fit;

/* The place of a drawing of `width` by `height` mm whose thing is drawn at `paper_scale` (display_list.h). False and `err` when no
 * page comes of the settings. */
bool plb_page_fit(const plb_options *o, double width, double height, double paper_scale, page_fit *out, error *err);

/* Pixels per inch of a picture of a page of `width` by `height` mm; false and `err` when they are too few or too many. */
bool plb_page_dpi(const plb_options *o, double width, double height, double *dpi, error *err);

#endif
