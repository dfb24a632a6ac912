/* SPDX-License-Identifier: MIT
 *
 * The cross-section of a line, of one strip or of several pooled: grey against distance from the centreline, both sides folded together.
 */
#ifndef PLB_PROFILE_CAPTURE_LINE_SECTION_H
#define PLB_PROFILE_CAPTURE_LINE_SECTION_H

#include "profile/capture/line_strip.h"

typedef struct {
    double n[PROFILE_SECTION_BINS], sum[PROFILE_SECTION_BINS], squares[PROFILE_SECTION_BINS];
} section_sums;

/* Adds the usable pixels of a strip, its distances times `stretch`. */
void plb_section_add(section_sums *sums, const line_strip *s, double stretch);
/* Gives mean and standard deviation by bin; a bin without pixels lies between its neighbours. */
void plb_section_figures(const section_sums *sums, double mean[PROFILE_SECTION_BINS], double sd[PROFILE_SECTION_BINS]);
/* Gives the width where darkness falls to `share` of its greatest, px; 0 when there is no line. */
double plb_section_width(const double mean[PROFILE_SECTION_BINS], double share);

#endif
