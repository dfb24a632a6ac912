/* SPDX-License-Identifier: MIT
 *
 * Step 5 of the medial axis turns the graph into strokes of a pen. At each joint the axis is thrown away and made again from the
 * arms that lead there: arms that go on straight into each other are one stroke; the others run on to that stroke, or
 * all to where their lines meet best. Two arms at an angle are one stroke with a corner. Free ends run on to the tip
 * of the shape, less half of what the pen is wide.
 */
#include "plan/letter/medial/medial.h"

#include <math.h>
#include <string.h>

/* Arms that bend by less go on into each other; with four at a joint, less than the second. */
#define STRAIGHT_DEGREES 32.0
#define CROSSING_DEGREES 50.0
#define SMOOTH_DEGREES 40.0 /* two arms alone: beyond, a corner */
#define MAX_ARMS 8          /* of a joint; more stay as the axis has them */

typedef enum { TO_NOTHING, TO_POINT, TO_ARM, TO_ARM_BY_CORNER } joint_kind;

/* Where a stroke goes on at one end of a branch. */
typedef struct {
    medial_arm arm;
    joint_kind kind;
    int mate;    /* an arm: 2 * branch + end */
    point place; /* the corner, or the point where the stroke ends */
} arm_end;

typedef struct {
    const medial *m;
    const raster *r;
    double nib;
    arm_end *arms; /* 2 for each branch */
    bool *drawn;   /* branches */
    pen *out;
} stroke_maker;

void plb_pen_free(pen *p)
{
    array_free(&p->points);
    array_free(&p->strokes);
}

/* ---- free ends ---- */

/* Extends a free end from its anchor straight on to the shape's edge. */
static void extend_to_tip(const stroke_maker *j, arm_end *e)
{
    point back = point_scale(e->arm.outward, -1), p = e->arm.anchor;
    double step = 0.5, gone = 0, most = 3 * e->arm.radius + plb_point_distance(p, j->m->nodes.v[e->arm.node].at);
    while (gone < most && raster_inside(j->r, point_add(p, point_scale(back, gone + step))))
        gone += step;
    double off = fmin(j->nib, 2 * e->arm.radius) / 2;
    e->kind = TO_POINT;
    e->place = point_add(p, point_scale(back, fmax(gone - off, 0)));
}

/* ---- joints ---- */

static void set_pair(stroke_maker *j, int a, int b, joint_kind kind, point place)
{
    j->arms[a].kind = j->arms[b].kind = kind;
    j->arms[a].mate = b;
    j->arms[b].mate = a;
    j->arms[a].place = j->arms[b].place = place;
}

static void set_end(stroke_maker *j, int a, point place)
{
    j->arms[a].kind = TO_POINT;
    j->arms[a].place = place;
}

/* Gives the point that lies nearest to all arms' lines: least squares. Kept near the joint. */
static point meeting_point(const stroke_maker *j, const int *arm, int n, int node)
{
    double xx = 1e-3, xy = 0, yy = 1e-3;
    point here = j->m->nodes.v[node].at, sum = point_scale(here, 1e-3);
    for (int i = 0; i < n; i++) {
        const medial_arm *a = &j->arms[arm[i]].arm;
        point d = a->outward;
        double pxx = 1 - d.x * d.x, pxy = -d.x * d.y, pyy = 1 - d.y * d.y;
        xx += pxx, xy += pxy, yy += pyy;
        sum = point_add(sum, (point){pxx * a->anchor.x + pxy * a->anchor.y, pxy * a->anchor.x + pyy * a->anchor.y});
    }
    double det = xx * yy - xy * xy;
    point at = {(yy * sum.x - xy * sum.y) / det, (xx * sum.y - xy * sum.x) / det};
    double off = plb_point_distance(at, here), most = 3 * j->m->nodes.v[node].radius;
    return off > most ? here : at;
}

/* A ring turns by itself: what an even one turns between the places where the directions of its two ends are taken. */
static double turn_of_ring(const stroke_maker *j, const int *arm, int node)
{
    const medial_arm *a = &j->arms[arm[0]].arm, *b = &j->arms[arm[1]].arm;
    point here = j->m->nodes.v[node].at;
    if (arm[0] / 2 != arm[1] / 2)
        return 0;
    double part = plb_point_distance(a->anchor, here) + plb_point_distance(b->anchor, here) + ARM_REACH * a->radius;
    return fmin(2 * PLB_PI * part / j->m->branches.v[arm[0] / 2].length, PLB_PI / 2);
}

