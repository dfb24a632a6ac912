/* SPDX-License-Identifier: MIT
 *
 * Pieces of line become long lines, so that a hand draws each in one movement. At each node the ends that go on straightest are
 * joined first; a line does not turn sharply, nor into one of another kind.
 */
#include "tap/model/line/line.h"

#include <stdlib.h>
#include <string.h>

/* Ends that are alone at a node go on when they turn by less than this, degrees; where more meet they must be straighter (chosen by
 * eye: a hexagon keeps its corners, a circle of ten sides does not). */
#define MAX_TURN 50.0
#define MAX_TURN_AMONG_MANY 25.0

/* An end is 2 * piece for its beginning, and 1 more for its end. */
typedef struct {
    uint64_t node;
    uint32_t end;
} node_end;

typedef struct {
    double turn; /* radians */
    uint32_t a, b;
} joint;

static int compare_ends(const void *a, const void *b)
{
    const node_end *x = a, *y = b;
    return x->node != y->node ? (x->node > y->node) - (x->node < y->node) : (x->end > y->end) - (x->end < y->end);
}

static int compare_joints(const void *a, const void *b)
{
    const joint *x = a, *y = b;
    return x->turn != y->turn ? (x->turn > y->turn) - (x->turn < y->turn) : x->a != y->a ? (x->a > y->a) - (x->a < y->a) : (x->b > y->b) - (x->b < y->b);
}

/* Gives the direction in which the line leaves the piece at this end. */
static vector way_out(const line_pieces *l, uint32_t end)
{
    const line_piece *p = &l->v[end / 2];
    return end % 2 ? vector_sub(p->to, p->from) : vector_sub(p->from, p->to);
}

#define MAX_ENDS 16 /* at a node where more meet, no line goes on */

/* Joins the ends v[0..n) of one node: next[end] becomes the end that the line goes on with. */
static void join_node(const line_pieces *l, const node_end *v, size_t n, uint32_t *next)
{
    joint joints[MAX_ENDS * MAX_ENDS / 2];
    size_t count = 0;
    double limit = (n == 2 ? MAX_TURN : MAX_TURN_AMONG_MANY) * PLB_PI / 180;
    for (size_t i = 0; i < n && n <= MAX_ENDS; i++)
        for (size_t k = i + 1; k < n; k++) {
            uint32_t a = v[i].end, b = v[k].end;
            bool are_alike = (l->v[a / 2].kind == LINE_CONTOUR) == (l->v[b / 2].kind == LINE_CONTOUR);
            double turn = vector_angle(way_out(l, a), vector_scale(way_out(l, b), -1));
            if (are_alike && a / 2 != b / 2 && (turn < limit || (l->v[a / 2].kind == LINE_CONTOUR && n == 2)))
                joints[count++] = (joint){turn, a, b};
        }
    qsort(joints, count, sizeof *joints, compare_joints);
    for (size_t i = 0; i < count; i++)
        if (next[joints[i].a] == NO_TRIANGLE && next[joints[i].b] == NO_TRIANGLE) {
            next[joints[i].a] = joints[i].b;
            next[joints[i].b] = joints[i].a;
        }
}

static bool join_all(const line_pieces *l, uint32_t *next)
{
    node_end *v = plb_new(2 * l->n + 1, sizeof *v);
    if (!v)
        return false;
    for (size_t i = 0; i < 2 * l->n; i++) {
        const line_piece *p = &l->v[i / 2];
        v[i] = (node_end){i % 2 ? p->node_to : p->node_from, (uint32_t)i};
    }
    qsort(v, 2 * l->n, sizeof *v, compare_ends);
    for (size_t i = 0, after; i < 2 * l->n; i = after) {
        for (after = i + 1; after < 2 * l->n && v[after].node == v[i].node;)
            after++;
        join_node(l, v + i, after - i, next);
    }
    plb_free(v);
    return true;
}

/* Follows the line that goes into the piece at `end`. */
static bool follow(uint32_t end, const uint32_t *next, unsigned char *is_taken, chain_list *out)
{
    chain c = {out->links.n, 0, false};
    for (uint32_t at = end; at != NO_TRIANGLE && !is_taken[at / 2]; at = next[at ^ 1]) {
        is_taken[at / 2] = 1;
        if (!array_push(&out->links, ((chain_link){at / 2, at % 2})))
            return false;
        c.n++;
        c.is_closed = next[at ^ 1] == end;
    }
    return array_push(&out->chains, c);
}

bool plb_line_chain(const line_pieces *l, chain_list *out, error *err)
{
    size_t ends = 2 * l->n;
    uint32_t *next = plb_new(ends + 1, sizeof *next);
    unsigned char *is_taken = plb_new(l->n + 1, 1);
    bool ok = next && is_taken;
    if (ok) {
        memset(next, 0xff, (ends + 1) * sizeof *next);
        ok = join_all(l, next);
    }
    /* First the lines that have ends, then those that close. */
    for (uint32_t i = 0; ok && i < ends; i++)
        if (next[i] == NO_TRIANGLE && !is_taken[i / 2])
            ok = follow(i, next, is_taken, out);
    for (uint32_t i = 0; ok && i < ends; i += 2)
        if (!is_taken[i / 2])
            ok = follow(i, next, is_taken, out);
    plb_free(next);
    plb_free(is_taken);
    return ok || plb_fail_memory(err);
}

void plb_chain_list_free(chain_list *l)
{
    array_free(&l->links);
    array_free(&l->chains);
}
