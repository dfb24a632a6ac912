/* SPDX-License-Identifier: MIT
 *
 * Builds PostScript paths (PLRM, sections 4.4 and 8.1) in device space; graphics states share them until one changes
 * its own.
 */
#include "tap/ps/ps.h"

#include <math.h>

void plb_ps_release_path(ps *p, ps_path *shared)
{
    if (--shared->references)
        return;
    p->path_points -= shared->path.points.n;
    plb_path_free(&shared->path);
    plb_free(shared);
}

static ps_path *fresh_path(ps *p)
{
    ps_path *shared = plb_new(1, sizeof *shared);
    if (shared)
        shared->references = 1;
    else
        plb_fail_memory(&p->err);
    return shared;
}

bool plb_ps_new_path(ps *p)
{
    ps_state *g = ps_gs(p);
    g->has_current = g->is_outline = false;
    if (g->path->references == 1) {
        p->path_points -= g->path->path.points.n;
        plb_path_clear(&g->path->path);
        return true;
    }
    ps_path *fresh = fresh_path(p);
    if (!fresh)
        return false;
    plb_ps_release_path(p, g->path);
    g->path = fresh;
    return true;
}

bool plb_ps_replace_path(ps *p, path *with)
{
    path empty = {0};
    point at;
    if (!plb_ps_new_path(p))
        return false;
    ps_state *g = ps_gs(p);
    if (with->points.n > PS_MAX_PATH_POINTS - p->path_points)
        return plb_ps_raise(p, PS_LIMITCHECK);
    plb_path_free(&g->path->path);
    g->path->path = *with;
    *with = empty;
    p->path_points += g->path->path.points.n;
    g->has_current = plb_path_current(&g->path->path, &at);
    if (g->has_current)
        g->start = g->current = at;
    return true;
}

/* Gives the current path for changing: shared with no other state, and with space for `points` more. */
static path *path_to_change(ps *p, size_t points)
{
    ps_state *g = ps_gs(p);
    size_t n = g->path->path.points.n, wanted = points + (g->path->references > 1 ? n : 0);
    if (wanted > PS_MAX_PATH_POINTS - p->path_points) {
        plb_ps_raise(p, PS_LIMITCHECK);
        return NULL;
    }
    if (g->path->references > 1) {
        ps_path *own = fresh_path(p);
        if (!own || !plb_ps_charge(p, n / 8))
            return plb_free(own), NULL;
        if (!plb_path_append(&own->path, &g->path->path, MATRIX_IDENTITY)) {
            plb_path_free(&own->path);
            plb_free(own);
            plb_fail_memory(&p->err);
            return NULL;
        }
        p->path_points += n;
        plb_ps_release_path(p, g->path);
        g->path = own;
    }
    g->is_outline = false;
    return &g->path->path;
}

static bool to_device(ps *p, point user, point *device)
{
    *device = plb_matrix_apply(ps_gs(p)->ctm, user);
    return (isfinite(device->x) && isfinite(device->y)) || plb_ps_raise(p, PS_LIMITCHECK);
}

/* Adds one segment whose points are in device space. */
static bool add(ps *p, path_op op, const point *at)
{
    static const unsigned points_of[] = {1, 1, 3, 0};
    path *to = path_to_change(p, points_of[op]);
    if (!to)
        return false;
    ps_state *g = ps_gs(p);
    size_t before = to->points.n;
    bool good = op == PATH_MOVE   ? plb_path_move(to, at[0])
                : op == PATH_LINE ? plb_path_line(to, at[0])
                : op == PATH_CURVE ? plb_path_curve(to, at[0], at[1], at[2])
                                   : plb_path_close(to);
    p->path_points += to->points.n - before;
    if (!good)
        return plb_fail_memory(&p->err);
    if (op == PATH_MOVE)
        g->start = at[0];
    g->current = op == PATH_CLOSE ? g->start : at[op == PATH_CURVE ? 2 : 0];
    g->has_current = true;
    return true;
}

static bool need_current(ps *p)
{
    return ps_gs(p)->has_current || plb_ps_raise(p, PS_NOCURRENTPOINT);
}

bool plb_ps_move(ps *p, point to)
{
    point at;
    return to_device(p, to, &at) && add(p, PATH_MOVE, &at);
}

