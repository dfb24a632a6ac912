/* SPDX-License-Identifier: MIT
 *
 * Plan, wide lines: as the point cannot be so broad, the pencil goes along several times, side by side: once on each
 * edge, and between them as close as the tone asks. No two passes lie at the same distance.
 */
#include "base/number/random.h"
#include "plan/item/wide.h"

#include <math.h>

/* Distance of passes that make the darkest tone, in widths of the pencil's line; paler ones go up to the inverse of
 * their darkness times that, but never farther than the second (chosen by eye). */
#define CLOSEST_WIDTHS 0.55
#define FARTHEST_WIDTHS 3.0
/* How far a pass strays from its place, as a part of their distance (chosen by eye). */
#define UNEVEN 0.2
/* The most passes of one line. */
#define MAX_PASSES 400

static point left_of(point a, point b)
{
    point d = point_sub(b, a);
    double length = plb_point_length(d);
    return length > 0 ? (point){d.y / length, -d.x / length} : (point){0, 0};
}

/* The point number k of `t` moved aside by `d`, in the mitre of its two segments. */
static point aside(const track *t, size_t k, double d)
{
    size_t n = t->points.n, last = n - 1;
    point at = t->points.v[k].at;
    size_t before = k > 0 ? k - 1 : t->closed ? last - 1 : 0, after = k < last ? k + 1 : t->closed ? 1 : last;
    point in = left_of(t->points.v[before].at, at), out = left_of(at, t->points.v[after].at);
    if (before == k)
        in = out;
    if (after == k)
        out = in;
    point sum = point_add(in, out);
    double squared = point_dot(sum, sum);
    return squared < 0.3 ? point_add(at, point_scale(in, d)) : point_add(at, point_scale(sum, 2 * d / squared));
}

/* Near a sharp bend the inner side runs backwards: such points are left out. */
static bool runs_forward(const track *t, size_t k, point from, point to)
{
    point along = point_sub(t->points.v[k].at, t->points.v[k - 1].at);
    return point_dot(along, point_sub(to, from)) > 0;
}

static bool push(track *pass, point at, bool corner)
{
    size_t n = pass->points.n;
    track_point p = {at, corner};
    return (n && plb_point_distance(pass->points.v[n - 1].at, at) < SAME_POINT_MM) || array_push(&pass->points, p);
}

/* Moves both ends outward by `more` mm. */
static void extend(track *pass, double more)
{
    size_t n = pass->points.n;
    if (n < 2 || more <= 0)
        return;
    track_point *v = pass->points.v;
    point first = left_of(v[1].at, v[0].at), last = left_of(v[n - 2].at, v[n - 1].at);
    v[0].at = point_add(v[0].at, (point){-first.y * more, first.x * more});
    v[n - 1].at = point_add(v[n - 1].at, (point){-last.y * more, last.x * more});
}

static bool build_pass(const track *t, double d, track *pass)
{
    size_t n = t->points.n;
    pass->points.n = 0;
    pass->closed = t->closed;
    bool ok = true;
    for (size_t k = 0; ok && k < n; k++) {
        point at = aside(t, k, d);
        size_t m = pass->points.n;
        if (m == 0 || k + 1 == n || runs_forward(t, k, pass->points.v[m - 1].at, at))
            ok = push(pass, at, t->points.v[k].corner);
    }
    if (ok && t->closed && pass->points.n)
        pass->points.v[pass->points.n - 1].at = pass->points.v[0].at;
    return ok;
}

/* How far the cap reaches beyond the end at distance `d` from the middle. */
static double cap_reach(const item *it, double radius, double d)
{
    if (it->cap == LINE_CAP_BUTT)
        return 0;
    return it->cap == LINE_CAP_SQUARE ? radius : sqrt(fmax(radius * radius - d * d, 0));
}

/* A track of one point is a dot; its passes go across the page. */
static track stretch_dot(const track *t, track_point ends[2])
{
    point at = t->points.v[0].at;
    ends[0] = (track_point){{at.x - SAME_POINT_MM, at.y}, false};
    ends[1] = (track_point){{at.x + SAME_POINT_MM, at.y}, false};
    return (track){.points = {ends, 2, 2}, .style = t->style};
}

static uint64_t hash_track(const track *t)
{
    uint64_t h = 0;
    for (size_t i = 0; i < t->points.n; i++)
        h = random_fold(h, llround(t->points.v[i].at.x * 1000), llround(t->points.v[i].at.y * 1000));
    return h;
}

bool plb_plan_passes(const item *it, const track *t, const plan_options *o, track_sink sink, void *closure, error *err)
{
    track_point ends[2];
    track centre = t->points.n == 1 ? stretch_dot(t, ends) : *t, pass = {.style = t->style};
    double room = it->width - o->pencil_width, dark = 1 - plb_paint_lightness(it->paint);
    double apart = o->pencil_width * fmin(CLOSEST_WIDTHS / fmax(dark, 0.01), FARTHEST_WIDTHS);
    double gaps = fmin(ceil(room / apart), MAX_PASSES);
    uint64_t key = random_key(o->seed, hash_track(t), PURPOSE_PASS);
    bool ok = true;
    pass.style.pressure = 1;
    for (int i = 0; ok && i <= (int)gaps; i++) {
        double stray = i == 0 || i == (int)gaps ? 0 : (random_unit(key, (uint64_t)i) - 0.5) * 2 * UNEVEN;
        double d = (i + stray) / gaps * room - room / 2;
        ok = build_pass(&centre, d, &pass) || plb_fail_memory(err);
        if (ok && !t->closed)
            extend(&pass, cap_reach(it, room / 2, d));
        pass.style.kind = i == 0 || i == (int)gaps ? STROKE_LINE : STROKE_HATCH;
        ok = ok && (pass.points.n < 2 || sink(closure, &pass));
    }
    array_free(&pass.points);
    return ok;
}
