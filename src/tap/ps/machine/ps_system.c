/* SPDX-License-Identifier: MIT
 *
 * Answers what PostScript programs ask about the machine they run on: memory, time, parameters, the job server. The
 * answers are constants or counts of steps, so that a drawing never depends on the machine (PLRM, sections 3.7 and
 * 8.1).
 */
#include "tap/ps/ps.h"

#include <string.h>

static bool op_vmstatus(ps *p)
{
    return plb_ps_push(p, ps_integer((int32_t)(p->state_count - 1))) && plb_ps_push(p, ps_integer((int32_t)p->memory)) &&
           plb_ps_push(p, ps_integer((int32_t)PS_MAX_MEMORY));
}

/* Gives a clock of steps, so that programs that wait come to an end. */
static bool op_time(ps *p)
{
    return plb_ps_push(p, ps_integer((int32_t)(p->steps / 1000)));
}

static bool op_setglobal(ps *p)
{
    p->global = ps_args(p, 1)->as.boolean;
    ps_drop(p, 1);
    return true;
}

static bool op_currentglobal(ps *p) { return plb_ps_push(p, ps_boolean(p->global)); }
static bool op_gcheck(ps *p) { return plb_ps_give(p, 1, ps_boolean(true)); }
static bool op_drop_one(ps *p) { ps_drop(p, 1); return true; }
static bool op_push_zero(ps *p) { return plb_ps_push(p, ps_integer(0)); }

static bool op_drop_two(ps *p) { ps_drop(p, 2); return true; }
static bool op_drop_three(ps *p) { ps_drop(p, 3); return true; }

/* Programs ask for these parameters and set them; what they set is not kept. */
static bool op_parameters(ps *p)
{
    static const char *const names[] = {
        "MaxFontItem", "MinFontCompress", "MaxUPathItem", "MaxFormItem", "MaxPatternItem", "MaxScreenItem", "MaxOpStack",
        "MaxDictStack", "MaxExecStack", "MaxLocalVM", "VMReclaim", "VMThreshold", "MaxFontCache", "MaxFormCache",
        "MaxPatternCache", "MaxOutlineCache", "MaxScreenStorage", "MaxUPathCache", "MaxDisplayList", "CurFontCache",
    };
    ps_dict *d = plb_ps_new_dict(p, 24);
    for (size_t i = 0; d && i < sizeof names / sizeof *names; i++)
        if (!plb_ps_put_text(p, d, names[i], ps_integer(100000)))
            return false;
    return d && plb_ps_push(p, ps_of_dict(d));
}

static bool op_internaldict(ps *p)
{
    ps_object *found = plb_ps_get_text(p, p->systemdict, "%internal");
    if (found)
        return plb_ps_give(p, 1, *found);
    ps_dict *d = plb_ps_new_dict(p, 8);
    return d && plb_ps_put_text(p, p->systemdict, "%internal", ps_of_dict(d)) && plb_ps_give(p, 1, ps_of_dict(d));
}

/* Leaves the server loop, which changes nothing here, and drops the password. */
static bool op_exitserver(ps *p)
{
    ps_drop(p, 1);
    return true;
}

static bool op_startjob(ps *p) { return plb_ps_give(p, 2, ps_boolean(false)); }

static const ps_operator status_operators[] = {
    {"setduplexmode", "b", op_drop_one},
    {"settumble", "b", op_drop_one},
    {"setpapertray", "i", op_drop_one},
    {"setjobtimeout", "i", op_drop_one},
    {"setdefaulttimeouts", "xxx", op_drop_three},
    {"setmargins", "xx", op_drop_two},
    {"jobtimeout", "", op_push_zero},
    {"pagecount", "", op_push_zero},
    {"papertray", "", op_push_zero},
    {NULL, NULL, NULL},
};

