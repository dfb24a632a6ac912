/* SPDX-License-Identifier: MIT
 *
 * Holds the operators on arrays, and those that arrays share with strings and dictionaries: get, put, length and the
 * intervals (PLRM, section 8.1).
 */
#include "tap/ps/ps.h"

#include <string.h>

static bool op_array(ps *p)
{
    int32_t n = ps_args(p, 1)->as.integer;
    ps_object array;
    if (n < 0)
        return plb_ps_raise(p, PS_RANGECHECK);
    return plb_ps_new_array(p, (uint32_t)n, &array) && plb_ps_give(p, 1, array);
}

/* Puts the topmost `n` operands as an array in the place of these and `more` operands below or above them. */
static bool gather(ps *p, uint32_t n, unsigned below, unsigned above)
{
    ps_object array;
    if (!plb_ps_new_array(p, n, &array))
        return false;
    if (n)
        memcpy(array.as.array, ps_args(p, n + above), n * sizeof array);
    return plb_ps_give(p, n + below + above, array);
}

static bool op_close_array(ps *p)
{
    uint32_t n;
    return plb_ps_count_to_mark(p, &n) && gather(p, n, 1, 0);
}

static bool op_packedarray(ps *p)
{
    int32_t n = ps_args(p, 1)->as.integer;
    if (n < 0)
        return plb_ps_raise(p, PS_RANGECHECK);
    if ((uint32_t)n + 1 > p->operand_count)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    return gather(p, (uint32_t)n, 0, 1);
}

static bool op_aload(ps *p)
{
    ps_object array = *ps_args(p, 1);
    if (array.n + p->operand_count > PS_MAX_OPERANDS)
        return plb_ps_raise(p, PS_STACKOVERFLOW);
    ps_drop(p, 1);
    if (array.n)
        memcpy(p->operands + p->operand_count, array.as.array, array.n * sizeof array);
    p->operand_count += array.n;
    return plb_ps_charge(p, array.n / 8) && plb_ps_push(p, array);
}

static bool op_astore(ps *p)
{
    ps_object array = *ps_args(p, 1);
    if (array.n + 1 > p->operand_count)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    if (array.n)
        memcpy(array.as.array, ps_args(p, array.n + 1), array.n * sizeof array);
    return plb_ps_charge(p, array.n / 8) && plb_ps_give(p, array.n + 1, array);
}

static bool op_length(ps *p)
{
    ps_object o = *ps_args(p, 1);
    size_t n = o.n;
    if (o.type == PS_NAME)
        n = o.as.name->length;
    else if (o.type == PS_DICT)
        n = o.as.dict->live;
    else if (o.type != PS_ARRAY && o.type != PS_STRING)
        return plb_ps_raise(p, PS_TYPECHECK);
    return plb_ps_give(p, 1, ps_integer((int32_t)n));
}

/* Tells whether `index` is an integer from 0 to `limit` - 1. */
static bool check_index(ps *p, ps_object index, uint32_t limit)
{
    if (index.type != PS_INTEGER)
        return plb_ps_raise(p, PS_TYPECHECK);
    return (index.as.integer >= 0 && (uint32_t)index.as.integer < limit) || plb_ps_raise(p, PS_RANGECHECK);
}

static bool get_from_dict(ps *p, const ps_dict *d, ps_object key)
{
    ps_object *value = plb_ps_get(p, d, key);
    return value ? plb_ps_give(p, 2, *value) : plb_ps_undefined(p, key);
}

static bool op_get(ps *p)
{
    ps_object *v = ps_args(p, 2), from = v[0];
    if (from.type == PS_DICT)
        return get_from_dict(p, from.as.dict, v[1]);
    if (from.type != PS_ARRAY && from.type != PS_STRING)
        return plb_ps_raise(p, PS_TYPECHECK);
    if (!check_index(p, v[1], from.n))
        return false;
    int32_t i = v[1].as.integer;
    return plb_ps_give(p, 2, from.type == PS_ARRAY ? from.as.array[i] : ps_integer((unsigned char)from.as.string[i]));
}

static bool op_put(ps *p)
{
    ps_object *v = ps_args(p, 3), into = v[0], value = v[2];
    if (into.type == PS_DICT) {
        if (!plb_ps_put(p, into.as.dict, v[1], value))
            return false;
    } else {
        if (into.type != PS_ARRAY && into.type != PS_STRING)
            return plb_ps_raise(p, PS_TYPECHECK);
        if (!check_index(p, v[1], into.n) || (into.type == PS_STRING && !check_index(p, value, 256)))
            return false;
        if (into.type == PS_ARRAY)
            into.as.array[v[1].as.integer] = value;
        else
            into.as.string[v[1].as.integer] = (char)value.as.integer;
    }
    ps_drop(p, 3);
    return true;
}

/* Gives the part of `from` that starts at `at`; the part shares the elements of `from`. */
static ps_object part(ps_object from, uint32_t at, uint32_t n)
{
    if (from.type == PS_ARRAY && n)
        from.as.array += at;
    else if (n)
        from.as.string += at;
    from.n = n;
    return from;
}

static bool op_getinterval(ps *p)
{
    ps_object *v = ps_args(p, 3);
    int64_t at = v[1].as.integer, n = v[2].as.integer;
    if (v[0].type != PS_ARRAY && v[0].type != PS_STRING)
        return plb_ps_raise(p, PS_TYPECHECK);
    if (at < 0 || n < 0 || at + n > v[0].n)
        return plb_ps_raise(p, PS_RANGECHECK);
    return plb_ps_give(p, 3, part(v[0], (uint32_t)at, (uint32_t)n));
}

static bool op_putinterval(ps *p)
{
    ps_object *v = ps_args(p, 3), into = v[0], from = v[2];
    int64_t at = v[1].as.integer;
    if ((into.type != PS_ARRAY && into.type != PS_STRING) || into.type != from.type)
        return plb_ps_raise(p, PS_TYPECHECK);
    if (at < 0 || at + from.n > into.n)
        return plb_ps_raise(p, PS_RANGECHECK);
    if (from.n && from.type == PS_ARRAY)
        memmove(into.as.array + at, from.as.array, from.n * sizeof from);
    else if (from.n)
        memmove(into.as.string + at, from.as.string, from.n);
    ps_drop(p, 3);
    return plb_ps_charge(p, from.n / 16);
}

static bool op_setpacking(ps *p)
{
    p->packing = ps_args(p, 1)->as.boolean;
    ps_drop(p, 1);
    return true;
}

static bool op_currentpacking(ps *p)
{
    return plb_ps_push(p, ps_boolean(p->packing));
}

const ps_operator plb_ps_array_operators[] = {
    {"array", "i", op_array},
    {"]", "", op_close_array},
    {"packedarray", "i", op_packedarray},
    {"aload", "a", op_aload},
    {"astore", "a", op_astore},
    {"length", "x", op_length},
    {"get", "xx", op_get},
    {"put", "xxx", op_put},
    {"getinterval", "xii", op_getinterval},
    {"putinterval", "xix", op_putinterval},
    {"setpacking", "b", op_setpacking},
    {"currentpacking", "", op_currentpacking},
    {NULL, NULL, NULL},
};
