/* SPDX-License-Identifier: MIT
 *
 * Cutting tracks: see trim.h. Used by clips and by what hides.
 */
#include "base/sort.h"
#include "plan/shape/trim.h"

#include <stdlib.h>

/* Pieces shorter than this that the cut leaves are dropped (chosen by eye: less than a touch of the point). */
#define SHORTEST_PIECE_MM 0.02

/* What is being cut: the piece under construction and where it goes. */
typedef struct {
    const cut_rule *rule;
    track piece;
    crossings at; /* of the segment at work */
    double done;  /* arc length reached, mm */
    bool lifted;  /* something was not seen */
    track_sink sink;
    void *closure;
    error *err;
} cutter;

box plb_track_bounds(const track *t)
{
    box b = BOX_EMPTY;
    for (size_t i = 0; i < t->points.n; i++)
        plb_box_add(&b, t->points.v[i].at);
    return b;
}

static bool flush(cutter *k)
{
    size_t n = k->piece.points.n;
    bool ok = true;
    if (n > 1 && (n > 2 || plb_point_distance(k->piece.points.v[0].at, k->piece.points.v[1].at) >= SHORTEST_PIECE_MM)) {
        k->piece.points.v[n - 1].corner = false;
        ok = k->sink(k->closure, &k->piece);
    }
    k->piece.points.n = 0;
    return ok;
}

static bool push(cutter *k, point at, bool corner)
{
    size_t n = k->piece.points.n;
    if (n && plb_point_distance(k->piece.points.v[n - 1].at, at) < SAME_POINT_MM)
        return true;
    track_point p = {at, corner && n > 0};
    if (n == 0)
        k->piece.start = k->done;
    return array_push(&k->piece.points, p) || plb_fail_memory(k->err);
}

/* The part of a segment from parameter `before` to `t`, which ends at k->done + `length`. */
static bool add_part(cutter *k, track_point from, track_point to, double before, double t, double length)
{
    bool seen = k->rule->sees(k->rule->of, point_mix(from.at, to.at, (before + t) / 2)), ok = true;
    if (seen && k->piece.points.n == 0)
        ok = push(k, point_mix(from.at, to.at, before), false);
    if (!seen && k->piece.points.n)
        ok = (before == 0 || push(k, point_mix(from.at, to.at, before), false)) && flush(k);
    k->done += length;
    k->lifted = k->lifted || !seen;
    return ok && (!seen || t < 1 || push(k, to.at, to.corner));
}

/* Cuts one straight segment at the crossings found and keeps the parts that are seen. */
static bool cut_segment(cutter *k, track_point from, track_point to)
{
    k->at.n = 0;
    if (!k->rule->cross(k->rule->of, from.at, to.at, &k->at) || !array_push(&k->at, 1.0))
        return plb_fail_memory(k->err);
    qsort(k->at.v, k->at.n, sizeof *k->at.v, plb_compare_doubles);
    double length = plb_point_distance(from.at, to.at), before = 0;
    bool ok = true;
    for (size_t i = 0; ok && i < k->at.n; i++) {
        double t = k->at.v[i];
        if ((t - before) * length < SAME_POINT_MM && i + 1 < k->at.n)
            continue;
        ok = add_part(k, from, to, before, t, (t - before) * length);
        before = t;
    }
    return ok;
}

bool plb_plan_cut(const cut_rule *rule, const track *t, track_sink sink, void *closure, error *err)
{
    if (t->points.n == 1)
        return !rule->sees(rule->of, t->points.v[0].at) || sink(closure, t);
    cutter k = {.rule = rule, .piece.style = t->style, .done = t->start, .sink = sink, .closure = closure, .err = err};
    bool ok = true;
    for (size_t i = 1; ok && i < t->points.n; i++)
        ok = cut_segment(&k, t->points.v[i - 1], t->points.v[i]);
    ok = ok && (k.lifted ? flush(&k) : sink(closure, t)); /* whole, it stays closed if it was */
    array_free(&k.at);
    array_free(&k.piece.points);
    return ok;
}
