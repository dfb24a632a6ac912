/* SPDX-License-Identifier: MIT
 *
 * Holds the operators of control: conditions, loops, `exec`, `stopped` and their kin (PLRM, section 8.1), and `bind`.
 * Each loop is a frame whose step starts the next round.
 */
#include "tap/ps/ps.h"

#include <math.h>

/* Drops `n` operands, the topmost of which is a procedure, and pushes a loop that runs it. */
static ps_frame *start_loop(ps *p, unsigned n, bool (*step)(ps *, ps_frame *))
{
    ps_object body = *ps_args(p, 1);
    ps_frame *f = plb_ps_push_frame(p, step);
    if (!f)
        return NULL;
    f->kind = FRAME_LOOP;
    f->body = body;
    ps_drop(p, n);
    return f;
}

static bool op_if(ps *p)
{
    ps_object *v = ps_args(p, 2), body = v[1];
    bool yes = v[0].as.boolean;
    ps_drop(p, 2);
    return !yes || plb_ps_execute(p, body);
}

static bool op_ifelse(ps *p)
{
    ps_object *v = ps_args(p, 3), body = v[0].as.boolean ? v[1] : v[2];
    ps_drop(p, 3);
    return plb_ps_execute(p, body);
}

static bool step_loop(ps *p, ps_frame *f)
{
    return plb_ps_execute(p, f->body);
}

static bool op_loop(ps *p)
{
    return start_loop(p, 1, step_loop) != NULL;
}

static bool step_repeat(ps *p, ps_frame *f)
{
    if (f->index-- == 0) {
        plb_ps_pop_frame(p);
        return true;
    }
    return plb_ps_execute(p, f->body);
}

static bool op_repeat(ps *p)
{
    int32_t times = ps_args(p, 2)->as.integer;
    if (times < 0)
        return plb_ps_raise(p, PS_RANGECHECK);
    ps_frame *f = start_loop(p, 2, step_repeat);
    if (f)
        f->index = (uint32_t)times;
    return f != NULL;
}

static bool step_for(ps *p, ps_frame *f)
{
    if (f->by >= 0 ? f->now > f->limit : f->now < f->limit) {
        plb_ps_pop_frame(p);
        return true;
    }
    ps_object now = f->index ? ps_whole(f->now) : ps_real(f->now);
    f->now += f->by;
    return plb_ps_push(p, now) && plb_ps_execute(p, f->body);
}

static bool op_for(ps *p)
{
    ps_object *v = ps_args(p, 4), from = v[0], by = v[1], limit = v[2];
    ps_frame *f = start_loop(p, 4, step_for);
    if (!f)
        return false;
    f->now = ps_value(from);
    f->by = ps_value(by);
    f->limit = ps_value(limit);
    f->index = from.type == PS_INTEGER && by.type == PS_INTEGER;
    return true;
}

static bool step_forall_array(ps *p, ps_frame *f)
{
    if (f->index >= f->subject.n) {
        plb_ps_pop_frame(p);
        return true;
    }
    return plb_ps_push(p, f->subject.as.array[f->index++]) && plb_ps_execute(p, f->body);
}

static bool step_forall_string(ps *p, ps_frame *f)
{
    if (f->index >= f->subject.n) {
        plb_ps_pop_frame(p);
        return true;
    }
    unsigned char c = (unsigned char)f->subject.as.string[f->index++];
    return plb_ps_push(p, ps_integer(c)) && plb_ps_execute(p, f->body);
}

static bool step_forall_dict(ps *p, ps_frame *f)
{
    const ps_dict *d = f->subject.as.dict;
    while (f->index < d->used && d->entries[f->index].key.type == PS_NULL)
        f->index++, p->steps++;
    if (f->index >= d->used) {
        plb_ps_pop_frame(p);
        return true;
    }
    ps_entry e = d->entries[f->index++];
    return plb_ps_push(p, e.key) && plb_ps_push(p, e.value) && plb_ps_execute(p, f->body);
}

