/* SPDX-License-Identifier: MIT
 *
 * How an operator says that it cannot go on: a fault, which the program may catch, or a failure, which ends the reading;
 * and the count of steps that bounds every program.
 */
#include "tap/ps/ps.h"

#include <stdio.h>
#include <string.h>

const char *const plb_ps_fault_names[PS_FAULT_COUNT] = {
    [PS_NO_FAULT] = "", [PS_CONFIGURATIONERROR] = "configurationerror", [PS_DICTFULL] = "dictfull",
    [PS_DICTSTACKOVERFLOW] = "dictstackoverflow", [PS_DICTSTACKUNDERFLOW] = "dictstackunderflow",
    [PS_EXECSTACKOVERFLOW] = "execstackoverflow", [PS_INTERRUPT] = "interrupt", [PS_INVALIDACCESS] = "invalidaccess",
    [PS_INVALIDEXIT] = "invalidexit", [PS_INVALIDFILEACCESS] = "invalidfileaccess", [PS_INVALIDFONT] = "invalidfont",
    [PS_INVALIDRESTORE] = "invalidrestore", [PS_IOERROR] = "ioerror", [PS_LIMITCHECK] = "limitcheck",
    [PS_NOCURRENTPOINT] = "nocurrentpoint", [PS_RANGECHECK] = "rangecheck", [PS_STACKOVERFLOW] = "stackoverflow",
    [PS_STACKUNDERFLOW] = "stackunderflow", [PS_SYNTAXERROR] = "syntaxerror", [PS_TIMEOUT] = "timeout",
    [PS_TYPECHECK] = "typecheck", [PS_UNDEFINED] = "undefined", [PS_UNDEFINEDFILENAME] = "undefinedfilename",
    [PS_UNDEFINEDRESOURCE] = "undefinedresource", [PS_UNDEFINEDRESULT] = "undefinedresult",
    [PS_UNMATCHEDMARK] = "unmatchedmark", [PS_UNREGISTERED] = "unregistered", [PS_VMERROR] = "VMerror",
};

bool plb_ps_raise(ps *p, ps_fault fault)
{
    p->fault = fault;
    p->detail[0] = '\0';
    if (p->op)
        p->culprit = (ps_object){.type = PS_OPERATOR, .executable = true, .as.op = p->op};
    return false;
}

bool plb_ps_explain(ps *p, ps_fault fault, const char *format, ...)
{
    va_list args;
    plb_ps_raise(p, fault);
    va_start(args, format);
    vsnprintf(p->detail, sizeof p->detail, format, args);
    va_end(args);
    return false;
}

bool plb_ps_undefined(ps *p, ps_object key)
{
    p->op = NULL;
    p->culprit = key;
    return plb_ps_raise(p, PS_UNDEFINED);
}

bool plb_ps_refuse(ps *p)
{
    p->refused = true;
    return plb_ps_explain(p, PS_INVALIDFILEACCESS, "the operator '%s' is refused", p->op->name);
}

bool plb_ps_fail(ps *p, error_kind kind, const char *format, ...)
{
    char text[400];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return plb_fail(&p->err, kind, "%d: %s", p->line, text);
}

bool plb_ps_charge(ps *p, size_t work)
{
    p->steps += work;
    if (p->steps <= p->max_steps)
        return true;
    return plb_ps_fail(p, ERROR_LIMIT, "the PostScript program runs for more than %u steps", PS_MAX_STEPS);
}
