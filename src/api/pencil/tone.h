/* SPDX-License-Identifier: MIT
 *
 * Measures how dark the hatching of a pencil comes out, as a person tries a pencil on a scrap of paper.
 */
#ifndef PLB_API_PENCIL_TONE_H
#define PLB_API_PENCIL_TONE_H

#include "api/pipeline.h"

/* Tells whether the plan of this drawing will ask for tones. */
bool plb_api_needs_tone(const display_list *list, const plan_options *options);
/* Fills in options->tone by drawing a swatch of each technique. False and `err` on failure. */
bool plb_api_measure_tone(const plb_options *o, plan_options *options, error *err);

#endif
