/* SPDX-License-Identifier: MIT
 *
 * Plan: from what was drawn to what a hand draws. plb_plan is the table of contents:
 *
 *     item → visible? → flatten → clip → dash → corners → stroke
 */
#include "plan/plan.h"

#include "base/random.h"
#include "plan/track.h"

#include <math.h>
#include <string.h>

/* Paint lighter than this leaves no mark on white paper (a faint grey grid of 0.9 still does). */
#define NO_MARK_LIGHTNESS 0.985
/* A point painted with a round or square cap is a dot: a touch of the pencil this long (chosen by eye). */
#define DOT_MM 0.12
/* Shorter scraps that cutting at corners leaves are dropped. */
#define SHORTEST_STROKE_MM 0.03
/* Identities hash positions in this unit, so that rounding noise does not change a stroke. */
#define IDENTITY_UNIT_MM 0.001

/* Identities given so far: open addressing, 0 marks an empty place. */
typedef struct {
    uint64_t *key;
    size_t n, room;
} identity_set;

typedef struct {
    const item *it;
    clipper *clip;
    identity_set given;
    stroke_list *out;
    error *err;
} planner;

/* Whether `key` was new to the set, in *fresh; false when out of memory. */
static bool insert(identity_set *s, uint64_t key, bool *fresh)
{
    if (s->n * 2 >= s->room) {
        identity_set bigger = {plb_new(s->room ? s->room * 2 : 1024, sizeof(uint64_t)), 0, s->room ? s->room * 2 : 1024};
        bool ignored;
        if (!bigger.key)
            return false;
        for (size_t i = 0; i < s->room; i++)
            if (s->key[i])
                insert(&bigger, s->key[i], &ignored);
        plb_free(s->key);
        *s = bigger;
    }
    size_t at = random_mix(key) & (s->room - 1);
    while (s->key[at] && s->key[at] != key)
        at = (at + 1) & (s->room - 1);
    *fresh = s->key[at] != key;
    if (*fresh) {
        s->key[at] = key;
        s->n++;
    }
    return true;
}

static uint64_t hash_shape(const track *t)
{
    uint64_t h = t->closed ? 0x9ae16a3b2f90404fu : 0xc3a5c85c97cb3127u;
    for (size_t i = 0; i < t->points.n; i++)
        h = random_fold(h, llround(t->points.v[i].at.x / IDENTITY_UNIT_MM), llround(t->points.v[i].at.y / IDENTITY_UNIT_MM));
    return h | 1;
}

/* A hash of the shape alone, so that nothing else in the drawing moves it; the second stroke of one shape, and the
 * third, step on from there, so that no two share their random numbers. */
static bool identify(identity_set *given, const track *t, uint64_t *identity)
{
    bool fresh = false;
    for (uint64_t h = hash_shape(t); !fresh; h = random_mix(h) | 1) {
        if (!insert(given, h, &fresh))
            return false;
        *identity = h;
    }
    return true;
}

static bool add_stroke(void *closure, const track *t)
{
    planner *p = closure;
    stroke_list *out = p->out;
    if (t->points.n < 2 || plb_track_length(t) < SHORTEST_STROKE_MM)
        return true;
    if (out->strokes.n >= PLAN_MAX_STROKES || t->points.n > PLAN_MAX_POINTS - out->points.n)
        return plb_fail(p->err, ERROR_LIMIT, "the drawing has more than %u strokes or %u points", PLAN_MAX_STROKES, PLAN_MAX_POINTS);
    stroke s = {.touch = t->touch, .first = out->points.n, .n = t->points.n, .closed = t->closed, .corner_first = t->corner_first, .corner_last = t->corner_last};
    if (!identify(&p->given, t, &s.identity) || !array_reserve(&out->points, t->points.n) || !array_push(&out->strokes, s))
        return plb_fail_memory(p->err);
    for (size_t i = 0; i < t->points.n; i++)
        out->points.v[out->points.n++] = t->points.v[i].at;
    return true;
}

static bool add_dot(planner *p, point at)
{
    track_point ends[2] = {{{at.x - DOT_MM / 2, at.y}, false}, {{at.x + DOT_MM / 2, at.y}, false}};
    track dot = {.points = {ends, 2, 2}, .touch = TOUCH_USUAL};
    return add_stroke(p, &dot);
}

static bool after_dash(void *closure, const track *t)
{
    planner *p = closure;
    return plb_plan_corners(t, add_stroke, p, p->err);
}

static bool after_clip(void *closure, const track *t)
{
    planner *p = closure;
    if (t->points.n == 1)
        return p->it->kind == ITEM_FILL || p->it->cap == LINE_CAP_BUTT || add_dot(p, t->points.v[0].at);
    return plb_plan_dash(p->it, t, after_dash, p, p->err);
}

static bool after_flatten(void *closure, const track *t)
{
    planner *p = closure;
    track touched = *t; /* the points stay the sender's */
    touched.touch = TOUCH_USUAL;
    return plb_plan_clip(p->clip, p->it->clip, &touched, after_clip, p, p->err);
}

static bool leaves_mark(const item *it)
{
    return plb_paint_lightness(it->paint) <= NO_MARK_LIGHTNESS;
}

/* A shape that is filled and stroked is outlined once, by its stroke. */
static bool is_outlined_by(const item *fill, const item *other)
{
    return fill->kind == ITEM_FILL && other->kind == ITEM_STROKE && leaves_mark(other) && plb_path_equal(&fill->path, &other->path);
}

static bool is_wanted(const display_list *list, size_t i)
{
    const item *it = &list->items.v[i];
    bool before = i > 0 && is_outlined_by(it, it - 1);
    bool after = i + 1 < list->items.n && is_outlined_by(it, it + 1);
    return leaves_mark(it) && !before && !after;
}

plan_options plb_plan_options_default(void)
{
    return (plan_options){.fill = FILL_OUTLINE, .text = TEXT_OUTLINE, .pencil_width = 0.35, .seed = 1};
}

bool plb_plan(const display_list *list, const plan_options *o, const messenger *say, stroke_list *out, error *err)
{
    (void)o;
    memset(out, 0, sizeof *out);
    out->width = list->width;
    out->height = list->height;
    planner p = {.clip = plb_clipper_new(list, err), .out = out, .err = err};
    bool ok = p.clip;
    for (size_t i = 0; ok && i < list->items.n; i++)
        if (is_wanted(list, i)) {
            p.it = &list->items.v[i];
            ok = plb_plan_flatten(&p.it->path, p.it->kind == ITEM_FILL, after_flatten, &p, err);
        }
    if (ok)
        plb_say(say, MESSAGE_DETAIL, "%zu items make %zu strokes", list->items.n, out->strokes.n);
    plb_clipper_free(p.clip);
    plb_free(p.given.key);
    if (!ok)
        plb_stroke_list_free(out);
    return ok;
}
