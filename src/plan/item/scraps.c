/* SPDX-License-Identifier: MIT
 *
 * Plan, one item, scraps: of hatching and of passes no scraps are left where something hides the rest, and the line's width stays
 * outside what hides the rest: thin white letters would else be closed.
 */
#include "plan/item/stages.h"

/* A hatch line ends this part of the pencil's width before what hides the rest (chosen by eye). */
#define NIB_WIDTHS 0.35

static point draw_back(point end, point towards, double by)
{
    return point_mix(end, towards, by / plb_point_distance(end, towards));
}

/* A straight part of a hatch line, drawn back from what hides the rest. */
static bool add_shortened(const track *t, double by, track_list *out)
{
    track_point ends[2] = {t->v[0], t->v[1]};
    track kept = *t;
    if (t->hidden_first)
        ends[0].at = draw_back(t->v[0].at, t->v[1].at, by);
    if (t->hidden_last)
        ends[1].at = draw_back(t->v[1].at, t->v[0].at, by);
    kept.v = ends;
    return plb_track_copy(out, &kept);
}

bool plb_plan_drop_scraps(const track_list *in, const plan_options *o, track_list *out, error *err)
{
    bool ok = true;
    for (size_t i = 0; ok && i < in->tracks.n; i++) {
        track t = plb_track_at(in, i);
        bool is_part = t.is_part && t.style.kind == STROKE_HATCH;
        if (is_part && plb_track_length(&t) < o->pencil_width)
            continue;
        ok = (is_part && t.n == 2 ? add_shortened(&t, NIB_WIDTHS * o->pencil_width, out) : plb_track_copy(out, &t)) || plb_fail_memory(err);
    }
    return ok;
}
