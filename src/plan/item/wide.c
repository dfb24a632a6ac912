/* SPDX-License-Identifier: MIT
 *
 * Wide lines: see wide.h. The area is a chain of quadrilaterals, one to a segment, all of the same turn so that the
 * nonzero rule joins them. Where the line turns a little they meet in a mitre, at corners a disc fills the gap.
 */
#include "plan/item/wide.h"

#include "plan/shape/flatten.h"

#include <math.h>

/* Joints that turn less than this are mitred. */
#define MITRE_DEGREES 40.0
/* Corners of the disc of a joint or a round cap: its area is within 2 % of the circle's. */
#define DISC_CORNERS 24

typedef struct {
    const item *it;
    double width; /* mm */
    path *out;
    error *err;
} widener;

static point unit(point a, point b)
{
    point d = point_sub(b, a);
    double length = plb_point_length(d);
    return length > 0 ? point_scale(d, 1 / length) : (point){1, 0};
}

static bool add_polygon(widener *w, const point *v, int n)
{
    bool ok = plb_path_move(w->out, v[0]);
    for (int i = 1; ok && i < n; i++)
        ok = plb_path_line(w->out, v[i]);
    return (ok && plb_path_close(w->out)) || plb_fail_memory(w->err);
}

static bool add_disc(widener *w, point at)
{
    point v[DISC_CORNERS];
    for (int i = 0; i < DISC_CORNERS; i++) {
        double a = 2 * PLB_PI * i / DISC_CORNERS;
        v[i] = (point){at.x + cos(a) * w->width / 2, at.y + sin(a) * w->width / 2};
    }
    return add_polygon(w, v, DISC_CORNERS);
}

/* Tells how far to the left of `at` the edge lies, between the directions in and out. */
static point side(const widener *w, point in, point out)
{
    point along = unit((point){0, 0}, point_add(in, out));
    double reach = w->width / 2 / fmax(point_dot(along, in), .5);
    return (point){-along.y * reach, along.x * reach};
}

static bool is_mitred(point in, point out)
{
    return point_dot(in, out) > cos(MITRE_DEGREES * PLB_PI / 180);
}

/* Gives point number k of the track, around a closed one: 0 <= k + n. */
static point at(const track *t, long k)
{
    long n = (long)t->n - (t->closed ? 1 : 0);
    return t->v[(k + n) % n].at;
}

/* Adds the quadrilateral of the segment from point k, and the discs that it needs at its ends. */
static bool add_segment(widener *w, const track *t, long k)
{
    long last = (long)t->n - 2;
    point a = at(t, k), b = at(t, k + 1), d = unit(a, b);
    bool is_first = k == 0 && !t->closed, is_last = k == last && !t->closed;
    point in = is_first ? d : unit(at(t, k - 1), a), out = is_last ? d : unit(b, at(t, k + 2));
    point left_a = side(w, is_mitred(in, d) ? in : d, d), left_b = side(w, d, is_mitred(d, out) ? out : d);
    double cap = w->it->cap == LINE_CAP_SQUARE ? w->width / 2 : 0;
    bool is_round = w->it->cap == LINE_CAP_ROUND;
    if (is_first)
        a = point_sub(a, point_scale(d, cap));
    if (is_last)
        b = point_add(b, point_scale(d, cap));
    point quad[4] = {point_sub(a, left_a), point_sub(b, left_b), point_add(b, left_b), point_add(a, left_a)};
    bool disc_a = is_first ? is_round : !is_mitred(in, d);
    return add_polygon(w, quad, 4) && (!disc_a || add_disc(w, a)) && (!is_last || !is_round || add_disc(w, b));
}

static bool add_track(widener *w, const track *t)
{
    if (t->n < 2)
        return w->it->cap == LINE_CAP_BUTT || add_disc(w, t->v[0].at);
    bool ok = true;
    for (size_t k = 0; ok && k + 1 < t->n; k++)
        ok = add_segment(w, t, (long)k);
    return ok;
}

bool plb_wide_outline(const item *it, double width, path *out, error *err)
{
    widener w = {it, width, out, err};
    track_list lines = {0};
    bool ok = plb_plan_flatten(&it->path, false, &lines, err);
    for (size_t i = 0; ok && i < lines.tracks.n; i++) {
        track t = plb_track_at(&lines, i);
        ok = add_track(&w, &t);
    }
    plb_tracks_free(&lines);
    return ok;
}
