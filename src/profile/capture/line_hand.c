/* SPDX-License-Identifier: MIT
 *
 * Capture of the hand: how far a line strays from its chord, next to a free hand's. One drawn along a ruler strays a fifth as
 * far, or less.
 */
#include "profile/hand.h"

#include "base/geometry/geom.h"

#include <math.h>

const double plb_hand_median_percent[HAND_MODES] = {.56, .22, .14, .095, .066, .044, .034, .031};

/* Gives the amplitude of mode k: twice the mean of the deviation times the sine. */
static double amplitude(const double line[], int n, int k)
{
    double sum = 0, rise = (line[n - 1] - line[0]) / (n - 1);
    for (int i = 0; i < n; i++)
        sum += (line[i] - line[0] - rise * i) * sin(PLB_PI * k * i / (n - 1));
    return 2 * fabs(sum) / n;
}

int plb_hand_compare(const double line[], int n, double mm, double ratios[HAND_MODES])
{
    int modes = 0;
    for (int k = 1; k <= HAND_MODES && n > 1 && 2 * n * mm / k >= HAND_SMOOTH_BELOW_MM; k++)
        ratios[modes++] = amplitude(line, n, k) / n * 100 / plb_hand_median_percent[k - 1];
    return modes;
}
