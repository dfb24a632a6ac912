/* SPDX-License-Identifier: MIT
 *
 * CairoScript: the tap's head line, then token by token through a table of operators. There is no recursion and no
 * loop in the language, only a stack.
 */
#include "input/cairoscript.h"

#include "base/number.h"
#include "input/cairoscript_state.h"

#include <math.h>
#include <string.h>

typedef bool (*operation)(script_state *s);

static script_context *top_context(script_state *s) { return plb_script_top(s, OBJECT_CONTEXT); }

static bool pop_many(script_state *s, unsigned n)
{
    while (n--)
        if (!plb_script_pop(s))
            return false;
    return true;
}

/* ---- the stack -------------------------------------------------------------------------------------------- */

static bool op_pop(script_state *s) { return plb_script_pop(s); }
static bool op_pop2(script_state *s) { return pop_many(s, 2); }
static bool op_pop4(script_state *s) { return pop_many(s, 4); }
static bool op_nothing(script_state *s) { (void)s; return true; }

static bool push_copy(script_state *s, size_t depth)
{
    script_value *v = plb_script_peek(s, depth);
    if (!v)
        return false;
    script_value copy = *v;
    if (!plb_script_push(s, copy))
        return false;
    if (copy.kind == VALUE_OBJECT)
        copy.object->references++;
    if (copy.kind == VALUE_ARRAY)
        s->arrays++;
    return true;
}

static bool op_dup(script_state *s) { return push_copy(s, 0); }

static bool op_index(script_state *s)
{
    double n;
    if (!plb_script_take(s, 1, &n))
        return false;
    if (!(n >= 0 && n < SCRIPT_MAX_STACK))
        return plb_fail(s->err, ERROR_SYNTAX, "index is out of range");
    return push_copy(s, (size_t)n);
}

static void rotate_up(script_value *v, size_t n)
{
    script_value last = v[n - 1];
    memmove(v + 1, v, (n - 1) * sizeof *v);
    v[0] = last;
}

static void rotate_down(script_value *v, size_t n)
{
    script_value first = v[0];
    memmove(v, v + 1, (n - 1) * sizeof *v);
    v[n - 1] = first;
}

static bool op_exch(script_state *s)
{
    if (!plb_script_peek(s, 1))
        return false;
    rotate_up(s->stack.v + s->stack.n - 2, 2);
    return true;
}

/* The script surface rolls by one only. */
static bool op_roll(script_state *s)
{
    double v[2];
    if (!plb_script_take(s, 2, v))
        return false;
    if (!(v[0] >= 1 && v[0] <= (double)s->stack.n) || fabs(v[1]) != 1)
        return plb_fail(s->err, ERROR_SYNTAX, "roll is out of range");
    size_t n = (size_t)v[0];
    (v[1] > 0 ? rotate_up : rotate_down)(s->stack.v + s->stack.n - n, n);
    return true;
}

static bool op_mark(script_state *s) { return plb_script_push(s, (script_value){.kind = VALUE_MARK}); }
static bool op_identity(script_state *s) { return plb_script_push(s, (script_value){.kind = VALUE_IDENTITY}); }
static bool op_opaque(script_state *s) { return plb_script_push(s, (script_value){.kind = VALUE_OPAQUE}); }

/* The first value above the topmost mark. */
static bool find_mark(script_state *s, size_t *first)
{
    size_t i = s->stack.n;
    while (i && s->stack.v[i - 1].kind != VALUE_MARK)
        i--;
    *first = i;
    return i > 0 || plb_fail(s->err, ERROR_SYNTAX, "a bracket closes that never opened");
}

