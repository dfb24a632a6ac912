/* SPDX-License-Identifier: MIT
 *
 * Keeps the graphics state: gsave and grestore, save and restore, line parameters, and the device-dependent settings
 * that are accepted without effect (PLRM, sections 4.2 and 8.1).
 */
#include "tap/ps/ps.h"

#include <math.h>
#include <string.h>

bool plb_ps_init_state(ps *p)
{
    p->states = plb_new(PS_MAX_STATES, sizeof *p->states);
    ps_path *shared = plb_new(1, sizeof *shared);
    if (!p->states || !shared) {
        plb_free(shared);
        return plb_fail_memory(&p->err);
    }
    shared->references = 1;
    p->state_count = 1;
    ps_gs(p)->path = shared;
    ps_gs(p)->font = ps_null();
    plb_ps_reset_graphics(p);
    return true;
}

void plb_ps_reset_graphics(ps *p)
{
    ps_state *g = ps_gs(p);
    g->ctm = plb_matrix_scale(PS_UNITS_PER_POINT, PS_UNITS_PER_POINT);
    g->clip = NO_CLIP;
    g->nothing_visible = false;
    g->paint = (paint){PAINT_SOLID, 0, 0, 0, 1};
    g->pattern = ps_null();
    g->colour_space = plb_ps_name(p, "DeviceGray");
    g->colour[0] = ps_real(0);
    g->components = 1;
    g->line_width = 1;
    g->miter_limit = 10;
    g->flatness = 1;
    g->cap = g->join = 0;
    g->dash = (ps_object){.type = PS_ARRAY};
    g->dash_offset = 0;
    plb_ps_new_path(p);
}

bool plb_ps_save_state(ps *p)
{
    if (p->state_count >= PS_MAX_STATES)
        return plb_ps_raise(p, PS_LIMITCHECK);
    p->states[p->state_count] = *ps_gs(p);
    p->state_count++;
    ps_gs(p)->path->references++;
    ps_gs(p)->save = 0;
    return true;
}

/* Goes back to the state below, which stays alone on the stack when it is the last. */
void plb_ps_restore_state(ps *p)
{
    if (p->state_count < 2)
        return;
    plb_ps_release_path(p, ps_gs(p)->path);
    p->state_count--;
}

void plb_ps_restore_to(ps *p, uint32_t count)
{
    while (p->state_count > count)
        plb_ps_restore_state(p);
}

static bool op_gsave(ps *p)
{
    return plb_ps_save_state(p);
}

/* Makes a copy of the state below current; `save` keeps its own. */
static bool op_grestore(ps *p)
{
    if (!ps_gs(p)->save) {
        plb_ps_restore_state(p);
        return true;
    }
    uint32_t save = ps_gs(p)->save;
    plb_ps_restore_state(p);
    if (!plb_ps_save_state(p))
        return false;
    ps_gs(p)->save = save;
    return true;
}

static bool op_grestoreall(ps *p)
{
    while (p->state_count > 1 && !ps_gs(p)->save)
        plb_ps_restore_state(p);
    return op_grestore(p);
}

static bool op_save(ps *p)
{
    if (!plb_ps_save_state(p))
        return false;
    ps_gs(p)->save = p->save_now = ++p->save_last;
    return plb_ps_push(p, (ps_object){.type = PS_SAVE, .as.save = p->save_now});
}

/* Gives the innermost save that is left on the stack of graphics states. */
static uint32_t innermost_save(const ps *p)
{
    for (uint32_t i = p->state_count; i-- > 0;)
        if (p->states[i].save)
            return p->states[i].save;
    return 0;
}

static bool op_restore(ps *p)
{
    ps_object o = *ps_args(p, 1);
    if (o.type != PS_SAVE)
        return plb_ps_raise(p, PS_TYPECHECK);
    uint32_t i = p->state_count;
    while (i > 0 && p->states[i - 1].save != o.as.save)
        i--;
    if (i < 2)
        return plb_ps_raise(p, PS_INVALIDRESTORE);
    if (!plb_ps_charge(p, p->state_count / 4) || !plb_ps_roll_back(p, o.as.save))
        return false;
    plb_ps_restore_to(p, i - 1);
    p->save_now = innermost_save(p);
    ps_drop(p, 1);
    return true;
}

