/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 1, the ends: a pencil that is set down or lifted slips a little aside.
 * Input: which ends are free, and the address of their random numbers. Output: the hook of each end, mm.
 *
 * Measured on short strokes with two free ends (193 dashes of three hands, hdBPMN): the last 3 px of 1/300 inch lie 0.5
 * to 0.7 px off the stroke's own straight fit, and one end in five is off by more than 1.5 px. An exponential distribution
 * of the tip's distance with a mean of 0.93 px has a fifth of its share beyond 1.5 px and its median at 0.65 px.
 */
#include "base/number/random.h"
#include "base/number/units.h"
#include "stroke/arm/hand.h"

#include <math.h>

#define MEAN_PX 0.93
#define LARGEST_PX 3.0 /* no one lets more stand (chosen by eye) */
/* Over this length the end bends away, as the square of the way (by eye: the length over which the pressure fades). */
#define REACH_PX 8.0
/* The strokes measured were about so long: on shorter ones hooks are smaller, in proportion. */
#define MEASURED_LENGTH_PX 40.0

static double hook(uint64_t key, uint64_t end)
{
    double size = -MEAN_PX * log(1 - random_unit(key, end));
    double side = random_bits(key, end + 2) & 1 ? 1 : -1;
    return side * (size < LARGEST_PX ? size : LARGEST_PX) * MM_PER_PAPER_PX;
}

void plb_hand_hooks(hand *h, bool free_first, bool free_last, uint64_t identity, const stroke_options *o)
{
    double shorter = h->length / (MEASURED_LENGTH_PX * MM_PER_PAPER_PX), scale = shorter < 1 ? shorter : 1;
    uint64_t key = random_key(o->seed, identity, PURPOSE_HOOK);
    h->hook_reach = REACH_PX * MM_PER_PAPER_PX * scale;
    h->hook_first = free_first ? h->strength * scale * hook(key, 0) : 0;
    h->hook_last = free_last ? h->strength * scale * hook(key, 1) : 0;
}
