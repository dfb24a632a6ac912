/* SPDX-License-Identifier: MIT
 *
 * Plan: from what was drawn to what a hand draws. plb_plan is the table of contents:
 *
 *     each item      visible? → its marks as tracks → clip → dash → corners → strokes
 *     all strokes    identities
 */
#include "plan/plan.h"

#include "plan/pass.h"
#include "plan/track.h"

#include <string.h>

/* Paint lighter than this leaves no mark on white paper (a faint grey grid of 0.9 still does). */
#define NO_MARK_LIGHTNESS 0.985
/* A point painted with a round or square cap is a dot: a touch of the pencil this long (chosen by eye). */
#define DOT_MM 0.12
/* Shorter scraps that cutting at corners leaves are dropped. */
#define SHORTEST_STROKE_MM 0.03

typedef struct {
    const display_list *list;
    const plan_options *how;
    clipper *clip;
    stroke_list *out;
    error *err;
    const item *it; /* the one at work */
    touch touch;    /* of its lines */
} planner;

/* ---- from a track to strokes, last step first: each hands on to the one above it ---- */

static bool add_stroke(void *closure, const track *t)
{
    planner *p = closure;
    stroke_list *out = p->out;
    if (t->points.n < 2 || plb_track_length(t) < SHORTEST_STROKE_MM)
        return true;
    if (out->strokes.n >= PLAN_MAX_STROKES || t->points.n > PLAN_MAX_POINTS - out->points.n)
        return plb_fail(p->err, ERROR_LIMIT, "the drawing has more than %u strokes or %u points", PLAN_MAX_STROKES, PLAN_MAX_POINTS);
    stroke s = {.touch = t->touch, .first = out->points.n, .n = t->points.n, .closed = t->closed, .corner_first = t->corner_first, .corner_last = t->corner_last};
    if (!array_reserve(&out->points, t->points.n) || !array_push(&out->strokes, s))
        return plb_fail_memory(p->err);
    for (size_t i = 0; i < t->points.n; i++)
        out->points.v[out->points.n++] = t->points.v[i].at;
    return true;
}

static bool add_dot(planner *p, point at)
{
    track_point ends[2] = {{{at.x - DOT_MM / 2, at.y}, false}, {{at.x + DOT_MM / 2, at.y}, false}};
    track dot = {.points = {ends, 2, 2}, .touch = p->touch};
    return add_stroke(p, &dot);
}

static bool cut_at_corners(void *closure, const track *t)
{
    planner *p = closure;
    return plb_plan_corners(t, add_stroke, p, p->err);
}

static bool cut_into_dashes(void *closure, const track *t)
{
    planner *p = closure;
    if (t->points.n == 1)
        return p->it->kind == ITEM_FILL || p->it->cap == LINE_CAP_BUTT || add_dot(p, t->points.v[0].at);
    return plb_plan_dash(p->it, t, cut_at_corners, p, p->err);
}

/* Where all marks come in, whatever made them: `t` carries its own touch. */
static bool add_mark(void *closure, const track *t)
{
    planner *p = closure;
    return plb_plan_clip(p->clip, p->it->clip, t, cut_into_dashes, p, p->err);
}

/* ---- from an item to tracks ---- */

static bool add_line(void *closure, const track *t)
{
    planner *p = closure;
    track touched = *t; /* the points stay the sender's */
    touched.touch = p->touch;
    return add_mark(p, &touched);
}

static bool draw_line(planner *p)
{
    return plb_plan_flatten(&p->it->path, false, add_line, p, p->err);
}

static bool draw_outline(planner *p)
{
    return plb_plan_flatten(&p->it->path, true, add_line, p, p->err);
}

static bool draw_fill(planner *p)
{
    return p->how->fill == FILL_NONE || draw_outline(p);
}

/* ---- which items ---- */

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

static bool draw_item(planner *p, size_t i)
{
    if (!is_wanted(p->list, i))
        return true;
    p->it = &p->list->items.v[i];
    p->touch = TOUCH_USUAL;
    return p->it->kind == ITEM_STROKE ? draw_line(p) : draw_fill(p);
}

static bool draw_items(planner *p)
{
    bool ok = true;
    for (size_t i = 0; ok && i < p->list->items.n; i++)
        ok = draw_item(p, i);
    return ok;
}

plan_options plb_plan_options_default(void)
{
    return (plan_options){.fill = FILL_OUTLINE, .text = TEXT_OUTLINE, .pencil_width = 0.35, .seed = 1};
}

bool plb_plan(const display_list *list, const plan_options *o, const messenger *say, stroke_list *out, error *err)
{
    memset(out, 0, sizeof *out);
    out->width = list->width;
    out->height = list->height;
    planner p = {.list = list, .how = o, .clip = plb_clipper_new(list, err), .out = out, .err = err};
    bool ok = p.clip && draw_items(&p) && plb_plan_identify(out, err);
    if (ok)
        plb_say(say, MESSAGE_DETAIL, "%zu items make %zu strokes", list->items.n, out->strokes.n);
    else
        plb_stroke_list_free(out);
    plb_clipper_free(p.clip);
    return ok;
}
