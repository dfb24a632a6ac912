/* SPDX-License-Identifier: MIT
 *
 * Holds the operators on dictionaries and the dictionary stack (PLRM, section 8.1).
 */
#include "tap/ps/ps.h"

#define PERMANENT_DICTS 3u /* systemdict, globaldict, userdict */

static bool op_dict(ps *p)
{
    int32_t n = ps_args(p, 1)->as.integer;
    if (n < 0)
        return plb_ps_raise(p, PS_RANGECHECK);
    if ((uint32_t)n > PS_MAX_ARRAY)
        return plb_ps_raise(p, PS_LIMITCHECK);
    ps_dict *d = plb_ps_new_dict(p, (uint32_t)n);
    return d && plb_ps_give(p, 1, ps_of_dict(d));
}

static bool op_close_dict(ps *p)
{
    uint32_t n;
    if (!plb_ps_count_to_mark(p, &n))
        return false;
    if (n % 2)
        return plb_ps_raise(p, PS_RANGECHECK);
    ps_dict *d = plb_ps_new_dict(p, n / 2);
    if (!d)
        return false;
    for (uint32_t i = 0; i < n; i += 2) {
        ps_object *pair = ps_args(p, n - i);
        if (!plb_ps_put(p, d, pair[0], pair[1]))
            return false;
    }
    return plb_ps_give(p, n + 1, ps_of_dict(d));
}

static bool op_begin(ps *p)
{
    if (p->dict_count >= PS_MAX_DICTS)
        return plb_ps_raise(p, PS_DICTSTACKOVERFLOW);
    p->dicts[p->dict_count++] = ps_args(p, 1)->as.dict;
    ps_drop(p, 1);
    return true;
}

static bool op_end(ps *p)
{
    if (p->dict_count <= PERMANENT_DICTS)
        return plb_ps_raise(p, PS_DICTSTACKUNDERFLOW);
    p->dict_count--;
    return true;
}

static bool op_def(ps *p)
{
    ps_object *v = ps_args(p, 2);
    if (!plb_ps_put(p, p->dicts[p->dict_count - 1], v[0], v[1]))
        return false;
    ps_drop(p, 2);
    return true;
}

static bool op_load(ps *p)
{
    ps_object key = *ps_args(p, 1), *value = plb_ps_lookup(p, key, NULL);
    return value ? plb_ps_give(p, 1, *value) : plb_ps_undefined(p, key);
}

static bool op_store(ps *p)
{
    ps_object *v = ps_args(p, 2);
    ps_dict *d = p->dicts[p->dict_count - 1];
    plb_ps_lookup(p, v[0], &d);
    if (!plb_ps_put(p, d, v[0], v[1]))
        return false;
    ps_drop(p, 2);
    return true;
}

static bool op_undef(ps *p)
{
    ps_object *v = ps_args(p, 2);
    plb_ps_remove(p, v[0].as.dict, v[1]);
    ps_drop(p, 2);
    return true;
}

static bool op_known(ps *p)
{
    ps_object *v = ps_args(p, 2);
    return plb_ps_give(p, 2, ps_boolean(plb_ps_get(p, v[0].as.dict, v[1]) != NULL));
}

static bool op_where(ps *p)
{
    ps_dict *d = NULL;
    if (!plb_ps_lookup(p, *ps_args(p, 1), &d))
        return plb_ps_give(p, 1, ps_boolean(false));
    return plb_ps_give(p, 1, ps_of_dict(d)) && plb_ps_push(p, ps_boolean(true));
}

static bool op_maxlength(ps *p)
{
    const ps_dict *d = ps_args(p, 1)->as.dict;
    uint32_t n = d->stated > d->live ? d->stated : d->live;
    return plb_ps_give(p, 1, ps_integer((int32_t)n));
}

static bool op_currentdict(ps *p)
{
    return plb_ps_push(p, ps_of_dict(p->dicts[p->dict_count - 1]));
}

static bool op_countdictstack(ps *p)
{
    return plb_ps_push(p, ps_integer((int32_t)p->dict_count));
}

static bool op_dictstack(ps *p)
{
    ps_object *v = ps_args(p, 1);
    if (v->n < p->dict_count)
        return plb_ps_raise(p, PS_RANGECHECK);
    for (uint32_t i = 0; i < p->dict_count; i++)
        v->as.array[i] = ps_of_dict(p->dicts[i]);
    v->n = p->dict_count;
    return true;
}

static bool op_cleardictstack(ps *p)
{
    p->dict_count = PERMANENT_DICTS;
    return true;
}

const ps_operator plb_ps_dict_operators[] = {
    {"dict", "i", op_dict},
    {">>", "", op_close_dict},
    {"begin", "d", op_begin},
    {"end", "", op_end},
    {"def", "xx", op_def},
    {"load", "x", op_load},
    {"store", "xx", op_store},
    {"undef", "dx", op_undef},
    {"known", "dx", op_known},
    {"where", "x", op_where},
    {"maxlength", "d", op_maxlength},
    {"currentdict", "", op_currentdict},
    {"countdictstack", "", op_countdictstack},
    {"dictstack", "a", op_dictstack},
    {"cleardictstack", "", op_cleardictstack},
    {NULL, NULL, NULL},
};
