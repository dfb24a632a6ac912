/* SPDX-License-Identifier: MIT
 *
 * Plan, step 1: paths become polylines; see flatten.h. Where the path itself has a corner it is marked; the vertices that
 * flattening puts into a curve never are.
 */
#include "plan/shape/flatten.h"

#include <math.h>

typedef struct {
    track_list *out;
    size_t n;            /* points of the subpath so far; 0: none is begun */
    point start;         /* of the subpath */
    point first_tangent; /* leaving the start; zero until known */
    point last_tangent;  /* arriving at the last point */
    bool close_all;
    error *err;
} flattener;

static point last_point(const flattener *f)
{
    return f->out->points.v[f->out->points.n - 1].at;
}

static bool is_zero(point v)
{
    return v.x == 0 && v.y == 0;
}

static bool turns_sharply(point in, point out)
{
    if (is_zero(in) || is_zero(out))
        return false;
    double lengths = plb_point_length(in) * plb_point_length(out);
    return point_dot(in, out) < cos(CORNER_DEGREES * PLB_PI / 180) * lengths;
}

static bool add_point(flattener *f, point to)
{
    bool ok = (f->n || plb_track_begin(f->out, &(track){.style = STROKE_STYLE_USUAL})) && plb_track_push(f->out, to, false);
    f->n = ok ? track_last(f->out)->n : 0;
    return ok || plb_fail_memory(f->err);
}

/* Marks a corner at the last point if the piece that leaves that point along `out` turns sharply. */
static void join(flattener *f, point out)
{
    if (is_zero(out))
        return;
    if (is_zero(f->first_tangent))
        f->first_tangent = out;
    else if (turns_sharply(f->last_tangent, out))
        f->out->points.v[f->out->points.n - 1].corner = true;
}

static bool add_line(flattener *f, point to)
{
    point from = last_point(f);
    if (plb_point_distance(from, to) < SAME_POINT_MM)
        return true;
    point along = point_sub(to, from);
    join(f, along);
    f->last_tangent = along;
    return add_point(f, to);
}

/* Tells how far the three legs of a control polygon turn altogether, radians. */
static double total_turn(point a, point b, point c)
{
    double first = is_zero(a) || is_zero(b) ? 0 : fabs(atan2(point_cross(a, b), point_dot(a, b)));
    double second = is_zero(b) || is_zero(c) ? 0 : fabs(atan2(point_cross(b, c), point_dot(b, c)));
    return first + second;
}

/* The chord error of n equal steps of a cubic is at most (3/4) max|second difference| / n^2 (de Boor). */
static int steps_of_curve(point p0, point c1, point c2, point p3)
{
    point d1 = {p0.x - 2 * c1.x + c2.x, p0.y - 2 * c1.y + c2.y};
    point d2 = {c1.x - 2 * c2.x + p3.x, c1.y - 2 * c2.y + p3.y};
    double bend = fmax(plb_point_length(d1), plb_point_length(d2));
    double by_error = sqrt(0.75 * bend / FLATNESS_MM);
    double turn = total_turn(point_sub(c1, p0), point_sub(c2, c1), point_sub(p3, c2));
    double by_turn = bend < FLATNESS_MM / 8 ? 1 : turn / (FLAT_TURN_DEGREES * PLB_PI / 180);
    double n = ceil(fmax(by_error, by_turn));
    return n < 1 ? 1 : n > 2000 ? 2000 : (int)n;
}

static point first_nonzero(point a, point b, point c)
{
    double least = SAME_POINT_MM;
    return plb_point_length(a) > least ? a : plb_point_length(b) > least ? b : c;
}

static bool add_curve(flattener *f, point c1, point c2, point to)
{
    point from = last_point(f);
    point a = point_sub(c1, from), b = point_sub(c2, c1), c = point_sub(to, c2);
    if (plb_point_length(a) + plb_point_length(b) + plb_point_length(c) < SAME_POINT_MM)
        return true;
    join(f, first_nonzero(a, b, c));
    f->last_tangent = first_nonzero(c, b, a);
    int n = steps_of_curve(from, c1, c2, to);
    for (int i = 1; i <= n; i++) {
        double t = (double)i / n, s = 1 - t;
        double w0 = s * s * s, w1 = 3 * s * s * t, w2 = 3 * s * t * t, w3 = t * t * t;
        point at = {w0 * from.x + w1 * c1.x + w2 * c2.x + w3 * to.x, w0 * from.y + w1 * c1.y + w2 * c2.y + w3 * to.y};
        if (!add_point(f, i == n ? to : at))
            return false;
    }
    return true;
}

static bool finish(flattener *f, bool close)
{
    if (f->n == 0)
        return true;
    bool ok = !(close || f->close_all) || add_line(f, f->start);
    track *t = track_last(f->out);
    track_point *v = track_last_points(f->out);
    t->closed = t->n > 2 && plb_point_distance(v[0].at, v[t->n - 1].at) < SAME_POINT_MM;
    if (t->closed) {
        v[t->n - 1].at = v[0].at;
        v[0].corner = v[t->n - 1].corner = turns_sharply(f->last_tangent, f->first_tangent);
    }
    f->n = 0;
    f->first_tangent = f->last_tangent = (point){0, 0};
    return ok;
}

static bool begin(flattener *f, point at)
{
    f->start = at;
    return add_point(f, at);
}

bool plb_plan_flatten(const path *p, bool close, track_list *out, error *err)
{
    flattener f = {.out = out, .close_all = close, .err = err};
    const point *at = p->points.v;
    bool ok = true;
    for (size_t i = 0; ok && i < p->ops.n; i++) {
        if (p->ops.v[i] != PATH_MOVE && f.n == 0)
            ok = begin(&f, f.start); /* drawing goes on after a close */
        switch (ok ? p->ops.v[i] : PATH_CLOSE + 1) {
        case PATH_MOVE: ok = finish(&f, false) && begin(&f, at[0]); at += 1; break;
        case PATH_LINE: ok = add_line(&f, at[0]); at += 1; break;
        case PATH_CURVE: ok = add_curve(&f, at[0], at[1], at[2]); at += 3; break;
        case PATH_CLOSE: ok = finish(&f, true); break;
        default: break;
        }
    }
    bool trailing_move = p->ops.n && p->ops.v[p->ops.n - 1] == PATH_MOVE;
    if (ok && trailing_move && f.n)
        plb_track_drop(out); /* a move that nothing follows draws nothing */
    return ok && (trailing_move || finish(&f, false));
}
