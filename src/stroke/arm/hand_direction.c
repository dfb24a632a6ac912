/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 1, the direction: lines differ by the way in which they are drawn.
 * Input: the way from a line's first point to its last, mm on the page (y down). Output: deviations, mm; pressures.
 *
 * The thesis saw in its drawings (chapter 7), and left to others: lines drawn from left to right end higher and lighter
 * than meant, from right to left lower and darker; lines drawn toward the body deviate less than lines away from it;
 * a line may start accurate and dark and deviate after the middle. Higher for the one and lower for the other is for
 * both the left of the direction: the arm turns about the elbow. How much is not told; the amounts are chosen by eye, so
 * that a drawing does not tilt. A left hand mirrors all of it.
 */
#include "base/number/units.h"
#include "stroke/arm/hand.h"

/* How far a level line's second half leans, share of the length; and its free end, the same and at most, mm. */
#define LEAN 0.0015
#define END_DRIFT 0.001
#define DRIFT_LARGEST_MM (1.5 * MM_PER_PAPER_PX)
#define LONGEST_LEANING_MM 120.0
/* Lines toward the body deviate less by this share, lines away from it more. */
#define STEADIER_TOWARD 0.15
/* The second half deviates more by this share, and the first less. */
#define LATE 0.25
/* A line begins darker by the first, and a level one ends lighter or darker by the second. */
#define DARK_BEGIN 0.03
#define LIGHT_END 0.07

/* A stroke runs from its first point to its last as a right hand draws it: the plan has seen to that. A left hand draws
 * level ones from right to left; steep ones are drawn downward by either hand. */
bool plb_hand_backward(point way, handedness handed)
{
    return handed == HANDED_LEFT && way.x > 0 && !plb_point_is_steep(way);
}

void plb_hand_direct(hand *h, point way, bool free_end, const stroke_options *o)
{
    h->backward = plb_hand_backward(way, o->handed);
    if (o->handed == HANDED_NONE)
        return;
    double turn = h->backward ? -1 : 1; /* from the frame of the drawing hand to that of the line */
    double right = turn * way.x / h->length, toward = turn * way.y / h->length;
    double level = right < 0 ? -right : right, mirror = o->handed == HANDED_LEFT ? -1 : 1;
    double reach = h->length < LONGEST_LEANING_MM ? h->length : LONGEST_LEANING_MM, drift = END_DRIFT * reach;
    for (int k = 0; k < h->waves; k++)
        h->amplitude[k] *= 1 - STEADIER_TOWARD * toward;
    h->late = LATE;
    h->lean = h->strength * turn * mirror * level * LEAN * reach;
    if (free_end)
        h->drift = h->strength * turn * mirror * level * (drift < DRIFT_LARGEST_MM ? drift : DRIFT_LARGEST_MM);
}

void plb_hand_pressure(point way, double length, const stroke_options *o, float *begin, float *end)
{
    *begin = *end = 1;
    if (o->handed == HANDED_NONE || o->squiggle == 0)
        return;
    double right = (plb_hand_backward(way, o->handed) ? -1 : 1) * way.x / length;
    double outward = o->handed == HANDED_LEFT ? -right : right;
    *begin = (float)(1 + DARK_BEGIN);
    *end = (float)(1 - LIGHT_END * outward);
}
