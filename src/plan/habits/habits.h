/* SPDX-License-Identifier: MIT
 *
 * Habits of people who sketch: lines past corners, lines drawn twice, construction lines.
 */
#ifndef PLB_PLAN_HABITS_HABITS_H
#define PLB_PLAN_HABITS_HABITS_H

#include "plan/plan.h"

/* `threads`: at most so many share the work. */

/* habits.c: all that the options ask for; before the strokes are put in order. False and `err` when out of memory. */
bool plb_plan_habits(stroke_list *list, const plan_options *o, error *err);
/* neighbours.c: finds for each straight line how far it may stray from its course, stroke.room. */
bool plb_plan_neighbours(stroke_list *list, int threads, error *err);
/* junctions.c: lines that others end upon stray little, stroke.room. */
bool plb_plan_junctions(stroke_list *list, int threads, error *err);
/* guides.c: construction lines for the long lines and the circles of the list, added to it. False when out of memory. */
bool plb_plan_guides(stroke_list *list, const plan_options *o);

#endif