static bool op_forall(ps *p)
{
    ps_object subject = *ps_args(p, 2);
    bool (*step)(ps *, ps_frame *) = subject.type == PS_ARRAY    ? step_forall_array
                                     : subject.type == PS_STRING ? step_forall_string
                                     : subject.type == PS_DICT   ? step_forall_dict
                                                                 : NULL;
    if (!step)
        return plb_ps_raise(p, PS_TYPECHECK);
    ps_frame *f = start_loop(p, 2, step);
    if (f)
        f->subject = subject;
    return f != NULL;
}

static bool op_exit(ps *p)
{
    for (uint32_t i = p->frame_count; i-- > 0;) {
        ps_frame_kind kind = p->frames[i].kind;
        if (kind == FRAME_STOPPED || kind == FRAME_SOURCE)
            break;
        if (kind != FRAME_LOOP)
            continue;
        while (p->frame_count > i)
            plb_ps_pop_frame(p);
        return true;
    }
    return plb_ps_raise(p, PS_INVALIDEXIT);
}

static bool op_exec(ps *p)
{
    ps_object body = *ps_args(p, 1);
    ps_drop(p, 1);
    return plb_ps_execute(p, body);
}

static bool step_stopped(ps *p, ps_frame *f)
{
    (void)f;
    plb_ps_pop_frame(p);
    return plb_ps_push(p, ps_boolean(false));
}

static bool op_stopped(ps *p)
{
    ps_object body = *ps_args(p, 1);
    ps_frame *f = plb_ps_push_frame(p, step_stopped);
    if (!f)
        return false;
    f->kind = FRAME_STOPPED;
    ps_drop(p, 1);
    return plb_ps_execute(p, body);
}

static bool op_stop(ps *p)
{
    return plb_ps_stop(p);
}

static bool op_quit(ps *p)
{
    p->finished = true;
    return true;
}

static bool op_countexecstack(ps *p)
{
    return plb_ps_push(p, ps_integer((int32_t)p->frame_count));
}

/* Fills the array with nulls for the frames, whose contents no program could use. */
static bool op_execstack(ps *p)
{
    ps_object *v = ps_args(p, 1);
    if (v->n < p->frame_count)
        return plb_ps_raise(p, PS_RANGECHECK);
    v->n = p->frame_count;
    return true;
}

/* Replaces names that now mean operators by these operators, in the procedures within too. Each place that holds a
 * procedure is marked when it has been seen, so that procedures that hold themselves come to an end. */
static bool bind_procedure(ps *p, ps_object proc, void *waiting_list)
{
    ARRAY(ps_object) *waiting = waiting_list;
    for (uint32_t i = 0; i < proc.n; i++) {
        ps_object *at = &proc.as.array[i];
        if (!at->executable)
            continue;
        if (at->type == PS_NAME) {
            ps_object *value = plb_ps_lookup(p, *at, NULL);
            if (value && value->type == PS_OPERATOR)
                *at = (ps_object){.type = PS_OPERATOR, .executable = true, .n = at->n, .as.op = value->as.op};
        } else if (at->type == PS_ARRAY && !at->stamp) {
            at->stamp = 1;
            if (!array_push(waiting, *at))
                return plb_fail_memory(&p->err);
        }
    }
    return plb_ps_charge(p, proc.n / 4 + 1);
}

static bool op_bind(ps *p)
{
    ARRAY(ps_object) waiting = {0};
    bool good = bind_procedure(p, *ps_args(p, 1), &waiting);
    while (good && waiting.n)
        good = bind_procedure(p, waiting.v[--waiting.n], &waiting);
    array_free(&waiting);
    return good;
}

const ps_operator plb_ps_control_operators[] = {
    {"if", "bp", op_if},
    {"ifelse", "bpp", op_ifelse},
    {"loop", "p", op_loop},
    {"repeat", "ip", op_repeat},
    {"for", "nnnp", op_for},
    {"forall", "xp", op_forall},
    {"exit", "", op_exit},
    {"exec", "x", op_exec},
    {"stopped", "x", op_stopped},
    {"stop", "", op_stop},
    {"quit", "", op_quit},
    {"countexecstack", "", op_countexecstack},
    {"execstack", "a", op_execstack},
    {"bind", "a", op_bind},
    {NULL, NULL, NULL},
};
