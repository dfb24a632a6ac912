/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 2, the free hand along a straight line, by far the commonest stroke: all in the line's own frame.
 * Input: the two ends, mm, and how the hand deviates. Output: samples of the path.
 */
#include "stroke/path/trace.h"

#include <math.h>

/* The path's bends grow with the length less than the length does: samples this far apart, times the root of the
 * length, keep the straight pieces between them within 0.005 mm of it (the modes' curvature: plumbago(7)). */
#define STEP_OF_ROOT 0.22
#define LONGEST_STEP_MM 1.5
#define MIN_LINE_STEPS 4
/* A hook has samples of its own, fewer when it hardly shows. */
#define HOOK_STEPS 4
#define HOOK_SHOWS_MM 0.05

typedef struct {
    point from, along, left;
    const hand *h;
    path_samples *out;
} line_frame;

static int steps_of(double hook)
{
    return fabs(hook) > HOOK_SHOWS_MM ? HOOK_STEPS : HOOK_STEPS / 2;
}

static void add(const line_frame *l, double along)
{
    double off = plb_hand_off(l->h, along);
    l->out->v[l->out->n++].at =
        (point){l->from.x + along * l->along.x + off * l->left.x, l->from.y + along * l->along.y + off * l->left.y};
}

bool plb_trace_line(const base_line *b, double length, const hand *h, path_samples *out)
{
    point along = point_scale(point_sub(b->v[1], b->v[0]), 1 / length);
    line_frame l = {b->v[0], along, {along.y, -along.x}, h, out};
    double step = STEP_OF_ROOT * sqrt(length / fmax(h->strength, 0.1)), n = ceil(length / fmin(step, LONGEST_STEP_MM));
    size_t steps = n < MIN_LINE_STEPS ? MIN_LINE_STEPS : (size_t)n;
    double inner = length - 2 * h->hook_reach;
    if (!array_reserve(out, steps + 2 * HOOK_STEPS + 1))
        return false;
    int first = h->hook_reach > 0 ? steps_of(h->hook_first) : 0, last = h->hook_reach > 0 ? steps_of(h->hook_last) : 0;
    for (int i = 0; i < first; i++)
        add(&l, h->hook_reach * i / first);
    for (size_t i = 0; i <= steps; i++)
        add(&l, h->hook_reach + inner * (double)i / (double)steps);
    for (int i = 1; i <= last; i++)
        add(&l, length - h->hook_reach * (last - i) / last);
    plb_path_measure(out, false);
    return true;
}
