/* SPDX-License-Identifier: MIT
 *
 * Plan, one item, marks: see marks.h.
 *
 *     a line        its subpaths
 *     a wide line   its dashes, each covered by passes side by side
 *     a fill        letters, if it is like lettering; else hatching and, where that does not follow the edge, its outline
 */
#include "plan/marks.h"

#include "plan/hatch/hatch_tone.h"
#include "plan/item/stages.h"
#include "plan/item/weight.h"
#include "plan/item/wide.h"
#include "plan/letter/letter.h"
#include "plan/shape/flatten.h"

#include <math.h>

/* A stroke that differs by so much in lightness from the fill that it goes round is an edge (chosen by eye). */
#define EDGE_CONTRAST 0.2
/* The outline of a hatched area keeps within this of its place, mm: nearer than half the pencil's line, so that no paper shows between. */
#define OUTLINE_STRAY_MM 0.15f
/* A dot of lettering, or a pair of dots, is at most so broad against a letter's longer side, at most so far from that letter, and painted at most so many items
 * before or after it (chosen by eye). */
#define DOT_SIZE 0.4
#define DOT_NEAR 0.8
#define DOT_ITEMS 2u
/* A solid stop is pressed so many times as hard as other solid shapes; stems thicker than so many mm are shaded as areas (chosen by eye). */
#define STOP_PRESSURE 1.6f
#define STOP_SHADED_MM 1.2

static stroke_style style_of(const plan_context *p, const item *it)
{
    stroke_style style = plb_style_of(it, p->options, p->usual_width);
    if (p->crowd[it - p->list->items.v] == CROWD_LINE) {
        style.pressure *= CROWD_LINE_PRESSURE;
        style.breadth = 1; /* with the side of the lead */
    }
    return style;
}

/* Presses a stop, or the dot of an i, that is solid because its letters are thick as firmly as they are drawn, with the softer pencil where that shades
 * them. */
static void press_stop(const plan_context *p, size_t i, track_list *marks)
{
    const item *it = &p->list->items.v[i];
    box b = plb_path_bounds(&it->path);
    letter_run r = plb_letter_run_at(p->runs, i);
    if (r.fills < 2 || fmax(b.x1 - b.x0, b.y1 - b.y0) > DOT_SIZE * r.size)
        return;
    for (size_t k = 0; k < marks->tracks.n; k++) {
        marks->tracks.v[k].style.pressure *= STOP_PRESSURE;
        marks->tracks.v[k].style.is_soft = r.stem > STOP_SHADED_MM && plb_is_soft_tone(1 - plb_paint_lightness(it->paint), p->options);
    }
}

/* Makes the dots of a crowd lightly. */
static void lighten_dot(const plan_context *p, size_t i, track_list *marks)
{
    for (size_t k = 0; p->crowd[i] == CROWD_DOT && k < marks->tracks.n; k++)
        marks->tracks.v[k].style.pressure *= CROWD_DOT_PRESSURE;
}

static void set_style(track_list *l, size_t first, stroke_style style)
{
    for (size_t k = first; k < l->tracks.n; k++)
        l->tracks.v[k].style = style;
}

/* Tells whether items are a fill that is hatched and the stroke around it. */
static bool is_hatched_in(const plan_context *p, const item *fill, const item *it)
{
    return p->options->fill == FILL_HATCH && fill->kind == ITEM_FILL && plb_leaves_mark(fill) && plb_path_equal(&fill->path, &it->path);
}

/* An outline is drawn with an eye on the hatching that it bounds. */
static bool add_line(const plan_context *p, size_t i, track_list *out, error *err)
{
    const item *it = &p->list->items.v[i];
    bool ok = plb_plan_flatten(&it->path, false, out, err);
    stroke_style style = style_of(p, it);
    if ((i > 0 && is_hatched_in(p, it - 1, it)) || (i + 1 < p->list->items.n && is_hatched_in(p, it + 1, it)))
        style.max_stray = OUTLINE_STRAY_MM;
    set_style(out, 0, style);
    return ok;
}

static bool add_wide_line(const plan_context *p, const item *it, track_list *out, error *err)
{
    track_list lines = {0}, dashes = {0};
    bool ok = plb_plan_flatten(&it->path, false, &lines, err) && plb_plan_dash(it, &lines, p->options, &dashes, err);
    stroke_style style = style_of(p, it);
    style.breadth = 1; /* with the side of the lead */
    set_style(&dashes, 0, style);
    for (size_t k = 0; ok && k < dashes.tracks.n; k++) {
        track t = plb_track_at(&dashes, k);
        ok = plb_plan_passes(it, &t, p->options, out, err);
    }
    plb_tracks_free(&lines);
    plb_tracks_free(&dashes);
    return ok;
}

static bool add_outline(const plan_context *p, const item *it, track_list *out, error *err)
{
    size_t first = out->tracks.n;
    bool ok = plb_plan_flatten(&it->path, true, out, err);
    stroke_style style = style_of(p, it);
    if (p->options->fill == FILL_HATCH)
        style.max_stray = OUTLINE_STRAY_MM;
    set_style(out, first, style);
    for (size_t k = first; k < out->tracks.n; k++)
        out->tracks.v[k].is_outline = true;
    return ok;
}

/* A shape that is filled and stroked is outlined once, by its stroke. */
static bool is_outlined_by(const item *fill, const item *other)
{
    return fill->kind == ITEM_FILL && other->kind == ITEM_STROKE && plb_leaves_mark(other) && plb_path_equal(&fill->path, &other->path);
}

/* Tells whether the stroke that follows a fill's outline has another tone than the fill: a bar or a facet with an edge, no letter. */
static bool is_edge(const item *fill, const item *outline)
{
    return fabs(plb_paint_lightness(outline->paint) - plb_paint_lightness(fill->paint)) > EDGE_CONTRAST;
}

