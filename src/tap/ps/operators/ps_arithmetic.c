/* SPDX-License-Identifier: MIT
 *
 * Holds the operators of arithmetic (PLRM, section 8.1): integers of 32 bits that become reals when they overflow,
 * angles in degrees, and the random numbers of Park and Miller ("Random number generators: good ones are hard to find",
 * CACM 31, 1988), which other interpreters use too, so that drawings come out alike.
 */
#include "tap/ps/ps.h"

#include <math.h>

static bool give_real(ps *p, unsigned drop, double v)
{
    return isfinite(v) ? plb_ps_give(p, drop, ps_real(v)) : plb_ps_raise(p, PS_UNDEFINEDRESULT);
}

/* Gives an integer where both operands are integers. */
static bool give_like(ps *p, const ps_object *v, double result)
{
    if (v[0].type == PS_INTEGER && v[1].type == PS_INTEGER)
        return plb_ps_give(p, 2, ps_whole(result));
    return give_real(p, 2, result);
}

static bool op_add(ps *p)
{
    ps_object *v = ps_args(p, 2);
    return give_like(p, v, ps_value(v[0]) + ps_value(v[1]));
}

static bool op_sub(ps *p)
{
    ps_object *v = ps_args(p, 2);
    return give_like(p, v, ps_value(v[0]) - ps_value(v[1]));
}

static bool op_mul(ps *p)
{
    ps_object *v = ps_args(p, 2);
    return give_like(p, v, ps_value(v[0]) * ps_value(v[1]));
}

static bool op_div(ps *p)
{
    ps_object *v = ps_args(p, 2);
    double by = ps_value(v[1]);
    return by == 0 ? plb_ps_raise(p, PS_UNDEFINEDRESULT) : give_real(p, 2, ps_value(v[0]) / by);
}

static bool op_idiv(ps *p)
{
    ps_object *v = ps_args(p, 2);
    if (!v[1].as.integer)
        return plb_ps_raise(p, PS_UNDEFINEDRESULT);
    return plb_ps_give(p, 2, ps_whole(trunc((double)v[0].as.integer / v[1].as.integer)));
}

static bool op_mod(ps *p)
{
    ps_object *v = ps_args(p, 2);
    if (!v[1].as.integer)
        return plb_ps_raise(p, PS_UNDEFINEDRESULT);
    return plb_ps_give(p, 2, ps_integer((int32_t)((int64_t)v[0].as.integer % v[1].as.integer)));
}

/* Does the operators of one operand that keep its type. */
static bool keep_type(ps *p, double result)
{
    return plb_ps_give(p, 1, ps_args(p, 1)->type == PS_INTEGER ? ps_whole(result) : ps_real(result));
}

static double top(ps *p)
{
    return ps_value(*ps_args(p, 1));
}

static bool op_neg(ps *p) { return keep_type(p, -top(p)); }
static bool op_abs(ps *p) { return keep_type(p, fabs(top(p))); }
static bool op_ceiling(ps *p) { return keep_type(p, ceil(top(p))); }
static bool op_floor(ps *p) { return keep_type(p, floor(top(p))); }
static bool op_round(ps *p) { return keep_type(p, floor(top(p) + 0.5)); }
static bool op_truncate(ps *p) { return keep_type(p, trunc(top(p))); }

/* These operators are not of the language, but Ghostscript's programs use them. */
static bool op_max(ps *p)
{
    ps_object *v = ps_args(p, 2);
    return plb_ps_give(p, 2, ps_value(v[0]) >= ps_value(v[1]) ? v[0] : v[1]);
}

static bool op_min(ps *p)
{
    ps_object *v = ps_args(p, 2);
    return plb_ps_give(p, 2, ps_value(v[0]) <= ps_value(v[1]) ? v[0] : v[1]);
}

static bool op_sqrt(ps *p)
{
    return top(p) < 0 ? plb_ps_raise(p, PS_RANGECHECK) : give_real(p, 1, sqrt(top(p)));
}

/* Gives the exact sine at the quarter turns, which drawings use. */
double plb_ps_sin(double degrees)
{
    static const double quarter[] = {0, 1, 0, -1};
    double turn = fmod(degrees, 360);
    if (turn < 0)
        turn += 360;
    double n = turn / 90;
    return n == floor(n) ? quarter[(int)n & 3] : sin(turn * (PLB_PI / 180));
}

double plb_ps_cos(double degrees)
{
    return plb_ps_sin(fmod(degrees, 360) + 90);
}

static bool op_sin(ps *p) { return give_real(p, 1, plb_ps_sin(top(p))); }
static bool op_cos(ps *p) { return give_real(p, 1, plb_ps_cos(top(p))); }

static bool op_atan(ps *p)
{
    ps_object *v = ps_args(p, 2);
    double y = ps_value(v[0]), x = ps_value(v[1]);
    if (x == 0 && y == 0)
        return plb_ps_raise(p, PS_UNDEFINEDRESULT);
    double degrees = atan2(y, x) * (180 / PLB_PI);
    return give_real(p, 2, degrees < 0 ? degrees + 360 : degrees);
}

static bool op_exp(ps *p)
{
    ps_object *v = ps_args(p, 2);
    return give_real(p, 2, pow(ps_value(v[0]), ps_value(v[1])));
}

static bool op_ln(ps *p)
{
    return top(p) <= 0 ? plb_ps_raise(p, PS_RANGECHECK) : give_real(p, 1, log(top(p)));
}

static bool op_log(ps *p)
{
    return top(p) <= 0 ? plb_ps_raise(p, PS_RANGECHECK) : give_real(p, 1, log10(top(p)));
}

static bool op_rand(ps *p)
{
    p->random = (int32_t)((int64_t)p->random * 16807 % INT32_MAX);
    return plb_ps_push(p, ps_integer(p->random));
}

static bool op_srand(ps *p)
{
    int32_t seed = ps_args(p, 1)->as.integer;
    if (seed <= 0)
        seed = -(seed % (INT32_MAX - 1)) + 1;
    p->random = seed >= INT32_MAX ? INT32_MAX - 1 : seed;
    ps_drop(p, 1);
    return true;
}

static bool op_rrand(ps *p)
{
    return plb_ps_push(p, ps_integer(p->random));
}

const ps_operator plb_ps_arithmetic_operators[] = {
    {"add", "nn", op_add},
    {"sub", "nn", op_sub},
    {"mul", "nn", op_mul},
    {"div", "nn", op_div},
    {"idiv", "ii", op_idiv},
    {"mod", "ii", op_mod},
    {"neg", "n", op_neg},
    {"abs", "n", op_abs},
    {"ceiling", "n", op_ceiling},
    {"floor", "n", op_floor},
    {"round", "n", op_round},
    {"truncate", "n", op_truncate},
    {"max", "nn", op_max},
    {"min", "nn", op_min},
    {".max", "nn", op_max},
    {".min", "nn", op_min},
    {"sqrt", "n", op_sqrt},
    {"sin", "n", op_sin},
    {"cos", "n", op_cos},
    {"atan", "nn", op_atan},
    {"exp", "nn", op_exp},
    {"ln", "n", op_ln},
    {"log", "n", op_log},
    {"rand", "", op_rand},
    {"srand", "i", op_srand},
    {"rrand", "", op_rrand},
    {NULL, NULL, NULL},
};
