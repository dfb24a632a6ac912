/* SPDX-License-Identifier: MIT
 *
 * Figures of a histogram of greys.
 */
#include "profile/histogram.h"

#include <math.h>

uint64_t plb_histogram_total(const uint32_t counts[], int greys)
{
    uint64_t total = 0;
    for (int g = 0; g < greys; g++)
        total += counts[g];
    return total;
}

int plb_histogram_percentile(const uint32_t counts[], int greys, double p)
{
    uint64_t total = plb_histogram_total(counts, greys), sum = 0;
    if (total == 0)
        return -1;
    double want = p * (double)total;
    for (int g = 0; g < greys; g++) {
        sum += counts[g];
        if (sum && (double)sum >= want)
            return g;
    }
    return greys - 1;
}

double plb_histogram_mean(const uint32_t counts[], int greys)
{
    double sum = 0, total = (double)plb_histogram_total(counts, greys);
    for (int g = 0; g < greys; g++)
        sum += (double)g * counts[g];
    return total > 0 ? sum / total : 0;
}

double plb_histogram_sd(const uint32_t counts[], int greys)
{
    double sum = 0, mean = plb_histogram_mean(counts, greys), total = (double)plb_histogram_total(counts, greys);
    for (int g = 0; g < greys; g++)
        sum += (g - mean) * (g - mean) * counts[g];
    return total > 0 ? sqrt(sum / total) : 0;
}
