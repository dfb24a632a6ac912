/* SPDX-License-Identifier: MIT
 *
 * Pencils ready to draw, kept with the profile that they are made from: one for each model and paper that
 * was asked for. So a batch, or a program that draws line by line, makes each once.
 */
#ifndef PLB_API_PENCIL_PENCILS_H
#define PLB_API_PENCIL_PENCILS_H

#include "api/api_internal.h"
#include "stroke/stroke.h"

/* The profile's pencil for a model and, where the paper shows, a paper; it lives as long as the profile. Threads may ask
 * at once. NULL and `err` when out of memory. */
const pencil *plb_api_pencil(const plb_profile *p, const line_model *model, paper_kind on, error *err);

#endif
