/* SPDX-License-Identifier: MIT
 *
 * Plan: from what was drawn to what a hand draws. plb_plan is the table of contents:
 *
 *     each item      visible? → its marks as tracks → clip → dash → hidden → calm → corners → strokes
 *     all strokes    clear of lettering → drawn once → joined → smooth → beside or upon each other? → habits → in order → identities
 */
#include "plan/plan.h"

#include "plan/item/clip.h"
#include "plan/item/dash.h"
#include "plan/habits/habits.h"
#include "plan/hatch/hatch.h"
#include "plan/hidden/occlusion.h"
#include "plan/letter/letter.h"
#include "plan/strokes/pass.h"
#include "plan/track.h"
#include "plan/item/weight.h"
#include "plan/item/wide.h"

#include <string.h>

/* A point painted with a round or square cap is a dot: a touch of the pencil this long (chosen by eye). */
#define DOT_MM 0.12
/* Lines closer than this part of the pencil's width are one line (chosen by eye). */
#define SAME_LINE_WIDTHS 0.2
/* A hatch line ends this part of the pencil's width before what hides it (chosen by eye). */
#define NIB_WIDTHS 0.35
/* Shorter scraps are dropped: of the drawing's own lines once pieces of one line have been joined, else at once. */
#define SHORTEST_STROKE_MM 0.03

typedef struct {
    const display_list *list;
    const plan_options *how;
    clipper *clip;
    cover *cover;
    double usual_width; /* of the drawing's lines, mm */
    stroke_list *out;
    error *err;
    const item *it; /* the one at work */
    size_t index;   /* its number */
    const track *whole; /* what comes back as it was when nothing hides it; borrowed */
    bool outlined;  /* a stroke follows its outline */
    bool is_drawn;  /* the next one, too, by the one at work */
    hatcher hatcher;
} planner;

/* ---- from a track to strokes, last step first: each hands on to the one above it ---- */

static bool add_stroke(void *closure, const track *t)
{
    planner *p = closure;
    stroke_list *out = p->out;
    if (t->points.n < 2 || (t->style.kind != STROKE_LINE && plb_track_length(t) < SHORTEST_STROKE_MM))
        return true;
    if (out->strokes.n >= PLAN_MAX_STROKES || t->points.n > PLAN_MAX_POINTS - out->points.n)
        return plb_fail(p->err, ERROR_LIMIT, "the drawing has more than %u strokes or %u points", PLAN_MAX_STROKES, PLAN_MAX_POINTS);
    stroke s = {.style = t->style, .first = out->points.n, .n = t->points.n, .closed = t->closed, .corner_first = t->corner_first, .corner_last = t->corner_last};
    if (!array_reserve(&out->points, t->points.n) || !array_push(&out->strokes, s))
        return plb_fail_memory(p->err);
    for (size_t i = 0; i < t->points.n; i++)
        out->points.v[out->points.n++] = t->points.v[i].at;
    return true;
}

static bool cut_at_corners(void *closure, const track *t)
{
    planner *p = closure;
    return plb_plan_corners(t, add_stroke, p, p->err);
}

/* Of the drawing's own lines; hatching and lettering have been made for the pencil. */
static bool calm(void *closure, const track *t)
{
    planner *p = closure;
    return t->style.kind == STROKE_LINE ? plb_plan_simplify(t, p->how->pencil_width, cut_at_corners, p, p->err) : cut_at_corners(p, t);
}

static point drawn_back(point end, point towards, double by)
{
    return point_mix(end, towards, by / plb_point_distance(end, towards));
}

/* Of hatching and of passes no scraps are left where something hides the rest, and the line's width stays outside it: thin
 * white letters would else be closed. */
