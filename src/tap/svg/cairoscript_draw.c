/* SPDX-License-Identifier: MIT
 *
 * Holds the CairoScript operators that draw: paths, painting, and the state of a context that painting uses.
 */
#include "tap/svg/cairoscript_state.h"

#include <string.h>

static script_context *top_context(script_state *s) { return plb_script_top(s, OBJECT_CONTEXT); }

static bool op_pop(script_state *s) { return plb_script_pop(s); }
static bool op_identity(script_state *s) { return plb_script_push(s, (script_value){.kind = VALUE_IDENTITY}); }
static bool op_nothing(script_state *s) { (void)s; return true; }

/* ---- state of a context or pattern -------------------------------------------------------------------------- */

/* Pops a matrix: [xx yx xy yy x0 y0] or identity. */
static bool take_matrix(script_state *s, matrix *m)
{
    script_value *v = plb_script_peek(s, 0);
    if (!v)
        return false;
    *m = MATRIX_IDENTITY;
    if (v->kind != VALUE_IDENTITY) {
        if (v->kind != VALUE_ARRAY || v->array.n != 6)
            return plb_fail(s->err, ERROR_SYNTAX, "an operand is not a matrix");
        memcpy(m, s->numbers.v + v->array.first, sizeof *m);
    }
    return plb_script_pop(s);
}

static bool op_set_matrix(script_state *s)
{
    matrix m;
    script_value *v = take_matrix(s, &m) ? plb_script_peek(s, 0) : NULL;
    if (!v)
        return false;
    if (v->kind == VALUE_OBJECT && v->object->kind == OBJECT_PATTERN)
        ((script_pattern *)v->object)->matrix = m;
    else if (v->kind == VALUE_OBJECT && v->object->kind == OBJECT_CONTEXT)
        ((script_context *)v->object)->ctm = m;
    else
        return plb_fail(s->err, ERROR_SYNTAX, "set-matrix has nothing to set");
    return true;
}

static bool op_scale(script_state *s)
{
    double v[2];
    script_context *c = plb_script_take(s, 2, v) ? top_context(s) : NULL;
    if (c)
        c->ctm = plb_matrix_multiply(plb_matrix_scale(v[0], v[1]), c->ctm);
    return c != NULL;
}

/* Pops the constant; -1 and an error when there is none. */
static int take_constant(script_state *s)
{
    script_value *v = plb_script_peek(s, 0);
    int code = v ? v->code : -1;
    return plb_script_pop_kind(s, VALUE_CONSTANT, "constant") ? code : -1;
}

static bool op_set_extend(script_state *s)
{
    int code = take_constant(s);
    script_pattern *p = code >= 0 ? plb_script_top(s, OBJECT_PATTERN) : NULL;
    if (p)
        p->repeats = code != CONST_EXTEND_NONE && code != CONST_EXTEND_PAD;
    if (p && p->gradient)
        p->gradient->extend = code == CONST_EXTEND_NONE ? GRADIENT_ENDS : code == CONST_EXTEND_PAD ? GRADIENT_PAD
                            : code == CONST_EXTEND_REFLECT ? GRADIENT_REFLECT : GRADIENT_REPEAT;
    return p != NULL;
}

static bool op_set_operator(script_state *s)
{
    int code = take_constant(s);
    script_context *c = code >= 0 ? top_context(s) : NULL;
    if (c)
        c->draws = code != CONST_NO_INK;
    if (c)
        c->blends = code == CONST_BLEND;
    if (c)
        c->multiplies = code == CONST_MULTIPLY;
    return c != NULL;
}

static bool op_set_fill_rule(script_state *s)
{
    int code = take_constant(s);
    script_context *c = code >= 0 ? top_context(s) : NULL;
    if (c)
        c->even_odd = code == CONST_EVEN_ODD;
    return c != NULL;
}

static bool op_set_line_cap(script_state *s)
{
    int code = take_constant(s);
    script_context *c = code >= 0 ? top_context(s) : NULL;
    if (c)
        c->cap = code == CONST_ROUND ? LINE_CAP_ROUND : code == CONST_SQUARE ? LINE_CAP_SQUARE : LINE_CAP_BUTT;
    return c != NULL;
}

static bool op_set_line_width(script_state *s)
{
    double v;
    script_context *c = plb_script_take(s, 1, &v) ? top_context(s) : NULL;
    if (c)
        c->width = v;
    return c != NULL;
}

/* [on off ...] OFFSET set-dash */
static bool op_set_dash(script_state *s)
{
    double offset;
    script_value *v = plb_script_take(s, 1, &offset) ? plb_script_peek(s, 0) : NULL;
    if (!v)
        return false;
    if (v->kind != VALUE_ARRAY)
        return plb_fail(s->err, ERROR_SYNTAX, "set-dash has no array");
    if (s->stack.n < 2)
        return plb_fail(s->err, ERROR_SYNTAX, "an operand is missing");
    size_t first = v->array.first, n = v->array.n;
    script_value *under = plb_script_peek(s, 1);
    if (under->kind != VALUE_OBJECT || under->object->kind != OBJECT_CONTEXT)
        return plb_fail(s->err, ERROR_SYNTAX, "an operand is not a context");
    script_context *c = (script_context *)under->object;
    c->dash.n = 0;
    c->dash_offset = offset;
    if (!array_reserve(&c->dash, n))
        return plb_fail_memory(s->err);
    for (size_t i = 0; i < n; i++)
        c->dash.v[c->dash.n++] = s->numbers.v[first + i];
    return plb_script_pop(s);
}

