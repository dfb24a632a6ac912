/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: lines along a ruler. A draughtsman rules the long lines of a frame and draws the short ones freely.
 * Input: strokes, mm, and how far each may deviate. Output: how far ruled ones may; and the passes of one wide line, a company, all as far
 * as the one of them that must keep closest.
 */
#include "plan/habits/habits.h"

#include "base/number/random.h"

#include <math.h>
#include <stdlib.h>

/* Where the drawing decides, lines are ruled from this length on, mm, and from this part of the page's longer side on, if they lie level or
 * upright within this angle (chosen by eye: frames, axes, long walls). */
#define LONG_MM 50.0
#define LONG_OF_PAGE 0.2
#define LEVEL_DEGREES 1.0
/* A ruled line keeps within this part of its length (ruled lines of two writers of hdBPMN: .2 to .4 %), at most this far, mm. */
#define RULED_OF_LENGTH 0.0025
#define RULED_MM 0.35

typedef struct {
    uint64_t company;
    size_t stroke;
} member;
typedef ARRAY(member) members;

static bool is_level_or_upright(point way, double length)
{
    return fmin(fabs(way.x), fabs(way.y)) <= sin(LEVEL_DEGREES * PLB_PI / 180) * length;
}

static void narrow(stroke *s, float limit)
{
    s->max_deviation = s->max_deviation > 0 ? fminf(s->max_deviation, limit) : limit;
}

static void rule(const stroke_list *list, const plan_options *o, stroke *s)
{
    const point *v = list->points.v + s->first;
    if (s->n != 2 || s->style.kind != STROKE_LINE)
        return;
    point way = point_sub(v[1], v[0]);
    double length = plb_point_length(way), least = fmax(LONG_MM, LONG_OF_PAGE * fmax(list->width, list->height));
    if (o->ruler == RULER_ALL || (length >= least && is_level_or_upright(way, length)))
        narrow(s, (float)fmin(RULED_OF_LENGTH * length, RULED_MM));
}

static int compare(const void *a, const void *b)
{
    const member *x = a, *y = b;
    return x->company != y->company ? (x->company > y->company) - (x->company < y->company) : (x->stroke > y->stroke) - (x->stroke < y->stroke);
}

/* Lets each company deviate as far as its most careful member. */
static void agree(stroke_list *list, members *all)
{
    if (all->n)
        qsort(all->v, all->n, sizeof *all->v, compare);
    for (size_t i = 0, end; i < all->n; i = end) {
        float least = 0;
        for (end = i; end < all->n && all->v[end].company == all->v[i].company; end++) {
            float own = list->strokes.v[all->v[end].stroke].max_deviation;
            least = own > 0 && (least == 0 || own < least) ? own : least;
        }
        for (size_t k = i; k < end; k++)
            list->strokes.v[all->v[k].stroke].max_deviation = least;
    }
}

bool plb_plan_ruler(stroke_list *list, const plan_options *o, error *err)
{
    members all = {0};
    bool ok = true;
    for (size_t i = 0; ok && i < list->strokes.n; i++) {
        stroke *s = &list->strokes.v[i];
        if (o->ruler != RULER_NONE)
            rule(list, o, s);
        ok = !s->style.company || array_push(&all, ((member){s->style.company, i}));
    }
    if (ok)
        agree(list, &all);
    array_free(&all);
    return ok || plb_fail_memory(err);
}
