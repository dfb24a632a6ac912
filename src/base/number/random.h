/* SPDX-License-Identifier: MIT
 *
 * Random numbers with an address. A value is a function of (seed, stroke identity, purpose, index), never the
 * next of a stream, so the order of work, the number of threads and the other strokes change nothing.
 * The mixing function is the finaliser of SplitMix64 (Steele, Lea & Flood, OOPSLA 2014).
 */
#ifndef PLB_BASE_NUMBER_RANDOM_H
#define PLB_BASE_NUMBER_RANDOM_H

#include <stdint.h>

/* A random number serves one of these purposes, which is part of its address. Renumbering one would change every drawing. */
typedef enum {
    PURPOSE_SQUIGGLE = 1, /* deviation of a path's control points */
    PURPOSE_CENTRE = 2,   /* grey of the centre row */
    PURPOSE_BESIDE = 3,   /* grey beside the centre */
    PURPOSE_OUTSIDE = 4,  /* grey of the rim */
    PURPOSE_HAND = 5,     /* amplitudes of a free hand's deviation */
    PURPOSE_LINE = 6,     /* a line's own depth, width, roughness … */
    PURPOSE_SLOW = 7,     /* slow changes of the section along the line */
    PURPOSE_CHAIN = 8,    /* not in use any more */
    PURPOSE_GRAIN = 9,    /* innovations of the grain */
    PURPOSE_PAPER = 10,   /* the paper's heights, and where the sheet lies */
    PURPOSE_HOOK = 20,    /* hooks at free ends */
    PURPOSE_CLOSING = 21, /* where a circle begins and how it meets itself */
    PURPOSE_HABIT = 22,   /* overshoot, restating, construction lines */
    PURPOSE_ARM = 23,     /* parameters of an arm's movement */
    PURPOSE_PASS = 40,    /* places of the passes of a wide line */
    PURPOSE_DASH = 41,    /* lengths of dashes and gaps */
    PURPOSE_LETTER = 42,  /* forms, size, lean and place of letters */
    PURPOSE_HATCH = 50,   /* places, ends and pressure of hatch lines */
    PURPOSE_POINT = 51,   /* how far the point is worn at a place */
    PURPOSE_GROUND = 60,  /* the sheet as a scanner sees it */
    PURPOSE_TOUCH = 52    /* how hard the hand presses at a place, and a stroke */
} random_purpose;

static inline uint64_t random_mix(uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/* The key of one use in one stroke: index it with random_bits or random_unit. */
static inline uint64_t random_key(uint64_t seed, uint64_t identity, random_purpose purpose)
{
    return random_mix(random_mix(seed + 0x9e3779b97f4a7c15u) ^ identity) + 0x632be59bd9b4e019u * (uint64_t)purpose;
}

static inline uint64_t random_bits(uint64_t key, uint64_t index)
{
    return random_mix(key + 0x9e3779b97f4a7c15u * (index + 1));
}

/* Folds a place into a hash: how identities are made of shapes. */
static inline uint64_t random_fold(uint64_t h, int64_t x, int64_t y)
{
    return random_mix(random_mix(h ^ (uint64_t)x) + (uint64_t)y * 0x9e3779b97f4a7c15u);
}

/* Uniform in [0, 1). */
static inline double random_unit(uint64_t key, uint64_t index)
{
    return (double)(random_bits(key, index) >> 11) * (1.0 / 9007199254740992.0);
}

#endif
