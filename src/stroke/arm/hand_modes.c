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
#include "base/geometry/interpolate.h"
#include "base/number/random.h"
#include "base/number/units.h"
#include "stroke/arm/hand.h"

#include <math.h>

/* A mode is at most this many times its median: a hand that slips farther starts again (90th percentile of the extreme measured:
 * 2.2 times the median). */
#define LARGEST_OF_MEDIAN 2.2

/* The longest lines measured: beyond, a draughtsman moves the arm on, and strays no farther. */
#define LONGEST_MEASURED_MM 250.0

/* A number that is normal enough for an amplitude, in units of the median of its size: the sum of four uniform ones of
 * 16 bits, less its mean. The median size of that sum is 0.4022 (the root of its distribution, Irwin and Hall's of 4). */
#define MEDIAN_OF_FOUR 0.4022
static double amplitude(uint64_t key, uint64_t index)
{
    uint64_t bits = random_bits(key, index);
    uint64_t sum = (bits & 0xffff) + (bits >> 16 & 0xffff) + (bits >> 32 & 0xffff) + (bits >> 48);
    double x = ((double)sum + 2 - 2 * 65536.0) / (65536.0 * MEDIAN_OF_FOUR);
    return x > LARGEST_OF_MEDIAN ? LARGEST_OF_MEDIAN : x < -LARGEST_OF_MEDIAN ? -LARGEST_OF_MEDIAN : x;
}

/* The measured modes, and beyond them as 1 / k^1.4: so the deviation by wavelength is that measured, rms 0.46 px at waves of 100 to
 * 200 px, 0.21 at 50 to 100. */
#define FALL_OFF 1.4
static double median_percent(int k)
{
    return k < HAND_MODES ? plb_hand_median_percent[k] : plb_hand_median_percent[HAND_MODES - 1] * pow((double)HAND_MODES / (k + 1), FALL_OFF);
}

/* Tells how many modes a hand makes: the first ones of whatever length, a closed line's in pairs. */
static int waves_of(double length, bool closed)
{
    double waves = closed ? 2 * (floor(length / HAND_SMOOTH_BELOW_MM) - 1) : floor(2 * length / HAND_SMOOTH_BELOW_MM);
    return (int)clamp(waves, closed ? 2 : 1, HAND_WAVES);
}

hand plb_hand(double length, bool closed, uint64_t identity, const stroke_options *o)
{
    hand h = {.length = length, .closed = closed};
    uint64_t key = random_key(o->seed, identity, PURPOSE_HAND);
    double papers_own = 5 * MM_PER_PAPER_PX; /* a --squiggle of these gives a free hand */
    double own = o->hand > 0 ? o->hand : 1, strength = o->squiggle < 0 ? own : o->squiggle / papers_own;
    double reach = length < LONGEST_MEASURED_MM ? length : LONGEST_MEASURED_MM;
    h.strength = strength;
    h.waves = waves_of(length, closed);
    for (int k = 0; k < h.waves; k++)
        h.amplitude[k] = strength * amplitude(key, (uint64_t)k) * median_percent(k) / 100 * reach;
    return h;
}

/* A closed curve is watched all the while it is drawn: large ones stray less, while small ones cannot be drawn as round;
 * the factor is the first, and more by the second over the extent, up to the third (by eye, that circles look careful). */
#define CLOSED_CARE 0.75
#define CLOSED_SMALL_MM 6.0
#define CLOSED_SMALL_MAX 1.5

void plb_hand_reach(hand *h, double extent)
{
    double longest = fmin(h->length, LONGEST_MEASURED_MM), share = fmin(extent, longest) / longest;
    if (h->closed)
        share *= CLOSED_CARE + fmin(CLOSED_SMALL_MM / extent, CLOSED_SMALL_MAX);
    for (int k = 0; k < h->waves; k++)
        h->amplitude[k] *= share;
}

