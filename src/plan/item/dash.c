/* SPDX-License-Identifier: MIT
 *
 * Plan, one item, dashes. Each dash becomes a track, so that it becomes a stroke of its own; as a hand does not measure,
 * none is as long as the other, and each lies a little askew. But the eye counts: gaps make up for what dashes were too long, so that a
 * pattern stays in step with its line, gaps stay open, and long and short dashes of one pattern stay apart.
 */
#include "plan/item/stages.h"

#include "base/geometry/interpolate.h"
#include "base/number/random.h"
#include "plan/item/weight.h"

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
#define DASH_UNEVEN 0.15
#define MAX_STRAY_MM 0.5
/* A free hand's dashes and gaps have lengths whose logarithms have these standard deviations, and differ from their own by no more than
 * so many of these. Rows of real dashes: .23 to .48 of the mean. Dashes below the first length are decided strokes and differ less, in proportion; those
 * beyond the second, as in centre lines, less by the root of it. */
#define DASH_SPREAD 0.28
#define GAP_SPREAD 0.18
#define SPREADS 1.8
#define FREE_DASH_MM 1.5
#define LONG_DASH_MM 5.0
/* Dashes of two lengths in one pattern keep apart: the spread is at most this part of the logarithm of their ratio. */
#define APART_OF_RATIO 0.22
/* A gap makes up for this part of how late it begins, but keeps between these parts of its length, and is no narrower than so many widths
 * of the pencil's line, where the pattern's own is not (chosen by eye). */
#define CATCH_UP 0.45
#define GAP_LEAST 0.6
#define GAP_MOST 1.6
#define GAP_WIDTHS 1.8
/* A dash is tilted by the first, degrees, one standard deviation, at most by so many, and no end leaves the line by more than the third, mm
 * (real ones: up to 10 degrees, in one row .3). */
#define TILT_DEGREES 3.0
#define TILT_MOST 2.5
#define TILT_MM 0.2
/* The row as a whole strays from its line by this part of the line's length, at most so far, mm (chosen by eye: less than a free line). */
#define ROW_STRAY 0.0035
#define ROW_STRAY_MM 0.3

/* A point painted with a round or square cap is a dot: a touch of the pencil this long (chosen by eye). */
#define DOT_LENGTH_MM 0.12

