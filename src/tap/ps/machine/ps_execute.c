/* SPDX-License-Identifier: MIT
 *
 * Executes objects one at a time (PLRM, section 3.5): literals are pushed, names looked up, procedures and files entered
 * as frames, operators called.
 */
#include "tap/ps/ps.h"

static bool step_source(ps *p, ps_frame *f);

bool plb_ps_push_source(ps *p, ps_file *file)
{
    ps_frame *f = plb_ps_push_frame(p, step_source);
    if (!f)
        return false;
    f->kind = FRAME_SOURCE;
    f->data = file;
    return true;
}

ps_file *plb_ps_current_file(ps *p)
{
    for (uint32_t i = p->frame_count; i-- > 0;) {
        ps_file *f = p->frames[i].data;
        if (p->frames[i].kind == FRAME_SOURCE && !f->is_string)
            return f;
        p->steps += i % 8 == 0;
    }
    return p->main_file;
}

static bool call(ps *p, ps_object o)
{
    p->op = o.as.op;
    if (o.n)
        p->line = (int)o.n;
    return plb_ps_check(p, p->op->signature) && p->op->run(p);
}

static bool step_procedure(ps *p, ps_frame *f);

bool plb_ps_execute(ps *p, ps_object o)
{
    while (o.executable && o.type == PS_NAME) {
        if (o.n)
            p->line = (int)o.n;
        ps_object *value = plb_ps_lookup(p, o, NULL);
        if (!value)
            return plb_ps_undefined(p, o);
        uint32_t line = o.n;
        o = *value;
        if (o.type == PS_OPERATOR)
            o.n = line;
        if (!plb_ps_charge(p, 1))
            return false;
    }
    if (o.type == PS_OPERATOR)
        return call(p, o);
    p->op = NULL;
    if (!o.executable)
        return plb_ps_push(p, o);
    if (o.type == PS_ARRAY) {
        ps_frame *f = plb_ps_push_frame(p, step_procedure);
        if (f)
            f->body = o;
        return f != NULL;
    }
    if (o.type == PS_STRING) {
        ps_file *f = plb_ps_file_of_string(p, o);
        return f && plb_ps_push_source(p, f);
    }
    if (o.type == PS_FILE)
        return plb_ps_push_source(p, o.as.file);
    return o.type == PS_NULL || plb_ps_push(p, o);
}

/* Executes an object met in a file or procedure, where a procedure waits instead of being entered. */
static bool meet(ps *p, ps_object o)
{
    if (!o.executable && o.type != PS_OPERATOR)
        return plb_ps_push(p, o);
    return o.type == PS_ARRAY ? plb_ps_push(p, o) : plb_ps_execute(p, o);
}

/* The last object is executed after the frame has gone, so that a procedure may end in a call of itself. */
static bool step_procedure(ps *p, ps_frame *f)
{
    if (f->index >= f->body.n) {
        plb_ps_pop_frame(p);
        return true;
    }
    ps_object o = f->body.as.array[f->index++];
    if (f->index == f->body.n)
        plb_ps_pop_frame(p);
    p->op = NULL;
    return meet(p, o);
}

static bool step_source(ps *p, ps_frame *f)
{
    ps_object o = {0};
    bool ended;
    p->op = NULL;
    if (!plb_ps_read_object(p, f->data, &o, &ended))
        return false;
    if (ended) {
        plb_ps_pop_frame(p);
        return true;
    }
    return meet(p, o);
}
