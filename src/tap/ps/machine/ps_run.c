/* SPDX-License-Identifier: MIT
 *
 * The heart of the PostScript interpreter: takes objects from files and procedures and executes them, one at a
 * time, with everything that is under way on a stack of frames; bounds the steps.
 */
#include "tap/ps/ps.h"

#include <math.h>
#include <string.h>

/* ---- operands --------------------------------------------------------------------------------------------- */

bool plb_ps_push(ps *p, ps_object o)
{
    if (p->operand_count >= PS_MAX_OPERANDS)
        return plb_ps_raise(p, PS_STACKOVERFLOW);
    p->operands[p->operand_count++] = o;
    return true;
}

bool plb_ps_give(ps *p, unsigned drop, ps_object result)
{
    if (!drop)
        return plb_ps_push(p, result);
    p->operand_count -= drop - 1;
    p->operands[p->operand_count - 1] = result;
    return true;
}

bool plb_ps_count_to_mark(ps *p, uint32_t *count)
{
    for (uint32_t i = p->operand_count; i-- > 0;)
        if (p->operands[i].type == PS_MARK) {
            *count = p->operand_count - 1 - i;
            return plb_ps_charge(p, *count / 8);
        }
    return plb_ps_charge(p, p->operand_count / 8) && plb_ps_raise(p, PS_UNMATCHEDMARK);
}

static bool fits(ps_object o, char letter)
{
    switch (letter) {
    case 'n': return ps_is_number(o);
    case 'i': return o.type == PS_INTEGER;
    case 'b': return o.type == PS_BOOLEAN;
    case 's': return o.type == PS_STRING;
    case 'a': return o.type == PS_ARRAY;
    case 'p': return ps_is_proc(o);
    case 'm': return o.type == PS_ARRAY && o.n == 6;
    case 'd': return o.type == PS_DICT;
    case 'k': return o.type == PS_NAME || o.type == PS_STRING;
    case 'f': return o.type == PS_FILE;
    default: return true;
    }
}

bool plb_ps_check(ps *p, const char *signature)
{
    size_t n = strlen(signature);
    if (n > p->operand_count)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    const ps_object *v = ps_args(p, (unsigned)n);
    for (size_t i = 0; i < n; i++)
        if (!fits(v[i], signature[i]))
            return plb_ps_raise(p, PS_TYPECHECK);
    return true;
}

/* ---- frames ----------------------------------------------------------------------------------------------- */

ps_frame *plb_ps_push_frame(ps *p, bool (*step)(ps *, ps_frame *))
{
    if (p->frame_count >= PS_MAX_FRAMES) {
        plb_ps_raise(p, PS_EXECSTACKOVERFLOW);
        return NULL;
    }
    ps_frame *f = &p->frames[p->frame_count++];
    *f = (ps_frame){.step = step};
    return f;
}

void plb_ps_pop_frame(ps *p)
{
    ps_frame *f = &p->frames[--p->frame_count];
    if (f->drop)
        f->drop(p, f);
}

static bool step_then(ps *p, ps_frame *f)
{
    bool (*then)(ps *, ps_frame *) = NULL;
    ps_frame copy = *f;
    memcpy(&then, f->data, sizeof then);
    plb_ps_pop_frame(p);
    return then(p, &copy);
}

ps_frame *plb_ps_push_then(ps *p, bool (*then)(ps *p, ps_frame *f))
{
    void *room = plb_ps_new(p, 1, sizeof then);
    if (!room)
        return NULL;
    memcpy(room, &then, sizeof then);
    ps_frame *f = plb_ps_push_frame(p, step_then);
    if (f)
        f->data = room;
    return f;
}

/* ---- files ------------------------------------------------------------------------------------------------ */

ps_file *plb_ps_file_of_string(ps *p, ps_object string)
{
    ps_file *f = plb_ps_new(p, 1, sizeof *f);
    if (f)
        *f = (ps_file){.at = string.as.string, .end = string.as.string + string.n, .is_string = true};
    return f;
}

static bool step_source(ps *p, ps_frame *f);