bool plb_ps_line(ps *p, point to)
{
    point at;
    return need_current(p) && to_device(p, to, &at) && add(p, PATH_LINE, &at);
}

bool plb_ps_rectangle(ps *p, point c, double width, double height)
{
    return plb_ps_move(p, c) && plb_ps_line(p, (point){c.x + width, c.y}) &&
           plb_ps_line(p, (point){c.x + width, c.y + height}) && plb_ps_line(p, (point){c.x, c.y + height}) &&
           add(p, PATH_CLOSE, NULL);
}

bool plb_ps_current_point(ps *p, point *at)
{
    matrix inverse;
    if (!need_current(p) || !plb_ps_inverse_ctm(p, &inverse))
        return false;
    *at = plb_matrix_apply(inverse, ps_gs(p)->current);
    return true;
}

/* ---- operators -------------------------------------------------------------------------------------------- */

static point point_at(const ps_object *v)
{
    return (point){ps_value(v[0]), ps_value(v[1])};
}

static bool done(ps *p, unsigned drop, bool good)
{
    if (good)
        ps_drop(p, drop);
    return good;
}

static bool op_newpath(ps *p) { return plb_ps_new_path(p); }
static bool op_moveto(ps *p) { return done(p, 2, plb_ps_move(p, point_at(ps_args(p, 2)))); }
static bool op_lineto(ps *p) { return done(p, 2, plb_ps_line(p, point_at(ps_args(p, 2)))); }

/* Gives the operands as vectors from the current point, in device space. */
static bool relative(ps *p, unsigned n, point *at)
{
    const ps_object *v = ps_args(p, 2 * n);
    if (!need_current(p))
        return false;
    for (unsigned i = 0; i < n; i++) {
        at[i] = point_add(ps_gs(p)->current, plb_matrix_apply_vector(ps_gs(p)->ctm, point_at(v + (size_t)2 * i)));
        if (!isfinite(at[i].x) || !isfinite(at[i].y))
            return plb_ps_raise(p, PS_LIMITCHECK);
    }
    return true;
}

static bool op_rmoveto(ps *p)
{
    point at;
    return done(p, 2, relative(p, 1, &at) && add(p, PATH_MOVE, &at));
}

static bool op_rlineto(ps *p)
{
    point at;
    return done(p, 2, relative(p, 1, &at) && add(p, PATH_LINE, &at));
}

static bool op_rcurveto(ps *p)
{
    point at[3];
    return done(p, 6, relative(p, 3, at) && add(p, PATH_CURVE, at));
}

static bool op_curveto(ps *p)
{
    const ps_object *v = ps_args(p, 6);
    point at[3];
    return done(p, 6, need_current(p) && to_device(p, point_at(v), at) && to_device(p, point_at(v + 2), at + 1) &&
                          to_device(p, point_at(v + 4), at + 2) && add(p, PATH_CURVE, at));
}

static bool op_closepath(ps *p)
{
    return !ps_gs(p)->has_current || add(p, PATH_CLOSE, NULL);
}

static bool op_currentpoint(ps *p)
{
    point at;
    return plb_ps_current_point(p, &at) && plb_ps_push(p, ps_real(at.x)) && plb_ps_push(p, ps_real(at.y));
}

/* Adds an arc in user space, `turn` degrees from `from`; at most a full circle. */
static bool add_arc(ps *p, point centre, double radius, double from, double turn)
{
    matrix m = ps_gs(p)->ctm;
    path *to = path_to_change(p, 16);
    if (!to)
        return false;
    double limit = fabs(centre.x) + fabs(centre.y) + fabs(radius);
    point far = plb_matrix_apply((matrix){fabs(m.xx), fabs(m.yx), fabs(m.xy), fabs(m.yy), m.x0, m.y0}, (point){limit, limit});
    if (!isfinite(far.x) || !isfinite(far.y))
        return plb_ps_raise(p, PS_LIMITCHECK);
    size_t before = to->points.n;
    double a = fmod(from, 360) * (PLB_PI / 180), b = a + turn * (PLB_PI / 180);
    bool good = plb_path_arc(to, centre, radius, a, b, turn < 0, m);
    p->path_points += to->points.n - before;
    if (!good)
        return plb_fail_memory(&p->err);
    ps_state *g = ps_gs(p);
    if (!g->has_current)
        g->start = to->points.v[before];
    g->current = to->points.v[to->points.n - 1];
    g->has_current = true;
    return true;
}

