/* SPDX-License-Identifier: MIT
 *
 * Does the `show` family. Glyphs of Type 3 fonts are procedures and are drawn; of all other fonts the letters are left
 * out, and the current point moves on by an estimated width, so that what follows keeps its place. One frame walks
 * through one string.
 */
#include "tap/ps/ps.h"

/* A letter that is not drawn advances by so many sizes of its font: Helvetica's digits and most small letters are so
 * wide (Adobe's Core14 metrics). */
#define MEAN_WIDTH 0.556

typedef struct ps_show {
    struct ps_show *outer;
    const ps_dict *font;
    matrix matrix; /* FontMatrix */
    int type;
    ps_object text, names;  /* names: the glyphs of glyphshow, in an array, instead of a text */
    ps_object shifts;       /* xshow and kin: numbers that replace the widths, `shift_step` for each character */
    ps_object between;      /* kshow: called between characters; cshow: called for each */
    unsigned shift_step;
    bool shift_x, shift_y, only_measure, calls_for_each, no_glyphs;
    point extra, extra_of_one; /* added to each advance; to that of the character `one` */
    int one;
    uint32_t next;
    uint32_t states;        /* graphics states at the start */
    bool in_glyph, has_image;
    point width, total, pen; /* of the glyph; of all; where the next goes, user space */
} ps_show;

/* ---- widths ----------------------------------------------------------------------------------------------- */

/* Gives a width in user space; Type 1 fonts measure in thousandths of the size, which their matrix knows, TrueType fonts in ones. */
static point estimated_width(const ps_show *s)
{
    bool in_thousandths = s->type == 1 || s->type == 2 || (s->type == 3 && plb_matrix_expansion(s->matrix) < 0.1);
    return plb_matrix_apply_vector(s->matrix, (point){in_thousandths ? 1000 * MEAN_WIDTH : MEAN_WIDTH, 0});
}

void plb_ps_note_glyph_width(ps *p, point width)
{
    if (p->showing)
        p->showing->width = plb_matrix_apply_vector(p->showing->matrix, width);
}

void plb_ps_note_glyph_image(ps *p)
{
    if (p->showing)
        p->showing->has_image = true;
}

/* ---- one character after the other ------------------------------------------------------------------------ */

static uint32_t length_of(const ps_show *s)
{
    return s->names.type == PS_ARRAY ? s->names.n : s->text.n;
}

static int code_at(const ps_show *s, uint32_t i)
{
    return s->names.type == PS_ARRAY ? -1 : (unsigned char)s->text.as.string[i];
}

/* Gives the advance that the program states for character `i`, else `by`. */
static point shifted(const ps_show *s, uint32_t i, point by)
{
    uint32_t at = i * s->shift_step;
    if (s->shifts.type != PS_ARRAY || at + s->shift_step > s->shifts.n)
        return by;
    const ps_object *v = s->shifts.as.array + at;
    return (point){s->shift_x ? ps_value(v[0]) : 0, s->shift_y ? ps_value(v[s->shift_step - 1]) : 0};
}

static bool advance(ps *p, ps_show *s, uint32_t i, point by)
{
    by = point_add(shifted(s, i, by), s->extra);
    if (code_at(s, i) == s->one)
        by = point_add(by, s->extra_of_one);
    s->total = point_add(s->total, by);
    if (s->only_measure)
        return true;
    s->pen = point_add(s->pen, by);
    return plb_ps_move(p, s->pen);
}

/* Gives the name of character `i`, from the font's Encoding or the program. */
static ps_object glyph_name(ps *p, const ps_show *s, uint32_t i)
{
    if (s->names.type == PS_ARRAY)
        return s->names.as.array[i];
    ps_object *encoding = plb_ps_get_text(p, s->font, "Encoding");
    uint32_t code = (uint32_t)code_at(s, i);
    return encoding && encoding->type == PS_ARRAY && code < encoding->n ? encoding->as.array[code] : plb_ps_name(p, ".notdef");
}