/* A circle drawn freely is an egg: its second harmonic has about this amplitude in the median, of its radius, with this standard deviation of the
 * logarithm, at most so much, and its third this share of the second. (Small circles of three writers of hdBPMN: 1.5 to 12 % of the radius; the logarithm
 * of the aspect of 544 annotated ones, twice the amplitude: .08 in the median, .27 in the 90th percentile, errors of annotation included.) Large
 * circles are drawn with more care: no more than so many mm. */
#define EGG_MEDIAN 0.038
#define EGG_SPREAD 0.6
#define EGG_LARGEST 0.1
#define EGG_THIRD 0.35
#define EGG_LARGEST_MM 0.32

void plb_hand_egg(hand *h, double radius, uint64_t key)
{
    double size = fmin(EGG_MEDIAN * exp(EGG_SPREAD * amplitude(key, 0x100) * MEDIAN_OF_FOUR * sqrt(3)), EGG_LARGEST);
    double most = h->strength * fmin(size * radius, EGG_LARGEST_MM);
    for (int k = 0; k < 4 && k < h->waves; k++) {
        double angle = 2 * PLB_PI * random_unit(key, 0x102 + (uint64_t)(k / 2)), share = k < 2 ? 1 : EGG_THIRD;
        h->amplitude[k] += most * share * (k & 1 ? sin(angle) : cos(angle));
    }
}

void plb_hand_keep(hand *h, double limit)
{
    h->limit = limit;
    double squares = h->lean * h->lean;
    for (int k = 0; k < h->waves; k++)
        squares += h->amplitude[k] * h->amplitude[k];
    double reach = 1.4 * sqrt(squares), share = reach > limit ? limit / reach : 1; /* 1.4: modes hardly ever peak together */
    for (int k = 0; k < h->waves; k++)
        h->amplitude[k] *= share;
    h->lean *= share;
    h->drift *= share;
}

/* An open line keeps its ends: the sum of a_k sin(k x), by sin((k + 1) x) = 2 cos(x) sin(k x) - sin((k - 1) x). */
static double open_modes(const hand *h, double x)
{
    double twice = 2 * cos(x), before = 0, now = sin(x), sum = 0;
    for (int k = 0; k < h->waves; k++) {
        sum += h->amplitude[k] * now;
        double next = twice * now - before;
        before = now;
        now = next;
    }
    return sum;
}

/* A closed one runs on across its joint: modes in pairs of cosine and sine, from the second harmonic on, since the first
 * would only move a circle. */
static double closed_modes(const hand *h, double x)
{
    double c = cos(2 * x), s = sin(2 * x), re = c, im = s, sum = 0;
    for (int k = 0; k < h->waves; k += 2) {
        double next = re * c - im * s;
        im = re * s + im * c;
        re = next;
        sum += h->amplitude[k] * re + h->amplitude[k + 1] * im;
    }
    return sum;
}

/* Adds up the deviations that the ends and the direction make. */
static double asides(const hand *h, double along)
{
    double u = h->backward ? 1 - along / h->length : along / h->length, to_last = h->length - along;
    double sum = h->lean * 6.75 * u * u * (1 - u) + h->drift * u * u * u;
    if (!(h->hook_reach > 0)) /* no hooks: rounding may leave `along` beyond an end */
        return sum;
    if (along < h->hook_reach)
        sum += h->hook_first * (1 - along / h->hook_reach) * (1 - along / h->hook_reach);
    if (to_last < h->hook_reach)
        sum += h->hook_last * (1 - to_last / h->hook_reach) * (1 - to_last / h->hook_reach);
    return sum;
}

double plb_hand_off(const hand *h, double along)
{
    double x = along / h->length * PLB_PI;
    if (h->closed)
        return closed_modes(h, x);
    double u = h->backward ? 1 - along / h->length : along / h->length;
    return open_modes(h, x) * (1 + h->late * (2 * u - 1)) + asides(h, along);
}
