/* SPDX-License-Identifier: MIT
 *
 * Holds the CairoScript operators that move values about: the stack, names, and the making of surfaces, patterns and
 * contexts.
 */
#include "tap/svg/cairoscript_state.h"

#include <math.h>
#include <string.h>

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

static bool op_opaque(script_state *s) { return plb_script_push(s, (script_value){.kind = VALUE_OPAQUE}); }

/* ---- surfaces, patterns, contexts -------------------------------------------------------------------------- */

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
    if (!plb_script_pop_kind(s, VALUE_OPAQUE, "dictionary"))
        return false;
    display_list *list = s->has_page ? NULL : &s->page;
    s->has_page = true;
    return push_surface(s, list, 0, 0, false);
}

/* OTHER WIDTH HEIGHT //CONTENT similar */
static bool op_similar(script_state *s)
{
    double size[2];
    return plb_script_pop_kind(s, VALUE_CONSTANT, "kind of content") && plb_script_take(s, 2, size) &&
           plb_script_pop_kind(s, VALUE_OBJECT, "surface") && push_surface(s, NULL, size[0], size[1], false);
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
    return plb_script_pop_kind(s, VALUE_OPAQUE, "dictionary") && push_surface(s, NULL, 0, 0, true);
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

static double share(double v) { return fmin(fmax(v, 0), 1); }

static bool push_colour(script_state *s, double red, double green, double blue, double alpha)
{
    paint colour = {PAINT_SOLID, share(red), share(green), share(blue), share(alpha)};
    script_pattern *p = plb_script_new_pattern(s, colour);
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
static bool push_gradient(script_state *s, gradient g)
{
    script_pattern *p = plb_script_new_pattern(s, (paint){.kind = PAINT_GRADIENT});
    if (!p || !plb_script_push_object(s, &p->head))
        return false;
    p->gradient = plb_new(1, sizeof *p->gradient);
    if (!p->gradient)
        return plb_fail_memory(s->err);
    g.extend = GRADIENT_PAD; /* cairo's default */
    g.opacity = 1;
    *p->gradient = g;
    return true;
}

static bool op_linear(script_state *s)
{
    double v[4];
    return plb_script_take(s, 4, v) && push_gradient(s, (gradient){.from = {v[0], v[1]}, .to = {v[2], v[3]}});
}

static bool op_radial(script_state *s)
{
    double v[6];
    return plb_script_take(s, 6, v) && push_gradient(s, (gradient){.radial = true, .from = {v[0], v[1]}, .from_radius = v[2],
                                                                   .to = {v[3], v[4]}, .to_radius = v[5]});
}

static bool op_add_stop(script_state *s)
{
    double v[5];
    script_pattern *p = plb_script_take(s, 5, v) ? plb_script_top(s, OBJECT_PATTERN) : NULL;
    if (!p)
        return false;
    for (int i = 0; i < 5; i++)
        v[i] = share(v[i]);
    p->paint.red += v[1];
    p->paint.green += v[2];
    p->paint.blue += v[3];
    p->paint.alpha += v[4];
    p->stops++;
    if (p->gradient)
        plb_gradient_add_stop(p->gradient, (gradient_stop){v[0], (float)v[1], (float)v[2], (float)v[3], (float)v[4]});
    return true;
}

static bool op_set_source(script_state *s)
{
    script_pattern *p = plb_script_top(s, OBJECT_PATTERN);
    if (!p)
        return false;
    s->stack.n--; /* its reference moves to the context */
    script_context *c = plb_script_top(s, OBJECT_CONTEXT);
    if (!c) {
        plb_script_release(s, &p->head);
        return false;
    }
    plb_script_release(s, c->source ? &c->source->head : NULL);
    c->source = p;
    return true;
}

/* ---- names ------------------------------------------------------------------------------------------------ */

script_binding *plb_script_lookup(script_state *s, int id)
{
    for (size_t i = s->bindings.n; i-- > 0;)
        if (s->bindings.v[i].id == id)
            return &s->bindings.v[i];
    return NULL;
}

static void unbind(script_state *s, int id)
{
    script_binding *b = plb_script_lookup(s, id);
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

/* Does CONTEXT /target get: the context stays below. */
static bool op_get(script_state *s)
{
    script_value *name = plb_script_peek(s, 0);
    int code = name && name->kind == VALUE_NAME ? name->code : NAME_OTHER;
    if (!name || !plb_script_pop(s))
        return false;
    if (code != NAME_TARGET && code != NAME_SOURCE)
        return op_opaque(s);
    script_context *c = plb_script_top(s, OBJECT_CONTEXT);
    if (!c)
        return false;
    if (code == NAME_SOURCE && !c->source)
        return push_colour(s, 0, 0, 0, 1);
    script_object *o = code == NAME_TARGET ? &c->target->head : &c->source->head;
    o->references++;
    return plb_script_push_object(s, o);
}

/* ---- the table ---------------------------------------------------------------------------------------------- */

static bool op_nothing(script_state *s) { (void)s; return true; }

/* The operators are sorted by name. Fonts and images are accepted and left out. */
const script_operator plb_script_object_operators[] = {
    {"a", op_alpha},
    {"add-color-stop", op_add_stop},
    {"array", op_opaque},
    {"context", op_context},
    {"def", op_def},
    {"dict", op_opaque},
    {"dup", op_dup},
    {"exch", op_exch},
    {"font", op_nothing},
    {"g", op_grey},
    {"get", op_get},
    {"image", op_image},
    {"index", op_index},
    {"linear", op_linear},
    {"pattern", op_pattern},
    {"pop", op_pop},
    {"radial", op_radial},
    {"record", op_record},
    {"rgb", op_rgb},
    {"rgba", op_rgba},
    {"roll", op_roll},
    {"set", op_pop2},
    {"set-font-face", op_pop},
    {"set-font-matrix", op_pop},
    {"set-font-options", op_pop},
    {"set-mime-data", op_pop2},
    {"set-scaled-font", op_pop},
    {"set-source", op_set_source},
    {"show-glyphs", op_pop},
    {"show-text-glyphs", op_pop4},
    {"similar", op_similar},
    {"surface", op_surface},
    {"undef", op_undef},
};
const size_t plb_script_object_count = sizeof plb_script_object_operators / sizeof *plb_script_object_operators;