/* Lettering has its own pressure; the paint's comes on top. The outline of a letter, stroked after it, is not drawn, too; one that was
 * stroked before it is all that is drawn. */
static bool add_letters(const plan_context *p, size_t i, bool outlined, bool *taken, track_list *out, bool *stands_for_next, error *err)
{
    const item *it = &p->list->items.v[i];
    text_style text = p->options->text;
    stroke_style style = style_of(p, it);
    if (!plb_plan_letter(it, plb_letter_run_at(p->runs, i), p->options, p->glyphs, taken, out, err))
        return false;
    for (size_t k = 0; k < out->tracks.n; k++) {
        out->tracks.v[k].style.pressure *= style.pressure;
        out->tracks.v[k].style.colour = style.colour;
    }
    if (text != TEXT_HAND)
        plb_tracks_clear(out);
    *stands_for_next = *taken && outlined && text != TEXT_OUTLINE; /* the stroke is the next item */
    return !*taken || text != TEXT_OUTLINE || outlined || add_outline(p, it, out, err);
}

/* Tells whether a fill is a stop, a comma or the dot of an i: small against a letter beside it that is painted just before or after it. Where
 * lettering is drawn a dot by itself comes out right; where it is left out, or outlined, the dot must go with it. */
static bool belongs_to_letter(const plan_context *p, size_t i, bool *belongs, error *err)
{
    const display_list *list = p->list;
    box b = plb_path_bounds(&list->items.v[i].path);
    double w = b.x1 - b.x0, high = b.y1 - b.y0;
    track_list letter = {0};
    bool ok = true;
    *belongs = false;
    for (size_t k = i > DOT_ITEMS ? i - DOT_ITEMS : 0; ok && !*belongs && k <= i + DOT_ITEMS && k < list->items.n; k++) {
        const item *it = &list->items.v[k];
        box n = plb_path_bounds(&it->path);
        double h = fmax(n.x1 - n.x0, n.y1 - n.y0), apart = fmax(fmax(n.x0 - b.x1, b.x0 - n.x1), fmax(n.y0 - b.y1, b.y0 - n.y1));
        bool is_near = k != i && it->kind == ITEM_FILL && apart < DOT_NEAR * h && fmin(w, high) < DOT_SIZE * h && fmax(w, high) < h;
        ok = !is_near || plb_plan_letter(it, plb_letter_run_at(p->runs, k), p->options, p->glyphs, belongs, &letter, err);
    }
    plb_tracks_free(&letter);
    return ok;
}

/* Tells whether a fill is shaded together with others. In colour each has strokes of its own. */
static bool is_cell(const plan_context *p, size_t i)
{
    return p->options->fill == FILL_HATCH && !p->options->colour && plb_cells_group(p->cells, i) > 0;
}

int plb_marks_clip(const plan_context *p, size_t i)
{
    return is_cell(p, i) ? plb_cells_clip(p->cells, i) : p->list->items.v[i].clip;
}

/* Adds the hatching of a group of cells in place of its last one. Edges of the cells' own tone are not drawn. */
static bool add_cell(const plan_context *p, size_t i, track_list *out, bool *stands_for_next, error *err)
{
    const item *it = &p->list->items.v[i];
    tone_field f = {0};
    *stands_for_next = i + 1 < p->list->items.n && is_outlined_by(it, it + 1) && !is_edge(it, it + 1);
    if (!plb_cells_is_last(p->cells, i))
        return true;
    bool ok = plb_cells_field(p->cells, plb_cells_group(p->cells, i), &f, err) && plb_plan_hatch_cells(&p->hatcher, it, &f, out, err);
    plb_field_free(&f);
    return ok;
}

static bool add_fill(const plan_context *p, size_t i, track_list *out, bool *stands_for_next, error *err)
{
    const item *it = &p->list->items.v[i];
    fill_style fill = p->options->fill;
    if (is_cell(p, i))
        return add_cell(p, i, out, stands_for_next, err);
    bool outlined_before = i > 0 && is_outlined_by(it, it - 1), outlined_after = i + 1 < p->list->items.n && is_outlined_by(it, it + 1);
    bool outlined = outlined_before || outlined_after, is_letter = false, is_blot = false, outline = fill == FILL_OUTLINE;
    if (fill == FILL_HATCH && !plb_is_blot(it, p->options, &is_blot, err))
        return false;
    bool has_edge = outlined_before || (outlined_after && is_edge(it, it + 1));
    if (!is_blot && !has_edge && !add_letters(p, i, outlined, &is_letter, out, stands_for_next, err))
        return false;
    if (!is_letter && p->options->text != TEXT_HAND) {
        if (!belongs_to_letter(p, i, &is_letter, err))
            return false;
        if (is_letter && p->options->text == TEXT_OUTLINE && !outlined)
            return add_outline(p, it, out, err);
    }
    if (is_letter)
        return true;
    if (fill == FILL_HATCH && !plb_plan_hatch(&p->hatcher, it, style_of(p, it).colour, &outline, out, err))
        return false;
    if (is_blot)
        press_stop(p, i, out);
    return !outline || outlined || add_outline(p, it, out, err);
}

bool plb_plan_marks(const plan_context *p, size_t i, track_list *out, bool *stands_for_next, error *err)
{
    const item *it = &p->list->items.v[i];
    plb_tracks_clear(out);
    *stands_for_next = false;
    bool ok = it->kind == ITEM_FILL ? add_fill(p, i, out, stands_for_next, err) : plb_is_wide(it, p->options) ? add_wide_line(p, it, out, err) : add_line(p, i, out, err);
    lighten_dot(p, i, out);
    return ok;
}
