/* SPDX-License-Identifier: MIT
 *
 * Holds the operators on the operand stack (PLRM, section 8.1).
 */
#include "tap/ps/ps.h"

#include <string.h>

static bool op_pop(ps *p)
{
    ps_drop(p, 1);
    return true;
}

static bool op_exch(ps *p)
{
    ps_object *v = ps_args(p, 2), lower = v[0];
    v[0] = v[1];
    v[1] = lower;
    return true;
}

static bool op_dup(ps *p)
{
    return plb_ps_push(p, *ps_args(p, 1));
}

static bool op_index(ps *p)
{
    int32_t i = ps_args(p, 1)->as.integer;
    if (i < 0)
        return plb_ps_raise(p, PS_RANGECHECK);
    if ((uint32_t)i + 2 > p->operand_count)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    return plb_ps_give(p, 1, *ps_args(p, (unsigned)i + 2));
}

static void reverse(ps_object *from, ps_object *to)
{
    for (; from < --to; from++) {
        ps_object kept = *from;
        *from = *to;
        *to = kept;
    }
}

/* Rotates by k with three reversals. */
static bool op_roll(ps *p)
{
    ps_object *v = ps_args(p, 2);
    int32_t n = v[0].as.integer, by = v[1].as.integer;
    if (n < 0)
        return plb_ps_raise(p, PS_RANGECHECK);
    if ((uint32_t)n + 2 > p->operand_count)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    if (!plb_ps_charge(p, (size_t)n / 8))
        return false;
    ps_drop(p, 2);
    if (!n)
        return true;
    int32_t up = by % n;
    if (up < 0)
        up += n;
    v = ps_args(p, (unsigned)n);
    reverse(v, v + n - up);
    reverse(v + n - up, v + n);
    reverse(v, v + n);
    return true;
}

static bool op_clear(ps *p)
{
    p->operand_count = 0;
    return true;
}

static bool op_count(ps *p)
{
    return plb_ps_push(p, ps_integer((int32_t)p->operand_count));
}

static bool op_mark(ps *p)
{
    return plb_ps_push(p, ps_mark());
}

static bool op_cleartomark(ps *p)
{
    uint32_t n;
    if (!plb_ps_count_to_mark(p, &n))
        return false;
    ps_drop(p, n + 1);
    return true;
}

static bool op_counttomark(ps *p)
{
    uint32_t n;
    return plb_ps_count_to_mark(p, &n) && plb_ps_push(p, ps_integer((int32_t)n));
}

/* Copies the topmost n operands: the `copy` of a number. */
static bool copy_operands(ps *p, int32_t n)
{
    if (n < 0)
        return plb_ps_raise(p, PS_RANGECHECK);
    if ((uint32_t)n + 1 > p->operand_count)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    if ((uint32_t)n + p->operand_count > PS_MAX_OPERANDS)
        return plb_ps_raise(p, PS_STACKOVERFLOW);
    ps_drop(p, 1);
    if (n)
        memcpy(p->operands + p->operand_count, ps_args(p, (unsigned)n), (size_t)n * sizeof *p->operands);
    p->operand_count += (uint32_t)n;
    return plb_ps_charge(p, (size_t)n / 8);
}

static bool copy_dict(ps *p)
{
    ps_object *v = ps_args(p, 2);
    const ps_dict *from = v[0].as.dict;
    ps_dict *to = v[1].as.dict;
    if (from == to)
        return plb_ps_give(p, 2, v[1]);
    for (uint32_t i = 0; i < from->used; i++)
        if (from->entries[i].key.type != PS_NULL && !plb_ps_put(p, to, from->entries[i].key, from->entries[i].value))
            return false;
    return plb_ps_charge(p, from->used) && plb_ps_give(p, 2, v[1]);
}

/* Copies a composite object into another of its type: the other `copy`; the result is the part that was filled. */
static bool copy_composite(ps *p)
{
    ps_object *v = ps_args(p, 2), to = v[1];
    if (v[0].type != to.type)
        return plb_ps_raise(p, PS_TYPECHECK);
    if (to.type == PS_DICT)
        return copy_dict(p);
    if (to.type != PS_ARRAY && to.type != PS_STRING)
        return plb_ps_raise(p, PS_TYPECHECK);
    if (v[0].n > to.n)
        return plb_ps_raise(p, PS_RANGECHECK);
    to.n = v[0].n;
    if (to.n && to.type == PS_ARRAY)
        memmove(to.as.array, v[0].as.array, to.n * sizeof *to.as.array);
    else if (to.n)
        memmove(to.as.string, v[0].as.string, to.n);
    return plb_ps_charge(p, to.n / 16) && plb_ps_give(p, 2, to);
}

static bool op_copy(ps *p)
{
    ps_object top = *ps_args(p, 1);
    if (top.type == PS_INTEGER)
        return copy_operands(p, top.as.integer);
    return plb_ps_check(p, "xx") && copy_composite(p);
}

const ps_operator plb_ps_stack_operators[] = {
    {"pop", "x", op_pop},
    {"exch", "xx", op_exch},
    {"dup", "x", op_dup},
    {"copy", "x", op_copy},
    {"index", "i", op_index},
    {"roll", "ii", op_roll},
    {"clear", "", op_clear},
    {"count", "", op_count},
    {"mark", "", op_mark},
    {"[", "", op_mark},
    {"<<", "", op_mark},
    {"cleartomark", "", op_cleartomark},
    {"counttomark", "", op_counttomark},
    {NULL, NULL, NULL},
};
