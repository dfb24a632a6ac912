/* SPDX-License-Identifier: MIT
 *
 * The direction in which a shape is hatched. One direction serves all shapes of about the same tone, so that a map or a chart does not
 * become a patchwork: the long axis that most of them share, or else the way a right hand hatches by habit.
 */
#include "plan/hatch/hatch.h"

#include "plan/hatch/hatch_tone.h"

#include <math.h>

/* A shared axis is the mean of those of the shapes, weighted by their outlines' lengths, when they agree this well: the length of the
 * mean vector of doubled angles (chosen by eye). */
#define AGREEMENT 0.7

/* Sums over the outline as a wire: of its pieces' lengths, and of their middles' moments. */
typedef struct {
    double length, x, y, xx, xy, yy;
} wire;

static void add_piece(wire *w, point a, point b)
{
    double l = plb_point_distance(a, b), x = (a.x + b.x) / 2, y = (a.y + b.y) / 2;
    point d = {(b.x - a.x) / 2, (b.y - a.y) / 2}; /* a piece is a wire itself */
    w->length += l;
    w->x += l * x;
    w->y += l * y;
    w->xx += l * (x * x + d.x * d.x / 3);
    w->xy += l * (x * y + d.x * d.y / 3);
    w->yy += l * (y * y + d.y * d.y / 3);
}

/* The control polygon stands for the outline: near enough for a direction. */
static wire wire_of(const path *p)
{
    wire w = {0};
    const point *at = p->points.v;
    point first = {0, 0};
    for (size_t i = 0; i < p->ops.n; i++)
        switch (p->ops.v[i]) {
        case PATH_MOVE: first = *at++; break;
        case PATH_LINE: add_piece(&w, at[-1], at[0]); at++; break;
        case PATH_CURVE: add_piece(&w, at[-1], at[0]), add_piece(&w, at[0], at[1]), add_piece(&w, at[1], at[2]); at += 3; break;
        default: add_piece(&w, at[-1], first); break;
        }
    return w;
}

static hatch_family *family_of(hatcher *h, const paint *p)
{
    return &h->families[(int)(plb_paint_darkness(p, false) * (HATCH_FAMILIES - 1) + 0.5)];
}

void plb_hatch_direction_learn(hatcher *h, const item *fill)
{
    wire w = wire_of(&fill->path);
    if (!(w.length > 0) || fill->is_directed)
        return;
    double x = w.x / w.length, y = w.y / w.length;
    double xx = w.xx / w.length - x * x, yy = w.yy / w.length - y * y, xy = w.xy / w.length - x * y;
    double middle = (xx + yy) / 2, apart = sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
    hatch_family *f = family_of(h, &fill->paint);
    f->weight += w.length;
    if (middle + apart > LONG_ELONGATION * LONG_ELONGATION * (middle - apart)) {
        f->cosine += w.length * (xx - yy) / 2 / apart;
        f->sine += w.length * xy / apart;
    }
}

double plb_hatch_direction(const hatcher *h, const item *fill)
{
    if (fill->is_directed)
        return fill->direction * PLB_PI / 180;
    const hatch_family *f = family_of((hatcher *)h, &fill->paint);
    if (f->weight > 0 && sqrt(f->cosine * f->cosine + f->sine * f->sine) > AGREEMENT * f->weight)
        return atan2(f->sine, f->cosine) / 2;
    return HATCH_HABIT;
}
