/* SPDX-License-Identifier: MIT
 *
 * Turns the settings of size into the page of a drawing, its place there, and the pixels of the picture.
 */
#ifndef PLB_API_SETTINGS_PAGE_FIT_H
#define PLB_API_SETTINGS_PAGE_FIT_H

#include "api/settings/settings.h"

typedef struct {
    double width, height; /* of the page, mm */
    double factor;        /* by which the drawing grows */
    double x0, y0;        /* where its top left corner comes to lie, mm */
} page_fit;

/* Gives the place of a drawing of `width` by `height` mm whose thing is drawn at `paper_scale` (display_list.h). False
 * and `err` when the settings leave no page. */
bool plb_page_fit(const plb_options *o, double width, double height, double paper_scale, page_fit *out, error *err);

/* Gives the pixels per inch of a picture of a page of `width` by `height` mm; false and `err` when they are too few or too many. */
bool plb_page_dpi(const plb_options *o, double width, double height, double *dpi, error *err);

#endif
