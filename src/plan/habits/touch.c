/* SPDX-License-Identifier: MIT
 *
 * The touch of the pencil changes over a page: the hand presses harder here and less there, and the point wears and is sharpened
 * again. Input: strokes. Output: pressure and breadth of each.
 *
 * Both changes are slow along the order of drawing. Because near strokes are drawn together, that is the same as slow over the page, and so they
 * are made: as smooth noise of the place where a stroke begins. A line that is added elsewhere then changes no other.
 *
 * A point is a cone with its tip worn off. The worn volume grows with the way that the pencil has gone, and with the cube of
 * the breadth of the face that is worn into the cone: b^3 = sharp^3 + (worn^3 - sharp^3) * share of the way to the next sharpening.
 */
#include "plan/habits/habits.h"

#include "base/geometry/interpolate.h"
#include "base/number/normal.h"
#include "base/number/random.h"

#include <math.h>

/* A point this much broader than sharp is sharpened again (chosen by eye: .26 mm becomes .36, between a draughtsman's line and the
 * blunt ones of hdBPMN). */
#define WORN 1.4
/* Knots of the noise lie so far apart, mm: about a metre of line on a page of plans (chosen by eye). */
#define KNOTS_MM 35.0
/* Standard deviations of the logarithm of pressure: slow, and each stroke's own. A change of the pressure to p changes the
 * darkness by its power .3 to .5 only; so that line segments of a page differ in darkness by .21 to .29 of the mean, as on six real pages. */
#define SLOW_PRESSURE 0.22
#define OWN_PRESSURE 0.16
/* Lettering is careful: so much of both. */
#define LETTERING 0.4
/* Short strokes are decided and hard, long ones light: pressure goes with this power of the length over the usual one, mm, within bounds
 * of lengths (chosen by eye). */
#define LENGTH_POWER (-0.1)
#define USUAL_LENGTH 20.0
#define SHORTEST 2.0
#define LONGEST 200.0

double plb_wear_mean(const plan_options *o)
{
    /* The mean of the cube root over the way, in closed form. */
    double cube = WORN * WORN * WORN;
    return o->point < 1 ? 0.75 * (cube * WORN - 1) / (cube - 1) : 1;
}

/* ---- smooth noise ---- */

/* Many strokes begin between the same four knots, whose numbers are therefore kept; a page of A3 has about a hundred such squares. */
#define KEPT 256
typedef struct {
    bool is_known;
    double column, row; /* of the upper left knot */
    double knots[4];    /* upper left, upper right, lower left, lower right */
} noise_square;
typedef struct {
    uint64_t key;
    noise_square kept[KEPT];
} noise;

/* Gives the normal number of a knot. */
static double knot(uint64_t key, double column, double row)
{
    return plb_normal_quantile(random_unit(random_fold(key, (int64_t)column, (int64_t)row), 0) * 0.998 + 0.001);
}

static const double *knots_around(noise *n, double column, double row)
{
    noise_square *q = &n->kept[((uint64_t)(int64_t)column + 16 * (uint64_t)(int64_t)row) % KEPT];
    if (!q->is_known || q->column != column || q->row != row) {
        *q = (noise_square){true, column, row, {0}};
        for (int k = 0; k < 4; k++)
            q->knots[k] = knot(n->key, column + k % 2, row + k / 2);
    }
    return q->knots;
}

/* Gives smooth noise at a place: of mean 0, and of standard deviation 1 at the knots and 2/3 amid them. */
static double noise_at(noise *n, point p)
{
    double column = floor(p.x / KNOTS_MM), row = floor(p.y / KNOTS_MM), u = p.x / KNOTS_MM - column, v = p.y / KNOTS_MM - row;
    const double *knots = knots_around(n, column, row);
    u = u * u * (3 - 2 * u);
    v = v * v * (3 - 2 * v);
    double upper = knots[0] * (1 - u) + knots[1] * u;
    double lower = knots[2] * (1 - u) + knots[3] * u;
    return upper * (1 - v) + lower * v;
}

/* ---- what it changes ---- */

static float breadth_at(noise *wear, const plan_options *o, point p)
{
    double worn = plb_normal_share(noise_at(wear, p) * 1.3); /* about even shares */
    return (float)fmin(o->point * cbrt(1 + (WORN * WORN * WORN - 1) * worn), 1);
}

static double pressure_at(noise *slow, const stroke_list *list, const stroke *s, const plan_options *o, point p)
{
    uint64_t address = s->style.company ? s->style.company : s->identity;
    double own = plb_normal_quantile(random_unit(random_key(o->seed, address, PURPOSE_TOUCH), 0) * 0.998 + 0.001);
    double change = SLOW_PRESSURE * noise_at(slow, p) + OWN_PRESSURE * own;
    double length = clamp(plb_stroke_length(list, s), SHORTEST, LONGEST);
    return s->style.kind == STROKE_LETTER ? exp(LETTERING * change) : exp(change) * pow(length / USUAL_LENGTH, LENGTH_POWER);
}

void plb_plan_touch(stroke_list *list, const plan_options *o)
{
    noise wear = {.key = random_key(o->seed, 0, PURPOSE_POINT)}, slow = {.key = random_key(o->seed, 0, PURPOSE_TOUCH)};
    for (size_t i = 0; i < list->strokes.n; i++) {
        stroke *s = &list->strokes.v[i];
        point p = list->points.v[s->first];
        if (s->style.breadth <= 0)
            s->style.breadth = breadth_at(&wear, o, p);
        /* Tones are measured: their pressure stays. */
        if (o->is_touched && s->style.kind != STROKE_HATCH)
            s->style.pressure *= (float)pressure_at(&slow, list, s, o, p);
    }
}
