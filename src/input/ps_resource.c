/* SPDX-License-Identifier: MIT
 *
 * PostScript resources: what the file itself defines, by category and name; fonts and encodings (PLRM, section 3.9).
 */
#include "input/ps.h"

static bool category_of(ps *p, ps_object name, bool make, ps_dict **out)
{
    ps_object *found = plb_ps_get(p, p->resources, name);
    *out = found && found->type == PS_DICT ? found->as.dict : NULL;
    if (*out || !make)
        return true;
    *out = plb_ps_new_dict(p, 8);
    return *out && plb_ps_put(p, p->resources, name, ps_of_dict(*out));
}

/* NULL when there is none. */
static ps_object *find_resource(ps *p, ps_object key, ps_object category)
{
    ps_dict *d;
    if (plb_ps_text_is(category, "Encoding") && plb_ps_text_is(key, "StandardEncoding"))
        return &p->standard_encoding;
    if (plb_ps_text_is(category, "Encoding") && plb_ps_text_is(key, "ISOLatin1Encoding"))
        return &p->latin1_encoding;
    category_of(p, category, false, &d);
    return d ? plb_ps_get(p, d, key) : NULL;
}

static bool op_findresource(ps *p)
{
    ps_object *v = ps_args(p, 2), font;
    if (plb_ps_text_is(v[1], "Font"))
        return plb_ps_find_font(p, v[0], &font) && plb_ps_give(p, 2, font);
    ps_object *found = find_resource(p, v[0], v[1]);
    return found ? plb_ps_give(p, 2, *found) : plb_ps_raise(p, PS_UNDEFINEDRESOURCE);
}

static bool op_defineresource(ps *p)
{
    ps_object *v = ps_args(p, 3), instance = v[1];
    ps_dict *d;
    if (plb_ps_text_is(v[2], "Font")) {
        if (!plb_ps_define_font(p, v[0], instance))
            return false;
    } else if (!category_of(p, v[2], true, &d) || !plb_ps_put(p, d, v[0], instance)) {
        return false;
    }
    return plb_ps_give(p, 3, instance);
}

static bool op_undefineresource(ps *p)
{
    ps_object *v = ps_args(p, 2);
    ps_dict *d;
    category_of(p, v[1], false, &d);
    if (d)
        plb_ps_remove(p, d, v[0]);
    ps_drop(p, 2);
    return true;
}

static bool op_resourcestatus(ps *p)
{
    ps_object *v = ps_args(p, 2);
    bool known = plb_ps_text_is(v[1], "Font") ? plb_ps_get(p, p->fonts, v[0]) != NULL : find_resource(p, v[0], v[1]) != NULL;
    if (!known)
        return plb_ps_give(p, 2, ps_boolean(false));
    return plb_ps_give(p, 2, ps_integer(0)) && plb_ps_push(p, ps_integer(0)) && plb_ps_push(p, ps_boolean(true));
}

/* No program draws from a list of resources: it is empty. */
static bool op_resourceforall(ps *p)
{
    ps_drop(p, 4);
    return true;
}

const ps_operator plb_ps_resource_operators[] = {
    {"findresource", "xk", op_findresource},
    {"defineresource", "xxk", op_defineresource},
    {"undefineresource", "xk", op_undefineresource},
    {"resourcestatus", "xk", op_resourcestatus},
    {"resourceforall", "xxsk", op_resourceforall},
    {NULL, NULL, NULL},
};