static bool leave_out_scraps(void *closure, const track *t)
{
    planner *p = closure;
    if (t == p->whole || t->style.kind != STROKE_HATCH)
        return calm(p, t);
    if (plb_track_length(t) < p->how->pencil_width)
        return true;
    size_t n = t->points.n, last = p->whole->points.n - 1;
    track_point ends[2] = {t->points.v[0], t->points.v[n - 1]};
    track kept = *t;
    if (n != 2)
        return cut_at_corners(p, t);
    double by = NIB_WIDTHS * p->how->pencil_width;
    if (plb_point_distance(ends[0].at, p->whole->points.v[0].at) > SAME_POINT_MM)
        ends[0].at = drawn_back(t->points.v[0].at, t->points.v[1].at, by);
    if (plb_point_distance(ends[1].at, p->whole->points.v[last].at) > SAME_POINT_MM)
        ends[1].at = drawn_back(t->points.v[1].at, t->points.v[0].at, by);
    kept.points.v = ends;
    return cut_at_corners(p, &kept);
}

static bool leave_out_hidden(void *closure, const track *t)
{
    planner *p = closure;
    p->whole = t;
    return plb_plan_hide(p->cover, p->index, t, leave_out_scraps, p, p->err);
}

static stroke_style style_of(const planner *p)
{
    return plb_style_of(p->it, p->how, p->usual_width);
}

static bool add_dot(planner *p, point at)
{
    track_point ends[2] = {{{at.x - DOT_MM / 2, at.y}, false}, {{at.x + DOT_MM / 2, at.y}, false}};
    track dot = {.points = {ends, 2, 2}, .style = style_of(p)};
    return leave_out_hidden(p, &dot);
}

static bool cut_into_dashes(void *closure, const track *t)
{
    planner *p = closure;
    if (t->points.n == 1)
        return p->it->kind == ITEM_FILL || p->it->cap == LINE_CAP_BUTT || add_dot(p, t->points.v[0].at);
    return plb_plan_dash(p->it, t, p->how, leave_out_hidden, p, p->err);
}

/* A line as thin as the pencil's. */
static bool add_line(void *closure, const track *t)
{
    planner *p = closure;
    track touched = *t; /* the points stay the sender's */
    touched.style = style_of(p);
    return plb_plan_clip(p->clip, p->it->clip, &touched, cut_into_dashes, p, p->err);
}

/* Where marks with a touch of their own come in: of hatching, of lettering, of wide lines. */
static bool add_mark(void *closure, const track *t)
{
    planner *p = closure;
    return plb_plan_clip(p->clip, p->it->clip, t, leave_out_hidden, p, p->err);
}

static bool add_passes(void *closure, const track *t)
{
    planner *p = closure;
    track touched = *t;
    touched.style = style_of(p);
    return plb_plan_passes(p->it, &touched, p->how, add_mark, p, p->err);
}

static bool add_wide_line(void *closure, const track *t)
{
    planner *p = closure;
    return plb_plan_dash(p->it, t, p->how, add_passes, p, p->err);
}

/* ---- from an item to tracks ---- */

static bool draw_line(planner *p)
{
    return plb_plan_flatten(&p->it->path, false, plb_is_wide(p->it, p->how) ? add_wide_line : add_line, p, p->err);
}

/* Where shapes of one paint lie upon each other their outlines would show what is not to be seen. */
static bool add_outline(void *closure, const track *t)
{
    planner *p = closure;
    return plb_plan_fuse(p->cover, p->index, t, add_line, p, p->err);
}

static bool draw_outline(planner *p)
{
    return plb_plan_flatten(&p->it->path, true, add_outline, p, p->err);
}

/* A shape that is filled and stroked is outlined once, by its stroke. */
static bool is_outlined_by(const item *fill, const item *other)
{
    return fill->kind == ITEM_FILL && other->kind == ITEM_STROKE && plb_leaves_mark(other) && plb_path_equal(&fill->path, &other->path);
}

/* Lettering has its own pressure; the paint's comes on top. */
static bool add_letter(void *closure, const track *t)
{
    planner *p = closure;
    track touched = *t;
    touched.style.pressure *= style_of(p).pressure;
    touched.style.colour = style_of(p).colour;
    return p->how->text != TEXT_HAND || add_mark(p, &touched);
}

