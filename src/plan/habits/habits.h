/* SPDX-License-Identifier: MIT
 *
 * Habits of people who sketch: lines past corners, lines drawn twice, construction lines.
 */
#ifndef PLB_PLAN_HABITS_HABITS_H
#define PLB_PLAN_HABITS_HABITS_H

#include "plan/plan.h"

/* habits.c: all that the options ask for; before the strokes are put in order. False and `err` when out of memory. */
bool plb_plan_habits(stroke_list *list, const plan_options *o, error *err);
/* ruler.c: lines along a ruler hardly deviate, and companies deviate together. False and `err` when out of memory. */
bool plb_plan_ruler(stroke_list *list, const plan_options *o, error *err);
/* corners.c: how a hand's lines meet at corners. False and `err` when out of memory. */
bool plb_plan_meet_corners(stroke_list *list, const plan_options *o, error *err);
/* touch.c: how hard each stroke is pressed, and how broad the point is then; once the strokes have their identities. */
void plb_plan_touch(stroke_list *list, const plan_options *o);
/* Gives how much broader than freshly sharpened the point is on average. */
double plb_wear_mean(const plan_options *o);
/* guides.c: construction lines for the long lines and the circles of the list, added to it. False when out of memory. */
bool plb_plan_guides(stroke_list *list, const plan_options *o);

#endif
