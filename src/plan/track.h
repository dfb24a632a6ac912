/* SPDX-License-Identifier: MIT
 *
 * A track: one subpath as a polyline, on its way from path to strokes. Each stage of an item's plan takes an array of tracks and
 * gives an array of tracks.
 */
#ifndef PLB_PLAN_TRACK_H
#define PLB_PLAN_TRACK_H

#include "base/array.h"
#include "base/error.h"
#include "base/geometry/geom.h"
#include "list/stroke_list.h"

#include <stdbool.h>

typedef struct {
    point at;    /* mm */
    bool corner; /* the line turns by more than CORNER_DEGREES here; false at the ends */
} track_point;

typedef struct {
    const track_point *v; /* n points, no two neighbours equal; of a closed track, first and last are the same point */
    size_t n, first;      /* … in a list: from this one of its points on */
    bool closed;
    bool corner_first, corner_last; /* an end where another stroke goes on round a corner */
    bool is_outline;                /* of a fill: not drawn where the fill lies upon an area of the same paint */
    bool is_part;                   /* the rest of the track is hidden … */
    bool hidden_first, hidden_last; /* … beyond this end */
    stroke_style style;
    double start; /* arc length from the subpath's beginning to the first point, mm: where its dashes stand */
} track;

/* A track_list holds tracks and the points of all of them, one track after the other. */
typedef struct {
    ARRAY(track) tracks;
    ARRAY(track_point) points;
} track_list;
void plb_tracks_free(track_list *l);
/* Empties the list, keeps its memory and gives the list back. */
track_list *plb_tracks_clear(track_list *l);
/* Gives track i; its points stay where they are until the list grows. */
track plb_track_at(const track_list *l, size_t i);

/* All functions below return false when out of memory. */

/* Begins a track without points, in other respects like `as`. */
bool plb_track_begin(track_list *l, const track *as);
/* Adds a point to the track begun last, unless it is the track's last point already. */
bool plb_track_push(track_list *l, point at, bool corner);
/* Takes the track begun last out of the list. */
void plb_track_drop(track_list *l);
/* Appends a track with its points. */
bool plb_track_copy(track_list *l, const track *t);
/* Gives the track begun last, and its points. */
static inline track *track_last(track_list *l) { return &l->tracks.v[l->tracks.n - 1]; }
static inline track_point *track_last_points(track_list *l) { return l->points.v + track_last(l)->first; }

double plb_track_length(const track *t);
box plb_track_bounds(const track *t);

/* A turn beyond this ends a stroke (chosen by eye: the papers know single lines only). */
#define CORNER_DEGREES 30.0
/* Points closer than this are one. */
#define SAME_POINT_MM 1e-5

#endif
