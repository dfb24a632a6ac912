/* SPDX-License-Identifier: MIT
 *
 * Medial axis, step 4: what the shape's ends and joints alone have made goes.
 *   - A spur: a leaf that hardly leaves the disc of its joint. The axis forks so into both corners of a stem's end.
 *   - Serifs: short leaves at the end of one long branch.
 *   - A wedge: where two strokes meet at a sharp angle (V, A, N) the axis runs on into the corner; the leaf goes when
 *     it ends about where the lines of both strokes meet anyhow.
 *   - A doubled joint: strokes that cross make two joints close to each other; they become one.
 */
#include "plan/letter/medial/medial.h"

#include <math.h>

/* In radii of the joint's disc (all chosen by eye on the fonts of the corpus). */
#define SPUR 1.0       /* the corner of a square end sticks out .41, on pixels up to .9 */
#define POINTED 0.28   /* in stem thicknesses: the radius at such a tip */
#define LEAST 0.4      /* in stem thicknesses: R is not less, near a stem's end it would be */
#define STUB 0.5       /* the same of a leaf with a blunt tip, such as the arms of a t */
#define BENT 1.5       /* the same of a leaf round a corner: what is left of an end's fork */
#define SLACK 0.75     /* pixels: the disc of a joint is found too small by as much */
#define THIN 0.72      /* radius in the middle of a leaf */
#define SERIF 2.0      /* Times: 1.5 */
#define WEDGE 1.4      /* how far past the lines' meeting a wedge's tip may reach */
#define WEDGE_LONGEST 4.5
#define DOUBLE 1.6     /* two joints are one when closer than this */
#define WEDGE_DEGREES 100.0

static int other_node(const medial_branch *b, int node)
{
    return b->node[b->node[0] == node];
}

/* Gives the joint that a leaf hangs on, or -1 when the branch is no leaf. */
static int joint_of(const medial *m, const medial_branch *b)
{
    if (b->gone || b->node[0] == b->node[1])
        return -1;
    int first = m->nodes.v[b->node[0]].degree, second = m->nodes.v[b->node[1]].degree;
    return first == 1 && second > 1 ? b->node[1] : second == 1 && first > 1 ? b->node[0] : -1;
}

/* Tells how far the shape at a leaf's tip lies outside of the joint's disc. */
static double protrusion(const medial *m, const medial_branch *b, int joint)
{
    const medial_node *tip = &m->nodes.v[other_node(b, joint)], *j = &m->nodes.v[joint];
    return plb_point_distance(tip->at, j->at) + tip->radius - j->radius;
}

/* Tells whether a leaf is thinner than the stroke that it hangs on: a serif, or the wedge of a corner. */
static bool is_thin(const medial *m, const medial_branch *leaf, int joint)
{
    return m->points.v[leaf->first + leaf->n / 2].radius < THIN * m->nodes.v[joint].radius;
}

static bool is_spur(const medial *m, const medial_branch *leaf, int joint, double stem, double detail)
{
    const medial_node *j = &m->nodes.v[joint];
    bool pointed = m->nodes.v[other_node(leaf, joint)].radius < POINTED * stem;
    double least = (!pointed ? STUB : j->degree == 2 && is_thin(m, leaf, joint) ? BENT : SPUR) * fmax(j->radius, LEAST * stem) + SLACK;
    return protrusion(m, leaf, joint) < fmax(least, detail);
}

/* Drops a leaf and its tip. */
static void drop(medial *m, medial_branch *b, int joint)
{
    b->gone = true;
    m->nodes.v[other_node(b, joint)].gone = true;
    m->nodes.v[other_node(b, joint)].degree = 0;
    m->nodes.v[joint].degree--;
}

/* All of a joint in one round: neither corner of an end is left over. */
static bool drop_spurs(medial *m, double stem, double detail)
{
    bool any = false;
    for (size_t i = 0; i < m->branches.n; i++) {
        medial_branch *b = &m->branches.v[i];
        int joint = joint_of(m, b);
        b->spur = joint >= 0 && is_spur(m, b, joint, stem, detail) ? joint : -1;
        any |= b->spur >= 0;
    }
    for (size_t i = 0; i < m->branches.n; i++) {
        medial_branch *b = &m->branches.v[i];
        if (b->spur >= 0)
            drop(m, b, b->spur);
    }
    return any;
}

/* ---- joining ---- */

/* Appends the points of `b` as seen from node `from`; without the first when that is there already. */
static bool append(medial *m, const medial_branch *b, int from, bool skip)
{
    if (!array_reserve(&m->points, b->n))
        return false;
    for (size_t i = skip; i < b->n; i++)
        m->points.v[m->points.n++] = m->points.v[b->node[0] == from ? b->first + i : b->first + b->n - 1 - i];
    return true;
}

static bool join(medial *m, size_t i, size_t j, int node)
{
    medial_branch a = m->branches.v[i], b = m->branches.v[j];
    size_t first = m->points.n;
    if (!append(m, &a, other_node(&a, node), false) || !append(m, &b, node, true))
        return false;
    m->branches.v[j].gone = true;
    m->branches.v[i] = (medial_branch){{other_node(&a, node), other_node(&b, node)}, first, m->points.n - first, a.length + b.length, false, -1};
    m->nodes.v[node].degree = 0;
    m->nodes.v[node].gone = true;
    return true;
}

