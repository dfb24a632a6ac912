/* SPDX-License-Identifier: MIT
 *
 * The arms: each row of the table is one model of how an arm moves. To add an arm, write a file with its row and name the row in
 * arms.c; the command line, the library's checks and the tests of all arms read the table.
 */
#ifndef PLB_STROKE_ARM_ARM_H
#define PLB_STROKE_ARM_ARM_H

#include "stroke/path/trajectory.h"

/* A control point in the line's own frame: how far along the line, how far off it (to the left of its direction). */
typedef struct {
    double along, off; /* mm */
} control;
#define CONTROLS_MAX 16

/* One movement from the first point of a line to its last. */
typedef struct {
    double length;   /* mm along the line */
    point way;       /* from first point to last, mm */
    double squiggle; /* the largest deviation D in force, mm: it shrinks with short lines (plumbago(7)) */
    uint64_t key, squiggle_key; /* of the random numbers of the movement, and of the deviations from it */
    const stroke_options *options;
} movement;

struct arm_model {
    const char *name, *about;
    double squiggle_px; /* the largest deviation D of a long line, px of 1/300 inch */
    /* The share of the way that is done at the share tau of the time. */
    double (*progress)(uint64_t key, double tau);
    /* Pushes the inner ones of n control points off the line. */
    void (*deviate)(const movement *m, control *c, size_t n);
    /* An arm whose path is no spline through its control points draws the path by itself; else NULL. */
    bool (*trace)(base_line *b, const stroke *s, double length, const stroke_options *o, path_samples *out);
    /* … and tells how far off the line that path is at each of n control points. */
    void (*follow)(const base_line *b, const stroke *s, double length, const stroke_options *o, control *c, size_t n);
};

/* arms.c: the table. Row i; NULL past the last. */
const arm_model *plb_arm_at(size_t i);
/* The rows, each in a file of its own. */
extern const arm_model plb_arm_hand, plb_arm_jerk, plb_arm_spring, plb_arm_lognormal, plb_arm_torque;

/* movement.c: the control points of a line of `length` mm, whose last point lies `way` from its first (001 section 3.1), by
 * `arm`. Their count, at most CONTROLS_MAX. */
size_t plb_movement_controls(const arm_model *arm, double length, point way, uint64_t identity, const stroke_options *o, control out[CONTROLS_MAX]);
/* Gives the share of the way that an arm has done at the share tau of the time. */
double plb_arm_progress(const arm_model *arm, uint64_t identity, const stroke_options *o, double tau);
/* Gives the largest deviation D in force for a line of `length` mm, mm. */
double plb_arm_squiggle(const arm_model *arm, double length, const stroke_options *o);

/* Several arms share the functions below. This one gives the share of the way that the movement of least jerk has done. */
double plb_minimum_jerk(uint64_t key, double tau);
/* Deviations that do not depend on each other, each uniform in ±D, less near the ends. */
void plb_deviate_freely(const movement *m, control *c, size_t n);
/* Gives the largest deviation at control point k of n. */
double plb_deviation_limit(const movement *m, const control *c, size_t k, size_t n);
/* Adds a bow of the whole movement, `bow` mm high: a parabola, which is an arc of a circle nearly. */
void plb_add_bow(control *c, size_t n, double bow);

/* Tells how far an arc of Plamondon's bows out, as a share -1 to 1 of D (arm_lognormal.c). */
double plb_lognormal_bow(uint64_t key);
/* Tells how far the movement of least change of torque bows out, mm to the left of `way` (arm_torque.c). */
double plb_torque_bow(point way, handedness handed);

#endif
