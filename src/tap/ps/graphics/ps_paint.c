/* SPDX-License-Identifier: MIT
 *
 * Turns stroke and fill into items of the display list, still in device space (PLRM, section 4.5).
 */
#include "tap/ps/ps.h"

#include <math.h>
#include <string.h>

/* Drops moves at the end, which draw nothing; false when nothing is left. */
static bool trim(path *shape)
{
    while (shape->ops.n && shape->ops.v[shape->ops.n - 1] == PATH_MOVE) {
        shape->ops.n--;
        shape->points.n--;
    }
    return shape->ops.n > 0;
}

static bool set_dash(ps *p, item *it, double scale)
{
    const ps_state *g = ps_gs(p);
    unsigned rounds = g->dash.n % 2 ? 2 : 1; /* an odd count alternates its meaning from round to round */
    for (unsigned i = 0; i < g->dash.n * rounds; i++)
        if (!array_push(&it->dash, ps_value(g->dash.as.array[i % g->dash.n]) * scale))
            return plb_fail_memory(&p->err);
    it->dash_offset = g->dash_offset * scale;
    return true;
}

static bool set_pen(ps *p, item *it)
{
    static const line_cap caps[] = {LINE_CAP_BUTT, LINE_CAP_ROUND, LINE_CAP_SQUARE};
    double scale = plb_matrix_expansion(ps_gs(p)->ctm);
    it->cap = caps[ps_gs(p)->cap];
    it->width = ps_gs(p)->line_width * scale;
    if (!isfinite(it->width))
        return plb_ps_raise(p, PS_LIMITCHECK);
    return !(scale > 0) || set_dash(p, it, scale);
}

static bool add_item(ps *p, item *it)
{
    const ps_state *g = ps_gs(p);
    if (!plb_path_append(&it->path, &g->path->path, MATRIX_IDENTITY))
        return plb_fail_memory(&p->err);
    if (!trim(&it->path) || !plb_ps_may_mark(p))
        return true;
    it->paint = g->paint;
    it->clip = g->clip;
    if (it->kind == ITEM_STROKE && !set_pen(p, it))
        return false;
    p->list_bytes += it->dash.n * sizeof(double);
    return plb_ps_count_list(p, &it->path) && plb_ps_charge(p, it->path.points.n / 8) &&
           plb_list_add(p->list, it, &p->err);
}

bool plb_ps_paint_path(ps *p, item_kind kind, bool even_odd)
{
    const ps_state *g = ps_gs(p);
    item it = {.kind = g->is_outline ? ITEM_STROKE : kind, .even_odd = even_odd && !g->is_outline};
    bool done = g->nothing_visible || g->no_output;
    if (!done && it.kind == ITEM_FILL && g->pattern.type == PS_DICT && !plb_ps_fill_with_tiles(p, even_odd, &done))
        return false;
    bool good = done || add_item(p, &it);
    plb_item_free(&it);
    return good && plb_ps_new_path(p);
}

static bool op_stroke(ps *p) { return plb_ps_paint_path(p, ITEM_STROKE, false); }
static bool op_fill(ps *p) { return plb_ps_paint_path(p, ITEM_FILL, false); }
static bool op_eofill(ps *p) { return plb_ps_paint_path(p, ITEM_FILL, true); }

/* ---- rectangles ------------------------------------------------------------------------------------------- */

/* Appends the rectangles that `operands` (four numbers, or one array of numbers) describe. */
static bool add_rectangles(ps *p, const ps_object *operands)
{
    uint32_t n = operands->type == PS_ARRAY ? operands->n : 4;
    const ps_object *v = operands->type == PS_ARRAY ? operands->as.array : operands;
    if (n % 4)
        return plb_ps_raise(p, PS_RANGECHECK);
    for (uint32_t i = 0; i < n; i++)
        if (!ps_is_number(v[i]))
            return plb_ps_raise(p, PS_TYPECHECK);
    for (uint32_t i = 0; i < n; i += 4)
        if (!plb_ps_rectangle(p, (point){ps_value(v[i]), ps_value(v[i + 1])}, ps_value(v[i + 2]), ps_value(v[i + 3])))
            return false;
    return plb_ps_charge(p, n);
}

