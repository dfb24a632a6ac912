/* SPDX-License-Identifier: MIT
 *
 * This header draws a profile as a picture.
 */
#ifndef PLB_SURFACE_PLOT_PROFILE_PLOT_H
#define PLB_SURFACE_PLOT_PROFILE_PLOT_H

#include "base/error.h"
#include "profile/profile.h"

/* Writes a PNG with both histograms, the cross-section and the co-occurrence matrix; complete or not at all. */
bool plb_profile_draw(const profile *p, const char *file, error *err);

#endif
