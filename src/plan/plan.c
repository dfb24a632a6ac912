/* SPDX-License-Identifier: MIT
 *
 * Plan: from what was drawn to what a hand draws. plb_plan is the table of contents:
 *
 *     all fills      how dark each is shaded, which are shaded as one, which need a direction of their own
 *     each item      visible? → marks → fuse → clip → dash → hidden → scraps → simplify → corners → strokes
 *     all strokes    clear of lettering → drawn once → joined → smooth → beside or upon each other? → habits → in order → identities
 *
 * Each stage of an item takes an array of tracks and gives one; each pass takes the list of all strokes as the one before left it.
 */
#include "plan/plan.h"

#include "plan/habits/habits.h"
#include "plan/item/stages.h"
#include "plan/item/weight.h"
#include "plan/marks.h"
#include "plan/strokes/passes.h"

#include <string.h>

/* Lines closer than this part of the pencil's width are one line (chosen by eye). */
#define SAME_LINE_WIDTHS 0.2
/* Shorter scraps are dropped: of the drawing's own lines once pieces of one line have been joined, else at once. */
#define SHORTEST_STROKE_MM 0.03
/* So many marks of an item go through the stages at a time: the arrays between the stages stay small, whatever the item. */
#define BATCH 256

plan_options plb_plan_options_default(void)
{
    static const tone_scale of_hb = {{.053, .084, .126, .179, .275, .394, .51, .601, .654}};
    return (plan_options){.tone = of_hb, .fill = FILL_OUTLINE, .text = TEXT_HAND, .pencil_width = 0.35, .shade_width = 0.35, .point = 1, .reduction = 1, .max_length = 1e7, .threads = 1, .seed = 1};
}

/* ---- one item ---- */

typedef struct {
    plan_context context;
    track_list marks;   /* of the item at work … */
    track_list a, b;    /* … and what the stages make of some of them, in turns */
    stroke_list *out;
    double length;      /* of its strokes, mm */
    error *err;
} planner;

static bool add_strokes(planner *p, const track_list *tracks)
{
    stroke_list *out = p->out;
    for (size_t i = 0; i < tracks->tracks.n; i++) {
        track t = plb_track_at(tracks, i);
        if (t.n < 2 || (t.style.kind != STROKE_LINE && plb_track_length(&t) < SHORTEST_STROKE_MM))
            continue;
        if (out->strokes.n >= PLAN_MAX_STROKES || t.n > PLAN_MAX_POINTS - out->points.n)
            return plb_fail(p->err, ERROR_LIMIT, "the drawing has more than %u strokes or %u points", PLAN_MAX_STROKES, PLAN_MAX_POINTS);
        p->length += plb_track_length(&t);
        if (p->length > p->context.options->max_length)
            return plb_fail(p->err, ERROR_LIMIT, "the drawing needs more than %g m of pencil line; --limit-length allows more", p->context.options->max_length / 1000);
        stroke s = {.style = t.style, .max_deviation = t.style.max_stray, .first = out->points.n, .n = t.n, .closed = t.closed, .corner_first = t.corner_first, .corner_last = t.corner_last};
        if (!array_reserve(&out->points, t.n) || !array_push(&out->strokes, s))
            return plb_fail_memory(p->err);
        for (size_t k = 0; k < t.n; k++)
            out->points.v[out->points.n++] = t.v[k].at;
    }
    return true;
}

static bool is_thin_line(const item *it, const plan_options *o)
{
    return it->kind == ITEM_STROKE && !plb_is_wide(it, o);
}

/* Tells whether the mark is part of a fill's outline, which goes through the stages by itself. */
static bool is_outline(const track_list *marks, size_t k)
{
    return marks->tracks.v[k].is_outline;
}

/* Tells how many marks from number k on go through the stages together: a batch of what lies inside an outline, or one track of the outline. */
static size_t count_batch(const track_list *marks, size_t k)
{
    size_t n = 1;
    while (!is_outline(marks, k) && n < BATCH && k + n < marks->tracks.n && !is_outline(marks, k + n))
        n++;
    return n;
}

/* Takes marks of item number `i` through the stages to strokes. */
static bool finish_marks(planner *p, size_t i, const track_list *marks)
{
    const plan_context *c = &p->context;
    const item *it = &c->list->items.v[i];
    const plan_options *o = c->options;
    track_list *a = &p->a, *b = &p->b;
    bool ok = true;
    if (is_outline(marks, 0)) {
        ok = plb_plan_fuse(c->occluders, i, marks, plb_tracks_clear(b), p->err);
        marks = b;
    }
    ok = ok && plb_plan_clip(c->clips, plb_marks_clip(c, i), marks, plb_tracks_clear(a), p->err);
    if (ok && is_thin_line(it, o)) {
        ok = plb_plan_dash(it, a, o, plb_tracks_clear(b), p->err);
        a = &p->b;
        b = &p->a;
    }
    return ok && plb_plan_hide(c->occluders, i, a, plb_tracks_clear(b), p->err) &&
           plb_plan_drop_scraps(b, o, plb_tracks_clear(a), p->err) &&
           plb_plan_simplify(a, o->pencil_width, plb_tracks_clear(b), p->err) &&
           plb_plan_corners(b, plb_tracks_clear(a), p->err) && add_strokes(p, a);
}

