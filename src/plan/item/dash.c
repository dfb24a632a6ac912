/* SPDX-License-Identifier: MIT
 *
 * Plan, step 3: dashes. Each dash becomes a track, so that it becomes a stroke of its own; as a hand does not measure,
 * none is quite as long as the other.
 */
#include "plan/item/dash.h"

#include "base/number/random.h"

#include <math.h>

/* A pattern whose period is shorter than so many widths of the pencil's line is drawn larger, by a whole number: no
 * pencil makes dashes finer than its point (chosen by eye). */
#define SHORTEST_PERIOD_WIDTHS 1.6
/* More dashes than this in one track are drawn solid. */
#define MAX_DASHES 200000.0
/* A shorter dash, such as dotted lines have them, is a touch of the point. */
#define TOUCH_MM 0.12
/* A hand's dash ends this part of the shorter of dash and gap before or after its place, but at most that far away
 * (chosen by eye). */
#define UNEVEN 0.15
#define MAX_STRAY_MM 0.5

/* A walk along the dash pattern. */
typedef struct {
    const item *it;
    double factor; /* of the pattern's lengths */
    uint64_t key;  /* of its unevenness */
    double index;  /* of the entry that is running, counted from the start of the line */
    size_t k;      /* the same within the pattern; even: on */
    double left;   /* mm of it still to go */
} pattern;

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

static double length_of(const pattern *p, size_t k)
{
    return p->it->dash.v[k % p->it->dash.n] * p->factor;
}

/* How far from its place the running entry ends. */
static double stray(const pattern *p)
{
    double room = fmin(length_of(p, p->k), length_of(p, p->k + 1)) * UNEVEN;
    return fmin(room, MAX_STRAY_MM) * (2 * random_unit(p->key, (uint64_t)(int64_t)p->index) - 1);
}

static void advance(pattern *p)
{
    do {
        double late = stray(p);
        p->k = (p->k + 1) % p->it->dash.n;
        p->index++;
        p->left = length_of(p, p->k) + stray(p) - late;
    } while (p->left <= 0 && (p->k & 1)); /* a gap of nothing is no gap */
}

/* Sets the walk at `where` mm from the start of the pattern. */
static void set_at(pattern *p, double where, double period)
{
    double phase = fmod(where, period);
    if (phase < 0)
        phase += period;
    p->index = fmod(round((where - phase) / period), 1e9) * (double)p->it->dash.n;
    p->k = 0;
    p->left = length_of(p, 0);
    while (phase >= p->left && phase > 0) {
        phase -= p->left;
        p->k = (p->k + 1) % p->it->dash.n;
        p->index++;
        p->left = length_of(p, p->k);
    }
    p->left = fmax(p->left - phase + stray(p), 0);
}

static bool push(track *dash, point at, bool corner, error *err)
{
    size_t n = dash->points.n;
    if (n && plb_point_distance(dash->points.v[n - 1].at, at) < SAME_POINT_MM)
        return true;
    track_point p = {at, corner && n > 0};
    return array_push(&dash->points, p) || plb_fail_memory(err);
}

/* A dash too short for the hand becomes a touch about its middle, along `direction`. */
static bool lengthen(track *dash, point direction, error *err)
{
    point a = dash->points.v[0].at, b = dash->points.v[dash->points.n - 1].at, middle = point_mix(a, b, .5);
    double length = plb_point_length(direction);
    point half = length > 0 ? point_scale(direction, TOUCH_MM / 2 / length) : (point){TOUCH_MM / 2, 0};
    dash->points.n = 0;
    return push(dash, point_sub(middle, half), false, err) && push(dash, point_add(middle, half), false, err);
}

/* Ends the dash that is being built. */
static bool flush(track *dash, point direction, track_sink sink, void *closure, error *err)
{
    bool ok = true;
    if (dash->points.n && plb_track_length(dash) < TOUCH_MM)
        ok = lengthen(dash, direction, err);
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
        bool on = !(p->k & 1), is_nothing = on && length_of(p, p->k) == 0 && p->it->cap == LINE_CAP_BUTT;
        if (on && !push(dash, here, false, err))
            return false;
        if (is_nothing) /* a dot without caps */
            dash->points.n = 0;
        if (on && !flush(dash, direction, sink, closure, err))
            return false;
        advance(p);
        if (!(p->k & 1) && !push(dash, here, false, err))
            return false;
    }
    p->left -= length - done;
    return (p->k & 1) || push(dash, to.at, to.corner, err);
}

static uint64_t hash_track(const track *t)
{
    point a = t->points.v[0].at, b = t->points.v[t->points.n - 1].at;
    uint64_t h = random_fold(1, llround(a.x * 1000), llround(a.y * 1000));
    return random_fold(h, llround(b.x * 1000), llround(b.y * 1000));
}

static bool has_gaps(const item *it)
{
    for (size_t k = 1; k < it->dash.n; k += 2)
        if (it->dash.v[k] > 0)
            return true;
    return false;
}

bool plb_plan_dash(const item *it, const track *t, const plan_options *o, track_sink sink, void *closure, error *err)
{
    double period = it->kind == ITEM_STROKE && has_gaps(it) ? period_of(it) : 0;
    double factor = period > 0 ? fmax(1, ceil(SHORTEST_PERIOD_WIDTHS * o->pencil_width / period)) : 0;
    period *= factor;
    if (!(period > 0 && period < 1e9) || t->points.n < 2 || plb_track_length(t) / period > MAX_DASHES)
        return sink(closure, t);
    pattern p = {.it = it, .factor = factor, .key = random_key(o->seed, hash_track(t), PURPOSE_DASH)};
    set_at(&p, t->start + it->dash_offset * factor, period);
    track dash = {.style = t->style};
    bool ok = (p.k & 1) || push(&dash, t->points.v[0].at, false, err);
    for (size_t i = 1; ok && i < t->points.n; i++)
        ok = walk(&p, &dash, t->points.v[i - 1], t->points.v[i], sink, closure, err);
    point last = point_sub(t->points.v[t->points.n - 1].at, t->points.v[t->points.n - 2].at);
    ok = ok && flush(&dash, last, sink, closure, err);
    array_free(&dash.points);
    return ok;
}
