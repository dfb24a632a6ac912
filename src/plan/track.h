/* SPDX-License-Identifier: MIT
 *
 * A track: one subpath as a polyline, on its way from path to strokes. Each step of the plan takes tracks and hands
 * on tracks.
 */
#ifndef PLB_PLAN_TRACK_H
#define PLB_PLAN_TRACK_H

#include "base/array.h"
#include "base/error.h"
#include "base/geometry/path.h"
#include "list/display_list.h"
#include "list/stroke_list.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    point at;    /* mm */
    bool corner; /* the line turns by more than CORNER_DEGREES here; false at the ends */
} track_point;

typedef struct {
    ARRAY(track_point) points; /* no two neighbours equal; of a closed track, first and last are the same point */
    bool closed;
    bool corner_first, corner_last; /* an end where another stroke goes on round a corner */
    stroke_style style;
    double start; /* arc length from the subpath's beginning to the first point, mm: where its dashes stand */
} track;

/* Receives a track; it stays the sender's. False stops the work (the receiver has filled its error). */
typedef bool (*track_sink)(void *closure, const track *t);

/* A turn beyond this ends a stroke (chosen by eye: the papers know single lines only). */
#define CORNER_DEGREES 30.0
/* Curves become polylines that keep within this distance of them: half the 0.05 mm that is asked for. */
#define FLATNESS_MM 0.025
/* No vertex inside a flattened curve turns by more than about this, whatever its size. */
#define FLAT_TURN_DEGREES 12.0
/* Points closer than this are one. */
#define SAME_POINT_MM 1e-5

/* flatten.c: subpaths of `p` as tracks, with corners marked; `close` closes open ones, as a fill does. A subpath without
 * length becomes a track of one point. */
bool plb_plan_flatten(const path *p, bool close, track_sink sink, void *closure, error *err);
/* simplify.c: `t` without wiggles finer than a pencil's line of `width` mm. */
bool plb_plan_simplify(const track *t, double width, track_sink sink, void *closure, error *err);
double plb_track_length(const track *t);

/* corner.c: a track cut at its corners; a closed one is first turned to start at a corner. */
bool plb_plan_corners(const track *t, track_sink sink, void *closure, error *err);

#endif
