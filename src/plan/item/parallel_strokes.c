/* SPDX-License-Identifier: MIT
 *
 * Plan, wide lines: as the point cannot be so broad, the pencil goes along both edges and then back and forth between them, as close as
 * the tone asks. All passes are one company: they follow the same path of the hand, so that no gaps open between them. None ends just
 * where the next one does; two by two, those between the edges are joined by the turn that the hand makes there.
 *
 *     ────────────────────   edge
 *     ────────────────────╮
 *     ╭───────────────────╯
 *     ╰──────────────────
 *     ────────────────────   edge
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
/* The hand keeps to a wide line's place within this part of its width and this, mm: gaps to other lines stay open (chosen by eye). */
#define STRAY_OF_WIDTH 0.15
#define STRAY_MM 0.12
/* Ends of passes lie within so many widths of the pencil's line before or after the cut, and within this part of the line's length
 * (chosen by eye: ragged as real ones, but no longer a line). */
#define END_WIDTHS 0.7
#define END_OF_LENGTH 0.03
/* A turn is drawn when the passes are no farther apart than so many widths; it is so many straight pieces, an arc this much flatter than half a
 * circle, and pressed so much less than the passes, because it lies on both of them (chosen by eye: no dark knots). */
#define TURN_WIDTHS 1.2
#define TURN_PIECES 6
#define TURN_FLAT 0.7
#define TURN_PRESSURE 0.4f

typedef struct {
    const item *it;
    const track *t;
    const plan_options *o;
    double radius; /* half of the way from the middle of one edge's pass to that of the other, mm */
    uint64_t key;
    track_list *out;
} wide_line;

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

/* Moves the end `at` away from `next` by `more` mm; a negative one draws it in. */
static void extend(track_point *at, track_point next, double more)
{
    double l = plb_point_distance(at->at, next.at);
    if (l + more > SAME_POINT_MM)
        at->at = point_mix(next.at, at->at, (l + more) / l);
}

static bool build_pass(const wide_line *w, double d, stroke_kind kind)
{
    const track *t = w->t;
    stroke_style style = {.pressure = 1, .colour = t->style.colour, .kind = kind, .breadth = 1, .company = random_mix(w->key) | 1};
    style.max_stray = (float)(STRAY_OF_WIDTH * w->it->width + STRAY_MM);
    bool ok = plb_track_begin(w->out, &(track){.closed = t->closed, .style = style});
    for (size_t k = 0; ok && k < t->n; k++) {
        point at = aside(t, k, d);
        bool begins = track_last(w->out)->n == 0;
        if (begins || k + 1 == t->n || runs_forward(t, k, w->out->points.v[w->out->points.n - 1].at, at))
            ok = plb_track_push(w->out, at, t->v[k].corner);
    }
    if (ok && t->closed && track_last(w->out)->n)
        w->out->points.v[w->out->points.n - 1].at = track_last_points(w->out)[0].at;
    return ok;
}

/* Tells how far the cap reaches beyond the end at distance `d` from the middle. */
static double cap_reach(const wide_line *w, double d)
{
    if (w->it->cap == LINE_CAP_BUTT)
        return 0;
    return w->it->cap == LINE_CAP_SQUARE ? w->radius : sqrt(fmax(w->radius * w->radius - d * d, 0));
}

/* Tells how far beyond its place the end of pass i lies, at the line's beginning (side 0) or end. Passes that meet in a turn share it. */
static double stray_of_end(const wide_line *w, int i, int side)
{
    int turn = (i + side) / 2; /* passes 2 k - 1 and 2 k meet at the end, 2 k and 2 k + 1 at the beginning */
    double most = fmin(END_WIDTHS * w->o->shade_width, END_OF_LENGTH * plb_track_length(w->t));
    return most * (2 * random_unit(w->key, 1000 + (uint64_t)(2 * turn + side)) - 1);
}

