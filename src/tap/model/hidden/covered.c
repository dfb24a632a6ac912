/* SPDX-License-Identifier: MIT
 *
 * See covered.h. The lines are looked at in short steps, each of which looks around in a grid of the lines that are there already.
 */
#include "tap/model/hidden/covered.h"

#include "base/number/random.h"

/* A step along a line, mm; lines nearer than NEAR whose directions differ by less than about 10 degrees are one (chosen by eye: a pencil's
 * line is as broad). */
#define STEP 0.4
#define NEAR 0.2
#define SAME_WAY 0.17 /* sine */
/* A shorter rest is not drawn, mm: less than a dash. */
#define SHORTEST 1.0

typedef struct {
    point at, way; /* middle of a step, unit vector */
    uint32_t next; /* in its cell's list */
} step;

typedef struct {
    ARRAY(step) steps;
    uint32_t *head; /* lists by cell */
    size_t room;    /* a power of two */
} step_grid;

static size_t list_of(const step_grid *g, double x, double y)
{
    return random_fold(0, (int64_t)floor(x / STEP), (int64_t)floor(y / STEP)) & (g->room - 1);
}

static bool is_covered(const step_grid *g, point at, point way)
{
    for (int i = -1; i <= 1; i++)
        for (int k = -1; k <= 1; k++)
            for (uint32_t n = g->head[list_of(g, at.x + i * STEP, at.y + k * STEP)]; n != NO_TRIANGLE; n = g->steps.v[n].next) {
                const step *s = &g->steps.v[n];
                point d = point_sub(at, s->at);
                if (fabs(point_cross(way, s->way)) < SAME_WAY && fabs(point_cross(d, s->way)) < NEAR && fabs(point_dot(d, s->way)) <= STEP * .75)
                    return true;
            }
    return false;
}

static bool enter(step_grid *g, point at, point way)
{
    size_t list = list_of(g, at.x, at.y);
    step s = {at, way, g->head[list]};
    g->head[list] = (uint32_t)g->steps.n;
    return array_push(&g->steps, s);
}

/* Enters a whole run. */
static bool enter_run(step_grid *g, const run_list *l, const run *r)
{
    for (size_t i = 0; i + 1 < r->n + r->is_closed; i++) {
        point a = l->points.v[r->first + i], d = point_sub(l->points.v[r->first + (i + 1) % r->n], a);
        double length = plb_point_length(d);
        size_t n = (size_t)(length / STEP) + 1;
        for (size_t k = 0; length > 0 && k < n; k++)
            if (!enter(g, point_add(a, point_scale(d, ((double)k + .5) / (double)n)), point_scale(d, 1 / length)))
                return false;
    }
    return true;
}

typedef struct {
    run_list *out;
    size_t first;
    line_kind kind;
    double length;
} rest;

static bool end_rest(rest *k)
{
    run_list *l = k->out;
    run r = {k->first, l->points.n - k->first, k->kind, true, false};
    if (r.n < 2 || k->length < SHORTEST)
        l->points.n = k->first;
    else if (!array_push(&l->runs, r))
        return false;
    k->first = l->points.n;
    k->length = 0;
    return true;
}

/* Appends the parts of a hidden run that nothing covers. */
static bool add_rest(const step_grid *g, const run_list *l, const run *r, run_list *out)
{
    rest k = {out, out->points.n, r->kind, 0};
    for (size_t i = 0; i + 1 < r->n + r->is_closed; i++) {
        point a = l->points.v[r->first + i], d = point_sub(l->points.v[r->first + (i + 1) % r->n], a);
        double length = plb_point_length(d);
        size_t n = (size_t)(length / STEP) + 1;
        for (size_t j = 0; length > 0 && j < n; j++) {
            point from = point_add(a, point_scale(d, (double)j / (double)n)), to = point_add(a, point_scale(d, ((double)j + 1) / (double)n));
            if (is_covered(g, point_mix(from, to, .5), point_scale(d, 1 / length))) {
                if (!end_rest(&k))
                    return false;
                continue;
            }
            /* The points between the corners say nothing. */
            bool goes_on = j > 0 && out->points.n >= k.first + 2;
            if (k.first == out->points.n && !array_push(&out->points, from))
                return false;
            if (goes_on)
                out->points.v[out->points.n - 1] = to;
            else if (!array_push(&out->points, to))
                return false;
            k.length += length / (double)n;
        }
    }
    return end_rest(&k);
}

static bool copy_run(const run_list *l, const run *r, run_list *out)
{
    run copy = *r;
    copy.first = out->points.n;
    if (!array_reserve(&out->points, r->n) || !array_push(&out->runs, copy))
        return false;
    for (size_t i = 0; i < r->n; i++)
        out->points.v[out->points.n++] = l->points.v[r->first + i];
    return true;
}

static bool make_room(step_grid *g, const run_list *l)
{
    double length = 0;
    for (size_t i = 0; i < l->runs.n; i++)
        for (size_t k = 1; k < l->runs.v[i].n; k++)
            length += plb_point_distance(l->points.v[l->runs.v[i].first + k - 1], l->points.v[l->runs.v[i].first + k]) + STEP;
    for (g->room = 64; (double)g->room < length / STEP && g->room < (size_t)1 << 24;)
        g->room *= 2;
    g->head = plb_new(g->room, sizeof *g->head);
    for (size_t i = 0; g->head && i < g->room; i++)
        g->head[i] = NO_TRIANGLE;
    return g->head;
}

bool plb_drop_covered(run_list *l, error *err)
{
    step_grid g = {0};
    run_list out = {0};
    bool ok = make_room(&g, l);
    for (size_t i = 0; ok && i < l->runs.n; i++)
        if (!l->runs.v[i].is_hidden)
            ok = enter_run(&g, l, &l->runs.v[i]) && copy_run(l, &l->runs.v[i], &out);
    for (size_t i = 0; ok && i < l->runs.n; i++) {
        size_t before = out.runs.n;
        if (!l->runs.v[i].is_hidden)
            continue;
        ok = add_rest(&g, l, &l->runs.v[i], &out);
        for (size_t k = before; ok && k < out.runs.n; k++)
            ok = enter_run(&g, &out, &out.runs.v[k]);
    }
    array_free(&g.steps);
    plb_free(g.head);
    if (ok) {
        plb_run_list_free(l);
        *l = out;
    } else {
        plb_run_list_free(&out);
    }
    return ok || plb_fail_memory(err);
}