/* ]: the numbers since the mark; an array of anything else is of no use to us. */
static bool close_array(script_state *s)
{
    size_t first;
    if (!find_mark(s, &first))
        return false;
    size_t n = s->stack.n - first, start = s->numbers.n;
    if (start + n > SCRIPT_MAX_STACK)
        return plb_fail(s->err, ERROR_LIMIT, "more than %u numbers in arrays", SCRIPT_MAX_STACK);
    if (!array_reserve(&s->numbers, n))
        return plb_fail_memory(s->err);
    bool numbers = true;
    for (size_t i = first; i < s->stack.n; i++)
        numbers = numbers && s->stack.v[i].kind == VALUE_NUMBER;
    for (size_t i = 0; numbers && i < n; i++)
        s->numbers.v[s->numbers.n++] = s->stack.v[first + i].number;
    if (numbers)
        s->stack.n = first;
    while (s->stack.n >= first)
        plb_script_pop(s);
    if (!numbers)
        return op_opaque(s);
    s->arrays++;
    return plb_script_push(s, (script_value){.kind = VALUE_ARRAY, .array = {(uint32_t)start, (uint32_t)n}});
}

/* >>: width and height are all we want of a dictionary; they stay behind as numbers under it. */
static bool close_dictionary(script_state *s)
{
    size_t first;
    if (!find_mark(s, &first))
        return false;
    while (s->stack.n >= first)
        plb_script_pop(s);
    return op_opaque(s);
}

/* ---- surfaces, patterns, contexts -------------------------------------------------------------------------- */

static bool pop_kind(script_state *s, value_kind kind, const char *what)
{
    script_value *v = plb_script_peek(s, 0);
    if (!v)
        return false;
    if (v->kind != kind)
        return plb_fail(s->err, ERROR_SYNTAX, "an operand is not a %s", what);
    return plb_script_pop(s);
}

static bool push_surface(script_state *s, display_list *list, double width, double height, bool is_image)
{
    script_surface *f = plb_script_new_surface(s, list);
    if (!f)
        return false;
    f->width = width;
    f->height = height;
    f->is_image = is_image;
    return plb_script_push_object(s, &f->head);
}

/* DICT surface: the first is the page. */
static bool op_surface(script_state *s)
{
    if (!pop_kind(s, VALUE_OPAQUE, "dictionary"))
        return false;
    display_list *list = s->has_page ? NULL : s->page;
    s->has_page = true;
    return push_surface(s, list, 0, 0, false);
}

/* OTHER WIDTH HEIGHT //CONTENT similar */
static bool op_similar(script_state *s)
{
    double size[2];
    return pop_kind(s, VALUE_CONSTANT, "kind of content") && plb_script_take(s, 2, size) &&
           pop_kind(s, VALUE_OBJECT, "surface") && push_surface(s, NULL, size[0], size[1], false);
}

/* //CONTENT [x y w h] record */
static bool op_record(script_state *s)
{
    script_value *v = plb_script_peek(s, 0);
    if (!v)
        return false;
    double w = 0, h = 0;
    if (v->kind == VALUE_ARRAY && v->array.n == 4) {
        const double *r = s->numbers.v + v->array.first;
        w = r[0] + r[2];
        h = r[1] + r[3];
    }
    return pop_many(s, 2) && push_surface(s, NULL, w, h, false);
}

static bool op_image(script_state *s)
{
    return pop_kind(s, VALUE_OPAQUE, "dictionary") && push_surface(s, NULL, 0, 0, true);
}

static bool op_context(script_state *s)
{
    script_surface *f = plb_script_top(s, OBJECT_SURFACE);
    script_context *c = f ? plb_script_new_context(s, f) : NULL;
    return c && plb_script_pop(s) && plb_script_push_object(s, &c->head);
}

static bool op_pattern(script_state *s)
{
    script_surface *f = plb_script_top(s, OBJECT_SURFACE);
    script_pattern *p = f ? plb_script_new_pattern(s, (paint){.kind = PAINT_PATTERN}) : NULL;
    if (!p)
        return false;
    f->head.references++;
    p->surface = f;
    return plb_script_pop(s) && plb_script_push_object(s, &p->head);
}

static bool push_colour(script_state *s, double red, double green, double blue, double alpha)
{
    script_pattern *p = plb_script_new_pattern(s, (paint){PAINT_SOLID, red, green, blue, alpha});
    return p && plb_script_push_object(s, &p->head);
}

