/* SPDX-License-Identifier: MIT
 *
 * Holds the operators on matrices and the current transformation matrix (PLRM, sections 4.3 and 8.1).
 */
#include "tap/ps/ps.h"

#include <math.h>
#include <string.h>

/* Larger factors or offsets come from a broken file; beyond them device coordinates lose their precision. */
#define LARGEST 1e15

bool plb_ps_get_matrix(ps *p, ps_object o, matrix *m)
{
    double v[6];
    if (o.type != PS_ARRAY)
        return plb_ps_raise(p, PS_TYPECHECK);
    if (o.n != 6)
        return plb_ps_raise(p, PS_RANGECHECK);
    for (int i = 0; i < 6; i++) {
        if (!ps_is_number(o.as.array[i]))
            return plb_ps_raise(p, PS_TYPECHECK);
        v[i] = ps_value(o.as.array[i]);
    }
    *m = (matrix){v[0], v[1], v[2], v[3], v[4], v[5]};
    return true;
}

void plb_ps_put_matrix(ps_object array, matrix m)
{
    double v[6] = {m.xx, m.yx, m.xy, m.yy, m.x0, m.y0};
    for (int i = 0; i < 6; i++)
        array.as.array[i] = ps_real(v[i]);
}

static bool is_sane(matrix m)
{
    double v[6] = {m.xx, m.yx, m.xy, m.yy, m.x0, m.y0};
    for (int i = 0; i < 6; i++)
        if (!(fabs(v[i]) <= LARGEST))
            return false;
    return true;
}

bool plb_ps_set_ctm(ps *p, matrix m)
{
    if (!is_sane(m))
        return plb_ps_raise(p, PS_LIMITCHECK);
    ps_gs(p)->ctm = m;
    return true;
}

bool plb_ps_inverse_ctm(ps *p, matrix *m)
{
    return (plb_matrix_invert(ps_gs(p)->ctm, m) && is_sane(*m)) || plb_ps_raise(p, PS_UNDEFINEDRESULT);
}

/* Replaces `drop` operands by the matrix `m` in `array`. */
static bool give_matrix(ps *p, unsigned drop, ps_object array, matrix m)
{
    if (array.n != 6)
        return plb_ps_raise(p, PS_RANGECHECK);
    if (!is_sane(m))
        return plb_ps_raise(p, PS_UNDEFINEDRESULT);
    plb_ps_put_matrix(array, m);
    return plb_ps_give(p, drop, array);
}

/* Does translate, scale, rotate: of the CTM, or of a matrix on top of the numbers, which is then the result. */
static bool change(ps *p, unsigned numbers, matrix (*make)(const ps_object *))
{
    ps_object top = *ps_args(p, 1);
    if (top.type == PS_ARRAY) {
        if (!plb_ps_check(p, numbers == 1 ? "na" : "nna"))
            return false;
        return give_matrix(p, numbers + 1, top, make(ps_args(p, numbers + 1)));
    }
    if (!plb_ps_check(p, numbers == 1 ? "n" : "nn") ||
        !plb_ps_set_ctm(p, plb_matrix_multiply(make(ps_args(p, numbers)), ps_gs(p)->ctm)))
        return false;
    ps_drop(p, numbers);
    return true;
}

static matrix make_translation(const ps_object *v)
{
    return (matrix){1, 0, 0, 1, ps_value(v[0]), ps_value(v[1])};
}

static matrix make_scale(const ps_object *v)
{
    return plb_matrix_scale(ps_value(v[0]), ps_value(v[1]));
}

static matrix make_rotation(const ps_object *v)
{
    double c = plb_ps_cos(ps_value(v[0])), s = plb_ps_sin(ps_value(v[0]));
    return (matrix){c, s, -s, c, 0, 0};
}

static bool op_translate(ps *p) { return change(p, 2, make_translation); }
static bool op_scale(ps *p) { return change(p, 2, make_scale); }
static bool op_rotate(ps *p) { return change(p, 1, make_rotation); }

static bool op_concat(ps *p)
{
    matrix m;
    if (!plb_ps_get_matrix(p, *ps_args(p, 1), &m) || !plb_ps_set_ctm(p, plb_matrix_multiply(m, ps_gs(p)->ctm)))
        return false;
    ps_drop(p, 1);
    return true;
}

