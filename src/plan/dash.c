/* SPDX-License-Identifier: MIT
 *
 * Plan, step 3: dashes. Each dash becomes a track, so that it becomes a stroke of its own.
 */
#include "plan/track.h"

#include <math.h>

/* A pattern finer than this is drawn as a solid line: no pencil makes such dashes (the point is wider; chosen by eye). */
#define SHORTEST_PERIOD_MM 0.25
/* More dashes than this in one track are drawn solid too. */
#define MOST_DASHES 200000.0
/* A dash without length, as dotted lines with round caps have it, is a touch of the point. */
#define TOUCH_MM 0.12

static double period_of(const item *it)
{
    double sum = 0;
    for (size_t k = 0; k < it->dash.n; k++) {
        if (!(it->dash.v[k] >= 0))
            return 0;
        sum += it->dash.v[k];
    }
    return sum;
}

/* A walk along the dash pattern. */
typedef struct {
    const item *it;
    size_t k;    /* the entry that is running; even: on */
    double left; /* mm of it still to go */
} pattern;

static void advance(pattern *p)
{
    do {
        p->k = (p->k + 1) % p->it->dash.n;
        p->left = p->it->dash.v[p->k];
    } while (p->left <= 0 && (p->k & 1)); /* a gap of nothing is no gap */
}

static pattern pattern_at(const item *it, double where, double period)
{
    pattern p = {it, 0, it->dash.v[0]};
    double phase = fmod(where, period);
    if (phase < 0)
        phase += period;
    while (phase >= p.left && phase > 0) {
        phase -= p.left;
        p.k = (p.k + 1) % it->dash.n;
        p.left = it->dash.v[p.k];
    }
    p.left -= phase;
    return p;
}

static bool push(track *dash, point at, bool corner, error *err)
{
    size_t n = dash->points.n;
    if (n && plb_point_distance(dash->points.v[n - 1].at, at) < SAME_POINT_MM)
        return true;
    track_point p = {at, corner && n > 0};
    return array_push(&dash->points, p) || plb_fail_memory(err);
}

/* Ends the dash that is being built; one without length is given that of a touch, along `direction`. */
static bool flush(track *dash, point direction, track_sink sink, void *closure, error *err)
{
    bool ok = true;
    if (dash->points.n == 1) {
        point at = dash->points.v[0].at;
        double length = plb_point_length(direction);
        point along = length > 0 ? point_scale(direction, TOUCH_MM / length) : (point){TOUCH_MM, 0};
        dash->points.n = 0;
        ok = push(dash, point_sub(at, point_scale(along, .5)), false, err) && push(dash, point_add(at, point_scale(along, .5)), false, err);
    }
    if (ok && dash->points.n) {
        dash->points.v[dash->points.n - 1].corner = false;
        ok = sink(closure, dash);
    }
    dash->points.n = 0;
    return ok;
}

/* One straight piece of the track. */
static bool walk(pattern *p, track *dash, track_point from, track_point to, track_sink sink, void *closure, error *err)
{
    double length = plb_point_distance(from.at, to.at), done = 0;
    point direction = point_sub(to.at, from.at);
    while (done + p->left < length) {
        done += p->left;
        point here = point_mix(from.at, to.at, done / length);
        bool on = !(p->k & 1);
        if (on && (!push(dash, here, false, err) || !flush(dash, direction, sink, closure, err)))
            return false;
        advance(p);
        if (!(p->k & 1) && !push(dash, here, false, err))
            return false;
        if (p->left <= 0) { /* a dash of no length: a dot */
            if (!flush(dash, direction, sink, closure, err))
                return false;
            advance(p);
        }
    }
    p->left -= length - done;
    return (p->k & 1) || push(dash, to.at, to.corner, err);
}

bool plb_plan_dash(const item *it, const track *t, track_sink sink, void *closure, error *err)
{
    double period = it->kind == ITEM_STROKE && it->dash.n ? period_of(it) : 0;
    bool has_gap = false;
    for (size_t k = 1; k < it->dash.n; k += 2)
        has_gap = has_gap || it->dash.v[k] > 0;
    if (!has_gap || !(period >= SHORTEST_PERIOD_MM) || t->points.n < 2 || plb_track_length(t) / period > MOST_DASHES)
        return sink(closure, t);
    pattern p = pattern_at(it, t->start + it->dash_offset, period);
    track dash = {.touch = t->touch};
    bool ok = (p.k & 1) || push(&dash, t->points.v[0].at, false, err);
    for (size_t i = 1; ok && i < t->points.n; i++)
        ok = walk(&p, &dash, t->points.v[i - 1], t->points.v[i], sink, closure, err);
    ok = ok && flush(&dash, (point){0, 0}, sink, closure, err);
    array_free(&dash.points);
    return ok;
}