static bool op_alpha(script_state *s)
{
    double v;
    return plb_script_take(s, 1, &v) && push_colour(s, 0, 0, 0, v);
}

static bool op_grey(script_state *s)
{
    double v;
    return plb_script_take(s, 1, &v) && push_colour(s, v, v, v, 1);
}

static bool op_rgb(script_state *s)
{
    double v[3];
    return plb_script_take(s, 3, v) && push_colour(s, v[0], v[1], v[2], 1);
}

static bool op_rgba(script_state *s)
{
    double v[4];
    return plb_script_take(s, 4, v) && push_colour(s, v[0], v[1], v[2], v[3]);
}

/* A gradient without stops paints nothing. */
static bool push_gradient(script_state *s)
{
    script_pattern *p = plb_script_new_pattern(s, (paint){.kind = PAINT_GRADIENT});
    return p && plb_script_push_object(s, &p->head);
}

static bool op_linear(script_state *s)
{
    double v[4];
    return plb_script_take(s, 4, v) && push_gradient(s);
}

static bool op_radial(script_state *s)
{
    double v[6];
    return plb_script_take(s, 6, v) && push_gradient(s);
}

static bool op_add_stop(script_state *s)
{
    double v[5];
    script_pattern *p = plb_script_take(s, 5, v) ? plb_script_top(s, OBJECT_PATTERN) : NULL;
    if (!p)
        return false;
    p->paint.red += v[1];
    p->paint.green += v[2];
    p->paint.blue += v[3];
    p->paint.alpha += v[4];
    p->stops++;
    return true;
}

static bool op_set_source(script_state *s)
{
    script_pattern *p = plb_script_top(s, OBJECT_PATTERN);
    if (!p)
        return false;
    s->stack.n--; /* its reference moves to the context */
    script_context *c = top_context(s);
    if (!c) {
        plb_script_release(s, &p->head);
        return false;
    }
    plb_script_release(s, c->source ? &c->source->head : NULL);
    c->source = p;
    return true;
}

/* ---- names ------------------------------------------------------------------------------------------------ */

/* "s12" is 12; others have a code below zero. */
static int name_code(const char *text, size_t length)
{
    if (length == 6 && !memcmp(text, "target", 6))
        return NAME_TARGET;
    if (length == 6 && !memcmp(text, "source", 6))
        return NAME_SOURCE;
    if (length < 2 || length > 9 || text[0] != 's')
        return NAME_OTHER;
    int id = 0;
    for (size_t i = 1; i < length; i++) {
        if (text[i] < '0' || text[i] > '9')
            return NAME_OTHER;
        id = id * 10 + (text[i] - '0');
    }
    return id;
}

static script_binding *lookup(script_state *s, int id)
{
    for (size_t i = s->bindings.n; i-- > 0;)
        if (s->bindings.v[i].id == id)
            return &s->bindings.v[i];
    return NULL;
}

static void unbind(script_state *s, int id)
{
    script_binding *b = lookup(s, id);
    if (!b)
        return;
    plb_script_release(s, b->object);
    *b = s->bindings.v[--s->bindings.n];
}

/* /NAME VALUE def */
static bool op_def(script_state *s)
{
    script_value *value = plb_script_peek(s, 0), *name = plb_script_peek(s, 1);
    if (!value || !name)
        return false;
    if (name->kind != VALUE_NAME)
        return plb_fail(s->err, ERROR_SYNTAX, "def has no name");
    if (value->kind == VALUE_OBJECT && name->code >= 0) {
        script_binding b = {name->code, value->object};
        unbind(s, b.id);
        if (s->bindings.n >= SCRIPT_MAX_OBJECTS || !array_push(&s->bindings, b))
            return plb_fail(s->err, ERROR_LIMIT, "more than %u names", SCRIPT_MAX_OBJECTS);
        b.object->references++;
    }
    return pop_many(s, 2);
}