/* Gives the turn from the first angle on to the next equivalent of the second. */
static double counterclockwise(double from, double to)
{
    double turn = to - from;
    if (turn < 0) {
        turn = fmod(turn, 360);
        if (turn < 0)
            turn += 360;
    }
    return turn > 360 ? 360 : turn;
}

static bool op_arc(ps *p)
{
    const ps_object *v = ps_args(p, 5);
    double from = ps_value(v[3]);
    return done(p, 5, add_arc(p, point_at(v), ps_value(v[2]), from, counterclockwise(from, ps_value(v[4]))));
}

static bool op_arcn(ps *p)
{
    const ps_object *v = ps_args(p, 5);
    double from = ps_value(v[3]);
    return done(p, 5, add_arc(p, point_at(v), ps_value(v[2]), from, -counterclockwise(ps_value(v[4]), from)));
}

/* Finds the arc that touches the lines from `a` to `b` and from `b` to `c`: its ends; `radius` 0 where the points are collinear. */
static void tangent_arc(point a, point b, point c, double *radius, point *first, point *last, point *centre)
{
    point u = point_sub(a, b), v = point_sub(c, b);
    double ul = plb_point_length(u), vl = plb_point_length(v);
    *first = *last = b;
    if (ul == 0 || vl == 0 || *radius == 0) {
        *radius = 0;
        return;
    }
    u = point_scale(u, 1 / ul);
    v = point_scale(v, 1 / vl);
    double sine = fabs(point_cross(u, v)), cosine = point_dot(u, v);
    if (sine < 1e-9) {
        *radius = 0;
        return;
    }
    double t = fabs(*radius) * (1 + cosine) / sine; /* r / tan(angle / 2) */
    *first = point_add(b, point_scale(u, t));
    *last = point_add(b, point_scale(v, t));
    point middle = point_add(u, v);
    double ml = plb_point_length(middle), far = sqrt(t * t + *radius * *radius);
    *centre = point_add(b, point_scale(middle, ml > 0 ? far / ml : 0));
}

static bool arc_between_tangents(ps *p, point *first, point *last)
{
    const ps_object *v = ps_args(p, 5);
    point from, corner = point_at(v), centre = {0, 0};
    double radius = ps_value(v[4]);
    if (!plb_ps_current_point(p, &from))
        return false;
    tangent_arc(from, corner, point_at(v + 2), &radius, first, last, &centre);
    if (radius == 0)
        return plb_ps_line(p, corner);
    double a = atan2(first->y - centre.y, first->x - centre.x) * (180 / PLB_PI);
    double b = atan2(last->y - centre.y, last->x - centre.x) * (180 / PLB_PI), turn = b - a;
    if (turn > 180)
        turn -= 360;
    if (turn < -180)
        turn += 360;
    return add_arc(p, centre, fabs(radius), a, turn);
}

static bool op_arct(ps *p)
{
    point first, last;
    return done(p, 5, arc_between_tangents(p, &first, &last));
}

static bool op_arcto(ps *p)
{
    point first, last;
    return done(p, 5, arc_between_tangents(p, &first, &last)) && plb_ps_push(p, ps_real(first.x)) &&
           plb_ps_push(p, ps_real(first.y)) && plb_ps_push(p, ps_real(last.x)) && plb_ps_push(p, ps_real(last.y));
}

const ps_operator plb_ps_path_operators[] = {
    {"newpath", "", op_newpath},
    {"moveto", "nn", op_moveto},
    {"rmoveto", "nn", op_rmoveto},
    {"lineto", "nn", op_lineto},
    {"rlineto", "nn", op_rlineto},
    {"curveto", "nnnnnn", op_curveto},
    {"rcurveto", "nnnnnn", op_rcurveto},
    {"closepath", "", op_closepath},
    {"currentpoint", "", op_currentpoint},
    {"arc", "nnnnn", op_arc},
    {"arcn", "nnnnn", op_arcn},
    {"arct", "nnnnn", op_arct},
    {"arcto", "nnnnn", op_arcto},
    {NULL, NULL, NULL},
};