/* Gives the branches that end at `node`, up to `capacity`; a loop counts once. */
static int branches_at(const medial *m, int node, size_t *found, int capacity)
{
    int n = 0;
    for (size_t i = 0; i < m->branches.n && n < capacity; i++)
        if (!m->branches.v[i].gone && (m->branches.v[i].node[0] == node || m->branches.v[i].node[1] == node))
            found[n++] = i;
    return n;
}

static medial_arm arm_at(const medial *m, size_t branch, int node)
{
    const medial_branch *b = &m->branches.v[branch];
    return plb_medial_arm(m, b, b->node[0] != node);
}

/* Two branches that go on into each other become one; those that make a corner stay apart. */
static bool join_straight(medial *m)
{
    for (size_t k = 0; k < m->nodes.n; k++) {
        size_t at[3];
        if (m->nodes.v[k].degree != 2 || branches_at(m, (int)k, at, 3) != 2)
            continue;
        medial_arm a = arm_at(m, at[0], (int)k), b = arm_at(m, at[1], (int)k);
        if (plb_medial_arms_bend(&a, &b) < 40 * PLB_PI / 180 && !join(m, at[0], at[1], (int)k))
            return false;
    }
    return true;
}

/* ---- serifs and wedges ---- */

static bool is_short_leaf(const medial *m, size_t branch, int node)
{
    const medial_branch *b = &m->branches.v[branch];
    return joint_of(m, b) == node && is_thin(m, b, node) && protrusion(m, b, node) < SERIF * m->nodes.v[node].radius;
}

/* Both leaves are short and go off to opposite sides of the third branch. */
static bool are_serifs(const medial *m, int node, size_t first, size_t second)
{
    if (!is_short_leaf(m, first, node) || !is_short_leaf(m, second, node))
        return false;
    point here = m->nodes.v[node].at;
    point a = point_sub(m->nodes.v[other_node(&m->branches.v[first], node)].at, here);
    point b = point_sub(m->nodes.v[other_node(&m->branches.v[second], node)].at, here);
    return point_dot(a, b) < -0.6 * plb_point_length(a) * plb_point_length(b);
}

static void drop_serifs(medial *m, int node, const size_t *at)
{
    for (int stem = 0; stem < 3; stem++) {
        size_t first = at[(stem + 1) % 3], second = at[(stem + 2) % 3];
        if (m->branches.v[at[stem]].length < 3 * m->nodes.v[node].radius || !are_serifs(m, node, first, second))
            continue;
        drop(m, &m->branches.v[first], node);
        drop(m, &m->branches.v[second], node);
        return;
    }
}

static bool is_wedge(const medial *m, int node, size_t leaf, size_t first, size_t second)
{
    medial_arm a = arm_at(m, first, node), b = arm_at(m, second, node);
    point meet, here = m->nodes.v[node].at, tip = m->nodes.v[other_node(&m->branches.v[leaf], node)].at;
    if (joint_of(m, &m->branches.v[leaf]) != node || point_dot(a.outward, b.outward) < cos(WEDGE_DEGREES * PLB_PI / 180))
        return false;
    point along = point_sub(tip, here);
    double length = plb_point_length(along), reach = length + m->nodes.v[other_node(&m->branches.v[leaf], node)].radius;
    if (length < 1 || length > WEDGE_LONGEST * m->nodes.v[node].radius || !plb_medial_arms_meet(&a, &b, &meet) || point_dot(point_add(a.outward, b.outward), along) > 0)
        return false;
    return reach - point_dot(point_sub(meet, here), along) / length < WEDGE * m->nodes.v[node].radius;
}

static void drop_wedge(medial *m, int node, const size_t *at)
{
    for (int leaf = 0; leaf < 3; leaf++)
        if (is_wedge(m, node, at[leaf], at[(leaf + 1) % 3], at[(leaf + 2) % 3])) {
            drop(m, &m->branches.v[at[leaf]], node);
            return;
        }
}

static void drop_ends(medial *m)
{
    for (size_t k = 0; k < m->nodes.n; k++) {
        size_t at[5];
        int degree = m->nodes.v[k].degree;
        if (degree != 3 || branches_at(m, (int)k, at, 5) != degree) /* of four, two cross: a t */
            continue;
        drop_serifs(m, (int)k, at);
        if (m->nodes.v[k].degree == 3)
            drop_wedge(m, (int)k, at);
    }
}

/* ---- doubled joints ---- */

static void rename_node(medial *m, int from, int to)
{
    for (size_t i = 0; i < m->branches.n; i++)
        for (int end = 0; end < 2; end++)
            if (!m->branches.v[i].gone && m->branches.v[i].node[end] == from)
                m->branches.v[i].node[end] = to;
}

static void merge_joints(medial *m)
{
    for (size_t i = 0; i < m->branches.n; i++) {
        medial_branch *b = &m->branches.v[i];
        medial_node *p = &m->nodes.v[b->node[0]], *q = &m->nodes.v[b->node[1]];
        if (b->gone || p == q || p->degree < 3 || q->degree < 3 || b->length > DOUBLE * fmax(p->radius, q->radius))
            continue;
        p->at = point_mix(p->at, q->at, 0.5);
        p->radius = fmax(p->radius, q->radius) + b->length / 4;
        p->degree += q->degree - 2;
        q->degree = 0;
        q->gone = true;
        b->gone = true;
        rename_node(m, b->node[1], b->node[0]);
    }
}

bool plb_medial_prune(medial *m, double stem, double detail, error *err)
{
    bool ok = join_straight(m);
    while (ok && drop_spurs(m, stem, detail))
        ok = join_straight(m);
    merge_joints(m);
    drop_ends(m);
    ok = ok && join_straight(m);
    return ok || plb_fail_memory(err);
}