static bool op_undef(script_state *s)
{
    script_value *name = plb_script_peek(s, 0);
    if (!name)
        return false;
    if (name->kind != VALUE_NAME)
        return plb_fail(s->err, ERROR_SYNTAX, "undef has no name");
    if (name->code >= 0)
        unbind(s, name->code);
    return plb_script_pop(s);
}

/* CONTEXT /target get: the context stays below. */
static bool op_get(script_state *s)
{
    script_value *name = plb_script_peek(s, 0);
    int code = name && name->kind == VALUE_NAME ? name->code : NAME_OTHER;
    if (!name || !plb_script_pop(s))
        return false;
    if (code != NAME_TARGET && code != NAME_SOURCE)
        return op_opaque(s);
    script_context *c = top_context(s);
    if (!c)
        return false;
    if (code == NAME_SOURCE && !c->source)
        return push_colour(s, 0, 0, 0, 1);
    script_object *o = code == NAME_TARGET ? &c->target->head : &c->source->head;
    o->references++;
    return plb_script_push_object(s, o);
}

/* ---- state of a context or pattern -------------------------------------------------------------------------- */

/* [xx yx xy yy x0 y0] or identity, popped. */
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

/* What a //CONSTANT means to the operator that takes it. */
enum { CONST_OTHER, CONST_BUTT, CONST_ROUND, CONST_SQUARE, CONST_EVEN_ODD, CONST_EXTEND_NONE, CONST_EXTEND_PAD, CONST_NO_INK };

/* Names of constants, sorted. The operators that add no ink: those that only erase or keep what is there. */
static const struct {
    const char *name;
    int code;
} constants[] = {
    {"CLEAR", CONST_NO_INK},          {"DEST", CONST_NO_INK},           {"DEST_IN", CONST_NO_INK},
    {"DEST_OUT", CONST_NO_INK},       {"EVEN_ODD", CONST_EVEN_ODD},     {"EXTEND_NONE", CONST_EXTEND_NONE},
    {"EXTEND_PAD", CONST_EXTEND_PAD}, {"LINE_CAP_BUTT", CONST_BUTT},    {"LINE_CAP_ROUND", CONST_ROUND},
    {"LINE_CAP_SQUARE", CONST_SQUARE},
};

static int constant_code(const char *text, size_t length)
{
    for (size_t i = 0; i < sizeof constants / sizeof *constants; i++)
        if (strlen(constants[i].name) == length && !memcmp(constants[i].name, text, length))
            return constants[i].code;
    return CONST_OTHER;
}

/* Pops the constant; -1 and an error when it is not there. */
static int take_constant(script_state *s)
{
    script_value *v = plb_script_peek(s, 0);
    int code = v ? v->code : -1;
    return pop_kind(s, VALUE_CONSTANT, "constant") ? code : -1;
}

static bool op_set_extend(script_state *s)
{
    int code = take_constant(s);
    script_pattern *p = code >= 0 ? plb_script_top(s, OBJECT_PATTERN) : NULL;
    if (p)
        p->repeats = code != CONST_EXTEND_NONE && code != CONST_EXTEND_PAD;
    return p != NULL;
}

