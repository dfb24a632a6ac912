/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: habits of people who sketch. Lines run past corners a little, some long lines are drawn twice, faint
 * construction lines carry long lines on and mark the axes of circles. Each is an option, and all are off by default. Only
 * lines of the drawing itself are touched: no hatching, no lettering, nothing short.
 *
 * All amounts are chosen by eye. Random numbers go by the seed and the shape of the stroke.
 */
#include "plan/habits/habits.h"

#include "base/number/random.h"
#include "plan/strokes/passes.h"

#include <math.h>

/* Past a corner: of the length asked for this share at most, and of the stroke's; one corner in so many is met exactly.
 * The end where a line begins is passed by less. */
#define OVERSHOOT_SPREAD 0.6
#define OVERSHOOT_OF_STROKE 0.1
#define OVERSHOOT_NONE 0.2
#define OVERSHOOT_AT_BEGIN 0.6

/* A line drawn twice: lines from so long on; how far beside it the second one lies at its ends and how far it starts and
 * ends elsewhere, mm; how light it is. */
#define RESTATE_LONG_MM 25.0
#define RESTATE_BESIDE_MM 0.45
#define RESTATE_ALONG_MM 1.8
#define RESTATE_PRESSURE 0.75f
/* Neither strays farther than this: the second is drawn with an eye on the first. */
#define RESTATED_DEVIATION_MM 0.7f

typedef struct {
    stroke_list *list;
    const plan_options *o;
    ARRAY(point) copy;
} habits;

static uint64_t key_of(const habits *h, const stroke *s)
{
    uint64_t hash = s->n;
    for (size_t i = s->first; i < s->first + s->n; i++)
        hash = random_fold(hash, llround(h->list->points.v[i].x * 1000), llround(h->list->points.v[i].y * 1000));
    return random_key(h->o->seed, hash, PURPOSE_HABIT);
}

static double between(uint64_t key, uint64_t index, double low, double high)
{
    return low + (high - low) * random_unit(key, index);
}

/* ---- past corners ---- */

/* Moves the end *at outward, away from `next`. */
static void pass_corner(point *at, point next, double by)
{
    double l = plb_point_distance(*at, next);
    *at = point_mix(next, *at, (l + by) / l);
}

static void overshoot(habits *h, stroke *s)
{
    uint64_t key = key_of(h, s);
    double most = fmin(h->o->overshoot, OVERSHOOT_OF_STROKE * plb_stroke_length(h->list, s));
    point *v = h->list->points.v + s->first;
    if (s->corner_first && random_unit(key, 0) > OVERSHOOT_NONE) {
        pass_corner(&v[0], v[1], OVERSHOOT_AT_BEGIN * most * between(key, 1, 1 - OVERSHOOT_SPREAD, 1));
        s->corner_first = false;
    }
    if (s->corner_last && random_unit(key, 2) > OVERSHOOT_NONE) {
        pass_corner(&v[s->n - 1], v[s->n - 2], most * between(key, 3, 1 - OVERSHOOT_SPREAD, 1));
        s->corner_last = false;
    }
}

/* ---- drawn twice ---- */

static point aside(uint64_t key, uint64_t index, double most)
{
    double angle = between(key, index, 0, 2 * PLB_PI), by = between(key, index + 1, 0.4, 1) * most;
    return (point){by * cos(angle), by * sin(angle)};
}

/* Both stay together. The list may move while it grows: `i` is the number of the line. */
static bool restate(habits *h, size_t i)
{
    stroke *s = &h->list->strokes.v[i];
    uint64_t key = key_of(h, s);
    if (random_unit(key, 10) >= h->o->restate || plb_stroke_length(h->list, s) < RESTATE_LONG_MM)
        return true;
    stroke again = *s;
    again.corner_first = again.corner_last = false;
    again.style.pressure *= RESTATE_PRESSURE;
    again.max_deviation = s->max_deviation = s->max_deviation > 0 ? fminf(s->max_deviation, RESTATED_DEVIATION_MM) : RESTATED_DEVIATION_MM;
    h->copy.n = 0;
    if (!array_reserve(&h->copy, s->n))
        return false;
    point first = aside(key, 11, RESTATE_BESIDE_MM), last = s->closed ? first : aside(key, 13, RESTATE_BESIDE_MM);
    for (size_t k = 0; k < s->n; k++) {
        point by = point_mix(first, last, (double)k / (double)(s->n - 1));
        h->copy.v[h->copy.n++] = point_add(h->list->points.v[s->first + k], by);
    }
    if (!s->closed) {
        pass_corner(&h->copy.v[0], h->copy.v[1], between(key, 15, -RESTATE_ALONG_MM, RESTATE_ALONG_MM / 2));
        pass_corner(&h->copy.v[s->n - 1], h->copy.v[s->n - 2], between(key, 16, -RESTATE_ALONG_MM, RESTATE_ALONG_MM / 2));
    }
    return plb_plan_append(h->list, &again, h->copy.v, h->copy.n);
}

static bool change_strokes(habits *h)
{
    bool ok = true;
    for (size_t i = 0, n = h->list->strokes.n; ok && i < n; i++) {
        if (h->list->strokes.v[i].style.kind != STROKE_LINE)
            continue;
        if (h->o->restate > 0)
            ok = restate(h, i);
        if (ok && h->o->overshoot > 0 && !h->list->strokes.v[i].closed)
            overshoot(h, &h->list->strokes.v[i]);
    }
    return ok;
}

bool plb_plan_habits(stroke_list *list, const plan_options *o, error *err)
{
    habits h = {.list = list, .o = o};
    bool ok = list->strokes.n <= PLAN_MAX_STROKES && (!o->construction || plb_plan_guides(list, o));
    ok = ok && change_strokes(&h);
    array_free(&h.copy);
    return ok || plb_fail_memory(err);
}
