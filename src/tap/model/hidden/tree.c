/* SPDX-License-Identifier: MIT
 *
 * See tree.h.
 */
#include "tap/model/hidden/tree.h"

#include <string.h>

#define NOTHING ((tree_box){{1e30f, 1e30f, 1e30f}, {-1e30f, -1e30f, -1e30f}})

static void add_box(tree_box *to, const tree_box *b)
{
    for (int k = 0; k < 3; k++) {
        to->low[k] = b->low[k] < to->low[k] ? b->low[k] : to->low[k];
        to->high[k] = b->high[k] > to->high[k] ? b->high[k] : to->high[k];
    }
}

/* Rounds outwards. */
static tree_box box_of(const view *v, size_t t)
{
    tree_box b = NOTHING;
    for (int i = 0; i < 3; i++) {
        vector p = view_corner(v, t, i);
        double at[3] = {p.x, p.y, p.z};
        for (int k = 0; k < 3; k++) {
            double slack = fabs(at[k]) * 2e-7 + 1e-30;
            b.low[k] = (float)lesser((double)b.low[k], at[k] - slack);
            b.high[k] = (float)greater((double)b.high[k], at[k] + slack);
        }
    }
    return b;
}

/* ---- order ---- */

typedef struct {
    uint32_t code, triangle;
} coded;

/* Spreads the bits of a number so that `gap` zeros follow each. */
static uint32_t spread(uint32_t x, int bits, int gap)
{
    uint32_t out = 0;
    for (int i = 0; i < bits; i++)
        out |= (x >> i & 1) << (i * (gap + 1));
    return out;
}

static uint32_t code_of(const tree_box *b, const tree_box *all, bool is_flat)
{
    int axes = is_flat ? 2 : 3, bits = is_flat ? 16 : 10;
    uint32_t code = 0;
    for (int k = 0; k < axes; k++) {
        double range = (double)all->high[k] - (double)all->low[k];
        double part = range > 0 ? (((double)b->low[k] + (double)b->high[k]) / 2 - (double)all->low[k]) / range : 0;
        uint32_t cell = (uint32_t)(part * ((1 << bits) - 1));
        code |= spread(cell, bits, axes - 1) << k;
    }
    return code;
}

/* Sorts by the code, byte by byte; those of one code stay in order. */
static void sort_codes(coded *v, coded *other, size_t n)
{
    for (int shift = 0; shift < 32; shift += 8) {
        size_t begin[257] = {0};
        for (size_t i = 0; i < n; i++)
            begin[(v[i].code >> shift & 255) + 1]++;
        for (int i = 1; i < 257; i++)
            begin[i] += begin[i - 1];
        for (size_t i = 0; i < n; i++)
            other[begin[v[i].code >> shift & 255]++] = v[i];
        coded *x = v;
        v = other;
        other = x;
    }
}

/* ---- the tree ---- */

static bool fill_order(box_tree *t, const view *v, bool is_flat)
{
    coded *codes = plb_new(2 * t->n + 1, sizeof *codes);
    tree_box *own = plb_new(t->n + 1, sizeof *own), all = NOTHING;
    if (codes && own) {
        for (size_t i = 0; i < t->n; i++) {
            own[i] = box_of(v, i);
            add_box(&all, &own[i]);
        }
        for (size_t i = 0; i < t->n; i++)
            codes[i] = (coded){code_of(&own[i], &all, is_flat), (uint32_t)i};
        sort_codes(codes, codes + t->n, t->n);
        for (size_t i = 0; i < t->n; i++) {
            t->order[i] = codes[i].triangle;
            t->boxes[i] = own[codes[i].triangle];
        }
    }
    bool ok = codes && own;
    plb_free(codes);
    plb_free(own);
    return ok;
}

bool plb_tree_build(box_tree *t, const view *v, bool is_flat, error *err)
{
    *t = (box_tree){.n = v->m->triangles.n, .leaves = 1};
    while (t->leaves * TREE_LEAF < t->n)
        t->leaves *= 2;
    t->nodes = plb_new(2 * t->leaves, sizeof *t->nodes);
    t->order = plb_new(t->n + 1, sizeof *t->order);
    t->boxes = plb_new(t->n + 1, sizeof *t->boxes);
    if (!t->nodes || !t->order || !t->boxes || !fill_order(t, v, is_flat)) {
        plb_tree_free(t);
        return plb_fail_memory(err);
    }
    for (size_t i = 0; i < 2 * t->leaves; i++)
        t->nodes[i] = NOTHING;
    for (size_t i = 0; i < t->n; i++)
        add_box(&t->nodes[t->leaves + i / TREE_LEAF], &t->boxes[i]);
    for (size_t i = t->leaves; --i > 0;) {
        add_box(&t->nodes[i], &t->nodes[2 * i]);
        add_box(&t->nodes[i], &t->nodes[2 * i + 1]);
    }
    return true;
}

void plb_tree_free(box_tree *t)
{
    plb_free(t->nodes);
    plb_free(t->order);
    plb_free(t->boxes);
    *t = (box_tree){0};
}