static void make_corner(stroke_maker *j, const int *arm, int node)
{
    const medial_arm *a = &j->arms[arm[0]].arm, *b = &j->arms[arm[1]].arm;
    if (plb_medial_arms_bend(a, b) - turn_of_ring(j, arm, node) < SMOOTH_DEGREES * PLB_PI / 180) {
        set_pair(j, arm[0], arm[1], TO_ARM, a->anchor);
        return;
    }
    point meet, here = j->m->nodes.v[node].at;
    double most = 4 * j->m->nodes.v[node].radius;
    if (!plb_medial_arms_meet(a, b, &meet) || plb_point_distance(meet, here) > most || !raster_inside(j->r, meet))
        meet = here;
    set_pair(j, arm[0], arm[1], TO_ARM_BY_CORNER, meet);
}

/* Finds where the arm's line hits the stroke through a and b, which is straight there; else the joint's middle. */
static point hit(const stroke_maker *j, int arm, int a, int b)
{
    const medial_arm *k = &j->arms[arm].arm;
    point from = j->arms[a].arm.anchor, along = point_sub(j->arms[b].arm.anchor, from);
    point middle = point_mix(from, j->arms[b].arm.anchor, 0.5);
    double det = point_cross(along, k->outward);
    if (fabs(det) < 0.15 * plb_point_length(along))
        return middle;
    double t = point_cross(point_sub(k->anchor, from), k->outward) / det;
    return t < -0.5 || t > 1.5 ? middle : point_add(from, point_scale(along, t));
}

typedef struct {
    int a, b;
    double bend;
} pairing;

static pairing best_pair(const stroke_maker *j, const int *arm, int n)
{
    pairing best = {-1, -1, 10};
    for (int i = 0; i < n; i++)
        for (int k = i + 1; k < n; k++) {
            bool taken = j->arms[arm[i]].kind != TO_NOTHING || j->arms[arm[k]].kind != TO_NOTHING;
            double bend = taken ? 10 : plb_medial_arms_bend(&j->arms[arm[i]].arm, &j->arms[arm[k]].arm);
            if (bend < best.bend)
                best = (pairing){arm[i], arm[k], bend};
        }
    return best;
}

static void make_joint(stroke_maker *j, const int *arm, int n, int node)
{
    pairing first = best_pair(j, arm, n);
    double straight = (n == 4 ? CROSSING_DEGREES : STRAIGHT_DEGREES) * PLB_PI / 180;
    if (first.bend > straight) { /* no stroke goes through: Y */
        point at = meeting_point(j, arm, n, node);
        for (int i = 0; i < n; i++)
            set_end(j, arm[i], at);
        return;
    }
    for (pairing p = first; p.a >= 0 && p.bend <= straight; p = best_pair(j, arm, n))
        set_pair(j, p.a, p.b, TO_ARM, (point){0, 0});
    for (int i = 0; i < n; i++)
        if (j->arms[arm[i]].kind == TO_NOTHING)
            set_end(j, arm[i], hit(j, arm[i], first.a, first.b));
}

/* Solves each node. The arms at a node are a linked list: head[node], next[arm]. */
static void solve_joints(stroke_maker *j, const int *head, const int *next)
{
    for (size_t k = 0; k < j->m->nodes.n; k++) {
        int arm[MAX_ARMS], n = 0;
        for (int a = head[k]; a >= 0; a = next[a])
            if (n < MAX_ARMS)
                arm[n++] = a;
            else
                set_end(j, a, j->m->nodes.v[k].at);
        if (n == 1)
            extend_to_tip(j, &j->arms[arm[0]]);
        else if (n == 2)
            make_corner(j, arm, (int)k);
        else if (n > 2)
            make_joint(j, arm, n, (int)k);
    }
}

/* ---- strokes ---- */

static bool add_point(pen *out, point at, bool corner)
{
    pen_point p = {at, corner};
    size_t first = out->strokes.v[out->strokes.n - 1].first;
    if (out->points.n > first && plb_point_distance(out->points.v[out->points.n - 1].at, at) < 0.1) {
        out->points.v[out->points.n - 1].corner |= corner;
        return true;
    }
    return array_push(&out->points, p);
}

