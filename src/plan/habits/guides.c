/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: construction lines. Before a draughtsman draws he sets out the long lines, faintly and beyond both
 * ends, once for all that lie on one line, and the two axes of each circle.
 *
 * All amounts are chosen by eye.
 */
#include "base/number/random.h"
#include "plan/habits/habits.h"
#include "plan/strokes/passes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Lines get a guide from this share of the page's longer side on, and from this length on, mm. */
#define LONG_OF_PAGE 0.12
#define LONG_MM 20.0
/* Beyond each end a guide goes on by this share of its length, within these bounds, more or less. */
#define BEYOND_SHARE 0.12
#define BEYOND_MIN_MM 4.0
#define BEYOND_MAX_MM 18.0
#define BEYOND_SPREAD 0.4
/* Lines whose directions differ by less than about the first and that lie beside each other by less than the second are on
 * one line. */
#define SAME_DIRECTION_DEGREES 0.5
#define SAME_LINE_MM 0.4
/* A closed curve is a circle when its box is square and its length that of a circle, both within this share. */
#define CIRCLE_WITHIN 0.06
#define CIRCLE_MIN_MM 12.0
/* A guide hardly touches the paper: its pressure. */
#define GUIDE_PRESSURE 0.35f
/* A guide is drawn with care, and the line on it follows it: so far they stray, mm. */
#define GUIDE_DEVIATION_MM 0.4f
#define GUIDED_DEVIATION_MM 0.6f

/* A stretch of a line in its normal form: the direction and the distance from the origin in steps, and from where to where. */
typedef struct {
    int64_t direction, distance;
    double angle, from, to, off;
} stretch;
typedef ARRAY(stretch) stretches;

static stretch stretch_of(point a, point b)
{
    point way = point_sub(b, a);
    if (way.x < 0 || (way.x == 0 && way.y < 0))
        way = point_scale(way, -1);
    double angle = atan2(way.y, way.x), c = cos(angle), s = sin(angle);
    double ta = a.x * c + a.y * s, tb = b.x * c + b.y * s, off = a.y * c - a.x * s;
    return (stretch){llround(angle * 180 / PLB_PI / SAME_DIRECTION_DEGREES), llround(off / SAME_LINE_MM), angle, fmin(ta, tb), fmax(ta, tb), off};
}

static int compare(const void *a, const void *b)
{
    const stretch *x = a, *y = b;
    if (x->direction != y->direction)
        return x->direction < y->direction ? -1 : 1;
    if (x->distance != y->distance)
        return x->distance < y->distance ? -1 : 1;
    return (x->from > y->from) - (x->from < y->from);
}

/* Narrows [*low, *high] to where at + t by lies in [0, most]. */
static void narrow(double at, double by, double most, double *low, double *high)
{
    if (fabs(by) < 1e-12)
        return;
    double t0 = -at / by, t1 = (most - at) / by;
    *low = fmax(*low, fmin(t0, t1));
    *high = fmin(*high, fmax(t0, t1));
}

/* Draws the guide along a stretch, beyond both its ends but not beyond the page. */
static bool draw(stroke_list *list, const plan_options *o, const stretch *s, double beyond)
{
    uint64_t hash = random_fold(1, llround(s->off * 1000), llround(s->angle * 1e6));
    uint64_t key = random_key(o->seed, random_fold(hash, llround(s->from * 1000), llround(s->to * 1000)), PURPOSE_HABIT);
    double c = cos(s->angle), n = sin(s->angle), low = -1e300, high = 1e300;
    narrow(-s->off * n, c, list->width, &low, &high);
    narrow(s->off * c, n, list->height, &low, &high);
    low = fmax(low, s->from - beyond * (1 + BEYOND_SPREAD * (2 * random_unit(key, 0) - 1)));
    high = fmin(high, s->to + beyond * (1 + BEYOND_SPREAD * (2 * random_unit(key, 1) - 1)));
    point ends[2] = {{low * c - s->off * n, low * n + s->off * c}, {high * c - s->off * n, high * n + s->off * c}};
    stroke guide = {.style = {.pressure = GUIDE_PRESSURE, .kind = STROKE_GUIDE}, .max_deviation = GUIDE_DEVIATION_MM};
    return high - low < 1 || plb_plan_append(list, &guide, ends, 2);
}

static double beyond_of(double length)
{
    return fmin(fmax(BEYOND_SHARE * length, BEYOND_MIN_MM), BEYOND_MAX_MM);
}

/* Stretches on one line that meet, or nearly, have one guide. */
static bool draw_lines(stroke_list *list, const plan_options *o, const stretches *s)
{
    bool ok = true;
    for (size_t i = 0; ok && i < s->n;) {
        stretch whole = s->v[i++];
        while (i < s->n && s->v[i].direction == whole.direction && s->v[i].distance == whole.distance &&
               s->v[i].from < whole.to + 2 * BEYOND_MAX_MM) {
            whole.to = fmax(whole.to, s->v[i].to);
            i++;
        }
        ok = draw(list, o, &whole, beyond_of(whole.to - whole.from));
    }
    return ok;
}

static bool is_circle(const stroke_list *list, const stroke *s, point *centre, double *diameter)
{
    box b = BOX_EMPTY;
    double length = 0;
    for (size_t i = s->first; i < s->first + s->n; i++) {
        plb_box_add(&b, list->points.v[i]);
        if (i > s->first)
            length += plb_point_distance(list->points.v[i - 1], list->points.v[i]);
    }
    double w = b.x1 - b.x0, h = b.y1 - b.y0;
    *centre = (point){(b.x0 + b.x1) / 2, (b.y0 + b.y1) / 2};
    *diameter = (w + h) / 2;
    return s->closed && *diameter >= CIRCLE_MIN_MM && fabs(w - h) < CIRCLE_WITHIN * *diameter &&
           fabs(length - PLB_PI * *diameter) < CIRCLE_WITHIN * length;
}

static bool draw_axes(stroke_list *list, const plan_options *o, point centre, double diameter)
{
    double r = diameter / 2;
    stretch level = stretch_of((point){centre.x - r, centre.y}, (point){centre.x + r, centre.y});
    stretch upright = stretch_of((point){centre.x, centre.y - r}, (point){centre.x, centre.y + r});
    double beyond = fmin(beyond_of(diameter), 0.3 * diameter);
    return draw(list, o, &level, beyond) && draw(list, o, &upright, beyond);
}

bool plb_plan_guides(stroke_list *list, const plan_options *o)
{
    stretches lines = {0};
    double least = fmax(LONG_MM, LONG_OF_PAGE * fmax(list->width, list->height));
    bool ok = true;
    for (size_t i = 0, n = list->strokes.n; ok && i < n; i++) {
        stroke s = list->strokes.v[i];
        const point *v = list->points.v + s.first;
        point centre;
        double diameter;
        if (s.style.kind != STROKE_LINE)
            continue;
        if (s.n == 2 && plb_point_distance(v[0], v[1]) >= least) {
            ok = array_push(&lines, stretch_of(v[0], v[1]));
            list->strokes.v[i].max_deviation = s.max_deviation > 0 ? fminf(s.max_deviation, GUIDED_DEVIATION_MM) : GUIDED_DEVIATION_MM;
        } else if (is_circle(list, &s, &centre, &diameter))
            ok = draw_axes(list, o, centre, diameter);
    }
    if (lines.n)
        qsort(lines.v, lines.n, sizeof *lines.v, compare);
    ok = ok && draw_lines(list, o, &lines);
    array_free(&lines);
    return ok;
}
