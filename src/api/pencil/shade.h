/* SPDX-License-Identifier: MIT
 *
 * Chooses the pencil that shades what is too dark for the one that draws.
 */
#ifndef PLB_API_PENCIL_SHADE_H
#define PLB_API_PENCIL_SHADE_H

#include "api/pipeline.h"

/* Finds a pencil that goes darker than options->tone, where fills of the list ask for one and the settings allow one: sets its figures in
 * `options`, and `soft`, which the caller owns; NULL: none is needed. False and `err` on failure. */
bool plb_api_find_soft(const plb_options *o, const display_list *list, plan_options *options, plb_profile **soft, error *err);

#endif
