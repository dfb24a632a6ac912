/* SPDX-License-Identifier: MIT
 *
 * Makes objects of the bytes of a file: numbers, names, strings, and procedures with all that they hold.
 */
#include "tap/ps/ps.h"

#include <math.h>
#include <string.h>

ps_file *plb_ps_file_of_string(ps *p, ps_object string)
{
    ps_file *f = plb_ps_new(p, 1, sizeof *f);
    if (f)
        *f = (ps_file){.at = string.as.string, .end = string.as.string + string.n, .is_string = true};
    return f;
}

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
    *out = t->integer ? ps_whole(t->number) : ps_real(t->number);
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

/* Puts a procedure in the place of the operands above the topmost brace. */
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

/* Reads the rest of a procedure whose first brace has been read; its parts wait on the operand stack. */
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
