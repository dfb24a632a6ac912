/* SPDX-License-Identifier: MIT
 *
 * Holds the operators of comparison, booleans and bits (PLRM, section 8.1).
 */
#include "tap/ps/ps.h"

#include <string.h>

static bool op_eq(ps *p)
{
    ps_object *v = ps_args(p, 2);
    return plb_ps_charge(p, v[0].type == PS_STRING ? v[0].n / 64 : 0) && plb_ps_give(p, 2, ps_boolean(plb_ps_equal(v[0], v[1])));
}

static bool op_ne(ps *p)
{
    ps_object *v = ps_args(p, 2);
    return plb_ps_charge(p, v[0].type == PS_STRING ? v[0].n / 64 : 0) && plb_ps_give(p, 2, ps_boolean(!plb_ps_equal(v[0], v[1])));
}

/* Compares numbers by value, strings by their bytes; -1, 0 or 1 in `order`. */
static bool compare(ps *p, int *order)
{
    ps_object *v = ps_args(p, 2);
    if (ps_is_number(v[0]) && ps_is_number(v[1])) {
        double a = ps_value(v[0]), b = ps_value(v[1]);
        *order = (a > b) - (a < b);
        return true;
    }
    if (v[0].type != PS_STRING || v[1].type != PS_STRING)
        return plb_ps_raise(p, PS_TYPECHECK);
    uint32_t n = v[0].n < v[1].n ? v[0].n : v[1].n;
    *order = n ? memcmp(v[0].as.string, v[1].as.string, n) : 0;
    if (!*order)
        *order = (v[0].n > v[1].n) - (v[0].n < v[1].n);
    return plb_ps_charge(p, n / 64);
}

static bool op_gt(ps *p)
{
    int order = 0;
    return compare(p, &order) && plb_ps_give(p, 2, ps_boolean(order > 0));
}

static bool op_ge(ps *p)
{
    int order = 0;
    return compare(p, &order) && plb_ps_give(p, 2, ps_boolean(order >= 0));
}

static bool op_lt(ps *p)
{
    int order = 0;
    return compare(p, &order) && plb_ps_give(p, 2, ps_boolean(order < 0));
}

static bool op_le(ps *p)
{
    int order = 0;
    return compare(p, &order) && plb_ps_give(p, 2, ps_boolean(order <= 0));
}

/* Takes two booleans or two integers; as integers in `a` and `b`. */
static bool both(ps *p, uint32_t *a, uint32_t *b)
{
    ps_object *v = ps_args(p, 2);
    if (v[0].type != v[1].type || (v[0].type != PS_BOOLEAN && v[0].type != PS_INTEGER))
        return plb_ps_raise(p, PS_TYPECHECK);
    *a = v[0].type == PS_BOOLEAN ? v[0].as.boolean : (uint32_t)v[0].as.integer;
    *b = v[1].type == PS_BOOLEAN ? v[1].as.boolean : (uint32_t)v[1].as.integer;
    return true;
}

static bool give_bits(ps *p, unsigned drop, uint32_t bits)
{
    bool is_boolean = ps_args(p, 1)->type == PS_BOOLEAN;
    return plb_ps_give(p, drop, is_boolean ? ps_boolean(bits & 1) : ps_integer((int32_t)bits));
}

static bool op_and(ps *p)
{
    uint32_t a = 0, b = 0;
    return both(p, &a, &b) && give_bits(p, 2, a & b);
}

static bool op_or(ps *p)
{
    uint32_t a = 0, b = 0;
    return both(p, &a, &b) && give_bits(p, 2, a | b);
}

static bool op_xor(ps *p)
{
    uint32_t a = 0, b = 0;
    return both(p, &a, &b) && give_bits(p, 2, a ^ b);
}

static bool op_not(ps *p)
{
    ps_object *v = ps_args(p, 1);
    if (v->type == PS_BOOLEAN)
        return plb_ps_give(p, 1, ps_boolean(!v->as.boolean));
    return v->type == PS_INTEGER ? plb_ps_give(p, 1, ps_integer(~v->as.integer)) : plb_ps_raise(p, PS_TYPECHECK);
}

static bool op_bitshift(ps *p)
{
    ps_object *v = ps_args(p, 2);
    uint32_t bits = (uint32_t)v[0].as.integer;
    int32_t by = v[1].as.integer;
    if (by >= 32 || by <= -32)
        bits = 0;
    else
        bits = by >= 0 ? bits << by : bits >> -by;
    return plb_ps_give(p, 2, ps_integer((int32_t)bits));
}


const ps_operator plb_ps_relation_operators[] = {
    {"eq", "xx", op_eq},
    {"ne", "xx", op_ne},
    {"gt", "xx", op_gt},
    {"ge", "xx", op_ge},
    {"lt", "xx", op_lt},
    {"le", "xx", op_le},
    {"and", "xx", op_and},
    {"or", "xx", op_or},
    {"xor", "xx", op_xor},
    {"not", "x", op_not},
    {"bitshift", "ii", op_bitshift},
    {NULL, NULL, NULL},
};
