/* SPDX-License-Identifier: MIT
 *
 * A tree of boxes finds the triangles near a place: those of a view are sorted along a curve that fills the space, and each node's
 * box holds the boxes of the two below.
 */
#ifndef PLB_TAP_MODEL_HIDDEN_TREE_H
#define PLB_TAP_MODEL_HIDDEN_TREE_H

#include "tap/model/view/view.h"

#define TREE_LEAF 4 /* triangles in a leaf */

typedef struct {
    float low[3], high[3]; /* of all below, never too small */
} tree_box;

typedef struct {
    size_t n;         /* triangles */
    size_t leaves;    /* a power of two */
    tree_box *nodes;  /* node k has 2 k and 2 k + 1 below; the root is 1, the leaves are leaves … 2 leaves - 1 */
    uint32_t *order;  /* triangles: leaf i has order[TREE_LEAF * i …] */
    tree_box *boxes;  /* of the triangles, in this order */
} box_tree;

/* Builds the tree over all triangles of the view. `is_flat`: depth does not count for neighbourhood. False when out of memory. */
bool plb_tree_build(box_tree *t, const view *v, bool is_flat, error *err);
void plb_tree_free(box_tree *t);

static inline bool tree_boxes_meet(const tree_box *a, const tree_box *b)
{
    return a->low[0] <= b->high[0] && b->low[0] <= a->high[0] && a->low[1] <= b->high[1] && b->low[1] <= a->high[1] && a->low[2] <= b->high[2] &&
           b->low[2] <= a->high[2];
}

#endif
