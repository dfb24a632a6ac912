/* SPDX-License-Identifier: MIT
 *
 * The second step of the capture measures the mean cross-section of all lines, in relative darkness.
 */
#include "profile/grain/grain.h"

#include "profile/grain/grain_math.h"

#include <math.h>

#define SECTION_BINS 44 /* the last ones only so that smoothing does not see an end */

void plb_grain_section(const grain_lines *lines, grain_model *g)
{
    double sum[SECTION_BINS] = {0}, n[SECTION_BINS] = {0}, smooth_sum[SECTION_BINS], smooth_n[SECTION_BINS];
    for (size_t j = 0; j < lines->n; j++) {
        const grain_line *l = &lines->v[j];
        for (int i = 0; i < l->n * GRAIN_ROWS; i++) {
            int bin = (int)fmin(fabs((double)l->place[i]) / PROFILE_SECTION_STEP, SECTION_BINS - 1);
            if (!l->usable[i / GRAIN_ROWS])
                continue;
            sum[bin] += l->dark[i];
            n[bin]++;
        }
    }
    plb_smooth_folded(sum, smooth_sum, SECTION_BINS);
    plb_smooth_folded(n, smooth_n, SECTION_BINS);
    for (int k = 0; k < GRAIN_SECTION; k++)
        g->section[k] = (float)(smooth_sum[k] / fmax(smooth_n[k], 1));
}

double plb_grain_root(const grain_model *g, double place)
{
    return sqrt(plb_interpolate(g->section, GRAIN_SECTION, PROFILE_SECTION_STEP / 2, PROFILE_SECTION_STEP, fabs(place)));
}

/* Below this root a line is nearly paper: dividing by less would make mountains of its noise (chosen by eye). */
#define MIN_ROOT 0.1

double plb_grain_root_slope(double root)
{
    return 2 * fmax(root, MIN_ROOT);
}
