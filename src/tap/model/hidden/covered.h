/* SPDX-License-Identifier: MIT
 *
 * Hidden lines that lie under seen ones in the picture are not drawn: in a view from straight ahead most do.
 */
#ifndef PLB_TAP_MODEL_HIDDEN_COVERED_H
#define PLB_TAP_MODEL_HIDDEN_COVERED_H

#include "tap/model/hidden/hide.h"

/* Cuts out of the hidden runs what lies along a seen run, or along a hidden one that comes before it. */
bool plb_drop_covered(run_list *l, error *err);

#endif
