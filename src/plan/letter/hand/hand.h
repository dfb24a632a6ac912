/* SPDX-License-Identifier: MIT
 *
 * Lettering in a draughtsman's alphabet: known characters become the strokes of hand/alphabet.h, each within the box of the
 * original's ink, so that width and place stay and nothing collides; no two are alike.
 */
#ifndef PLB_PLAN_LETTER_HAND_HAND_H
#define PLB_PLAN_LETTER_HAND_HAND_H

#include "list/display_list.h"
#include "plan/track.h"

/* Appends the strokes of the fill's characters that the alphabet has to `out`, in mm, corners marked, in the order of writing; the
 * outlines of all others to `rest`. Strokes keep `inset` mm inside the box of each character's ink. False when out of memory. */
bool plb_hand_letters(const item *fill, double inset, uint64_t seed, track_list *out, path *rest);

#endif