static bool op_setmatrix(ps *p)
{
    matrix m;
    if (!plb_ps_get_matrix(p, *ps_args(p, 1), &m) || !plb_ps_set_ctm(p, m))
        return false;
    ps_drop(p, 1);
    return true;
}

static bool op_currentmatrix(ps *p)
{
    return give_matrix(p, 1, *ps_args(p, 1), ps_gs(p)->ctm);
}

static matrix default_matrix(void)
{
    return plb_matrix_scale(PS_UNITS_PER_POINT, PS_UNITS_PER_POINT);
}

static bool op_defaultmatrix(ps *p)
{
    return give_matrix(p, 1, *ps_args(p, 1), default_matrix());
}

static bool op_initmatrix(ps *p)
{
    ps_gs(p)->ctm = default_matrix();
    return true;
}

static bool op_identmatrix(ps *p)
{
    return give_matrix(p, 1, *ps_args(p, 1), MATRIX_IDENTITY);
}

static bool op_matrix(ps *p)
{
    ps_object array;
    if (!plb_ps_new_array(p, 6, &array))
        return false;
    plb_ps_put_matrix(array, MATRIX_IDENTITY);
    return plb_ps_push(p, array);
}

static bool op_concatmatrix(ps *p)
{
    ps_object *v = ps_args(p, 3);
    matrix a, b;
    return plb_ps_get_matrix(p, v[0], &a) && plb_ps_get_matrix(p, v[1], &b) &&
           give_matrix(p, 3, v[2], plb_matrix_multiply(a, b));
}

static bool op_invertmatrix(ps *p)
{
    ps_object *v = ps_args(p, 2);
    matrix m, inverse;
    if (!plb_ps_get_matrix(p, v[0], &m))
        return false;
    return plb_matrix_invert(m, &inverse) ? give_matrix(p, 2, v[1], inverse) : plb_ps_raise(p, PS_UNDEFINEDRESULT);
}

/* Gives the matrix a transform works with: the operand on top where there is one, else the CTM; `used` operands hold it. */
static bool matrix_of_transform(ps *p, bool inverse, matrix *m, unsigned *used)
{
    ps_object top = *ps_args(p, 1);
    *used = top.type == PS_ARRAY;
    *m = ps_gs(p)->ctm;
    if (!plb_ps_check(p, *used ? "nna" : "nn") || (*used && !plb_ps_get_matrix(p, top, m)))
        return false;
    return !inverse || plb_matrix_invert(*m, m) || plb_ps_raise(p, PS_UNDEFINEDRESULT);
}

static bool transform(ps *p, bool inverse, point (*apply)(matrix, point))
{
    matrix m;
    unsigned used;
    if (!matrix_of_transform(p, inverse, &m, &used))
        return false;
    ps_object *v = ps_args(p, 2 + used);
    point out = apply(m, (point){ps_value(v[0]), ps_value(v[1])});
    if (!isfinite(out.x) || !isfinite(out.y))
        return plb_ps_raise(p, PS_UNDEFINEDRESULT);
    ps_drop(p, 2 + used);
    return plb_ps_push(p, ps_real(out.x)) && plb_ps_push(p, ps_real(out.y));
}

static bool op_transform(ps *p) { return transform(p, false, plb_matrix_apply); }
static bool op_itransform(ps *p) { return transform(p, true, plb_matrix_apply); }
static bool op_dtransform(ps *p) { return transform(p, false, plb_matrix_apply_vector); }
static bool op_idtransform(ps *p) { return transform(p, true, plb_matrix_apply_vector); }

const ps_operator plb_ps_matrix_operators[] = {
    {"translate", "x", op_translate},
    {"scale", "x", op_scale},
    {"rotate", "x", op_rotate},
    {"concat", "a", op_concat},
    {"setmatrix", "a", op_setmatrix},
    {"currentmatrix", "a", op_currentmatrix},
    {"defaultmatrix", "a", op_defaultmatrix},
    {"initmatrix", "", op_initmatrix},
    {"identmatrix", "a", op_identmatrix},
    {"matrix", "", op_matrix},
    {"concatmatrix", "aaa", op_concatmatrix},
    {"invertmatrix", "aa", op_invertmatrix},
    {"transform", "x", op_transform},
    {"itransform", "x", op_itransform},
    {"dtransform", "x", op_dtransform},
    {"idtransform", "x", op_idtransform},
    {NULL, NULL, NULL},
};
