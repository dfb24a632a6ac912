/* SPDX-License-Identifier: MIT
 *
 * The passes of the plan that look at all strokes together, once each item has made its own.
 */
#ifndef PLB_PLAN_PASS_H
#define PLB_PLAN_PASS_H

#include "base/error.h"
#include "list/strokes.h"

/* Each returns false and fills `err` when out of memory. */

/* identity.c: fills in the identities. */
bool plb_plan_identify(stroke_list *list, error *err);

#endif
