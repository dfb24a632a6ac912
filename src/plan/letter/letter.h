/* SPDX-License-Identifier: MIT
 *
 * Lettering: a fill that is thin everywhere - text as glyph outlines, expanded strokes, thin bars - becomes the strokes of
 * a pen along its medial axis.
 */
#ifndef PLB_PLAN_LETTER_LETTER_H
#define PLB_PLAN_LETTER_LETTER_H

#include "plan/letter/glyphs.h"
#include "plan/letter/runs.h"
#include "plan/plan.h"
#include "plan/track.h"

/* Appends the strokes of `fill` to `out`: of the kind STROKE_LETTER, in mm, corners marked. *taken is false, and nothing
 * appended, when the shape is not like lettering: solid, thick or far too large. The run that the fill belongs to decides how broad and dark
 * the strokes are. `glyphs` keeps the shapes met, for the next fill. False and `err` when out of memory. */
bool plb_plan_letter(const item *fill, letter_run run, const plan_options *o, glyph_store *glyphs, bool *taken, track_list *out, error *err);

#endif
