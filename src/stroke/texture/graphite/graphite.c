/* SPDX-License-Identifier: MIT
 *
 * The graphite model draws grain as measured on real lines (plumbago(7)).
 */
#include "base/number/units.h"
#include "stroke/texture/models.h"

/* A stroke no longer than this is a dot: the point is pressed down, not drawn along (chosen by eye). */
#define MAX_DOT_MM 0.25

/* The pencil is lifted only where the line ends, not at a corner; in hatching it comes down while the hand moves already,
 * in lettering it stands still at both ends. */
static grain_ends ends_of(const path_samples *path, const stroke *s, const stroke_options *o)
{
    bool careful = s->style.kind == STROKE_LETTER, even = careful || s->style.kind == STROKE_HATCH;
    double pressure = stroke_pressure(s, o);
    float first = (float)(pressure * (double)path->pressure_first), last = (float)(pressure * (double)path->pressure_last);
    grain_end free_first = path->backward ? GRAIN_LEAVE : GRAIN_START, free_last = path->backward ? GRAIN_START : GRAIN_LEAVE;
    if (path->closed)
        return (grain_ends){GRAIN_JOINT, GRAIN_JOINT, first, last, even, s->style.breadth};
    if (s->style.kind == STROKE_HATCH)
        free_first = free_last = GRAIN_LEAVE;
    bool dot = path->n > 0 && path->v[path->n - 1].along <= MAX_DOT_MM;
    if (dot)
        free_first = free_last = GRAIN_CORNER;
    else if (careful)
        free_first = free_last = GRAIN_START;
    return (grain_ends){s->corner_first ? GRAIN_CORNER : free_first, s->corner_last ? GRAIN_CORNER : free_last, first, last, even, s->style.breadth};
}

/* A grain is always at 300 dpi. */
static bool make(const path_samples *path, const stroke *s, const stroke_options *o, texture_buffers *b, shading *out, error *err)
{
    double dpi = PAPER_PX_PER_INCH, length_px = path->v[path->n - 1].along / MM_PER_INCH * dpi;
    if (!plb_grain_make(&b->grain, length_px, ends_of(path, s, o), o->soft && s->style.is_soft ? o->soft : o->pencil, o->seed, s->identity, err))
        return false;
    *out = plb_grain_shading(&b->grain, dpi, o->dpi);
    return true;
}

const line_model plb_model_graphite = {
    .name = "graphite",
    .about = "as measured on real lines",
    .arm = &plb_arm_hand,
    .is_measured = true,
    .on_paper = true,
    .prepare = plb_pencil_on_paper,
    .make = make,
};
