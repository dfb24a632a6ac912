/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 1, the free hand: how it deviates from the line it means to draw.
 * Input: the length of the line, mm, and the address of its random numbers. Output: the deviation at a place along it.
 *
 * Measured on 104 freehand lines of six hands, 16 to 250 mm long (scans of hdBPMN, CC BY 4.0): the deviation from the
 * chord, in sine modes over the length, has the same share of the length for short and long lines; mode 1, one bow, is
 * half of it, and the modes fall off about as 1 / k^1.4. The largest distance is 1.0 % of the length in the median.
 * Below 4 mm of wavelength the hand is smooth: what looks rough there is grain.
 */
#include "base/random.h"
#include "base/units.h"
#include "stroke/stroke.h"

#include <math.h>

/* Median amplitude of each mode, % of the length. */
static const double median_percent[HAND_MODES] = {.56, .22, .14, .095, .066, .044, .034, .031};
/* The median of |x| for a standard normal x: amplitudes are taken to be normal. */
#define MEDIAN_OF_NORMAL 0.6745
/* Shorter waves than this the hand does not make. */
#define SMOOTH_BELOW_MM 4.0
/* A mode is at most this many times its median: a hand that slips farther starts anew (90th percentile of the extreme measured:
 * 2.2 times the median). */
#define LARGEST_OF_MEDIAN 2.2

/* The longest lines measured: beyond, a draughtsman moves the arm on, and strays no farther. */
#define LONGEST_MEASURED_MM 250.0

/* Normal enough for amplitudes: the sum of twelve uniform numbers, less its mean; without any function of libm. */
static double normal(uint64_t key, uint64_t index)
{
    double sum = 0;
    for (uint64_t k = 0; k < 12; k++)
        sum += random_unit(key, index * 12 + k);
    return sum - 6;
}

hand plb_hand(double length, bool closed, uint64_t identity, const stroke_options *o)
{
    hand h = {.length = length, .closed = closed};
    uint64_t key = random_key(o->seed, identity, PURPOSE_HAND);
    double papers_own = 5 * MM_PER_PAPER_PX; /* a --squiggle of the default leaves the hand as it was measured */
    double strength = o->squiggle < 0 ? 1 : o->squiggle / papers_own;
    double reach = length < LONGEST_MEASURED_MM ? length : LONGEST_MEASURED_MM;
    for (int k = 0; k < HAND_MODES; k++) {
        double wave = closed ? length / (k / 2 + 2) : 2 * length / (k + 1), limit = LARGEST_OF_MEDIAN * MEDIAN_OF_NORMAL;
        double x = normal(key, (uint64_t)k);
        x = x > limit ? limit : x < -limit ? -limit : x;
        if (wave >= SMOOTH_BELOW_MM || k == 0)
            h.amplitude[k] = strength * x * median_percent[k] / MEDIAN_OF_NORMAL / 100 * reach;
    }
    return h;
}

/* An open line keeps its ends; a closed one runs on across its joint: modes in pairs of cosine and sine, from the second
 * harmonic on, since the first would only move a circle. */
double plb_hand_off(const hand *h, double along)
{
    double x = along / h->length * PLB_PI, sum = 0;
    for (int k = 0; k < HAND_MODES; k++)
        if (h->amplitude[k] != 0)
            sum += h->amplitude[k] * (!h->closed ? sin((k + 1) * x) : k & 1 ? sin((k / 2 + 2) * 2 * x) : cos((k / 2 + 2) * 2 * x));
    return sum;
}
