/* SPDX-License-Identifier: MIT
 *
 * This file finds a gradient's colour at a place (SVG 2, section 14; cairo's definition of two-circle gradients).
 */
#include "list/display_list.h"

#include <math.h>
#include <string.h>

/* Gives the place along a linear gradient: the projection onto its axis. False when it has no axis. */
static bool linear_offset(const gradient *g, point p, double *t)
{
    point axis = point_sub(g->to, g->from);
    double length2 = point_dot(axis, axis);
    *t = point_dot(point_sub(p, g->from), axis) / length2;
    return length2 > 0;
}

/* Gives the larger t whose circle, of radius not below 0, passes through `p`. False when there is none. */
static bool radial_offset(const gradient *g, point p, double *t)
{
    point axis = point_sub(g->to, g->from), q = point_sub(p, g->from);
    double grow = g->to_radius - g->from_radius, r0 = g->from_radius;
    double a = point_dot(axis, axis) - grow * grow, b = point_dot(q, axis) + r0 * grow, c = point_dot(q, q) - r0 * r0;
    if (fabs(a) < 1e-12 * (point_dot(axis, axis) + grow * grow)) {
        *t = c / (2 * b);
        return b != 0 && r0 + *t * grow >= 0;
    }
    double root = b * b - a * c;
    if (!(root >= 0))
        return false;
    root = sqrt(root);
    double one = (b + root) / a, other = (b - root) / a;
    *t = fmax(one, other);
    if (r0 + *t * grow < 0)
        *t = fmin(one, other);
    return r0 + *t * grow >= 0;
}

static bool extend(gradient_extend extension, double *t)
{
    if (*t >= 0 && *t <= 1)
        return true;
    if (extension == GRADIENT_REPEAT)
        *t -= floor(*t);
    if (extension == GRADIENT_REFLECT)
        *t = fabs(*t - 2 * floor(*t / 2 + 0.5));
    *t = fmin(fmax(*t, 0), 1);
    return extension != GRADIENT_ENDS;
}

static paint mix(const gradient_stop *a, const gradient_stop *b, double t)
{
    double k = b->offset > a->offset ? (t - a->offset) / (b->offset - a->offset) : 1;
    return (paint){.kind = PAINT_SOLID, .red = a->red + (b->red - a->red) * k, .green = a->green + (b->green - a->green) * k,
                   .blue = a->blue + (b->blue - a->blue) * k, .alpha = a->alpha + (b->alpha - a->alpha) * k};
}

paint plb_gradient_at(const gradient *g, point mm)
{
    double t = 0;
    point p = plb_matrix_apply(g->to_space, mm);
    bool there = (g->radial ? radial_offset : linear_offset)(g, p, &t) && isfinite(t) && extend(g->extend, &t) && g->n;
    if (!there)
        return (paint){.kind = PAINT_SOLID};
    unsigned i = 0;
    while (i < g->n && g->stops[i].offset <= t)
        i++;
    paint at = mix(&g->stops[i ? i - 1 : 0], &g->stops[i < g->n ? i : g->n - 1], t);
    at.alpha *= g->opacity;
    return at;
}

static bool same_colour(const gradient_stop *a, const gradient_stop *b)
{
    return a->red == b->red && a->green == b->green && a->blue == b->blue && a->alpha == b->alpha;
}

/* Tells how much is lost without stop i: how far its colour lies from what its neighbours would make there, times the stretch between
 * them, as Visvalingam & Whyatt (1993) weigh the corners of a line. Infinite for the ends and for a step of colour. */
static double loss_without(const gradient *g, unsigned i)
{
    if (i == 0 || i + 1 >= g->n)
        return INFINITY;
    const gradient_stop *a = &g->stops[i - 1], *s = &g->stops[i], *b = &g->stops[i + 1];
    if (s->offset == a->offset || s->offset == b->offset)
        return same_colour(s, s->offset == a->offset ? a : b) ? 0 : INFINITY;
    paint p = mix(a, b, s->offset);
    double apart = fabs(p.red - s->red) + fabs(p.green - s->green) + fabs(p.blue - s->blue) + fabs(p.alpha - s->alpha);
    return apart * (b->offset - a->offset);
}

void plb_gradient_add_stop(gradient *g, gradient_stop stop)
{
    if (g->n && stop.offset < g->stops[g->n - 1].offset) /* SVG: a stop is never before the one in front of it */
        stop.offset = g->stops[g->n - 1].offset;
    if (g->n == GRADIENT_MAX_STOPS) {
        unsigned least = GRADIENT_MAX_STOPS - 1;
        for (unsigned i = 1; i + 1 < g->n; i++)
            least = loss_without(g, i) < loss_without(g, least) ? i : least;
        memmove(&g->stops[least], &g->stops[least + 1], (g->n - 1 - least) * sizeof *g->stops);
        g->n--;
    }
    g->stops[g->n++] = stop;
}

bool plb_gradient_is_opaque(const gradient *g, double opacity)
{
    bool all = g->n && g->extend != GRADIENT_ENDS;
    for (unsigned i = 0; all && i < g->n; i++)
        all = g->stops[i].alpha * g->opacity >= opacity;
    return all;
}

static bool same_stop(const gradient_stop *a, const gradient_stop *b)
{
    return a->offset == b->offset && same_colour(a, b);
}

static bool same_point(point a, point b) { return a.x == b.x && a.y == b.y; }

static bool same_matrix(const matrix *a, const matrix *b)
{
    return a->xx == b->xx && a->yx == b->yx && a->xy == b->xy && a->yy == b->yy && a->x0 == b->x0 && a->y0 == b->y0;
}

/* Compares member by member, for the bytes between members may be anything. */
static bool same(const gradient *a, const gradient *b)
{
    bool all = a->radial == b->radial && a->extend == b->extend && a->n == b->n && a->opacity == b->opacity &&
               same_matrix(&a->to_space, &b->to_space) && same_point(a->from, b->from) && same_point(a->to, b->to) &&
               a->from_radius == b->from_radius && a->to_radius == b->to_radius;
    for (unsigned i = 0; all && i < a->n; i++)
        all = same_stop(&a->stops[i], &b->stops[i]);
    return all;
}

bool plb_list_append_gradient(display_list *list, const gradient *g, error *err)
{
    if (list->gradients.n >= LIST_MAX_GRADIENTS)
        return plb_fail(err, ERROR_LIMIT, "the drawing has more than %u gradients", LIST_MAX_GRADIENTS);
    return array_push(&list->gradients, *g) || plb_fail_memory(err);
}

bool plb_list_add_gradient(display_list *list, const gradient *g, unsigned *index, error *err)
{
    if (list->gradients.n && same(&list->gradients.v[list->gradients.n - 1], g)) {
        *index = (unsigned)list->gradients.n;
        return true;
    }
    if (!plb_list_append_gradient(list, g, err))
        return false;
    *index = (unsigned)list->gradients.n;
    return true;
}

const gradient *plb_item_gradient(const display_list *list, const item *it)
{
    return it->paint.kind == PAINT_GRADIENT && it->gradient ? &list->gradients.v[it->gradient - 1] : NULL;
}
