/* SPDX-License-Identifier: MIT
 *
 * Holds the operators on types and conversions (PLRM, section 8.1). Access attributes are accepted and not kept:
 * nothing here needs protection from the file's own program.
 */
#include "tap/ps/ps.h"

#include "base/number/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool op_type(ps *p)
{
    static const char *const names[] = {
        [PS_NULL] = "nulltype", [PS_MARK] = "marktype", [PS_BRACE] = "marktype", [PS_INTEGER] = "integertype",
        [PS_REAL] = "realtype", [PS_BOOLEAN] = "booleantype", [PS_NAME] = "nametype", [PS_STRING] = "stringtype",
        [PS_ARRAY] = "arraytype", [PS_DICT] = "dicttype", [PS_OPERATOR] = "operatortype", [PS_FILE] = "filetype",
        [PS_SAVE] = "savetype", [PS_FONT_ID] = "fonttype", [PS_GSTATE] = "gstatetype",
    };
    ps_object name = plb_ps_name(p, names[ps_args(p, 1)->type]);
    name.executable = true;
    return name.as.name && plb_ps_give(p, 1, name);
}

static bool op_cvx(ps *p)
{
    ps_args(p, 1)->executable = true;
    return true;
}

static bool op_cvlit(ps *p)
{
    ps_args(p, 1)->executable = false;
    return true;
}

static bool op_xcheck(ps *p)
{
    return plb_ps_give(p, 1, ps_boolean(ps_args(p, 1)->executable));
}

static bool op_keep_access(ps *p)
{
    (void)p;
    return true;
}

static bool op_has_access(ps *p)
{
    return plb_ps_give(p, 1, ps_boolean(true));
}

/* Gives the number that an operand is or, as a string, spells. */
static bool number_of(ps *p, ps_object o, ps_object *out)
{
    if (o.type == PS_STRING) {
        ps_file *f = plb_ps_file_of_string(p, o);
        bool ended = true;
        if (!f || !plb_ps_read_object(p, f, out, &ended))
            return false;
        if (ended)
            return plb_ps_raise(p, PS_SYNTAXERROR);
        o = *out;
    }
    *out = o;
    return ps_is_number(o) || plb_ps_raise(p, PS_TYPECHECK);
}

static bool op_cvi(ps *p)
{
    ps_object number;
    if (!number_of(p, *ps_args(p, 1), &number))
        return false;
    ps_object whole = ps_whole(trunc(ps_value(number)));
    return whole.type == PS_INTEGER ? plb_ps_give(p, 1, whole) : plb_ps_raise(p, PS_RANGECHECK);
}

static bool op_cvr(ps *p)
{
    ps_object number;
    return number_of(p, *ps_args(p, 1), &number) && plb_ps_give(p, 1, ps_real(ps_value(number)));
}

static bool op_cvn(ps *p)
{
    ps_object s = *ps_args(p, 1), name = {.type = PS_NAME, .executable = s.executable};
    name.as.name = plb_ps_intern(p, s.as.string, s.n);
    return name.as.name && plb_ps_give(p, 1, name);
}

/* Writes a real as text: always with a point, like other interpreters. */
static void print_real(char out[64], double v)
{
    if (fabs(v) > 1e15) {
        snprintf(out, 64, "%.40s", v > 0 ? "1000000000000000.0" : "-1000000000000000.0");
        return;
    }
    char text[48];
    plb_format_number(text, v, 6);
    snprintf(out, 64, "%s%s", text, strchr(text, '.') ? "" : ".0");
}

/* Gives the text that cvs writes for an object; `spare` has space for numbers. */
static const char *text_of(ps_object o, char spare[64], size_t *n)
{
    const char *text = "--nostringval--";
    if (o.type == PS_NAME || o.type == PS_STRING)
        return plb_ps_text(o, n);
    if (o.type == PS_INTEGER)
        snprintf(spare, 64, "%ld", (long)o.as.integer);
    if (o.type == PS_REAL)
        print_real(spare, o.as.real);
    if (ps_is_number(o))
        text = spare;
    else if (o.type == PS_BOOLEAN)
        text = o.as.boolean ? "true" : "false";
    else if (o.type == PS_OPERATOR)
        text = o.as.op->name;
    *n = strlen(text);
    return text;
}

/* Fills the string on top with `n` bytes and leaves the part filled in the place of `drop` operands. */
static bool fill_string(ps *p, unsigned drop, const char *text, size_t n)
{
    ps_object s = *ps_args(p, 1);
    if (n > s.n)
        return plb_ps_raise(p, PS_RANGECHECK);
    if (n)
        memmove(s.as.string, text, n);
    s.n = (uint32_t)n;
    return plb_ps_charge(p, n / 64) && plb_ps_give(p, drop, s);
}

static bool op_cvs(ps *p)
{
    char spare[64];
    size_t n;
    const char *text = text_of(*ps_args(p, 2), spare, &n);
    return fill_string(p, 2, text, n);
}

static bool op_cvrs(ps *p)
{
    ps_object *v = ps_args(p, 3);
    int32_t radix = v[1].as.integer;
    char text[64];
    size_t n, at = sizeof text;
    if (radix < 2 || radix > 36)
        return plb_ps_raise(p, PS_RANGECHECK);
    if (radix == 10) {
        const char *decimal = text_of(v[0], text, &n);
        return fill_string(p, 3, decimal, n);
    }
    ps_object whole = ps_whole(trunc(ps_value(v[0])));
    if (whole.type != PS_INTEGER)
        return plb_ps_raise(p, PS_RANGECHECK);
    uint32_t rest = (uint32_t)whole.as.integer;
    do {
        text[--at] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"[rest % (uint32_t)radix];
        rest /= (uint32_t)radix;
    } while (rest);
    return fill_string(p, 3, text + at, sizeof text - at);
}

const ps_operator plb_ps_type_operators[] = {
    {"type", "x", op_type},
    {"cvx", "x", op_cvx},
    {"cvlit", "x", op_cvlit},
    {"xcheck", "x", op_xcheck},
    {"executeonly", "x", op_keep_access},
    {"noaccess", "x", op_keep_access},
    {"readonly", "x", op_keep_access},
    {"rcheck", "x", op_has_access},
    {"wcheck", "x", op_has_access},
    {"cvi", "x", op_cvi},
    {"cvr", "x", op_cvr},
    {"cvn", "s", op_cvn},
    {"cvs", "xs", op_cvs},
    {"cvrs", "nis", op_cvrs},
    {NULL, NULL, NULL},
};
