/* SPDX-License-Identifier: MIT
 *
 * Holds the operators on the current path as a whole: flattenpath, strokepath, pathbbox, pathforall and the user paths
 * of Level 2 (PLRM, sections 4.4, 4.6 and 8.1).
 */
#include "tap/ps/ps.h"

#include <math.h>

#define PIECES_OF_A_CURVE 16 /* chosen by eye: fine for a drawing of a page's size */

static point curve_at(point a, const point *c, double t)
{
    double s = 1 - t;
    point sum = point_scale(a, s * s * s);
    sum = point_add(sum, point_scale(c[0], 3 * s * s * t));
    sum = point_add(sum, point_scale(c[1], 3 * s * t * t));
    return point_add(sum, point_scale(c[2], t * t * t));
}

static bool flatten(const path *from, path *to)
{
    size_t k = 0;
    bool good = true;
    point start = {0, 0}, at = {0, 0};
    for (size_t i = 0; i < from->ops.n && good; i++) {
        const point *v = from->points.v + k;
        switch (from->ops.v[i]) {
        case PATH_MOVE: good = plb_path_move(to, start = at = v[0]), k++; break;
        case PATH_LINE: good = plb_path_line(to, at = v[0]), k++; break;
        case PATH_CLOSE: good = plb_path_close(to), at = start; break;
        default:
            for (int j = 1; j <= PIECES_OF_A_CURVE && good; j++)
                good = plb_path_line(to, curve_at(at, v, (double)j / PIECES_OF_A_CURVE));
            at = v[2];
            k += 3;
        }
    }
    return good;
}

static bool op_flattenpath(ps *p)
{
    const path *now = &ps_gs(p)->path->path;
    path flat = {0};
    if (now->points.n > PS_MAX_PATH_POINTS / PIECES_OF_A_CURVE)
        return plb_ps_raise(p, PS_LIMITCHECK);
    if (!plb_ps_charge(p, now->points.n))
        return false;
    ps_state kept = *ps_gs(p);
    bool good = flatten(now, &flat) || plb_fail_memory(&p->err);
    good = good && plb_ps_replace_path(p, &flat);
    plb_path_free(&flat);
    ps_gs(p)->start = kept.start;
    return good;
}

/* Leaves the path as it is: nothing that is drawn depends on the path's direction but the winding rule, which only asks for equality. */
static bool op_reversepath(ps *p)
{
    (void)p;
    return true;
}

static bool op_strokepath(ps *p)
{
    ps_gs(p)->is_outline = true;
    return true;
}

static bool op_pathbbox(ps *p)
{
    matrix inverse;
    box user = BOX_EMPTY;
    const path *now = &ps_gs(p)->path->path;
    if (!ps_gs(p)->has_current)
        return plb_ps_raise(p, PS_NOCURRENTPOINT);
    if (!plb_ps_charge(p, now->points.n / 8) || !plb_ps_inverse_ctm(p, &inverse))
        return false;
    box b = plb_path_bounds(now);
    for (int i = 0; i < 4; i++)
        plb_box_add(&user, plb_matrix_apply(inverse, (point){i & 1 ? b.x1 : b.x0, i & 2 ? b.y1 : b.y0}));
    return plb_ps_push(p, ps_real(user.x0)) && plb_ps_push(p, ps_real(user.y0)) && plb_ps_push(p, ps_real(user.x1)) &&
           plb_ps_push(p, ps_real(user.y1));
}

/* pathforall: the frame holds a reference to the path as it was; index: the segment, extra.n: its first point. */
static void drop_pathforall(ps *p, ps_frame *f)
{
    plb_ps_release_path(p, f->data);
}

static bool step_pathforall(ps *p, ps_frame *f)
{
    static const unsigned points_of[] = {1, 1, 3, 0};
    const path *walked = &((ps_path *)f->data)->path;
    matrix inverse;
    if (f->index >= walked->ops.n) {
        plb_ps_pop_frame(p);
        return true;
    }
    if (!plb_ps_inverse_ctm(p, &inverse))
        return false;
    unsigned op = walked->ops.v[f->index++];
    for (unsigned i = 0; i < points_of[op]; i++) {
        point at = plb_matrix_apply(inverse, walked->points.v[f->extra.n++]);
        if (!plb_ps_push(p, ps_real(at.x)) || !plb_ps_push(p, ps_real(at.y)))
            return false;
    }
    return plb_ps_execute(p, f->body.as.array[op]);
}

static bool op_pathforall(ps *p)
{
    ps_object procs;
    if (!plb_ps_new_array(p, 4, &procs))
        return false;
    for (int i = 0; i < 4; i++)
        procs.as.array[i] = ps_args(p, 4)[i];
    ps_frame *f = plb_ps_push_frame(p, step_pathforall);
    if (!f)
        return false;
    f->kind = FRAME_LOOP;
    f->body = procs;
    f->data = ps_gs(p)->path;
    f->drop = drop_pathforall;
    ps_gs(p)->path->references++;
    ps_drop(p, 4);
    return true;
}

/* ---- user paths: a procedure of path operators ------------------------------------------------------------ */

static bool then_stroke(ps *p, ps_frame *f)
{
    (void)f;
    bool good = plb_ps_paint_path(p, ITEM_STROKE, false);
    plb_ps_restore_state(p);
    return good;
}

static bool then_fill(ps *p, ps_frame *f)
{
    (void)f;
    bool good = plb_ps_paint_path(p, ITEM_FILL, false);
    plb_ps_restore_state(p);
    return good;
}

static bool then_fill_even_odd(ps *p, ps_frame *f)
{
    (void)f;
    bool good = plb_ps_paint_path(p, ITEM_FILL, true);
    plb_ps_restore_state(p);
    return good;
}

static bool paint_user_path(ps *p, bool (*then)(ps *, ps_frame *))
{
    ps_object body = *ps_args(p, 1);
    if (!plb_ps_push_then(p, then) || !plb_ps_save_state(p) || !plb_ps_new_path(p))
        return false;
    body.executable = true;
    ps_drop(p, 1);
    return plb_ps_execute(p, body);
}

static bool op_ustroke(ps *p) { return paint_user_path(p, then_stroke); }
static bool op_ufill(ps *p) { return paint_user_path(p, then_fill); }
static bool op_ueofill(ps *p) { return paint_user_path(p, then_fill_even_odd); }

static bool op_uappend(ps *p)
{
    ps_object body = *ps_args(p, 1);
    body.executable = true;
    ps_drop(p, 1);
    return plb_ps_execute(p, body);
}

static bool op_setbbox(ps *p)
{
    ps_drop(p, 4);
    return true;
}

static bool op_ucache(ps *p)
{
    (void)p;
    return true;
}

const ps_operator plb_ps_whole_path_operators[] = {
    {"flattenpath", "", op_flattenpath},
    {"reversepath", "", op_reversepath},
    {"strokepath", "", op_strokepath},
    {"pathbbox", "", op_pathbbox},
    {"pathforall", "pppp", op_pathforall},
    {"ustroke", "a", op_ustroke},
    {"ufill", "a", op_ufill},
    {"ueofill", "a", op_ueofill},
    {"uappend", "a", op_uappend},
    {"setbbox", "nnnn", op_setbbox},
    {"ucache", "", op_ucache},
    {NULL, NULL, NULL},
};
