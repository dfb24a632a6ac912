/* SPDX-License-Identifier: MIT
 *
 * Measures how dark the hatching of a pencil comes out, as a person tries a pencil on a scrap of paper.
 */
#ifndef PLB_API_PENCIL_TONE_H
#define PLB_API_PENCIL_TONE_H

#include "api/pipeline.h"

/* Tells whether the plan of this drawing will ask for tones. */
bool plb_api_needs_tone(const display_list *list, const plan_options *options);
/* tone_known.c: the scale of one of the eight pencils with the usual paper, pressure and hand; NULL: it must be measured. */
const tone_scale *plb_api_tone_known(const plb_options *o);
/* Gives the scale of one of the eight pencils by its index (plb_pencil_name), used as usual; NULL past the last. */
const tone_scale *plb_api_tone_of_grade(size_t index);
/* Measures the scale by drawing a swatch of each technique, `side` mm wide at `dpi`: 14 and 100 tell a tone to .03. False and `err` on failure. */
bool plb_api_measure_tone(const plb_options *o, const plan_options *options, double side, double dpi, tone_scale *out, error *err);
/* Fills in options->tone: known, or measured. False and `err` on failure. */
bool plb_api_find_tone(const plb_options *o, plan_options *options, error *err);

#endif