static bool op_set_operator(script_state *s)
{
    int code = take_constant(s);
    script_context *c = code >= 0 ? top_context(s) : NULL;
    if (c)
        c->draws = code != CONST_NO_INK;
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

/* A mask of one colour is an opacity; through any other the source is painted whole. */
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
        s->page->masks++;
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

/* ---- tokens ------------------------------------------------------------------------------------------------- */

/* All that the script surface of cairo 1.16 writes for what librsvg draws, and what it writes for fonts and images,
 * which is accepted and left out. Sorted by name. */
static const struct {
    const char *name;
    operation run;
} operators[] = {
    {"a", op_alpha},
    {"add-color-stop", op_add_stop},
    {"array", op_opaque},
    {"c", op_curve},
    {"clip+", op_clip},
    {"context", op_context},
    {"copy-page", op_nothing},
    {"def", op_def},
    {"dict", op_opaque},
    {"dup", op_dup},
    {"exch", op_exch},
    {"fill+", op_fill},
    {"font", op_nothing},
    {"g", op_grey},
    {"get", op_get},
    {"h", op_close},
    {"identity", op_identity},
    {"image", op_image},
    {"index", op_index},
    {"l", op_line},
    {"linear", op_linear},
    {"m", op_move},
    {"mask", op_mask},
    {"n", op_new_path},
    {"paint", op_paint},
    {"pattern", op_pattern},
    {"pop", op_pop},
    {"radial", op_radial},
    {"record", op_record},
    {"rectangle", op_rectangle},
    {"reset-clip", op_reset_clip},
    {"rgb", op_rgb},
    {"rgba", op_rgba},
    {"roll", op_roll},
    {"scale", op_scale},
    {"set", op_pop2},
    {"set-antialias", op_pop},
    {"set-dash", op_set_dash},
    {"set-extend", op_set_extend},
    {"set-fill-rule", op_set_fill_rule},
    {"set-filter", op_pop},
    {"set-font-face", op_pop},
    {"set-font-matrix", op_pop},
    {"set-font-options", op_pop},
    {"set-line-cap", op_set_line_cap},
    {"set-line-join", op_pop},
    {"set-line-width", op_set_line_width},
    {"set-matrix", op_set_matrix},
    {"set-mime-data", op_pop2},
    {"set-miter-limit", op_pop},
    {"set-operator", op_set_operator},
    {"set-scaled-font", op_pop},
    {"set-source", op_set_source},
    {"set-tolerance", op_pop},
    {"show-glyphs", op_pop},
    {"show-page", op_nothing},
    {"show-text-glyphs", op_pop4},
    {"similar", op_similar},
    {"stroke+", op_stroke},
    {"surface", op_surface},
    {"undef", op_undef},
};

static int compare_name(const char *name, const token *t)
{
    int order = strncmp(name, t->text, t->length);
    return order ? order : name[t->length] != '\0';
}

static operation find_operator(const token *t)
{
    size_t low = 0, high = sizeof operators / sizeof *operators;
    while (low < high) {
        size_t middle = (low + high) / 2;
        int order = compare_name(operators[middle].name, t);
        if (order == 0)
            return operators[middle].run;
        if (order < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return NULL;
}

/* The four names that make up nine tenths of a script, without a search. */
static operation find_short(char name)
{
    return name == 'l' ? op_line : name == 'm' ? op_move : name == 'c' ? op_curve : name == 'n' ? op_new_path : NULL;
}

static bool run_name(script_state *s, const token *t)
{
    operation run = t->length == 1 ? find_short(t->text[0]) : NULL;
    if (!run)
        run = find_operator(t);
    if (run)
        return run(s);
    int id = name_code(t->text, t->length);
    script_binding *b = id >= 0 ? lookup(s, id) : NULL;
    if (b) {
        b->object->references++;
        return plb_script_push_object(s, b->object);
    }
    int shown = t->length > 40 ? 40 : (int)t->length;
    return plb_fail(s->err, ERROR_SYNTAX, "unknown operator %.*s", shown, t->text);
}

/* { ... }: only glyph procedures of bitmap fonts are written like this. */
static bool skip_procedure(script_state *s)
{
    token t;
    for (size_t depth = 1; depth;) {
        if (!plb_scan_next(&s->scan, &t, s->err))
            return false;
        if (t.kind == TOKEN_END)
            return plb_fail(s->err, ERROR_SYNTAX, "a procedure never ends");
        depth += (t.kind == TOKEN_PROC_OPEN) - (size_t)(t.kind == TOKEN_PROC_CLOSE);
    }
    return op_opaque(s);
}

static bool run_token(script_state *s, const token *t)
{
    switch (t->kind) {
    case TOKEN_NUMBER: return plb_script_push(s, (script_value){.kind = VALUE_NUMBER, .number = t->number});
    case TOKEN_NAME: return run_name(s, t);
    case TOKEN_LITERAL: return plb_script_push(s, (script_value){.kind = VALUE_NAME, .code = name_code(t->text, t->length)});
    case TOKEN_IMMEDIATE: return plb_script_push(s, (script_value){.kind = VALUE_CONSTANT, .code = constant_code(t->text, t->length)});
    case TOKEN_ARRAY_OPEN:
    case TOKEN_DICT_OPEN: return op_mark(s);
    case TOKEN_ARRAY_CLOSE: return close_array(s);
    case TOKEN_DICT_CLOSE: return close_dictionary(s);
    case TOKEN_PROC_OPEN: return skip_procedure(s);
    case TOKEN_STRING:
    case TOKEN_DATA: return op_opaque(s);
    default: return plb_fail(s->err, ERROR_SYNTAX, "a } without its {");
    }
}

/* ---- the head line ------------------------------------------------------------------------------------------ */

#define HEAD_MAX 400
#define HEAD_WORD "%%Plumbago-tap 1"
enum { HEAD_NUMBERS = 11 };

/* The first line into `line`; the scanner is set to what follows. */
static bool read_head_line(script_state *s, cairoscript_source *from, char line[HEAD_MAX], size_t *length)
{
    const char *data = NULL;
    size_t size = 0;
    *length = 0;
    while (from->refill(from->closure, &data, &size)) {
        for (size_t i = 0; i < size; i++) {
            if (data[i] == '\n') {
                plb_scan_init(&s->scan, data + i + 1, size - i - 1);
                return true;
            }
            if (*length == HEAD_MAX)
                return plb_fail(s->err, ERROR_SYNTAX, "its first line is too long");
            line[(*length)++] = data[i];
        }
    }
    return plb_fail(s->err, ERROR_SYNTAX, "it is empty");
}

static bool read_head(script_state *s, cairoscript_source *from)
{
    char line[HEAD_MAX];
    size_t length;
    double v[HEAD_NUMBERS];
    if (!read_head_line(s, from, line, &length))
        return false;
    const char *at = line + strlen(HEAD_WORD), *end = line + length;
    bool ok = length > strlen(HEAD_WORD) && !memcmp(line, HEAD_WORD, strlen(HEAD_WORD));
    for (int i = 0; ok && i < HEAD_NUMBERS; i++)
        ok = at < end && *at == ' ' && plb_parse_number(at + 1, end, &v[i], &at) && isfinite(v[i]);
    if (!ok || !(v[0] > 0) || !(v[1] > 0))
        return plb_fail(s->err, ERROR_SYNTAX, "its first line is not \"" HEAD_WORD "\" and %d numbers", HEAD_NUMBERS);
    s->page->width = v[0];
    s->page->height = v[1];
    memcpy(&s->to_page, v + 2, sizeof s->to_page);
    s->page->images += (unsigned long)fmin(fmax(v[8], 0), 1e9);
    s->page->masks += (unsigned long)fmin(fmax(v[9], 0), 1e9);
    from->filters = (unsigned long)fmin(fmax(v[10], 0), 1e9);
    return true;
}

bool plb_read_cairoscript(cairoscript_source *from, display_list *list, error *err)
{
    error inner = {0};
    script_state s = {.page = list, .err = &inner};
    token t;
    bool ok = read_head(&s, from);
    from->complete = false;
    if (ok) {
        s.scan.refill = from->refill;
        s.scan.closure = from->closure;
    }
    while (ok) {
        ok = plb_scan_next(&s.scan, &t, &inner);
        if (!ok || t.kind == TOKEN_END)
            break;
        ok = run_token(&s, &t);
    }
    int line = s.scan.line + 1;
    plb_script_free(&s);
    from->complete = ok;
    if (ok)
        return true;
    if (inner.kind == ERROR_LIMIT || inner.kind == ERROR_MEMORY)
        return plb_fail(err, inner.kind, "%s", inner.text);
    return plb_fail(err, inner.kind, "line %d: %s", line, inner.text);
}