static bool draw_items(planner *p)
{
    const display_list *list = p->context.list;
    bool ok = true, is_drawn = false; /* by the marks of the item before */
    for (size_t i = 0; ok && i < list->items.n; i++) {
        bool is_visible = !is_drawn && plb_leaves_mark(&list->items.v[i]) && !plb_occluders_hide_item(p->context.occluders, i);
        is_drawn = false;
        if (!is_visible)
            continue;
        ok = plb_plan_marks(&p->context, i, &p->marks, &is_drawn, p->err);
        for (size_t k = 0, n; ok && k < p->marks.tracks.n; k += n) {
            track_list some = p->marks; /* borrowed */
            some.tracks.v += k;
            some.tracks.n = n = count_batch(&p->marks, k);
            ok = finish_marks(p, i, &some);
        }
    }
    plb_tracks_free(&p->marks);
    plb_tracks_free(&p->a);
    plb_tracks_free(&p->b);
    return ok;
}

/* ---- all strokes together ---- */

/* Drops scraps that nothing went on from. */
static void drop_short_strokes(stroke_list *out)
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
    if (!plb_plan_clearance(out, (o->pencil_width + o->shade_width) / 2, err) || !plb_plan_duplicates(out, same, err) || !plb_plan_join(out, same, o->threads, err))
        return false;
    drop_short_strokes(out);
    bool ok = plb_plan_smooth(out, err) && plb_plan_neighbours(out, o->threads, err) && plb_plan_nested(out, err) && plb_plan_junctions(out, o->threads, err) &&
              plb_plan_beside_letters(out, o->pencil_width, o->threads, err) && plb_plan_ruler(out, o, err) &&
              (!o->is_free || o->overshoot > 0 || plb_plan_meet_corners(out, o, err)) && plb_plan_habits(out, o, err) && plb_plan_order(out, err) &&
              plb_plan_identify(out, err);
    if (ok)
        plb_plan_touch(out, o);
    return ok;
}

/* ---- all of it ---- */

/* Takes the list with a dark paint for the letters that are to be written: an array of items of its own, whose paths stay the list's. */
static bool ink_letters(plan_context *c, const display_list *list, const bool *is_inked, error *err)
{
    c->inked = *list;
    c->list = &c->inked;
    c->inked.items.v = plb_new(list->items.n, sizeof *c->inked.items.v);
    if (!c->inked.items.v)
        return plb_fail_memory(err);
    for (size_t i = 0; i < list->items.n; i++) {
        c->inked.items.v[i] = list->items.v[i];
        if (is_inked[i])
            c->inked.items.v[i].paint = (paint){PAINT_SOLID, 0, 0, 0, 1};
    }
    return true;
}

static bool context_init(plan_context *c, const display_list *list, const plan_options *o, error *err)
{
    tone_curve curve;
    bool *is_inked = plb_new(list->items.n, sizeof *is_inked);
    *c = (plan_context){.options = o};
    bool ok = is_inked ? plb_tone_curve_find(list, o, &curve, is_inked, err) : plb_fail_memory(err);
    ok = ok && ink_letters(c, list, is_inked, err);
    plb_free(is_inked);
    if (!ok)
        return false;
    const display_list *drawn = list; /* a white word is no run with the dark area that it is written on */
    list = c->list;
    c->clips = plb_clipper_new(list, err);
    c->occluders = c->clips ? plb_occluders_new(list, o, c->clips, err) : NULL;
    c->cells = c->occluders ? plb_cells_new(list, c->occluders, err) : NULL;
    paint_manners manners;
    if (!c->cells || !plb_manners_find(list, o, &curve, c->cells, &manners, err))
        return false;
    c->crowd = plb_new(list->items.n, sizeof *c->crowd);
    if (!c->crowd)
        return plb_fail_memory(err);
    if (!o->colour && !plb_crowds_find(list, o, c->crowd, err))
        return false;
    c->glyphs = plb_glyphs_new(o->pencil_width, err);
    c->runs = c->glyphs ? plb_letter_runs_new(drawn, err) : NULL;
    c->hatcher = plb_hatcher(list, o, &curve, &manners);
    return c->runs && plb_usual_width(list, o, &c->usual_width, err);
}

static void context_free(plan_context *c)
{
    plb_letter_runs_free(c->runs);
    plb_glyphs_free(c->glyphs);
    plb_free(c->crowd);
    plb_cells_free(c->cells);
    plb_free(c->inked.items.v);
    plb_occluders_free(c->occluders);
    plb_clipper_free(c->clips);
}

bool plb_plan(const display_list *list, const plan_options *o, const log_sink *say, stroke_list *out, error *err)
{
    memset(out, 0, sizeof *out);
    out->width = list->width;
    out->height = list->height;
    planner p = {.out = out, .err = err};
    bool ok = context_init(&p.context, list, o, err) && draw_items(&p) && arrange(out, o, err);
    if (ok)
        plb_log(say, MESSAGE_DETAIL, "%zu items make %zu strokes, %.3g m", list->items.n, out->strokes.n, p.length / 1000);
    else
        plb_stroke_list_free(out);
    if (ok && plb_occluders_are_exhausted(p.context.occluders))
        plb_log(say, MESSAGE_WARNING, "too many areas lie over each other: not all hidden lines are left out");
    context_free(&p.context);
    return ok;
}
