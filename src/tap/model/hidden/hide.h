/* SPDX-License-Identifier: MIT
 *
 * Hidden lines: each piece of line is clipped exactly against each triangle that covers it; the rest is seen.
 */
#ifndef PLB_TAP_MODEL_HIDDEN_HIDE_H
#define PLB_TAP_MODEL_HIDDEN_HIDE_H

#include "tap/model/hidden/tree.h"
#include "tap/model/line/line.h"

/* A run is a part of a chain that is seen, or not seen, as a whole. */
typedef struct {
    size_t first, n; /* of the points */
    line_kind kind;
    bool is_hidden, is_closed;
} run;

typedef struct {
    ARRAY(point) points; /* mm on the page */
    ARRAY(run) runs;
} run_list;

/* Splits the chains into runs. Those that are hidden are left out unless `keep_hidden`. */
bool plb_hide(const view *v, const box_tree *tree, const line_pieces *pieces, const chain_list *chains, bool keep_hidden, run_list *out, error *err);
void plb_run_list_free(run_list *l);

/* So far may a place lie behind a surface, mm, and still count as lying on it: a part of the model's size on paper. */
double plb_hide_tolerance(const view *v);

#endif
