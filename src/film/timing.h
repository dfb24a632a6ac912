/* SPDX-License-Identifier: MIT
 *
 * When the pencil is where: how long a hand takes for a stroke, and how far along it the pencil is at each moment. The speed is that of the movement of least
 * jerk, a bell, and lower where the path bends, by the power of two thirds (plumbago(7)).
 */
#ifndef PLB_FILM_TIMING_H
#define PLB_FILM_TIMING_H

#include "stroke/path/trajectory.h"

/* Returns how long a movement over so many mm takes, in a unit that all movements share: long ones are made faster, so that they take little longer. */
double plb_film_time(double mm);

/* A stroke_clock holds the effort of a path's parts: effort[i] up to sample i, whose differences grow with length and bend. */
typedef struct {
    ARRAY(double) effort;
} stroke_clock;
/* Replaces the clock by that of a path; false when out of memory. */
bool plb_film_clock_set(stroke_clock *c, const path_samples *path);
/* Returns how far along the path, mm, the pencil is when the share `tau` of the stroke's time has passed. */
double plb_film_clock_along(const stroke_clock *c, const path_samples *path, double tau);

#endif