/* ---- line parameters -------------------------------------------------------------------------------------- */

static bool set_number(ps *p, double *where)
{
    *where = ps_value(*ps_args(p, 1));
    ps_drop(p, 1);
    return true;
}

static bool op_setlinewidth(ps *p)
{
    if (!set_number(p, &ps_gs(p)->line_width))
        return false;
    ps_gs(p)->line_width = fabs(ps_gs(p)->line_width);
    return true;
}

static bool op_setmiterlimit(ps *p)
{
    return ps_value(*ps_args(p, 1)) < 1 ? plb_ps_raise(p, PS_RANGECHECK) : set_number(p, &ps_gs(p)->miter_limit);
}

static bool op_setflat(ps *p) { return set_number(p, &ps_gs(p)->flatness); }

static bool set_style(ps *p, int *where)
{
    int32_t v = ps_args(p, 1)->as.integer;
    if (v < 0 || v > 2)
        return plb_ps_raise(p, PS_RANGECHECK);
    *where = v;
    ps_drop(p, 1);
    return true;
}

static bool op_setlinecap(ps *p) { return set_style(p, &ps_gs(p)->cap); }
static bool op_setlinejoin(ps *p) { return set_style(p, &ps_gs(p)->join); }

static bool op_setdash(ps *p)
{
    ps_object *v = ps_args(p, 2), copy;
    double total = 0;
    if (v[0].n > 64)
        return plb_ps_raise(p, PS_LIMITCHECK);
    for (uint32_t i = 0; i < v[0].n; i++) {
        if (!ps_is_number(v[0].as.array[i]))
            return plb_ps_raise(p, PS_TYPECHECK);
        if (ps_value(v[0].as.array[i]) < 0)
            return plb_ps_raise(p, PS_RANGECHECK);
        total += ps_value(v[0].as.array[i]);
    }
    if (v[0].n && total == 0)
        return plb_ps_raise(p, PS_RANGECHECK);
    if (!plb_ps_new_array(p, v[0].n, &copy))
        return false;
    if (copy.n)
        memcpy(copy.as.array, v[0].as.array, copy.n * sizeof copy);
    ps_gs(p)->dash = copy;
    ps_gs(p)->dash_offset = ps_value(v[1]);
    ps_drop(p, 2);
    return true;
}

static bool op_currentdash(ps *p)
{
    return plb_ps_push(p, ps_gs(p)->dash) && plb_ps_push(p, ps_real(ps_gs(p)->dash_offset));
}

static bool set_flag(ps *p, bool *where)
{
    *where = ps_args(p, 1)->as.boolean;
    ps_drop(p, 1);
    return true;
}

static bool op_setstrokeadjust(ps *p) { return set_flag(p, &ps_gs(p)->stroke_adjust); }
static bool op_setoverprint(ps *p) { return set_flag(p, &ps_gs(p)->overprint); }

static bool op_currentlinewidth(ps *p) { return plb_ps_push(p, ps_real(ps_gs(p)->line_width)); }
static bool op_currentmiterlimit(ps *p) { return plb_ps_push(p, ps_real(ps_gs(p)->miter_limit)); }
static bool op_currentflat(ps *p) { return plb_ps_push(p, ps_real(ps_gs(p)->flatness)); }
static bool op_currentlinecap(ps *p) { return plb_ps_push(p, ps_integer(ps_gs(p)->cap)); }
static bool op_currentlinejoin(ps *p) { return plb_ps_push(p, ps_integer(ps_gs(p)->join)); }
static bool op_currentstrokeadjust(ps *p) { return plb_ps_push(p, ps_boolean(ps_gs(p)->stroke_adjust)); }
static bool op_currentoverprint(ps *p) { return plb_ps_push(p, ps_boolean(ps_gs(p)->overprint)); }

static bool op_initgraphics(ps *p)
{
    plb_ps_reset_graphics(p);
    return true;
}

static bool op_nulldevice(ps *p)
{
    ps_gs(p)->no_output = true;
    return true;
}

/* ---- accepted without effect ------------------------------------------------------------------------------ */

