/* SPDX-License-Identifier: MIT
 *
 * Keeps pencils that are ready to draw with the profile that they are made from: one for each model and paper that a
 * call asked for. So a batch, or a program that draws line by line, makes each pencil once.
 */
#ifndef PLB_API_PENCIL_PENCILS_H
#define PLB_API_PENCIL_PENCILS_H

#include "api/api_internal.h"
#include "stroke/stroke.h"

/* Gives the profile's pencil for a model and, where the paper shows, a paper; the pencil lives as long as the profile.
 * Threads may call this at once. NULL and `err` when out of memory. */
const pencil *plb_api_pencil(const plb_profile *p, const line_model *model, paper_kind on, error *err);

#endif
