/* SPDX-License-Identifier: MIT
 *
 * Keeps graphics states as objects, which programs fill and set at will (PLRM, section 4.2).
 */
#include "tap/ps/ps.h"

void plb_ps_free_kept_states(ps *p)
{
    for (size_t i = 0; i < p->kept_states.n; i++)
        plb_ps_release_path(p, p->kept_states.v[i].path);
    array_free(&p->kept_states);
}

static bool op_gstate(ps *p)
{
    ps_state copy = *ps_gs(p);
    if (p->kept_states.n >= PS_MAX_STATES)
        return plb_ps_raise(p, PS_LIMITCHECK);
    copy.save = 0;
    if (!array_push(&p->kept_states, copy))
        return plb_fail_memory(&p->err);
    copy.path->references++;
    return plb_ps_push(p, (ps_object){.type = PS_GSTATE, .as.save = (uint32_t)(p->kept_states.n - 1)});
}

/* Makes `to` a copy of `from`, but for what belongs to a place on the stack of states. */
static void assign(ps *p, ps_state *to, const ps_state *from)
{
    uint32_t save = to->save;
    from->path->references++;
    plb_ps_release_path(p, to->path);
    *to = *from;
    to->save = save;
}

static ps_state *kept_state(ps *p)
{
    ps_object o = *ps_args(p, 1);
    if (o.type == PS_GSTATE)
        return &p->kept_states.v[o.as.save];
    plb_ps_raise(p, PS_TYPECHECK);
    return NULL;
}

/* The object stays on the stack. */
static bool op_currentgstate(ps *p)
{
    ps_state *s = kept_state(p);
    if (s)
        assign(p, s, ps_gs(p));
    return s != NULL;
}

static bool op_setgstate(ps *p)
{
    const ps_state *s = kept_state(p);
    if (!s)
        return false;
    assign(p, ps_gs(p), s);
    ps_drop(p, 1);
    return true;
}

const ps_operator plb_ps_gstate_operators[] = {
    {"gstate", "", op_gstate},
    {"currentgstate", "x", op_currentgstate},
    {"setgstate", "x", op_setgstate},
    {NULL, NULL, NULL},
};
