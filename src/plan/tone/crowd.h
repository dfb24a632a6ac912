/* SPDX-License-Identifier: MIT
 *
 * Crowds: where a line is drawn over a cloud of dots, as a fit over what was measured, graphite has no colour to tell the two apart. A person dots
 * lightly and draws the line firmly.
 */
#ifndef PLB_PLAN_TONE_CROWD_H
#define PLB_PLAN_TONE_CROWD_H

#include "base/error.h"
#include "list/display_list.h"
#include "plan/plan.h"

/* An item is a dot of a crowd, a line over one, or neither. */
typedef enum { CROWD_NONE, CROWD_DOT, CROWD_LINE } crowd_part;

/* Says in part[0 … items - 1], which the caller provides with CROWD_NONE in it, which items are the dots of a crowd and which the lines over them. False and `err` when
 * out of memory. */
bool plb_crowds_find(const display_list *list, const plan_options *o, crowd_part *part, error *err);

/* Times the usual pressure of such dots and such lines (chosen by eye). */
#define CROWD_DOT_PRESSURE 0.5f
#define CROWD_LINE_PRESSURE 1.8f

#endif
