/* SPDX-License-Identifier: MIT */
#include "plan/track.h"

#include <string.h>

void plb_tracks_free(track_list *l)
{
    array_free(&l->tracks);
    array_free(&l->points);
}

track_list *plb_tracks_clear(track_list *l)
{
    l->tracks.n = l->points.n = 0;
    return l;
}

track plb_track_at(const track_list *l, size_t i)
{
    track t = l->tracks.v[i];
    t.v = l->points.v + t.first;
    return t;
}

bool plb_track_begin(track_list *l, const track *as)
{
    track t = *as;
    t.v = NULL;
    t.n = 0;
    t.first = l->points.n;
    return array_push(&l->tracks, t);
}

bool plb_track_push(track_list *l, point at, bool corner)
{
    track *t = track_last(l);
    if (t->n && plb_point_distance(l->points.v[l->points.n - 1].at, at) < SAME_POINT_MM)
        return true;
    track_point p = {at, corner};
    t->n++;
    return array_push(&l->points, p);
}

void plb_track_drop(track_list *l)
{
    l->points.n = track_last(l)->first;
    l->tracks.n--;
}

bool plb_track_copy(track_list *l, const track *t)
{
    if (!plb_track_begin(l, t) || !array_reserve(&l->points, t->n))
        return false;
    memcpy(l->points.v + l->points.n, t->v, t->n * sizeof *t->v);
    l->points.n += t->n;
    track_last(l)->n = t->n;
    return true;
}

double plb_track_length(const track *t)
{
    double sum = 0;
    for (size_t i = 1; i < t->n; i++)
        sum += plb_point_distance(t->v[i - 1].at, t->v[i].at);
    return sum;
}

box plb_track_bounds(const track *t)
{
    box b = BOX_EMPTY;
    for (size_t i = 0; i < t->n; i++)
        plb_box_add(&b, t->v[i].at);
    return b;
}
