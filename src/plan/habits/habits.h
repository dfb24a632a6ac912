/* SPDX-License-Identifier: MIT
 *
 * Habits of people who sketch: lines past corners, lines drawn twice, construction lines.
 */
#ifndef PLB_PLAN_HABITS_HABITS_H
#define PLB_PLAN_HABITS_HABITS_H

#include "plan/plan.h"

/* habits.c: all that the options ask for; before the strokes are put in order. False and `err` when out of memory. */
bool plb_plan_habits(stroke_list *list, const plan_options *o, error *err);
/* guides.c: construction lines for the long lines and the circles of the list, added to it. False when out of memory. */
bool plb_plan_guides(stroke_list *list, const plan_options *o);

#endif