/* Gives the number of operands that the rectangles take, from the top downwards under `above` others; 0: raised. */
static unsigned rectangle_operands(ps *p, unsigned above)
{
    if (p->operand_count <= above) {
        plb_ps_raise(p, PS_STACKUNDERFLOW);
        return 0;
    }
    unsigned n = ps_args(p, above + 1)->type == PS_ARRAY ? 1 : 4;
    if (p->operand_count < n + above) {
        plb_ps_raise(p, PS_STACKUNDERFLOW);
        return 0;
    }
    return n;
}

/* Paints in a graphics state of its own, so that the current path stays. */
static bool paint_rectangles(ps *p, item_kind kind, unsigned above, const matrix *pen)
{
    unsigned n = rectangle_operands(p, above);
    if (!n || !plb_ps_save_state(p))
        return false;
    bool good = plb_ps_new_path(p) && add_rectangles(p, ps_args(p, n + above)) &&
                (!pen || plb_ps_set_ctm(p, plb_matrix_multiply(*pen, ps_gs(p)->ctm))) && plb_ps_paint_path(p, kind, false);
    plb_ps_restore_state(p);
    if (good)
        ps_drop(p, n + above);
    return good;
}

static bool op_rectfill(ps *p)
{
    return paint_rectangles(p, ITEM_FILL, 0, NULL);
}

/* A matrix on top of the rectangles shapes the pen; six numbers cannot be rectangles. */
static bool op_rectstroke(ps *p)
{
    matrix pen;
    ps_object top = *ps_args(p, 1);
    if (top.type != PS_ARRAY || top.n != 6)
        return paint_rectangles(p, ITEM_STROKE, 0, NULL);
    return plb_ps_get_matrix(p, top, &pen) && paint_rectangles(p, ITEM_STROKE, 1, &pen);
}

static bool op_rectclip(ps *p)
{
    unsigned n = rectangle_operands(p, 0);
    if (!n || !plb_ps_new_path(p) || !add_rectangles(p, ps_args(p, n)) || !plb_ps_clip_to_path(p, false))
        return false;
    ps_drop(p, n);
    return plb_ps_new_path(p);
}

/* ---- shadings --------------------------------------------------------------------------------------------- */

/* Gives the mean of a function's first and last values, where the function states them; else a middle grey. */
static void mean_of_function(ps *p, const ps_dict *shading, double *grey)
{
    ps_object *function = plb_ps_get_text(p, shading, "Function");
    *grey = 0.5;
    if (!function || function->type != PS_DICT)
        return;
    ps_object *first = plb_ps_get_text(p, function->as.dict, "C0"), *last = plb_ps_get_text(p, function->as.dict, "C1");
    if (!first || !last || first->type != PS_ARRAY || last->type != PS_ARRAY || !first->n || first->n != last->n ||
        first->n > 3)
        return;
    *grey = 0;
    for (uint32_t i = 0; i < first->n; i++)
        *grey += (ps_value(first->as.array[i]) + ps_value(last->as.array[i])) / (2 * first->n);
    *grey = *grey < 0 ? 0 : *grey > 1 ? 1 : *grey;
}

/* Paints all that the clip leaves, for a shading: a fill of the clip's bounds with one mean grey. */
static bool op_shfill(ps *p)
{
    double grey;
    mean_of_function(p, ps_args(p, 1)->as.dict, &grey);
    if (plb_ps_leave_to_ghostscript(p, OMISSION_SHADING))
        return true;
    if (!plb_ps_save_state(p))
        return false;
    box b = plb_ps_clip_bounds(p);
    ps_gs(p)->ctm = MATRIX_IDENTITY;
    ps_gs(p)->paint = (paint){PAINT_GRADIENT, grey, grey, grey, 1};
    bool good = plb_ps_new_path(p) && plb_ps_rectangle(p, (point){b.x0, b.y0}, b.x1 - b.x0, b.y1 - b.y0) &&
                plb_ps_paint_path(p, ITEM_FILL, false);
    plb_ps_restore_state(p);
    if (good)
        ps_drop(p, 1);
    return good;
}

const ps_operator plb_ps_paint_operators[] = {
    {"stroke", "", op_stroke},
    {"fill", "", op_fill},
    {"eofill", "", op_eofill},
    {"rectfill", "x", op_rectfill},
    {"rectstroke", "x", op_rectstroke},
    {"rectclip", "x", op_rectclip},
    {"shfill", "d", op_shfill},
    {NULL, NULL, NULL},
};
