/* SPDX-License-Identifier: MIT
 *
 * Tells which strokes touch which band of the page.
 */
#ifndef PLB_API_RENDER_BANDS_H
#define PLB_API_RENDER_BANDS_H

#include "api/pipeline.h"

/* The strokes of band k are those numbered index[first[k]] to index[first[k + 1] - 1], in the list's order. */
typedef struct {
    size_t n;       /* bands */
    size_t *first;  /* n + 1 of them */
    uint32_t *index;
} band_strokes;

/* Finds the bands of the page's rows [top, height): of `rows` rows each, with `members` threads. False and `err` on
 * failure; the caller frees `b` then, too. */
bool plb_bands_init(band_strokes *b, const stroke_list *list, const stroke_options *o, int top, int height, int rows, int members, error *err);
void plb_bands_free(band_strokes *b);

#endif
