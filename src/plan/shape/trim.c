/* SPDX-License-Identifier: MIT
 *
 * Cutting tracks: see trim.h. Clips and occluders cut with these.
 */
#include "plan/shape/trim.h"

#include "base/sort.h"

#include <stdlib.h>

/* Pieces shorter than this that the cut leaves are dropped (chosen by eye: less than a touch of the point). */
#define SHORTEST_PIECE_MM 0.02

/* A track on the way through the cut, and the piece under construction, the last of `out` while it is open. */
typedef struct {
    const trim_rule *rule;
    track_list *out;
    bool is_open;
    stroke_style style;
    crossings at; /* of the segment at work */
    double done;  /* arc length reached, mm */
    bool lifted;  /* something was not seen */
    error *err;
} cutter;

/* Ends the piece; a scrap is taken out again. */
static void end_piece(cutter *k)
{
    const track *piece = track_last(k->out);
    track_point *v = track_last_points(k->out);
    size_t n = piece->n;
    k->is_open = false;
    if (n > 1 && (n > 2 || plb_point_distance(v[0].at, v[1].at) >= SHORTEST_PIECE_MM))
        v[n - 1].corner = false;
    else
        plb_track_drop(k->out);
}

static bool push(cutter *k, point at, bool corner)
{
    bool begins = !k->is_open;
    bool ok = (!begins || plb_track_begin(k->out, &(track){.style = k->style, .start = k->done})) && plb_track_push(k->out, at, corner && !begins);
    k->is_open = ok;
    return ok || plb_fail_memory(k->err);
}

/* Adds the part of a segment from parameter `before` to `t`, which ends at k->done + `length`. */
static bool add_part(cutter *k, track_point from, track_point to, double before, double t, double length)
{
    bool seen = k->rule->sees(k->rule->of, point_mix(from.at, to.at, (before + t) / 2)), ok = true;
    if (seen && !k->is_open)
        ok = push(k, point_mix(from.at, to.at, before), false);
    if (!seen && k->is_open) {
        ok = before == 0 || push(k, point_mix(from.at, to.at, before), false);
        end_piece(k);
    }
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

bool plb_plan_trim(const trim_rule *rule, const track *t, track_list *out, bool *is_part, error *err)
{
    if (t->n == 1 && !rule->sees(rule->of, t->v[0].at))
        return *is_part = true;
    if (t->n == 1)
        return plb_track_copy(out, t) || plb_fail_memory(err);
    cutter k = {.rule = rule, .out = out, .style = t->style, .done = t->start, .err = err};
    size_t tracks = out->tracks.n, points = out->points.n;
    bool ok = true;
    for (size_t i = 1; ok && i < t->n; i++)
        ok = cut_segment(&k, t->v[i - 1], t->v[i]);
    if (ok && k.is_open)
        end_piece(&k);
    if (ok && k.lifted)
        *is_part = true;
    if (ok && !k.lifted) { /* whole, it stays closed if it was */
        out->tracks.n = tracks;
        out->points.n = points;
        ok = plb_track_copy(out, t) || plb_fail_memory(err);
    }
    array_free(&k.at);
    return ok;
}