/* Adds the branch entered by arm `a` up to its other end. */
static bool add_branch(stroke_maker *j, int a)
{
    size_t i = j->arms[a].arm.cut, last = j->arms[a ^ 1].arm.cut, step = (size_t)j->arms[a].arm.step;
    size_t n = step == 1 ? last - i : i - last;
    if (!add_point(j->out, j->arms[a].arm.anchor, false))
        return false;
    for (size_t k = 1; k < n && n < SIZE_MAX / 2; k++)
        if (!add_point(j->out, j->m->points.v[i + k * step].at, false))
            return false;
    return add_point(j->out, j->arms[a ^ 1].arm.anchor, false);
}

/* Adds the stroke from arm `a` through all joints that lead on. */
static bool add_stroke(stroke_maker *j, int a)
{
    pen_stroke s = {.first = j->out->points.n};
    int start = a;
    if (!array_push(&j->out->strokes, s) || (j->arms[a].kind != TO_ARM && !add_point(j->out, j->arms[a].place, false)))
        return false;
    for (;;) {
        j->drawn[a / 2] = true;
        const arm_end *e = &j->arms[a ^ 1];
        if (!add_branch(j, a) || (e->kind != TO_ARM && !add_point(j->out, e->place, e->kind == TO_ARM_BY_CORNER)))
            return false;
        if (e->kind == TO_POINT || e->kind == TO_NOTHING)
            break;
        a = e->mate;
        if (a == start || j->drawn[a / 2])
            break;
    }
    pen_stroke *made = &j->out->strokes.v[j->out->strokes.n - 1];
    made->closed = j->arms[start].kind >= TO_ARM;
    if (made->closed && !add_point(j->out, j->out->points.v[made->first].at, false))
        return false;
    if (made->closed && j->arms[start].kind == TO_ARM_BY_CORNER)
        j->out->points.v[made->first].corner = j->out->points.v[j->out->points.n - 1].corner = true;
    made->n = j->out->points.n - made->first;
    return true;
}

static bool add_strokes(stroke_maker *j, bool rings)
{
    for (size_t b = 0; b < j->m->branches.n; b++)
        for (int end = 0; end < 2; end++) {
            int a = (int)(2 * b) + end;
            bool starts = rings || j->arms[a].kind == TO_POINT;
            if (!j->m->branches.v[b].gone && !j->drawn[b] && starts && !add_stroke(j, a))
                return false;
        }
    return true;
}

static bool add_dots(stroke_maker *j)
{
    for (size_t k = 0; k < j->m->nodes.n; k++) {
        const medial_node *node = &j->m->nodes.v[k];
        pen_stroke s = {.first = j->out->points.n, .n = 1};
        pen_point p = {node->at, false};
        if (!node->gone && node->degree == 0 && (!array_push(&j->out->strokes, s) || !array_push(&j->out->points, p)))
            return false;
    }
    return true;
}

static void link_arms(stroke_maker *j, int *head, int *next)
{
    for (size_t k = 0; k < j->m->nodes.n; k++)
        head[k] = -1;
    for (size_t b = 0; b < j->m->branches.n; b++)
        for (int end = 0; end < 2 && !j->m->branches.v[b].gone; end++) {
            int a = (int)(2 * b) + end, node = j->m->branches.v[b].node[end];
            j->arms[a].arm = plb_medial_arm(j->m, &j->m->branches.v[b], end);
            next[a] = head[node];
            head[node] = a;
        }
}

bool plb_medial_strokes(const medial *m, const raster *r, double nib, pen *out, error *err)
{
    memset(out, 0, sizeof *out);
    size_t arms = 2 * m->branches.n + 1;
    stroke_maker j = {.m = m, .r = r, .nib = nib, .out = out};
    j.arms = plb_new(arms, sizeof *j.arms);
    j.drawn = plb_new(arms, sizeof *j.drawn);
    int *head = plb_new(m->nodes.n + 1, sizeof *head), *next = plb_new(arms, sizeof *next);
    bool ok = j.arms && j.drawn && head && next;
    if (ok) {
        link_arms(&j, head, next);
        solve_joints(&j, head, next);
        ok = add_strokes(&j, false) && add_strokes(&j, true) && add_dots(&j);
    }
    plb_free(j.arms);
    plb_free(j.drawn);
    plb_free(head);
    plb_free(next);
    if (!ok)
        plb_pen_free(out);
    return ok || plb_fail_memory(err);
}