/* ---- paths and painting ------------------------------------------------------------------------------------- */

static bool room_for_point(script_state *s, const script_context *c)
{
    return c->path.points.n < LIST_MAX_POINTS || plb_fail(s->err, ERROR_LIMIT, "a path has more than %u points", LIST_MAX_POINTS);
}

static bool op_new_path(script_state *s)
{
    script_context *c = top_context(s);
    if (c)
        plb_path_clear(&c->path);
    return c != NULL;
}

static bool op_move(script_state *s)
{
    double v[2];
    script_context *c = plb_script_take(s, 2, v) ? top_context(s) : NULL;
    return c && room_for_point(s, c) && (plb_path_move(&c->path, (point){v[0], v[1]}) || plb_fail_memory(s->err));
}

static bool op_line(script_state *s)
{
    double v[2];
    script_context *c = plb_script_take(s, 2, v) ? top_context(s) : NULL;
    return c && room_for_point(s, c) && (plb_path_line(&c->path, (point){v[0], v[1]}) || plb_fail_memory(s->err));
}

static bool op_curve(script_state *s)
{
    double v[6];
    script_context *c = plb_script_take(s, 6, v) ? top_context(s) : NULL;
    return c && room_for_point(s, c) &&
           (plb_path_curve(&c->path, (point){v[0], v[1]}, (point){v[2], v[3]}, (point){v[4], v[5]}) || plb_fail_memory(s->err));
}

static bool op_close(script_state *s)
{
    script_context *c = top_context(s);
    return c && (plb_path_close(&c->path) || plb_fail_memory(s->err));
}

static bool op_rectangle(script_state *s)
{
    double v[4];
    script_context *c = plb_script_take(s, 4, v) ? top_context(s) : NULL;
    if (!c || !room_for_point(s, c))
        return false;
    double x1 = v[0] + v[2], y1 = v[1] + v[3];
    path *p = &c->path;
    return (plb_path_move(p, (point){v[0], v[1]}) && plb_path_line(p, (point){x1, v[1]}) && plb_path_line(p, (point){x1, y1}) &&
            plb_path_line(p, (point){v[0], y1}) && plb_path_close(p)) || plb_fail_memory(s->err);
}

static bool op_fill(script_state *s)
{
    script_context *c = top_context(s);
    return c && plb_script_fill(s, c);
}

static bool op_stroke(script_state *s)
{
    script_context *c = top_context(s);
    return c && plb_script_stroke(s, c);
}

static bool op_paint(script_state *s)
{
    script_context *c = top_context(s);
    return c && plb_script_paint(s, c, 1);
}

/* Paints through a mask: a mask of one colour is an opacity; through any other the source is painted whole. */
static bool op_mask(script_state *s)
{
    script_pattern *p = plb_script_top(s, OBJECT_PATTERN);
    if (!p)
        return false;
    bool solid = p->paint.kind == PAINT_SOLID;
    double alpha = solid ? p->paint.alpha : 1;
    if (!plb_script_pop(s))
        return false;
    if (!solid)
        s->page.omissions.n[OMISSION_MASK]++;
    script_context *c = top_context(s);
    return c && plb_script_paint(s, c, alpha);
}

static bool op_clip(script_state *s)
{
    script_context *c = top_context(s);
    return c && plb_script_clip(s, c);
}

static bool op_reset_clip(script_state *s)
{
    script_context *c = top_context(s);
    if (c)
        c->clip = NO_CLIP;
    return c != NULL;
}

/* ---- the table ---------------------------------------------------------------------------------------------- */

/* The operators are sorted by name. */
const script_operator plb_script_draw_operators[] = {
    {"c", op_curve},
    {"clip+", op_clip},
    {"copy-page", op_nothing},
    {"fill+", op_fill},
    {"h", op_close},
    {"identity", op_identity},
    {"l", op_line},
    {"m", op_move},
    {"mask", op_mask},
    {"n", op_new_path},
    {"paint", op_paint},
    {"rectangle", op_rectangle},
    {"reset-clip", op_reset_clip},
    {"scale", op_scale},
    {"set-antialias", op_pop},
    {"set-dash", op_set_dash},
    {"set-extend", op_set_extend},
    {"set-fill-rule", op_set_fill_rule},
    {"set-filter", op_pop},
    {"set-line-cap", op_set_line_cap},
    {"set-line-join", op_pop},
    {"set-line-width", op_set_line_width},
    {"set-matrix", op_set_matrix},
    {"set-miter-limit", op_pop},
    {"set-operator", op_set_operator},
    {"set-tolerance", op_pop},
    {"show-page", op_nothing},
    {"stroke+", op_stroke},
};
const size_t plb_script_draw_count = sizeof plb_script_draw_operators / sizeof *plb_script_draw_operators;