/* Draws a Type 3 glyph: its procedure runs in a graphics state of its own, with the font's matrix at the pen. */
static bool start_glyph(ps *p, ps_show *s, uint32_t i)
{
    ps_object *build = plb_ps_get_text(p, s->font, "BuildGlyph");
    ps_object what = build ? glyph_name(p, s, i) : ps_integer(code_at(s, i));
    if (!build)
        build = plb_ps_get_text(p, s->font, "BuildChar");
    if (!build)
        return plb_ps_raise(p, PS_INVALIDFONT);
    matrix at = plb_matrix_multiply(s->matrix, (matrix){1, 0, 0, 1, s->pen.x, s->pen.y});
    s->states = p->state_count;
    s->width = (point){0, 0};
    if (!plb_ps_save_state(p))
        return false;
    s->in_glyph = true;
    ps_gs(p)->no_output |= s->only_measure;
    return plb_ps_set_ctm(p, plb_matrix_multiply(at, ps_gs(p)->ctm)) && plb_ps_new_path(p) &&
           plb_ps_push(p, ps_of_dict((ps_dict *)s->font)) && plb_ps_push(p, what) && plb_ps_execute(p, *build);
}

static void leave_glyph(ps *p, ps_show *s)
{
    if (s->in_glyph)
        plb_ps_restore_to(p, s->states);
    s->in_glyph = false;
}

static void drop_show(ps *p, ps_frame *f)
{
    ps_show *s = f->data;
    leave_glyph(p, s);
    p->showing = s->outer;
    if (s->has_image && !s->only_measure)
        plb_ps_omit(p, OMISSION_PIXEL_TEXT);
}

static bool call_between(ps *p, const ps_show *s)
{
    return plb_ps_push(p, ps_integer(code_at(s, s->next - 1))) && plb_ps_push(p, ps_integer(code_at(s, s->next))) &&
           plb_ps_execute(p, s->between);
}

/* Does cshow: hands out the character's code and width, and draws nothing. */
static bool call_for_each(ps *p, const ps_show *s, uint32_t i)
{
    point w = estimated_width(s);
    return plb_ps_push(p, ps_integer(code_at(s, i))) && plb_ps_push(p, ps_real(w.x)) && plb_ps_push(p, ps_real(w.y)) &&
           plb_ps_execute(p, s->between);
}

static bool finish(ps *p, ps_frame *f)
{
    const ps_show *s = f->data;
    plb_ps_pop_frame(p);
    return !s->only_measure || (plb_ps_push(p, ps_real(s->total.x)) && plb_ps_push(p, ps_real(s->total.y)));
}

static bool step_show(ps *p, ps_frame *f)
{
    ps_show *s = f->data;
    if (s->in_glyph) {
        leave_glyph(p, s);
        if (!advance(p, s, s->next++, s->width))
            return false;
        if (s->between.type == PS_ARRAY && s->next < length_of(s))
            return call_between(p, s);
    }
    if (s->next >= length_of(s))
        return finish(p, f);
    if (s->calls_for_each)
        return call_for_each(p, s, s->next++);
    if (!s->only_measure && !plb_ps_current_point(p, &s->pen))
        return false;
    if (s->type == 3 && !s->no_glyphs)
        return start_glyph(p, s, s->next);
    if (!advance(p, s, s->next, estimated_width(s)))
        return false;
    s->next++;
    return s->between.type != PS_ARRAY || s->next >= length_of(s) || call_between(p, s);
}

/* ---- setting out ------------------------------------------------------------------------------------------ */

static bool find_font(ps *p, ps_show *s)
{
    ps_object font = ps_gs(p)->font;
    if (font.type != PS_DICT)
        return plb_ps_raise(p, PS_INVALIDFONT);
    s->font = font.as.dict;
    ps_object *m = plb_ps_get_text(p, s->font, "FontMatrix"), *type = plb_ps_get_text(p, s->font, "FontType");
    if (!m)
        return plb_ps_raise(p, PS_INVALIDFONT);
    s->type = type && type->type == PS_INTEGER ? type->as.integer : 1;
    return plb_ps_get_matrix(p, *m, &s->matrix);
}

/* Starts the walk described by `plan` and drops `n` operands. */
static bool show(ps *p, ps_show plan, unsigned n)
{
    if (!find_font(p, &plan) || (!plan.only_measure && !plb_ps_current_point(p, &plan.pen)))
        return false;
    bool drawn = (plan.type == 3 && !plan.no_glyphs) || plan.only_measure || plan.calls_for_each || !length_of(&plan);
    if (!drawn && !ps_gs(p)->no_output && plb_ps_leave_to_ghostscript(p, OMISSION_TEXT))
        return true;
    ps_show *s = plb_ps_new(p, 1, sizeof *s);
    ps_frame *f = s ? plb_ps_push_frame(p, step_show) : NULL;
    if (!f)
        return false;
    *s = plan;
    s->outer = p->showing;
    p->showing = s;
    f->data = s;
    f->drop = drop_show;
    if (plan.between.type == PS_ARRAY)
        f->kind = FRAME_LOOP;
    ps_drop(p, n);
    return true;
}

