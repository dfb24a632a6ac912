/* SPDX-License-Identifier: MIT
 *
 * PostScript resources: what the file itself defines, by category and name; fonts and encodings (PLRM, section 3.9).
 */
#include "tap/ps/ps.h"

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

/* ---- the ProcSet CIDInit: character maps are read and not used ------------------------------------------- */

static bool op_begin_entries(ps *p) { return plb_ps_give(p, 1, ps_mark()); }

static bool op_end_entries(ps *p)
{
    uint32_t n;
    if (!plb_ps_count_to_mark(p, &n))
        return false;
    ps_drop(p, n + 1);
    return true;
}

static bool op_drop_one(ps *p) { ps_drop(p, 1); return true; }

static bool op_nothing(ps *p)
{
    (void)p;
    return true;
}

static const ps_operator cid_operators[] = {
    {"begincmap", "", op_nothing},
    {"endcmap", "", op_nothing},
    {"usecmap", "x", op_drop_one},
    {"usefont", "x", op_drop_one},
    {"begincodespacerange", "i", op_begin_entries},
    {"endcodespacerange", "", op_end_entries},
    {"begincidchar", "i", op_begin_entries},
    {"endcidchar", "", op_end_entries},
    {"begincidrange", "i", op_begin_entries},
    {"endcidrange", "", op_end_entries},
    {"beginnotdefchar", "i", op_begin_entries},
    {"endnotdefchar", "", op_end_entries},
    {"beginnotdefrange", "i", op_begin_entries},
    {"endnotdefrange", "", op_end_entries},
    {"beginbfchar", "i", op_begin_entries},
    {"endbfchar", "", op_end_entries},
    {"beginbfrange", "i", op_begin_entries},
    {"endbfrange", "", op_end_entries},
    {NULL, NULL, NULL},
};

static bool make_cid_procset(ps *p)
{
    ps_dict *procsets, *d = plb_ps_new_dict(p, 24);
    return d && plb_ps_add_operators(p, d, cid_operators) && category_of(p, plb_ps_name(p, "ProcSet"), true, &procsets) &&
           plb_ps_put_text(p, procsets, "CIDInit", ps_of_dict(d));
}

/* The categories that exist without a definition: what programs look up is a dictionary. */
bool plb_ps_make_resources(ps *p)
{
    static const char *const names[] = {"Generic", "Font", "Encoding", "ProcSet", "Category", "Pattern", "Form", "ColorSpace", "Halftone"};
    ps_dict *categories;
    if (!category_of(p, plb_ps_name(p, "Category"), true, &categories))
        return false;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        ps_dict *d = plb_ps_new_dict(p, 4);
        if (!d || !plb_ps_put_text(p, categories, names[i], ps_of_dict(d)))
            return false;
    }
    return make_cid_procset(p);
}

static bool op_findresource(ps *p)
{
    ps_object *v = ps_args(p, 2), font;
    if (plb_ps_text_is(v[1], "Font"))
        return plb_ps_find_font(p, v[0], &font) && plb_ps_give(p, 2, font);
    ps_object *found = find_resource(p, v[0], v[1]);
    if (found)
        return plb_ps_give(p, 2, *found);
    size_t kn = 0, cn;
    const char *category = plb_ps_text(v[1], &cn), *key = v[0].type == PS_NAME || v[0].type == PS_STRING ? plb_ps_text(v[0], &kn) : "";
    return plb_ps_explain(p, PS_UNDEFINEDRESOURCE, "the %.*s resource '%.*s' is not in the file", cn < 40 ? (int)cn : 40, category,
                          kn < 60 ? (int)kn : 60, key);
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