/* The outline of a letter, stroked after it, is not drawn, too; one that was stroked before it is all that is drawn. */
static bool draw_letters(planner *p, bool *taken)
{
    *taken = false;
    if (p->index > 0 && is_outlined_by(p->it, p->it - 1))
        return true;
    if (!plb_plan_letter(p->it, p->how, taken, add_letter, p, p->err))
        return false;
    p->is_drawn = *taken && p->outlined && p->how->text != TEXT_OUTLINE; /* the stroke is the next item */
    return !*taken || p->how->text != TEXT_OUTLINE || p->outlined || draw_outline(p);
}

static bool draw_fill(planner *p)
{
    bool is_letter = false, is_blot = false;
    if (p->how->fill == FILL_HATCH && !plb_is_blot(p->it, p->how, &is_blot, p->err))
        return false;
    if (!is_blot && !draw_letters(p, &is_letter))
        return false;
    if (is_letter)
        return true;
    bool outline = p->how->fill == FILL_OUTLINE;
    if (p->how->fill == FILL_HATCH && !plb_plan_hatch(&p->hatcher, p->it, style_of(p).colour, &outline, add_mark, p, p->err))
        return false;
    return !outline || p->outlined || draw_outline(p);
}

/* ---- which items ---- */

static bool is_outlined(const display_list *list, size_t i)
{
    const item *it = &list->items.v[i];
    return (i > 0 && is_outlined_by(it, it - 1)) || (i + 1 < list->items.n && is_outlined_by(it, it + 1));
}

static bool draw_item(planner *p, size_t i)
{
    p->it = &p->list->items.v[i];
    p->index = i;
    bool is_drawn = p->is_drawn;
    p->is_drawn = false;
    if (!plb_leaves_mark(p->it) || is_drawn || plb_cover_hides_item(p->cover, i))
        return true;
    p->outlined = is_outlined(p->list, i);
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
    static const tone_scale of_hb = {{.07, .12, .2, .35, .45, .51}};
    return (plan_options){.tone = of_hb, .fill = FILL_OUTLINE, .text = TEXT_HAND, .pencil_width = 0.35, .threads = 1, .seed = 1};
}

/* ---- all strokes together ---- */

/* Scraps that nothing went on from. */
static void drop_scraps(stroke_list *out)
{
    size_t kept = 0;
    for (size_t i = 0; i < out->strokes.n; i++)
        if (plb_stroke_length(out, &out->strokes.v[i]) >= SHORTEST_STROKE_MM)
            out->strokes.v[kept++] = out->strokes.v[i];
    out->strokes.n = kept;
}

static bool arrange(stroke_list *out, const plan_options *o, error *err)
{
    double same = SAME_LINE_WIDTHS * o->pencil_width;
    if (!plb_plan_clearance(out, o->pencil_width, err) || !plb_plan_duplicates(out, same, err) || !plb_plan_join(out, same, o->threads, err))
        return false;
    drop_scraps(out);
    return plb_plan_smooth(out, err) && plb_plan_neighbours(out, o->threads, err) && plb_plan_junctions(out, o->threads, err) &&
           plb_plan_habits(out, o, err) && plb_plan_order(out, err) && plb_plan_identify(out, err);
}

static void report(const planner *p, const log_sink *say)
{
    plb_log(say, MESSAGE_DETAIL, "%zu items make %zu strokes", p->list->items.n, p->out->strokes.n);
    if (plb_cover_is_exhausted(p->cover))
        plb_log(say, MESSAGE_WARNING, "too many areas lie over each other: not all hidden lines are left out");
}

bool plb_plan(const display_list *list, const plan_options *o, const log_sink *say, stroke_list *out, error *err)
{
    memset(out, 0, sizeof *out);
    out->width = list->width;
    out->height = list->height;
    planner p = {.list = list, .how = o, .hatcher = plb_hatcher(list, o), .clip = plb_clipper_new(list, err), .out = out, .err = err};
    bool ok = p.clip && (p.cover = plb_cover_new(list, o, p.clip, err)) && plb_usual_width(list, o, &p.usual_width, err) &&
              draw_items(&p) && arrange(out, o, err);
    if (ok)
        report(&p, say);
    else
        plb_stroke_list_free(out);
    plb_cover_free(p.cover);
    plb_clipper_free(p.clip);
    return ok;
}
