/* SPDX-License-Identifier: MIT
 *
 * Several views of a model on one sheet.
 */
#ifndef PLB_TAP_MODEL_SHEET_H
#define PLB_TAP_MODEL_SHEET_H

#include "tap/model/view_items.h"

/* Writes the page and the views: front, top, side, isometric. `unit` is the model's, mm. */
bool plb_sheet_write(item_writer *w, const mesh *m, double unit, const model_settings *s);

#endif
