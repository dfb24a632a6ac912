/* SPDX-License-Identifier: MIT
 *
 * Holds the operators on strings, and those that print, which are accepted and say nothing (PLRM, section 8.1).
 */
#include "tap/ps/ps.h"

#include <string.h>

static bool op_string(ps *p)
{
    int32_t n = ps_args(p, 1)->as.integer;
    ps_object s;
    if (n < 0)
        return plb_ps_raise(p, PS_RANGECHECK);
    return plb_ps_new_string(p, NULL, (size_t)n, &s) && plb_ps_give(p, 1, s);
}

static ps_object slice(ps_object s, size_t at, size_t n)
{
    s.as.string += at;
    s.n = (uint32_t)n;
    return s;
}

/* Gives the place where `key` first lies in `s`; s.n when it does not. */
static bool find(ps *p, ps_object s, ps_object key, size_t *at)
{
    *at = s.n;
    if (key.n > s.n)
        return true;
    for (size_t i = 0; i + key.n <= s.n; i++) {
        if (key.n && s.as.string[i] != key.as.string[0])
            continue;
        if (!plb_ps_charge(p, key.n / 64))
            return false;
        if (!key.n || !memcmp(s.as.string + i, key.as.string, key.n)) {
            *at = i;
            break;
        }
    }
    return plb_ps_charge(p, *at / 16);
}

static bool op_search(ps *p)
{
    ps_object *v = ps_args(p, 2), s = v[0], key = v[1];
    size_t at;
    if (!find(p, s, key, &at))
        return false;
    if (at == s.n && key.n)
        return plb_ps_give(p, 1, ps_boolean(false));
    return plb_ps_give(p, 2, slice(s, at + key.n, s.n - at - key.n)) && plb_ps_push(p, slice(s, at, key.n)) &&
           plb_ps_push(p, slice(s, 0, at)) && plb_ps_push(p, ps_boolean(true));
}

static bool op_anchorsearch(ps *p)
{
    ps_object *v = ps_args(p, 2), s = v[0], key = v[1];
    p->steps += key.n / 64;
    if (key.n > s.n || (key.n && memcmp(s.as.string, key.as.string, key.n)))
        return plb_ps_give(p, 1, ps_boolean(false));
    return plb_ps_give(p, 2, slice(s, key.n, s.n - key.n)) && plb_ps_push(p, slice(s, 0, key.n)) &&
           plb_ps_push(p, ps_boolean(true));
}

static bool op_swallow(ps *p)
{
    ps_drop(p, 1);
    return true;
}

static bool op_nothing(ps *p)
{
    (void)p;
    return true;
}

const ps_operator plb_ps_string_operators[] = {
    {"string", "i", op_string},
    {"search", "ss", op_search},
    {"anchorsearch", "ss", op_anchorsearch},
    {"print", "s", op_swallow},
    {"=", "x", op_swallow},
    {"==", "x", op_swallow},
    {"=only", "x", op_swallow},
    {"==only", "x", op_swallow},
    {"stack", "", op_nothing},
    {"pstack", "", op_nothing},
    {"flush", "", op_nothing},
    {NULL, NULL, NULL},
};
