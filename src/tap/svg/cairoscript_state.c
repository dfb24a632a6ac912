/* SPDX-License-Identifier: MIT
 *
 * Keeps the CairoScript reader's stack and its counted objects. A context holds a pattern, a pattern a surface, a
 * surface nothing: releasing goes three deep at most, whatever the input.
 */
#include "tap/svg/cairoscript_state.h"

#include <string.h>

static void *new_object(script_state *s, script_kind kind, size_t size)
{
    if (s->objects >= SCRIPT_MAX_OBJECTS) {
        plb_fail(s->err, ERROR_LIMIT, "more than %u groups at once", SCRIPT_MAX_OBJECTS);
        return NULL;
    }
    script_object *o = plb_new(1, size);
    if (!o) {
        plb_fail_memory(s->err);
        return NULL;
    }
    o->kind = kind;
    o->references = 1;
    s->objects++;
    return o;
}

script_surface *plb_script_new_surface(script_state *s, display_list *list)
{
    script_surface *f = new_object(s, OBJECT_SURFACE, sizeof *f);
    if (!f)
        return NULL;
    plb_list_init(&f->own);
    f->list = list ? list : &f->own;
    f->to_list = list ? s->to_page : MATRIX_IDENTITY;
    return f;
}

script_pattern *plb_script_new_pattern(script_state *s, paint colour)
{
    script_pattern *p = new_object(s, OBJECT_PATTERN, sizeof *p);
    if (!p)
        return NULL;
    p->paint = colour;
    p->matrix = MATRIX_IDENTITY;
    return p;
}

script_context *plb_script_new_context(script_state *s, script_surface *target)
{
    script_context *c = new_object(s, OBJECT_CONTEXT, sizeof *c);
    if (!c)
        return NULL;
    target->head.references++;
    c->target = target;
    c->ctm = MATRIX_IDENTITY;
    c->clip = NO_CLIP;
    c->draws = true;
    c->width = 2; /* cairo's default */
    return c;
}

void plb_script_release(script_state *s, script_object *o)
{
    if (!o || --o->references)
        return;
    s->objects--;
    if (o->kind == OBJECT_SURFACE) {
        script_surface *f = (script_surface *)o;
        s->held -= f->held;
        plb_list_free(&f->own);
    } else if (o->kind == OBJECT_PATTERN) {
        script_pattern *p = (script_pattern *)o;
        plb_script_release(s, p->surface ? &p->surface->head : NULL);
        plb_free(p->gradient);
    } else {
        script_context *c = (script_context *)o;
        plb_script_release(s, c->source ? &c->source->head : NULL);
        plb_script_release(s, &c->target->head);
        plb_path_free(&c->path);
        array_free(&c->dash);
    }
    plb_free(o);
}

bool plb_script_push(script_state *s, script_value v)
{
    if (s->stack.n >= SCRIPT_MAX_STACK)
        return plb_fail(s->err, ERROR_LIMIT, "more than %u operands", SCRIPT_MAX_STACK);
    return array_push(&s->stack, v) || plb_fail_memory(s->err);
}

bool plb_script_push_object(script_state *s, script_object *o)
{
    if (!o)
        return false;
    if (plb_script_push(s, (script_value){.kind = VALUE_OBJECT, .object = o}))
        return true;
    plb_script_release(s, o);
    return false;
}

script_value *plb_script_peek(script_state *s, size_t depth)
{
    if (depth < s->stack.n)
        return &s->stack.v[s->stack.n - 1 - depth];
    plb_fail(s->err, ERROR_SYNTAX, "an operand is missing");
    return NULL;
}

bool plb_script_pop(script_state *s)
{
    script_value *v = plb_script_peek(s, 0);
    if (!v)
        return false;
    if (v->kind == VALUE_OBJECT)
        plb_script_release(s, v->object);
    if (v->kind == VALUE_ARRAY && --s->arrays == 0)
        s->numbers.n = 0;
    s->stack.n--;
    return true;
}

bool plb_script_take(script_state *s, size_t n, double *numbers)
{
    if (s->stack.n < n)
        return plb_fail(s->err, ERROR_SYNTAX, "an operand is missing");
    const script_value *v = s->stack.v + s->stack.n - n;
    for (size_t i = 0; i < n; i++) {
        if (v[i].kind != VALUE_NUMBER)
            return plb_fail(s->err, ERROR_SYNTAX, "an operand is not a number");
        numbers[i] = v[i].number;
    }
    s->stack.n -= n;
    return true;
}

bool plb_script_pop_kind(script_state *s, value_kind kind, const char *what)
{
    script_value *v = plb_script_peek(s, 0);
    if (!v)
        return false;
    if (v->kind != kind)
        return plb_fail(s->err, ERROR_SYNTAX, "an operand is not a %s", what);
    return plb_script_pop(s);
}

void *plb_script_top(script_state *s, script_kind kind)
{
    static const char *const names[] = {"surface", "pattern", "context"};
    script_value *v = plb_script_peek(s, 0);
    if (!v)
        return NULL;
    if (v->kind == VALUE_OBJECT && v->object->kind == kind)
        return v->object;
    plb_fail(s->err, ERROR_SYNTAX, "an operand is not a %s", names[kind]);
    return NULL;
}

void plb_script_free(script_state *s)
{
    while (s->stack.n)
        plb_script_pop(s);
    for (size_t i = 0; i < s->bindings.n; i++)
        plb_script_release(s, s->bindings.v[i].object);
    array_free(&s->bindings);
    array_free(&s->stack);
    array_free(&s->numbers);
    array_free(&s->text);
    plb_scan_free(&s->scan);
}
