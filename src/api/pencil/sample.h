/* SPDX-License-Identifier: MIT */
#ifndef PLB_API_PENCIL_SAMPLE_H
#define PLB_API_PENCIL_SAMPLE_H

#include "profile/profile.h"

/* Draws lines of a free hand on medium paper in one direction: a line_sampler. `closure` is not used. */
bool plb_api_sample(void *closure, const profile *p, int lines, int width, int height, uint8_t *grey, error *err);

#endif
