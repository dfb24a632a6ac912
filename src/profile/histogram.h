/* SPDX-License-Identifier: MIT
 *
 * Figures of a histogram of greys: 256 counts.
 */
#ifndef PLB_PROFILE_HISTOGRAM_H
#define PLB_PROFILE_HISTOGRAM_H

#include <stdint.h>

/* Gives the sum of the first `greys` counts. */
uint64_t plb_histogram_total(const uint32_t counts[], int greys);
/* Gives the least grey below `greys` at which a share of at least `p` (0 to 1) of the counts is reached; -1: no counts. */
int plb_histogram_percentile(const uint32_t counts[], int greys, double p);
double plb_histogram_mean(const uint32_t counts[], int greys);
double plb_histogram_sd(const uint32_t counts[], int greys);

#endif
