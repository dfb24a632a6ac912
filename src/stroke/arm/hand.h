/* SPDX-License-Identifier: MIT
 *
 * The free hand: how it deviates from the line that it means to draw.
 */
#ifndef PLB_STROKE_ARM_HAND_H
#define PLB_STROKE_ARM_HAND_H

#include "base/geometry/geom.h"
#include "profile/hand.h"
#include "stroke/options.h"

/* How a free hand deviates from one line: instead of D at control points. hand_modes.c fills the modes, hand_direction.c
 * and hand_hooks.c the rest. All in the line's own frame, first to last, to the left; mm. */
#define HAND_WAVES 32 /* of the longest lines; the first HAND_MODES as measured, the others as these fall off */
typedef struct {
    double length;
    bool closed;
    int waves;                 /* so many modes are not shorter than a hand makes */
    double strength;           /* 1: a free hand */
    double amplitude[HAND_WAVES];
    double late;               /* the second half of the way deviates so much more, and the first less (a share) */
    double lean, drift;        /* of the way's second half, and of its free end */
    bool backward;             /* the hand draws from last to first */
    double limit;              /* about how far it may stray at most, mm; 0: freely */
    double hook_first, hook_last, hook_reach; /* of free ends, and over which length */
} hand;
hand plb_hand(double length, bool closed, uint64_t identity, const stroke_options *o);
/* On a curve the modes go by how far it reaches, `extent` in mm, instead of by its length. */
void plb_hand_reach(hand *h, double extent);
/* A closed line that is a circle of `radius` mm becomes egg-shaped. */
void plb_hand_egg(hand *h, double radius, uint64_t key);
/* Tells how far off the line the hand is at `along` mm from its start: mm to the left of the direction. */
double plb_hand_off(const hand *h, double along);

/* Tells whether a hand draws a line from its last point to its first; `way` leads from first to last (hand_direction.c). */
bool plb_hand_backward(point way, handedness handed);
/* Sets all that depends on the direction in which a line is drawn. `free_end`: no other line goes on where it ends. */
void plb_hand_direct(hand *h, point way, bool free_end, const stroke_options *o);
/* Computes the pressure at the beginning and at the end of the movement, times the usual. */
void plb_hand_pressure(point way, double length, const stroke_options *o, float *begin, float *end);
/* Hooks at the ends that are free (hand_hooks.c). */
void plb_hand_hooks(hand *h, bool free_first, bool free_last, uint64_t identity, const stroke_options *o);

/* Keeps the deviation within about `limit` mm of the line: another one runs beside it (hand_modes.c). */
void plb_hand_keep(hand *h, double limit);

#endif