/* Adds the turn from the end of one pass to that of the next. */
static bool add_turn(const wide_line *w, point a, point b, point from)
{
    point middle = point_mix(a, b, .5), half = point_scale(point_sub(a, b), .5), way = point_sub(a, from);
    point out = {-half.y, half.x};
    track turn = {.style = track_last(w->out)->style, .corner_first = true, .corner_last = true};
    out = point_scale(out, point_dot(out, way) < 0 ? -TURN_FLAT : TURN_FLAT);
    turn.style.pressure *= TURN_PRESSURE;
    bool ok = plb_track_begin(w->out, &turn);
    for (int k = 0; ok && k <= TURN_PIECES; k++) {
        double angle = PLB_PI * k / TURN_PIECES;
        ok = plb_track_push(w->out, point_add(middle, point_add(point_scale(half, cos(angle)), point_scale(out, sin(angle)))), false);
    }
    return ok;
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

/* The pass added last: the places of its two ends, and of the points next to them; where its track is. */
typedef struct {
    point end[2], next[2];
    size_t track;
    bool is_inner;
} pass;

/* Moves the ends of the pass added last to where they belong. Edges turn into no other pass. */
static pass place_ends(const wide_line *w, int i, bool is_edge, double d)
{
    size_t n = track_last(w->out)->n;
    track_point *v = track_last_points(w->out);
    int number = is_edge ? -2 - i : i;
    double reach = cap_reach(w, d);
    extend(&v[0], v[1], reach + stray_of_end(w, number, 0));
    extend(&v[n - 1], v[n - 2], reach + stray_of_end(w, number, 1));
    return (pass){{v[0].at, v[n - 1].at}, {v[1].at, v[n - 2].at}, w->out->tracks.n - 1, !is_edge};
}

/* Joins two passes by the turn at the line's beginning (side 0) or end: there the pencil is not lifted. */
static bool join_passes(const wide_line *w, const pass *a, const pass *b, int side)
{
    track *v = w->out->tracks.v;
    *(side ? &v[a->track].corner_last : &v[a->track].corner_first) = true;
    *(side ? &v[b->track].corner_last : &v[b->track].corner_first) = true;
    return add_turn(w, a->end[side], b->end[side], a->next[side]);
}

bool plb_plan_passes(const item *it, const track *t, const plan_options *o, track_list *out, error *err)
{
    track_point ends[2];
    track centre = t->n == 1 ? stretch_dot(t, ends) : *t;
    double breadth = it->width - o->shade_width, dark = 1 - plb_paint_lightness(it->paint);
    double apart = o->shade_width * fmin(CLOSEST_WIDTHS / fmax(dark, 0.01), FARTHEST_WIDTHS);
    int gaps = (int)fmin(ceil(breadth / apart), MAX_PARALLEL_PASSES);
    wide_line w = {it, &centre, o, breadth / 2, random_key(o->seed, hash_track(t), PURPOSE_PASS), out};
    bool ok = true, turns = !t->closed && apart < TURN_WIDTHS * o->shade_width;
    pass last = {.is_inner = false};
    for (int i = 0; ok && i <= gaps; i++) {
        bool is_edge = i == 0 || i == gaps;
        double stray = is_edge ? 0 : (random_unit(w.key, (uint64_t)i) - 0.5) * 2 * PASS_UNEVEN;
        double d = (i + stray) / gaps * breadth - breadth / 2;
        ok = build_pass(&w, d, is_edge ? STROKE_LINE : STROKE_HATCH);
        if (ok && track_last(out)->n < 2) {
            plb_track_drop(out);
            last.is_inner = false;
        } else if (ok && !t->closed) {
            pass now = place_ends(&w, i, is_edge, d);
            ok = !turns || is_edge || !last.is_inner || join_passes(&w, &last, &now, i % 2 == 0);
            last = now;
        }
    }
    return ok || plb_fail_memory(err);
}