const ps_operator plb_ps_system_operators[] = {
    {"vmstatus", "", op_vmstatus},
    {"usertime", "", op_time},
    {"realtime", "", op_time},
    {"setglobal", "b", op_setglobal},
    {"currentglobal", "", op_currentglobal},
    {"setshared", "b", op_setglobal},
    {"currentshared", "", op_currentglobal},
    {"gcheck", "x", op_gcheck},
    {"scheck", "x", op_gcheck},
    {"vmreclaim", "i", op_drop_one},
    {"setvmthreshold", "i", op_drop_one},
    {"setucacheparams", "x", op_drop_one},
    {"setuserparams", "d", op_drop_one},
    {"setsystemparams", "d", op_drop_one},
    {"currentuserparams", "", op_parameters},
    {"currentsystemparams", "", op_parameters},
    {"setobjectformat", "i", op_drop_one},
    {"currentobjectformat", "", op_push_zero},
    {"internaldict", "i", op_internaldict},
    {"startjob", "bx", op_startjob},
    {"exitserver", "i", op_exitserver},
    {NULL, NULL, NULL},
};

static bool add_all_operators(ps *p)
{
    static const ps_operator *const tables[] = {
        plb_ps_stack_operators, plb_ps_arithmetic_operators, plb_ps_relation_operators, plb_ps_control_operators,
        plb_ps_array_operators, plb_ps_dict_operators, plb_ps_string_operators, plb_ps_type_operators,
        plb_ps_file_operators, plb_ps_matrix_operators, plb_ps_state_operators,
        plb_ps_colour_operators, plb_ps_path_operators, plb_ps_whole_path_operators, plb_ps_paint_operators,
        plb_ps_clip_operators, plb_ps_gstate_operators, plb_ps_pattern_operators, plb_ps_font_operators, plb_ps_text_operators, plb_ps_image_operators,
        plb_ps_page_operators, plb_ps_foreign_operators, plb_ps_system_operators,
    };
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++)
        if (!plb_ps_add_operators(p, p->systemdict, tables[i]))
            return false;
    return plb_ps_add_operators(p, p->statusdict, status_operators);
}

static bool put_string(ps *p, ps_dict *d, const char *key, const char *text)
{
    ps_object s;
    return plb_ps_new_string(p, text, strlen(text), &s) && plb_ps_put_text(p, d, key, s);
}

/* The interpreter claims Level 3, because some programs draw nothing for less. */
static bool add_values(ps *p)
{
    ps_dict *d = p->systemdict, *status = p->statusdict;
    return plb_ps_put_text(p, d, "true", ps_boolean(true)) && plb_ps_put_text(p, d, "false", ps_boolean(false)) &&
           plb_ps_put_text(p, d, "null", ps_null()) && plb_ps_put_text(p, d, "languagelevel", ps_integer(3)) &&
           plb_ps_put_text(p, d, "revision", ps_integer(0)) && plb_ps_put_text(p, d, "serialnumber", ps_integer(0)) &&
           put_string(p, d, "product", "Plumbago") && put_string(p, d, "version", "3010") &&
           put_string(p, status, "product", "Plumbago") && put_string(p, status, "printername", "Plumbago") &&
           put_string(p, status, "jobname", "") && plb_ps_put_text(p, status, "manualfeed", ps_boolean(false)) &&
           plb_ps_put_text(p, status, "waittimeout", ps_integer(0));
}

static bool add_dicts(ps *p)
{
    const struct {
        const char *name;
        ps_dict *dict;
    } all[] = {{"systemdict", p->systemdict}, {"userdict", p->userdict}, {"globaldict", p->globaldict}, {"shareddict", p->globaldict},
               {"statusdict", p->statusdict}, {"serverdict", p->statusdict}, {"errordict", p->errordict}, {"$error", p->error_info}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (!plb_ps_put_text(p, p->systemdict, all[i].name, ps_of_dict(all[i].dict)))
            return false;
    return plb_ps_put_text(p, p->statusdict, "exitserver", *plb_ps_get_text(p, p->systemdict, "exitserver"));
}

static bool make_dicts(ps *p)
{
    ps_dict **const all[] = {&p->systemdict, &p->globaldict, &p->userdict, &p->statusdict, &p->errordict, &p->error_info};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        *all[i] = plb_ps_new_dict(p, 64);
        if (!*all[i])
            return false;
    }
    p->dicts[0] = p->systemdict;
    p->dicts[1] = p->globaldict;
    p->dicts[2] = p->userdict;
    p->dict_count = 3;
    return true;
}

bool plb_ps_make_system(ps *p)
{
    return make_dicts(p) && add_all_operators(p) && add_values(p) && add_dicts(p) && plb_ps_make_errordict(p) &&
           plb_ps_make_fonts(p);
}
