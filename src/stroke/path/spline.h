/* SPDX-License-Identifier: MIT
 *
 * The papers' path: a spline through the control points of an arm.
 */
#ifndef PLB_STROKE_PATH_SPLINE_H
#define PLB_STROKE_PATH_SPLINE_H

#include "stroke/arm/arm.h"

/* Computes the spline's path of a line of `length` mm. False when out of memory. */
bool plb_path_spline(base_line *b, const arm_model *arm, const stroke *s, double length, const stroke_options *o, path_samples *out);
/* Gives the path's control points in the line's own frame; their count. */
size_t plb_path_spline_controls(const arm_model *arm, double length, point way, const stroke *s, const stroke_options *o, control c[CONTROLS_MAX]);

#endif
