/* SPDX-License-Identifier: MIT
 *
 * A made-up pencil whose statistics are known exactly, for tests of path and texture.
 */
#ifndef PLB_TESTS_PENCIL_FOR_TESTS_H
#define PLB_TESTS_PENCIL_FOR_TESTS_H

#include "base/array.h"
#include "profile/profile.h"
#include "stroke/stroke.h"

#include <string.h>

/* Centre 100 to 180 (a triangle about 140), line 90 to 250, 5 px wide at half depth and 9 at a tenth; the matrix
 * knows pairs of greys that differ by at most 20. */
static profile *profile_for_tests(void)
{
    profile *p = plb_new(1, sizeof *p);
    p->ccm = plb_new(PROFILE_GREYS * PROFILE_GREYS, sizeof *p->ccm);
    strcpy(p->name, "test");
    p->dpi = 300;
    p->width_half = 5;
    p->width_tenth = 9;
    p->paper = 255;
    p->lines = 1;
    p->pixels = 1000;
    p->min_mid = 100;
    p->max_mid = 180;
    p->min_range = 90;
    p->max_range = 250;
    for (int g = 100; g <= 180; g++)
        p->mid[g] = (uint32_t)(41 - (g < 140 ? 140 - g : g - 140));
    for (int g = 90; g <= 250; g++)
        p->range[g] = 10;
    for (int i = 90; i <= 250; i++)
        for (int j = 90; j <= 250; j++)
            p->ccm[i * PROFILE_GREYS + j] = i - j <= 20 && j - i <= 20;
    return p;
}

static void free_profile_for_tests(profile *p)
{
    plb_free(p->ccm);
    plb_free(p);
}

#endif
