/* SPDX-License-Identifier: MIT
 *
 * Runs a program, and decides on a fault: the fault's handler of errordict runs, which by default stops the program up
 * to the nearest `stopped`; where there is none the fault becomes the one line of text the user sees (PLRM, section
 * 3.11).
 */
#include "tap/ps/ps.h"

#include <string.h>

static error_kind kind_of(ps_fault fault)
{
    switch (fault) {
    case PS_LIMITCHECK: case PS_VMERROR: case PS_STACKOVERFLOW: case PS_EXECSTACKOVERFLOW: case PS_DICTSTACKOVERFLOW:
    case PS_DICTFULL:
        return ERROR_LIMIT;
    case PS_UNDEFINED: case PS_UNDEFINEDRESOURCE: case PS_INVALIDFILEACCESS: case PS_CONFIGURATIONERROR:
        return ERROR_UNSUPPORTED;
    default: return ERROR_SYNTAX;
    }
}

/* Gives the culprit's name as one word that can be shown. */
static const char *show(ps_object o, char out[64])
{
    const char *text = o.type == PS_OPERATOR ? o.as.op->name : "";
    size_t n = strlen(text), k = 0;
    if (o.type == PS_NAME || o.type == PS_STRING)
        text = plb_ps_text(o, &n);
    for (; k < n && k < 60; k++)
        out[k] = text[k] > ' ' && text[k] <= '~' ? text[k] : '?';
    out[k] = '\0';
    return out;
}

static bool report(ps *p)
{
    char name[64];
    show(p->culprit, name);
    p->line = p->fault_line;
    if (p->detail[0])
        return plb_ps_fail(p, kind_of(p->last_fault), "%s", p->detail);
    if (p->last_fault == PS_UNDEFINED && p->culprit.type == PS_NAME)
        return plb_ps_fail(p, ERROR_UNSUPPORTED, "the PostScript operator '%s' is not known to this program", name);
    if (!name[0])
        return plb_ps_fail(p, kind_of(p->last_fault), "PostScript error %s", plb_ps_fault_names[p->last_fault]);
    return plb_ps_fail(p, kind_of(p->last_fault), "%s in '%s'", plb_ps_fault_names[p->last_fault], name);
}

bool plb_ps_stop(ps *p)
{
    while (p->frame_count) {
        bool found = p->frames[p->frame_count - 1].kind == FRAME_STOPPED;
        plb_ps_pop_frame(p);
        if (found)
            return plb_ps_give(p, p->operand_count == PS_MAX_OPERANDS, ps_boolean(true));
    }
    p->finished = true;
    return p->last_fault == PS_NO_FAULT || report(p);
}

static bool op_default_handler(ps *p)
{
    if (p->operand_count)
        ps_drop(p, 1);
    return plb_ps_stop(p);
}

static bool op_handleerror(ps *p)
{
    (void)p;
    return true;
}

static const ps_operator default_handler = {"%error", "", op_default_handler};
static const ps_operator handleerror = {"handleerror", "", op_handleerror};

static ps_object operator_object(const ps_operator *op)
{
    return (ps_object){.type = PS_OPERATOR, .executable = true, .as.op = op};
}

bool plb_ps_make_errordict(ps *p)
{
    for (int i = 1; i < PS_FAULT_COUNT; i++)
        if (!plb_ps_put_text(p, p->errordict, plb_ps_fault_names[i], operator_object(&default_handler)))
            return false;
    return plb_ps_put_text(p, p->errordict, "handleerror", operator_object(&handleerror)) &&
           plb_ps_put_text(p, p->systemdict, "handleerror", operator_object(&handleerror)) &&
           plb_ps_put_text(p, p->error_info, "newerror", ps_boolean(false)) &&
           plb_ps_put_text(p, p->error_info, "recordstacks", ps_boolean(false)) &&
           plb_ps_put_text(p, p->error_info, "errorinfo", ps_null()) &&
           plb_ps_put_text(p, p->error_info, "errorname", ps_null()) &&
           plb_ps_put_text(p, p->error_info, "command", ps_null());
}

/* Runs the handler after a step returned false; false when the reading is over. */
static bool handle_fault(ps *p)
{
    if (p->err.kind != ERROR_NONE || !plb_ps_charge(p, 50))
        return false;
    ps_fault fault = p->fault ? p->fault : PS_UNREGISTERED;
    ps_object name = plb_ps_name(p, plb_ps_fault_names[fault]);
    p->fault = PS_NO_FAULT;
    p->last_fault = fault;
    p->fault_line = p->line;
    if (!name.as.name || !plb_ps_put_text(p, p->error_info, "newerror", ps_boolean(true)) ||
        !plb_ps_put_text(p, p->error_info, "errorname", name) || !plb_ps_put_text(p, p->error_info, "command", p->culprit))
        return plb_ps_fail(p, ERROR_LIMIT, "out of memory");
    ps_object *handler = plb_ps_get(p, p->errordict, name);
    bool ours = !handler || (handler->type == PS_OPERATOR && handler->as.op == &default_handler);
    if (ours)
        return plb_ps_stop(p);
    if (p->operand_count < PS_MAX_OPERANDS)
        plb_ps_push(p, p->culprit);
    return plb_ps_execute(p, *handler) || (p->err.kind == ERROR_NONE && plb_ps_stop(p));
}

bool plb_ps_run(ps *p)
{
    while (p->frame_count && !p->finished) {
        ps_frame *f = &p->frames[p->frame_count - 1];
        if (!plb_ps_charge(p, 1))
            return false;
        p->op = NULL;
        p->culprit = ps_null();
        if (!f->step(p, f) && !handle_fault(p))
            return false;
    }
    return p->err.kind == ERROR_NONE;
}
