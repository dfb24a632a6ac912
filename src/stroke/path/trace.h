/* SPDX-License-Identifier: MIT
 *
 * The paths of a free hand.
 */
#ifndef PLB_STROKE_PATH_TRACE_H
#define PLB_STROKE_PATH_TRACE_H

#include "stroke/arm/hand.h"
#include "stroke/path/trajectory.h"

/* straight.c: along a straight line. follow.c: along a curve that the hand knows exactly. curve.c: along a curve that the
 * hand remembers by via points; where the stroke is closed, the path starts at a place of its own, passes that place at the end,
 * and `out` becomes an open path. All return false when out of memory. */
bool plb_trace_line(const base_line *b, double length, const hand *h, path_samples *out);
bool plb_trace_exactly(base_line *b, double length, const hand *h, path_samples *out);
bool plb_trace_curve(const base_line *b, double length, const hand *h, uint64_t identity, const stroke_options *o, path_samples *out);

#endif
