/* SPDX-License-Identifier: MIT
 *
 * Lengths on paper, in millimetres. The papers' pixel is 1/300 inch: their scans and figures are at 300 dpi
 * (seed thesis, section 6.1).
 */
#ifndef PLB_BASE_NUMBER_UNITS_H
#define PLB_BASE_NUMBER_UNITS_H

#include <stdbool.h>

#define MM_PER_INCH 25.4
#define MM_PER_POINT (MM_PER_INCH / 72) /* the point of PostScript and PDF */
#define PAPER_PX_PER_INCH 300.0
#define MM_PER_PAPER_PX (MM_PER_INCH / PAPER_PX_PER_INCH)

/* Reads "12.5mm", "5/300in", "36" (default unit px = 1/96 in) and the like; units mm cm in pt px. `mm` gets
 * millimetres. False when the text is not a length. Independent of the locale. */
bool plb_read_length(const char *text, double *mm);

#endif
