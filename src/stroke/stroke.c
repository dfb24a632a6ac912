/* SPDX-License-Identifier: MIT
 *
 * One stroke: the stages in order.
 */
#include "stroke/stroke.h"

#include "base/geometry/interpolate.h"
#include "base/number/units.h"
#include "stroke/pencil.h"

#include <math.h>

/* Rows beyond this are on no page. */
#define MAX_ROWS 1e8

void plb_stroke_scratch_free(stroke_scratch *s)
{
    array_free(&s->path);
    plb_strip_free(&s->strip);
    plb_grain_free(&s->grain);
    plb_free(s->map.fine);
    s->map = (map_room){0};
}

bool plb_texture(strip *s, double length_px, bool closed, const pencil *p, uint64_t seed, uint64_t identity, error *err)
{
    if (!plb_texture_fill(s, length_px, p, seed, identity, err))
        return false;
    plb_texture_ccm(s, p, NULL);
    if (closed)
        plb_texture_wrap(s);
    plb_texture_blur(s);
    if (closed)
        plb_texture_wrap(s);
    return true;
}

static double pressure_of(const stroke *s, const stroke_options *o)
{
    double own = s->style.pressure > 0 ? (double)s->style.pressure : 1;
    return o->pressure > 0 ? own * o->pressure : own;
}

/* A stroke no longer than this is a dot: the point is pressed down, not drawn along (chosen by eye). */
#define DOT_MM 0.25

/* The pencil is lifted only where the line ends, not at a corner; in hatching it comes down while the hand moves already,
 * in lettering it stands still at both ends. */
static grain_ends ends_of(const path_samples *path, const stroke *s, const stroke_options *o)
{
    bool careful = s->style.kind == STROKE_LETTER;
    double pressure = pressure_of(s, o);
    float first = (float)(pressure * (double)path->pressure_first), last = (float)(pressure * (double)path->pressure_last);
    grain_end free_first = path->backward ? GRAIN_LEAVE : GRAIN_START, free_last = path->backward ? GRAIN_START : GRAIN_LEAVE;
    if (path->closed)
        return (grain_ends){GRAIN_JOINT, GRAIN_JOINT, first, last, careful};
    if (s->style.kind == STROKE_HATCH)
        free_first = free_last = GRAIN_LEAVE;
    bool dot = path->n > 0 && path->v[path->n - 1].along <= DOT_MM;
    if (dot)
        free_first = free_last = GRAIN_CORNER;
    else if (careful)
        free_first = free_last = GRAIN_START;
    return (grain_ends){s->corner_first ? GRAIN_CORNER : free_first, s->corner_last ? GRAIN_CORNER : free_last, first, last, careful};
}

bool plb_stroke_draw(const stroke_list *list, const stroke *s, const stroke_options *o, stroke_scratch *scratch, patch_sink sink,
                     void *closure, error *err)
{
    path_samples *path = &scratch->path;
    double dpi = o->model == MODEL_GRAPHITE ? PAPER_PX_PER_INCH : o->pencil->profile->dpi; /* a grain is always at 300 dpi */
    if (!plb_path_sample(list, s, o, path, err))
        return false;
    if (path->n < 2)
        return true;
    double length_px = path->v[path->n - 1].along / MM_PER_INCH * dpi;
    shading texture;
    if (o->model == MODEL_GRAPHITE) {
        if (!plb_grain_make(&scratch->grain, length_px, ends_of(path, s, o), o->pencil, o->seed, s->identity, err))
            return false;
        texture = plb_grain_shading(&scratch->grain, dpi, o->dpi);
    } else {
        if (!plb_texture(&scratch->strip, length_px, s->closed, o->pencil, o->seed, s->identity, err))
            return false;
        if (pressure_of(s, o) != 1) /* at the usual one they are the papers' greys, bit for bit */
            plb_strip_press(&scratch->strip, pressure_of(s, o));
        texture = plb_strip_shading(&scratch->strip, dpi);
    }
    map_page page = {o->dpi, o->clip_top, o->clip_bottom};
    return plb_strip_map(&texture, &page, path, path->closed, &scratch->map, sink, closure) || plb_fail_memory(err);
}

bool plb_stroke_rows(const stroke_list *list, const stroke *s, const stroke_options *o, stroke_scratch *scratch, int *top, int *foot,
                     error *err)
{
    path_samples *path = &scratch->path;
    if (!plb_path_sample(list, s, o, path, err))
        return false;
    double low = path->n ? path->v[0].at.y : 0, high = low, px = o->dpi / MM_PER_INCH;
    for (size_t i = 1; i < path->n; i++) {
        low = fmin(low, path->v[i].at.y);
        high = fmax(high, path->v[i].at.y);
    }
    *top = (int)clamp(floor((low - STROKE_REACH_MM) * px) - 1, -MAX_ROWS, MAX_ROWS);
    *foot = (int)clamp(ceil((high + STROKE_REACH_MM) * px) + 1, -MAX_ROWS, MAX_ROWS);
    return true;
}
