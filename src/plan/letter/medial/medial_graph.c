/* SPDX-License-Identifier: MIT
 *
 * Step 3 of the medial axis reads the thinned raster off as a graph. Pixels with three or more neighbours, taken together
 * where they touch, are joints; pixels with one are ends; chains of pixels with two are branches. The staircase that
 * pixels make of a slanted line is smoothed away at once.
 */
#include "plan/letter/medial/medial.h"

#include <math.h>
#include <string.h>

/* Passes of (1 2 1)/4 along a chain: a Gaussian of 1.7 pixels, as much as the staircase asks for. */
#define SMOOTHING 6

static const int step_x[8] = {1, 0, -1, 0, 1, -1, -1, 1}, step_y[8] = {0, 1, 0, -1, 1, 1, -1, -1}; /* direct ones first */

typedef struct {
    const raster *r;
    medial *m;
    int *owner;      /* of each pixel: 0 none, n > 0: node n - 1, -1: of a branch that is traced */
    ARRAY(int) stack;
} graph_maker;

void plb_medial_free(medial *m)
{
    array_free(&m->nodes);
    array_free(&m->branches);
    array_free(&m->points);
}

static int neighbour(const graph_maker *g, int i, int k)
{
    return i + step_y[k] * g->r->width + step_x[k];
}

static int count_neighbours(const graph_maker *g, int i)
{
    int n = 0;
    for (int k = 0; k < 8; k++)
        n += g->r->on[neighbour(g, i, k)];
    return n;
}

static medial_point point_of(const graph_maker *g, int i)
{
    point at = {i % g->r->width + 0.5, i / g->r->width + 0.5};
    return (medial_point){at, g->r->radius[i]};
}

/* All joint pixels that hang together with `i` become one node in their middle. */
static bool add_node(graph_maker *g, int i)
{
    medial_node node = {.radius = 0};
    int members = 0, id = (int)g->m->nodes.n + 1;
    bool joint = count_neighbours(g, i) > 2;
    g->stack.n = 0;
    g->owner[i] = id;
    if (!array_push(&g->stack, i))
        return false;
    while (g->stack.n) {
        int at = g->stack.v[--g->stack.n];
        medial_point p = point_of(g, at);
        node.at = point_add(node.at, p.at);
        node.radius = fmax(node.radius, p.radius);
        members++;
        for (int k = 0; joint && k < 8; k++) {
            int next = neighbour(g, at, k);
            if (!g->r->on[next] || g->owner[next] || count_neighbours(g, next) < 3)
                continue;
            g->owner[next] = id;
            if (!array_push(&g->stack, next))
                return false;
        }
    }
    node.at = point_scale(node.at, 1.0 / members);
    return array_push(&g->m->nodes, node);
}

static bool add_nodes(graph_maker *g)
{
    int n = g->r->width * g->r->height;
    for (int i = 0; i < n; i++)
        if (g->r->on[i] && !g->owner[i] && count_neighbours(g, i) != 2 && !add_node(g, i))
            return false;
    return true;
}

static void smooth(medial_point *p, size_t n)
{
    for (int pass = 0; pass < SMOOTHING; pass++) {
        point before = p[0].at;
        for (size_t i = 1; i + 1 < n; i++) {
            point here = p[i].at;
            p[i].at = point_mix(point_mix(before, p[i + 1].at, 0.5), here, 0.5);
            before = here;
        }
    }
}

static bool end_branch(medial *m, size_t first, int from, int to)
{
    medial_branch b = {.node = {from, to}, .first = first, .n = m->points.n - first, .spur = -1};
    if (from == to && b.n < 6) { /* a pixel between two of one joint */
        m->points.n = first;
        return true;
    }
    smooth(m->points.v + first, b.n);
    for (size_t i = first + 1; i < first + b.n; i++)
        b.length += plb_point_distance(m->points.v[i - 1].at, m->points.v[i].at);
    m->nodes.v[from].degree++;
    m->nodes.v[to].degree++;
    return array_push(&m->branches, b);
}

static bool push_node(medial *m, int node)
{
    medial_point p = {m->nodes.v[node].at, m->nodes.v[node].radius};
    return array_push(&m->points, p);
}

/* Walks from the line's pixel `i`, a neighbour of node `from`, along the chain to the next node. */
static bool trace(graph_maker *g, int from, int i)
{
    size_t first = g->m->points.n;
    int to = -1;
    if (!push_node(g->m, from))
        return false;
    while (i >= 0) {
        medial_point p = point_of(g, i);
        if (!array_push(&g->m->points, p))
            return false;
        g->owner[i] = -1;
        int next = -1;
        for (int k = 0; k < 8; k++) {
            int j = neighbour(g, i, k), other = g->r->on[j] ? g->owner[j] : -1;
            if (other == 0)
                next = j;
            else if (other > 0 && (other != from + 1 || g->m->points.n > first + 3))
                to = other - 1;
        }
        i = to >= 0 ? -1 : next;
    }
    if (to < 0)
        to = from; /* back where it began */
    return push_node(g->m, to) && end_branch(g->m, first, from, to);
}

/* Branches start at the free chain pixels beside a node's pixels; nodes that touch directly are one node already. */
static bool trace_from_nodes(graph_maker *g)
{
    int n = g->r->width * g->r->height;
    for (int i = 0; i < n; i++)
        for (int k = 0; g->owner[i] > 0 && k < 8; k++) {
            int next = neighbour(g, i, k);
            if (!g->r->on[next])
                continue;
            if (g->owner[next] == 0 && !trace(g, g->owner[i] - 1, next))
                return false;
            if (g->owner[next] > g->owner[i]) { /* an end beside a joint, or two ends */
                size_t first = g->m->points.n;
                if (!push_node(g->m, g->owner[i] - 1) || !push_node(g->m, g->owner[next] - 1) || !end_branch(g->m, first, g->owner[i] - 1, g->owner[next] - 1))
                    return false;
            }
        }
    return true;
}

/* Rings without a joint: a node anywhere on them. */
static bool trace_rings(graph_maker *g)
{
    int n = g->r->width * g->r->height;
    for (int i = 0; i < n; i++)
        if (g->r->on[i] && !g->owner[i]) {
            medial_point p = point_of(g, i);
            medial_node node = {.at = p.at, .radius = p.radius};
            g->owner[i] = (int)g->m->nodes.n + 1;
            if (!array_push(&g->m->nodes, node))
                return false;
            for (int k = 0; k < 8; k++) {
                int next = neighbour(g, i, k);
                if (g->r->on[next] && !g->owner[next]) {
                    if (!trace(g, g->owner[i] - 1, next))
                        return false;
                    break;
                }
            }
        }
    return true;
}

bool plb_medial_graph(medial *m, const raster *r, error *err)
{
    memset(m, 0, sizeof *m);
    graph_maker g = {.r = r, .m = m, .owner = plb_new((size_t)r->width * (size_t)r->height, sizeof(int))};
    bool ok = g.owner && add_nodes(&g) && trace_from_nodes(&g) && trace_rings(&g);
    plb_free(g.owner);
    array_free(&g.stack);
    if (ok && m->branches.n <= MEDIAL_MAX_BRANCHES)
        return true;
    plb_medial_free(m);
    return ok || plb_fail_memory(err);
}
