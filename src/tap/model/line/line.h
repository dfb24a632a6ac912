/* SPDX-License-Identifier: MIT
 *
 * The lines of a view before anything hides them: pieces of straight line, and how they follow each other.
 */
#ifndef PLB_TAP_MODEL_LINE_LINE_H
#define PLB_TAP_MODEL_LINE_LINE_H

#include "tap/model/view/view.h"

typedef enum {
    LINE_CONTOUR, /* where a smooth surface turns away from the eye */
    LINE_EDGE,    /* a border or a crease */
    LINE_MATERIAL,
    LINE_MEETING, /* where surfaces run through each other */
    LINE_WIRE
} line_kind;

/* A node is a place where lines may go on: a number that lines which end there have in common. */
typedef struct {
    vector from, to;       /* mm, as in the view */
    uint64_t node_from, node_to;
    uint32_t edge;         /* whose triangles do not hide it, or NO_TRIANGLE */
    uint32_t own[2];       /* triangles that do not, or NO_TRIANGLE */
    line_kind kind;
} line_piece;

typedef ARRAY(line_piece) line_pieces;

/* A chain is a row of pieces, each in one direction or the other. */
typedef struct {
    uint32_t piece;
    bool is_backward;
} chain_link;
typedef struct {
    size_t first, n; /* of the links */
    bool is_closed;
} chain;
typedef struct {
    ARRAY(chain_link) links;
    ARRAY(chain) chains;
} chain_list;

/* Each adds the pieces of its kind; false when out of memory. */
bool plb_line_edges(const view *v, line_pieces *out, error *err);
/* The zero set of the normal's component towards the eye, between the normals of the corners [BH19, §4.4]. */
bool plb_line_contours(const view *v, line_pieces *out, error *err);
bool plb_line_meetings(const view *v, line_pieces *out, error *err);

/* Joins pieces that end at one node to rows, the straightest first; each piece is in one chain. */
bool plb_line_chain(const line_pieces *pieces, chain_list *out, error *err);
void plb_chain_list_free(chain_list *l);

#endif
