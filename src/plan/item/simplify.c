/* SPDX-License-Identifier: MIT
 *
 * Plan, one item, before corners: what is finer than the pencil is not drawn. Where corner follows corner closer than the point is
 * wide, as on coasts and torn edges, a hand makes one calm movement along their mean course: the line is sampled evenly
 * by its length and smoothed by binomial weights; the run's ends stay.
 */
#include "plan/item/stages.h"

#include <math.h>

/* Corners closer than so many widths of the pencil are crowded, so many in a row are a wiggle: an arrowhead, a box or a
 * cross of any size keep theirs (chosen by eye). */
#define CROWDED_WIDTHS 1.6
#define MIN_CORNERS 6
/* Samples to a width, and the weights to either side: a standard deviation of half a width. */
#define SAMPLES_PER_WIDTH 4.0
#define WEIGHTS_A_SIDE 8
static const double weights[WEIGHTS_A_SIDE + 1] = {12870, 11440, 8008, 4368, 1820, 560, 120, 16, 1};

typedef struct {
    const track *t;
    double width;
    track_list *out;
    ARRAY(point) samples;
} simplifier;

static bool add(simplifier *c, track_point p)
{
    track_last(c->out)->n++;
    return array_push(&c->out->points, p);
}

/* Samples the line from point first to point last at even distances of about a part of a width. */
static bool sample(simplifier *c, size_t first, size_t last)
{
    const track_point *v = c->t->v;
    double length = 0;
    for (size_t i = first; i < last; i++)
        length += plb_point_distance(v[i].at, v[i + 1].at);
    double parts = fmax(ceil(length * SAMPLES_PER_WIDTH / c->width), 2), step = length / parts, done = 0;
    size_t i = first;
    c->samples.n = 0;
    for (size_t k = 0; k < (size_t)parts; k++) {
        double want = (double)k * step, here = plb_point_distance(v[i].at, v[i + 1].at);
        while (done + here < want && i + 2 <= last) {
            done += here;
            i++;
            here = plb_point_distance(v[i].at, v[i + 1].at);
        }
        if (!array_push(&c->samples, point_mix(v[i].at, v[i + 1].at, here > 0 ? fmin((want - done) / here, 1) : 0)))
            return false;
    }
    return array_push(&c->samples, v[last].at);
}

/* Gives sample k; beyond an end the samples within, turned about the end. */
static point sample_at(const simplifier *c, long k)
{
    long last = (long)c->samples.n - 1;
    long mirror = k < 0 ? -k : k > last ? 2 * last - k : k;
    point p = c->samples.v[mirror < 0 ? 0 : mirror > last ? last : mirror];
    if (k >= 0 && k <= last)
        return p;
    return point_sub(point_scale(c->samples.v[k < 0 ? 0 : last], 2), p);
}

static bool smooth_run(simplifier *c, size_t first, size_t last)
{
    bool ok = sample(c, first, last);
    for (long k = 1; ok && k + 1 < (long)c->samples.n; k++) {
        point sum = point_scale(sample_at(c, k), weights[0] / 65536);
        for (long side = 1; side <= WEIGHTS_A_SIDE; side++)
            sum = point_add(sum, point_scale(point_add(sample_at(c, k - side), sample_at(c, k + side)), weights[side] / 65536));
        track_point p = {sum, false};
        ok = add(c, p);
    }
    return ok && add(c, c->t->v[last]);
}

/* Gives the last corner of the crowded run that begins at corner `first`; how many it has in *corners. */
static size_t end_of_run(const simplifier *c, size_t first, size_t *corners)
{
    const track *t = c->t;
    size_t last = first;
    double since = 0;
    *corners = 1;
    for (size_t i = first + 1; i < t->n; i++) {
        since += plb_point_distance(t->v[i - 1].at, t->v[i].at);
        if (since > CROWDED_WIDTHS * c->width)
            break;
        if (!t->v[i].corner)
            continue;
        last = i;
        since = 0;
        ++*corners;
    }
    return last;
}

static bool copy(simplifier *c)
{
    const track *t = c->t;
    bool ok = add(c, t->v[0]);
    for (size_t i = 0; ok && i + 1 < t->n;) {
        size_t corners = 0, last = t->v[i].corner ? end_of_run(c, i, &corners) : i;
        if (corners < MIN_CORNERS && last == i)
            last = i + 1;
        if (corners >= MIN_CORNERS)
            ok = smooth_run(c, i, last);
        else
            for (size_t k = i + 1; ok && k <= last; k++)
                ok = add(c, t->v[k]);
        i = last;
    }
    return ok;
}

static size_t count_corners(const track *t)
{
    size_t n = 0;
    for (size_t i = 0; i < t->n; i++)
        n += t->v[i].corner;
    return n;
}

static bool simplify(simplifier *c, const track *t)
{
    if (t->style.kind != STROKE_LINE || count_corners(t) < MIN_CORNERS)
        return plb_track_copy(c->out, t);
    c->t = t;
    return plb_track_begin(c->out, t) && copy(c);
}

bool plb_plan_simplify(const track_list *in, double width, track_list *out, error *err)
{
    simplifier c = {.width = width, .out = out};
    bool ok = true;
    for (size_t i = 0; ok && i < in->tracks.n; i++) {
        track t = plb_track_at(in, i);
        ok = simplify(&c, &t) || plb_fail_memory(err);
    }
    array_free(&c.samples);
    return ok;
}