static bool op_drop_one(ps *p) { ps_drop(p, 1); return true; }
static bool op_drop_three(ps *p) { ps_drop(p, 3); return true; }
static bool op_drop_four(ps *p) { ps_drop(p, 4); return true; }

static bool op_push_procedure(ps *p)
{
    return plb_ps_push(p, (ps_object){.type = PS_ARRAY, .executable = true});
}

static bool op_currentscreen(ps *p)
{
    return plb_ps_push(p, ps_integer(60)) && plb_ps_push(p, ps_integer(45)) && op_push_procedure(p);
}

static bool op_currentcolorscreen(ps *p)
{
    return op_currentscreen(p) && op_currentscreen(p) && op_currentscreen(p) && op_currentscreen(p);
}

static bool op_setcolorscreen(ps *p) { ps_drop(p, 12); return true; }

static bool op_currentcolortransfer(ps *p)
{
    return op_push_procedure(p) && op_push_procedure(p) && op_push_procedure(p) && op_push_procedure(p);
}

static bool op_currenthalftone(ps *p)
{
    const ps_object spot = {.type = PS_ARRAY, .executable = true};
    ps_dict *d = plb_ps_new_dict(p, 4);
    return d && plb_ps_put_text(p, d, "HalftoneType", ps_integer(1)) && plb_ps_put_text(p, d, "Frequency", ps_integer(60)) &&
           plb_ps_put_text(p, d, "Angle", ps_integer(45)) && plb_ps_put_text(p, d, "SpotFunction", spot) &&
           plb_ps_push(p, ps_of_dict(d));
}

static bool op_push_dict(ps *p)
{
    ps_dict *d = plb_ps_new_dict(p, 4);
    return d && plb_ps_push(p, ps_of_dict(d));
}

static bool op_push_number(ps *p) { return plb_ps_push(p, ps_real(0.02)); }

const ps_operator plb_ps_state_operators[] = {
    {"gsave", "", op_gsave},
    {"grestore", "", op_grestore},
    {"grestoreall", "", op_grestoreall},
    {"save", "", op_save},
    {"restore", "x", op_restore},
    {"initgraphics", "", op_initgraphics},
    {"nulldevice", "", op_nulldevice},
    {"setlinewidth", "n", op_setlinewidth},
    {"setlinecap", "i", op_setlinecap},
    {"setlinejoin", "i", op_setlinejoin},
    {"setmiterlimit", "n", op_setmiterlimit},
    {"setflat", "n", op_setflat},
    {"setdash", "an", op_setdash},
    {"setstrokeadjust", "b", op_setstrokeadjust},
    {"setoverprint", "b", op_setoverprint},
    {"currentlinewidth", "", op_currentlinewidth},
    {"currentlinecap", "", op_currentlinecap},
    {"currentlinejoin", "", op_currentlinejoin},
    {"currentmiterlimit", "", op_currentmiterlimit},
    {"currentflat", "", op_currentflat},
    {"currentdash", "", op_currentdash},
    {"currentstrokeadjust", "", op_currentstrokeadjust},
    {"currentoverprint", "", op_currentoverprint},
    {"settransfer", "x", op_drop_one},
    {"setcolortransfer", "xxxx", op_drop_four},
    {"setblackgeneration", "x", op_drop_one},
    {"setundercolorremoval", "x", op_drop_one},
    {"setscreen", "nnx", op_drop_three},
    {"setcolorscreen", "xxxxxxxxxxxx", op_setcolorscreen},
    {"sethalftone", "x", op_drop_one},
    {"setsmoothness", "n", op_drop_one},
    {"setcolorrendering", "x", op_drop_one},
    {"currenttransfer", "", op_push_procedure},
    {"currentcolortransfer", "", op_currentcolortransfer},
    {"currentblackgeneration", "", op_push_procedure},
    {"currentundercolorremoval", "", op_push_procedure},
    {"currentscreen", "", op_currentscreen},
    {"currentcolorscreen", "", op_currentcolorscreen},
    {"currenthalftone", "", op_currenthalftone},
    {"currentcolorrendering", "", op_push_dict},
    {"currentsmoothness", "", op_push_number},
    {NULL, NULL, NULL},
};