static ps_show plan_of(ps_object text)
{
    return (ps_show){.text = text, .one = -2};
}

static bool op_show(ps *p)
{
    return show(p, plan_of(*ps_args(p, 1)), 1);
}

static bool op_stringwidth(ps *p)
{
    ps_show plan = plan_of(*ps_args(p, 1));
    plan.only_measure = true;
    return show(p, plan, 1);
}

static point pair(const ps_object *v)
{
    return (point){ps_value(v[0]), ps_value(v[1])};
}

static bool op_ashow(ps *p)
{
    ps_object *v = ps_args(p, 3);
    ps_show plan = plan_of(v[2]);
    plan.extra = pair(v);
    return show(p, plan, 3);
}

static bool op_widthshow(ps *p)
{
    ps_object *v = ps_args(p, 4);
    ps_show plan = plan_of(v[3]);
    plan.extra_of_one = pair(v);
    plan.one = v[2].as.integer;
    return show(p, plan, 4);
}

static bool op_awidthshow(ps *p)
{
    ps_object *v = ps_args(p, 6);
    ps_show plan = plan_of(v[5]);
    plan.extra_of_one = pair(v);
    plan.one = v[2].as.integer;
    plan.extra = pair(v + 3);
    return show(p, plan, 6);
}

static bool op_kshow(ps *p)
{
    ps_object *v = ps_args(p, 2);
    ps_show plan = plan_of(v[1]);
    plan.between = v[0];
    return show(p, plan, 2);
}

static bool op_cshow(ps *p)
{
    ps_object *v = ps_args(p, 2);
    ps_show plan = plan_of(v[1]);
    plan.between = v[0];
    plan.calls_for_each = true;
    return show(p, plan, 2);
}

static bool show_shifted(ps *p, bool x, bool y)
{
    ps_object *v = ps_args(p, 2);
    ps_show plan = plan_of(v[0]);
    plan.shifts = v[1];
    plan.shift_x = x;
    plan.shift_y = y;
    plan.shift_step = x && y ? 2 : 1;
    return show(p, plan, 2);
}

static bool op_xshow(ps *p) { return show_shifted(p, true, false); }
static bool op_yshow(ps *p) { return show_shifted(p, false, true); }
static bool op_xyshow(ps *p) { return show_shifted(p, true, true); }

static bool op_glyphshow(ps *p)
{
    ps_show plan = plan_of((ps_object){.type = PS_STRING});
    if (!plb_ps_new_array(p, 1, &plan.names))
        return false;
    plan.names.as.array[0] = *ps_args(p, 1);
    return show(p, plan, 1);
}

/* Moves the current point on, because the outlines of letters are not known. */
static bool op_charpath(ps *p)
{
    ps_show plan = plan_of(*ps_args(p, 2));
    plan.no_glyphs = true;
    return show(p, plan, 2);
}

static bool op_setcharwidth(ps *p)
{
    plb_ps_note_glyph_width(p, pair(ps_args(p, 2)));
    ps_drop(p, 2);
    return true;
}

static bool op_setcachedevice(ps *p)
{
    plb_ps_note_glyph_width(p, pair(ps_args(p, 6)));
    ps_drop(p, 6);
    return true;
}

static bool op_setcachedevice2(ps *p)
{
    plb_ps_note_glyph_width(p, pair(ps_args(p, 10)));
    ps_drop(p, 10);
    return true;
}

const ps_operator plb_ps_text_operators[] = {
    {"show", "s", op_show},
    {"ashow", "nns", op_ashow},
    {"widthshow", "nnis", op_widthshow},
    {"awidthshow", "nninns", op_awidthshow},
    {"kshow", "ps", op_kshow},
    {"cshow", "ps", op_cshow},
    {"xshow", "sa", op_xshow},
    {"yshow", "sa", op_yshow},
    {"xyshow", "sa", op_xyshow},
    {"glyphshow", "x", op_glyphshow},
    {"stringwidth", "s", op_stringwidth},
    {"charpath", "sb", op_charpath},
    {"setcharwidth", "nn", op_setcharwidth},
    {"setcachedevice", "nnnnnn", op_setcachedevice},
    {"setcachedevice2", "nnnnnnnnnn", op_setcachedevice2},
    {NULL, NULL, NULL},
};
