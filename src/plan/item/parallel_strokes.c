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
#define PASS_UNEVEN 0.2
/* The most passes of one line. */
#define MAX_PARALLEL_PASSES 400

static point left_of(point a, point b)
{
    point d = point_sub(b, a);
    double length = plb_point_length(d);
    return length > 0 ? (point){d.y / length, -d.x / length} : (point){0, 0};
}

/* Gives the point number k of `t` moved aside by `d`, in the mitre of its two segments. */
static point aside(const track *t, size_t k, double d)
{
    size_t n = t->n, last = n - 1;
    point at = t->v[k].at;
    size_t before = k > 0 ? k - 1 : t->closed ? last - 1 : 0, after = k < last ? k + 1 : t->closed ? 1 : last;
    point in = left_of(t->v[before].at, at), out = left_of(at, t->v[after].at);
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
    point along = point_sub(t->v[k].at, t->v[k - 1].at);
    return point_dot(along, point_sub(to, from)) > 0;
}

/* Moves both ends of the track begun last outward by `more` mm. */
static void extend(track_list *out, double more)
{
    size_t n = track_last(out)->n;
    if (n < 2 || more <= 0)
        return;
    track_point *v = track_last_points(out);
    point first = left_of(v[1].at, v[0].at), last = left_of(v[n - 2].at, v[n - 1].at);
    v[0].at = point_add(v[0].at, (point){-first.y * more, first.x * more});
    v[n - 1].at = point_add(v[n - 1].at, (point){-last.y * more, last.x * more});
}

static bool build_pass(const track *t, double d, stroke_kind kind, track_list *out)
{
    bool ok = plb_track_begin(out, &(track){.closed = t->closed, .style = {1, t->style.colour, kind}});
    for (size_t k = 0; ok && k < t->n; k++) {
        point at = aside(t, k, d);
        bool begins = track_last(out)->n == 0;
        if (begins || k + 1 == t->n || runs_forward(t, k, out->points.v[out->points.n - 1].at, at))
            ok = plb_track_push(out, at, t->v[k].corner);
    }
    if (ok && t->closed && track_last(out)->n)
        out->points.v[out->points.n - 1].at = track_last_points(out)[0].at;
    return ok;
}

/* Tells how far the cap reaches beyond the end at distance `d` from the middle. */
static double cap_reach(const item *it, double radius, double d)
{
    if (it->cap == LINE_CAP_BUTT)
        return 0;
    return it->cap == LINE_CAP_SQUARE ? radius : sqrt(fmax(radius * radius - d * d, 0));
}

/* A track of one point is a dot; its passes go across the page. */
static track stretch_dot(const track *t, track_point ends[2])
{
    point at = t->v[0].at;
    ends[0] = (track_point){{at.x - SAME_POINT_MM, at.y}, false};
    ends[1] = (track_point){{at.x + SAME_POINT_MM, at.y}, false};
    return (track){.v = ends, .n = 2, .style = t->style};
}

static uint64_t hash_track(const track *t)
{
    uint64_t h = 0;
    for (size_t i = 0; i < t->n; i++)
        h = random_fold(h, llround(t->v[i].at.x * 1000), llround(t->v[i].at.y * 1000));
    return h;
}

bool plb_plan_passes(const item *it, const track *t, const plan_options *o, track_list *out, error *err)
{
    track_point ends[2];
    track centre = t->n == 1 ? stretch_dot(t, ends) : *t;
    double breadth = it->width - o->shade_width, dark = 1 - plb_paint_lightness(it->paint);
    double apart = o->shade_width * fmin(CLOSEST_WIDTHS / fmax(dark, 0.01), FARTHEST_WIDTHS);
    int gaps = (int)fmin(ceil(breadth / apart), MAX_PARALLEL_PASSES);
    uint64_t key = random_key(o->seed, hash_track(t), PURPOSE_PASS);
    bool ok = true;
    for (int i = 0; ok && i <= gaps; i++) {
        bool is_edge = i == 0 || i == gaps;
        double stray = is_edge ? 0 : (random_unit(key, (uint64_t)i) - 0.5) * 2 * PASS_UNEVEN;
        double d = (i + stray) / gaps * breadth - breadth / 2;
        ok = build_pass(&centre, d, is_edge ? STROKE_LINE : STROKE_HATCH, out) || plb_fail_memory(err);
        if (ok && !t->closed)
            extend(out, cap_reach(it, breadth / 2, d));
        if (ok && track_last(out)->n < 2)
            plb_track_drop(out);
    }
    return ok;
}
