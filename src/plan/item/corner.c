/* SPDX-License-Identifier: MIT
 *
 * Plan, step 4: a stroke ends where the line turns sharply.
 */
#include "plan/track.h"

/* Points first to last of `t` as a track of their own. */
static bool send(const track *t, size_t first, size_t last, track *piece, track_sink sink, void *closure, error *err)
{
    size_t n = t->points.n;
    piece->points.n = 0;
    piece->style = t->style;
    piece->corner_first = t->closed || t->corner_first || first > 0;
    piece->corner_last = t->closed || t->corner_last || last + 1 < n;
    if (!array_reserve(&piece->points, last - first + 1))
        return plb_fail_memory(err);
    for (size_t i = first; i <= last; i++) {
        track_point p = t->points.v[i];
        p.corner = false;
        piece->points.v[piece->points.n++] = p;
    }
    return sink(closure, piece);
}

/* The closed track `t` begun at its vertex `k` instead. */
static bool rotate(const track *t, size_t k, track *out, error *err)
{
    size_t n = t->points.n - 1;
    if (!array_reserve(&out->points, n + 1))
        return plb_fail_memory(err);
    for (size_t i = 0; i <= n; i++)
        out->points.v[i] = t->points.v[(k + i) % n];
    out->points.n = n + 1;
    return true;
}

static bool cut(const track *t, track_sink sink, void *closure, error *err)
{
    track piece = {0};
    bool ok = true;
    size_t first = 0, n = t->points.n;
    for (size_t i = 1; ok && i < n; i++)
        if (i == n - 1 || t->points.v[i].corner) {
            ok = send(t, first, i, &piece, sink, closure, err);
            first = i;
        }
    array_free(&piece.points);
    return ok;
}

bool plb_plan_corners(const track *t, track_sink sink, void *closure, error *err)
{
    size_t n = t->points.n, k = 0;
    if (n < 2)
        return sink(closure, t);
    if (!t->closed)
        return cut(t, sink, closure, err);
    while (k < n && !t->points.v[k].corner)
        k++;
    if (k == n) /* smooth all around: one closed stroke */
        return sink(closure, t);
    track turned = {.style = t->style, .closed = true};
    bool ok = rotate(t, k, &turned, err) && cut(&turned, sink, closure, err);
    array_free(&turned.points);
    return ok;
}