/* A walk along the dash pattern. */
typedef struct {
    const item *it;
    track_list *out;
    bool is_open;  /* the last track of `out` is a dash that goes on */
    stroke_style style;
    double factor; /* of the pattern's lengths */
    uint64_t key;  /* of its unevenness */
    double index;  /* of the entry that is running, counted from the start of the line */
    size_t k;      /* the same within the pattern; even: on */
    double left;   /* mm of it still to go */
    const plan_options *o;
    double late;   /* how much farther on than its place it ends, mm */
    double done, length; /* mm of the line so far, and of all of it */
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

/* Tells how far from its place the running entry ends. */
static double stray(const pattern *p)
{
    double most = fmin(length_of(p, p->k), length_of(p, p->k + 1)) * DASH_UNEVEN;
    return fmin(most, MAX_STRAY_MM) * (2 * random_unit(p->key, (uint64_t)(int64_t)p->index) - 1);
}

/* Gives a number that is near enough normal, of standard deviation 1, within ±SPREADS. */
static double normal(const pattern *p, uint64_t what)
{
    uint64_t bits = random_bits(p->key, (uint64_t)(int64_t)p->index * 8 + what);
    double sum = (double)((bits & 0xffff) + (bits >> 16 & 0xffff) + (bits >> 32 & 0xffff) + (bits >> 48)) / 65536 - 2;
    return clamp(sum * sqrt(3), -SPREADS, SPREADS);
}

/* Gives how much the running dash may differ from the pattern's, as the logarithm's standard deviation. */
static double spread_of(const pattern *p, double length)
{
    double spread = DASH_SPREAD * fmin(length / FREE_DASH_MM, 1) * sqrt(fmin(LONG_DASH_MM / fmax(length, LONG_DASH_MM), 1));
    for (size_t k = 0; length > 0 && k < p->it->dash.n; k += 2) {
        double ratio = length_of(p, k) > 0 ? fabs(log(length_of(p, k) / length)) : 0;
        spread = ratio > 0.05 ? fmin(spread, APART_OF_RATIO * ratio) : spread;
    }
    return spread;
}

/* Gives the running entry's length as a hand makes it. */
static double uneven_length(pattern *p)
{
    double length = length_of(p, p->k), made = length;
    bool is_gap = p->k & 1;
    if (!is_gap)
        made = length * exp(spread_of(p, length) * normal(p, 0));
    else {
        double least = fmax(GAP_LEAST * length, fmin(length, GAP_WIDTHS * p->o->pencil_width));
        made = clamp(length * exp(GAP_SPREAD * normal(p, 1)) - CATCH_UP * p->late, least, fmax(GAP_MOST * length, least));
    }
    p->late += made - length;
    return made;
}

static void advance(pattern *p)
{
    do {
        double late = stray(p);
        p->k = (p->k + 1) % p->it->dash.n;
        p->index++;
        p->left = p->o->is_free ? uneven_length(p) : length_of(p, p->k) + stray(p) - late;
    } while (p->left <= 0 && (p->k & 1)); /* a gap of nothing is no gap */
}

/* Sets the walk at `where` mm from the start of the pattern. */
static void set_at(pattern *p, double where, double period)
{
    double phase = fmod(where, period);
    if (phase < 0)
        phase += period;
    double periods = round((where - phase) / period); /* too many for a number: then as well none */
    p->index = isfinite(periods) ? fmod(periods, 1e9) * (double)p->it->dash.n : 0;
    p->k = 0;
    p->left = length_of(p, 0);
    while (phase >= p->left && phase > 0) {
        phase -= p->left;
        p->k = (p->k + 1) % p->it->dash.n;
        p->index++;
        p->left = length_of(p, p->k);
    }
    p->left = fmax(p->left - phase + (p->o->is_free ? 0 : stray(p)), 0);
}

static bool push(pattern *p, point at, bool corner)
{
    bool begins = !p->is_open;
    p->is_open = (!begins || plb_track_begin(p->out, &(track){.style = p->style})) && plb_track_push(p->out, at, corner && !begins);
    return p->is_open;
}

/* A dash too short for the hand becomes a touch about its middle, along `direction`. */
static bool lengthen(pattern *p, const track *dash, point direction)
{
    point middle = point_mix(dash->v[0].at, dash->v[dash->n - 1].at, .5);
    double length = plb_point_length(direction);
    point half = length > 0 ? point_scale(direction, TOUCH_MM / 2 / length) : (point){TOUCH_MM / 2, 0};
    plb_track_drop(p->out);
    p->is_open = false;
    return push(p, point_sub(middle, half), false) && push(p, point_add(middle, half), false);
}

/* Tells how far beside its line the row lies at a place along it, mm: nowhere at its ends. */
static double row_stray(const pattern *p, double along)
{
    double x = clamp(along / p->length, 0, 1) * PLB_PI, sum = 0;
    for (int k = 1; k <= 3; k++)
        sum += (2 * random_unit(p->key, 0x10000000 + (uint64_t)k) - 1) * sin(k * x) / k;
    return sum * fmin(ROW_STRAY * p->length, ROW_STRAY_MM);
}

/* Lays the dash built last, which has no corner, askew and beside the line. */
static void tilt(const pattern *p, double length)
{
    track_point *v = track_last_points(p->out);
    size_t n = track_last(p->out)->n;
    point middle = point_mix(v[0].at, v[n - 1].at, .5), way = point_sub(v[n - 1].at, v[0].at);
    double chord = plb_point_length(way), most = TILT_DEGREES * PLB_PI / 180, angle = clamp(most * 1.4 * normal(p, 2), -TILT_MOST * most, TILT_MOST * most);
    if (chord < TOUCH_MM)
        return;
    angle = clamp(angle, -2 * TILT_MM / length, 2 * TILT_MM / length);
    double c = cos(angle), s = sin(angle), off = row_stray(p, p->done) / chord;
    for (size_t k = 0; k < n; k++) {
        point d = point_sub(v[k].at, middle);
        v[k].at = (point){middle.x + c * d.x - s * d.y + off * way.y, middle.y + s * d.x + c * d.y - off * way.x};
    }
}

static bool has_corner(const track *t)
{
    bool found = false;
    for (size_t k = 1; k + 1 < t->n; k++)
        found |= t->v[k].corner;
    return found;
}

/* Ends the dash that is being built. */
static bool end_dash(pattern *p, point direction)
{
    if (!p->is_open)
        return true;
    track dash = plb_track_at(p->out, p->out->tracks.n - 1);
    double length = plb_track_length(&dash);
    bool ok = length >= TOUCH_MM || lengthen(p, &dash, direction);
    if (ok && p->o->is_free && length >= TOUCH_MM && !has_corner(&dash))
        tilt(p, length);
    if (ok)
        p->out->points.v[p->out->points.n - 1].corner = false;
    p->is_open = false;
    return ok;
}

/* Walks along one straight piece of the track. */
static bool walk(pattern *p, track_point from, track_point to)
{
    double length = plb_point_distance(from.at, to.at), done = 0;
    point direction = point_sub(to.at, from.at);
    while (done + p->left < length) {
        done += p->left;
        p->done += p->left;
        point here = point_mix(from.at, to.at, done / length);
        bool on = !(p->k & 1), is_nothing = on && length_of(p, p->k) == 0 && p->it->cap == LINE_CAP_BUTT;
        if (on && !push(p, here, false))
            return false;
        if (is_nothing) { /* a dot without caps */
            plb_track_drop(p->out);
            p->is_open = false;
        }
        if (on && !end_dash(p, direction))
            return false;
        advance(p);
        if (!(p->k & 1) && !push(p, here, false))
            return false;
    }
    p->left -= length - done;
    p->done += length - done;
    return (p->k & 1) || push(p, to.at, to.corner);
}

static uint64_t hash_track(const track *t)
{
    point a = t->v[0].at, b = t->v[t->n - 1].at;
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

static bool add_dashes(const item *it, const track *t, const plan_options *o, track_list *out)
{
    double period = it->kind == ITEM_STROKE && has_gaps(it) ? period_of(it) : 0;
    double factor = period > 0 ? fmax(1, ceil(SHORTEST_PERIOD_WIDTHS * o->pencil_width / period)) : 0;
    period *= factor;
    if (!(period > 0 && period < 1e9) || plb_track_length(t) / period > MAX_DASHES)
        return plb_track_copy(out, t);
    pattern p = {.it = it, .out = out, .style = t->style, .factor = factor, .o = o, .length = plb_track_length(t), .key = random_key(o->seed, hash_track(t), PURPOSE_DASH)};
    set_at(&p, t->start + it->dash_offset * factor, period);
    bool ok = (p.k & 1) || push(&p, t->v[0].at, false);
    for (size_t i = 1; ok && i < t->n; i++)
        ok = walk(&p, t->v[i - 1], t->v[i]);
    return ok && end_dash(&p, point_sub(t->v[t->n - 1].at, t->v[t->n - 2].at));
}

/* A point is left to the passes of a wide line; else a cap makes it a dot. */
static bool add_dot(const item *it, const track *t, const plan_options *o, track_list *out)
{
    if (plb_is_wide(it, o))
        return plb_track_copy(out, t);
    point at = t->v[0].at;
    track_point ends[2] = {{{at.x - DOT_LENGTH_MM / 2, at.y}, false}, {{at.x + DOT_LENGTH_MM / 2, at.y}, false}};
    track dot = {.v = ends, .n = 2, .style = t->style};
    return it->cap == LINE_CAP_BUTT || plb_track_copy(out, &dot);
}

bool plb_plan_dash(const item *it, const track_list *in, const plan_options *o, track_list *out, error *err)
{
    bool ok = true;
    for (size_t i = 0; ok && i < in->tracks.n; i++) {
        track t = plb_track_at(in, i);
        ok = (t.n == 1 ? add_dot(it, &t, o, out) : add_dashes(it, &t, o, out)) || plb_fail_memory(err);
    }
    return ok;
}