bool plb_ps_push_source(ps *p, ps_file *file)
{
    p->retry = ps_of_file(file);
    p->retry.executable = true;
    if (!plb_ps_open_file(p, file))
        return false;
    if (file->opaque)
        return plb_ps_fail(p, ERROR_UNSUPPORTED, "a program encoded by the filter '%s' cannot be read", file->opaque);
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

/* ---- from tokens to objects ------------------------------------------------------------------------------- */

static bool scan_fault(ps *p, const error *err)
{
    if (err->kind == ERROR_MEMORY)
        return plb_fail_memory(&p->err);
    return plb_ps_explain(p, err->kind == ERROR_LIMIT ? PS_LIMITCHECK : PS_SYNTAXERROR, "%s", err->text);
}

static bool scan_token(ps *p, ps_file *f, token *t)
{
    error err = {0};
    p->scan.at = f->at;
    p->scan.end = f->end;
    p->scan.next_line = f->line;
    bool good = plb_scan_next(&p->scan, t, &err);
    p->steps += (size_t)(p->scan.at - f->at) / 32;
    f->at = p->scan.at;
    if (f->line) {
        f->line = p->scan.next_line;
        p->line = p->scan.line;
    }
    return good || scan_fault(p, &err);
}

static bool named_object(ps *p, const char *text, size_t n, bool executable, ps_object *out)
{
    *out = (ps_object){.type = PS_NAME, .executable = executable, .n = (uint32_t)p->line};
    out->as.name = plb_ps_intern(p, text, n);
    return out->as.name != NULL;
}

static bool immediate_object(ps *p, const token *t, ps_object *out)
{
    ps_object name;
    if (!named_object(p, t->text, t->length, true, &name))
        return false;
    ps_object *value = plb_ps_lookup(p, name, NULL);
    if (!value)
        return plb_ps_undefined(p, name);
    *out = *value;
    return true;
}

static bool number_object(ps *p, const token *t, ps_object *out)
{
    if (!isfinite(t->number))
        return plb_ps_raise(p, PS_LIMITCHECK);
    *out = t->integer ? plb_ps_whole(t->number) : ps_real(t->number);
    return true;
}

static bool simple_object(ps *p, const token *t, ps_object *out)
{
    switch (t->kind) {
    case TOKEN_NUMBER: return number_object(p, t, out);
    case TOKEN_NAME: return named_object(p, t->text, t->length, true, out);
    case TOKEN_LITERAL: return named_object(p, t->text, t->length, false, out);
    case TOKEN_IMMEDIATE: return immediate_object(p, t, out);
    case TOKEN_STRING: return plb_ps_new_string(p, t->text, t->length, out);
    case TOKEN_ARRAY_OPEN: return named_object(p, "[", 1, true, out);
    case TOKEN_ARRAY_CLOSE: return named_object(p, "]", 1, true, out);
    case TOKEN_DICT_OPEN: return named_object(p, "<<", 2, true, out);
    case TOKEN_DICT_CLOSE: return named_object(p, ">>", 2, true, out);
    default:
        return plb_ps_explain(p, PS_SYNTAXERROR, "%s", t->kind == TOKEN_PROC_CLOSE ? "a '}' without its '{'" : "a malformed string");
    }
}

/* The operands above the topmost brace become a procedure in its place. */
static bool close_brace(ps *p, ps_object *out)
{
    uint32_t n = 0;
    while (p->operands[p->operand_count - 1 - n].type != PS_BRACE)
        n++;
    if (!plb_ps_new_array(p, n, out))
        return false;
    if (n)
        memcpy(out->as.array, ps_args(p, n), n * sizeof *out->as.array);
    out->executable = true;
    ps_drop(p, n + 1);
    return true;
}

/* The rest of a procedure whose first brace has been read; its parts wait on the operand stack. */
static bool read_procedure(ps *p, ps_file *f, ps_object *out)
{
    unsigned depth = 1;
    int first_line = p->line;
    token t;
    if (!plb_ps_push(p, (ps_object){.type = PS_BRACE}))
        return false;
    while (depth) {
        ps_object o = {.type = PS_BRACE};
        if (!scan_token(p, f, &t) || !plb_ps_charge(p, 1))
            return false;
        if (t.kind == TOKEN_END) {
            p->line = first_line;
            return plb_ps_explain(p, PS_SYNTAXERROR, "the procedure that starts here never ends");
        }
        if (t.kind == TOKEN_PROC_OPEN)
            depth++;
        else if (t.kind == TOKEN_PROC_CLOSE ? !close_brace(p, &o) : !simple_object(p, &t, &o))
            return false;
        if (t.kind == TOKEN_PROC_CLOSE && --depth == 0) {
            *out = o;
            return true;
        }
        if (!plb_ps_push(p, o))
            return false;
    }
    return true;
}

bool plb_ps_read_object(ps *p, ps_file *f, ps_object *out, bool *ended)
{
    token t;
    uint32_t base = p->operand_count;
    if (!scan_token(p, f, &t))
        return false;
    *ended = t.kind == TOKEN_END;
    if (*ended)
        return true;
    if (t.kind != TOKEN_PROC_OPEN)
        return simple_object(p, &t, out);
    bool good = read_procedure(p, f, out);
    if (!good)
        p->operand_count = base;
    return good;
}

/* ---- execution -------------------------------------------------------------------------------------------- */

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

/* An object met in a file or procedure: a procedure there waits, it is not entered. */
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

/* ---- the loop --------------------------------------------------------------------------------------------- */

bool plb_ps_charge(ps *p, size_t work)
{
    p->steps += work;
    if (p->steps <= PS_MAX_STEPS)
        return true;
    return plb_ps_fail(p, ERROR_LIMIT, "the PostScript program runs for more than %u steps", PS_MAX_STEPS);
}

bool plb_ps_run(ps *p)
{
    while (p->frame_count && !p->finished) {
        ps_frame *f = &p->frames[p->frame_count - 1];
        if (!plb_ps_charge(p, 1))
            return false;
        p->op = NULL;
        p->culprit = ps_null();
        if (f->step(p, f) || (p->pull && plb_ps_start_pull(p)))
            continue;
        if (!plb_ps_handle_fault(p))
            return false;
    }
    return p->err.kind == ERROR_NONE;
}
