/* SPDX-License-Identifier: MIT
 *
 * The paper's tooth, for this folder only, is a field of heights that belongs to the page, so that all strokes skip over the
 * same hollows and catch the same peaks.
 */
#ifndef PLB_STROKE_TEXTURE_GRAPHITE_PAPER_H
#define PLB_STROKE_TEXTURE_GRAPHITE_PAPER_H

#include "stroke/texture/graphite/grain_field.h"

#define PAPER_UNIT 32      /* steps of a height's standard deviation */
#define PAPER_SIDE_MAX 191
#define PAPER_RUN 64       /* texels that can be read in one go from any place of a tile */
#define PAPER_BLOCK 8      /* heights are made so many at a time */
#define PAPER_LAGS 3       /* texels apart at which heights correlate, and zero */

typedef struct {
    double share;                    /* of the grain's variance that is the paper's, 0 to 1 */
    double correlation[PAPER_LAGS];  /* of heights so many texels apart along an axis; along both: the product */
    int8_t tile[PAPER_TILES][PAPER_SIDE_MAX][PAPER_SIDE_MAX + PAPER_RUN];
} paper;

/* Fills `p` (texture_paper.c); `normal`: numbers to draw from, GRAIN_NORMALS of them. A texel is 1/300 inch. False when out
 * of memory. */
bool plb_paper_make(paper *p, paper_kind kind, const float normal[]);
paper_sheet plb_paper_sheet(uint64_t seed);
/* Heights at `n` (at most PAPER_RUN) places of the page, the first at (x, y) mm, each next `step` mm farther in x, in
 * 1/PAPER_UNIT. Room for `n` up to the next multiple of PAPER_BLOCK is written. */
void plb_paper_row(const paper *p, const paper_sheet *sheet, double x, double y, double step, int n, int16_t *out);

#endif
