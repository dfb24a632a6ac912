/* SPDX-License-Identifier: MIT
 *
 * Plan, one item, corners: a stroke ends where the line turns sharply.
 */
#include "plan/item/stages.h"

/* Gives point i of `t`, whose drawing begins at vertex k. A closed track ends exactly where it begins, to the last bit: the order of
 * drawing tells a closed line by that. */
static track_point point_of(const track *t, size_t k, size_t i)
{
    return t->closed ? t->v[(k + i) % (t->n - 1)] : t->v[i];
}

/* Makes a track of the points first to last of `t`, begun at vertex k. */
static bool add_piece(const track *t, size_t k, size_t first, size_t last, track_list *out)
{
    track piece = {.style = t->style};
    piece.corner_first = t->closed || t->corner_first || first > 0;
    piece.corner_last = t->closed || t->corner_last || last + 1 < t->n;
    if (!plb_track_begin(out, &piece) || !array_reserve(&out->points, last - first + 1))
        return false;
    for (size_t i = first; i <= last; i++)
        out->points.v[out->points.n++] = (track_point){point_of(t, k, i).at, false};
    track_last(out)->n = last - first + 1;
    return true;
}

static bool cut(const track *t, track_list *out)
{
    size_t k = 0, first = 0;
    while (t->closed && k < t->n && !t->v[k].corner)
        k++;
    if (t->n < 2 || k == t->n) /* smooth all around: one closed stroke */
        return plb_track_copy(out, t);
    bool ok = true;
    for (size_t i = 1; ok && i < t->n; i++)
        if (i == t->n - 1 || point_of(t, k, i).corner) {
            ok = add_piece(t, k, first, i, out);
            first = i;
        }
    return ok;
}

bool plb_plan_corners(const track_list *in, track_list *out, error *err)
{
    bool ok = true;
    for (size_t i = 0; ok && i < in->tracks.n; i++) {
        track t = plb_track_at(in, i);
        ok = cut(&t, out) || plb_fail_memory(err);
    }
    return ok;
}
