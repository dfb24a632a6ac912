/* SPDX-License-Identifier: MIT
 *
 * Keeps the interpreter's two stacks: operands, checked against an operator's signature, and the frames of what is
 * under way.
 */
#include "tap/ps/ps.h"

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
    void *memory = plb_ps_new(p, 1, sizeof then);
    if (!memory)
        return NULL;
    memcpy(memory, &then, sizeof then);
    ps_frame *f = plb_ps_push_frame(p, step_then);
    if (f)
        f->data = memory;
    return f;
}
