/* SPDX-License-Identifier: MIT
 *
 * One stroke: the stages in order.
 */
#include "stroke/stroke.h"

#include "base/geometry/interpolate.h"
#include "base/number/units.h"

#include <math.h>

/* Rows beyond this are on no page. */
#define MAX_ROWS 1e8

void plb_stroke_scratch_free(stroke_scratch *s)
{
    array_free(&s->path);
    plb_texture_buffers_free(&s->texture);
    plb_free(s->map.fine);
    s->map = (map_buffer){0};
}

bool plb_stroke_draw(const stroke_list *list, const stroke *s, const stroke_options *o, stroke_scratch *scratch, patch_sink sink,
                     void *closure, error *err)
{
    path_samples *path = &scratch->path;
    shading texture;
    if (!plb_path_sample(list, s, o, path, err))
        return false;
    if (path->n < 2)
        return true;
    if (!plb_model_of(o)->make(path, s, o, &scratch->texture, &texture, err))
        return false;
    map_page page = {o->dpi, o->clip_top, o->clip_bottom};
    return plb_strip_map(&texture, &page, path, path->closed, &scratch->map, sink, closure) || plb_fail_memory(err);
}

bool plb_stroke_rows(const stroke_list *list, const stroke *s, const stroke_options *o, stroke_scratch *scratch, int *top, int *bottom,
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
    *bottom = (int)clamp(ceil((high + STROKE_REACH_MM) * px) + 1, -MAX_ROWS, MAX_ROWS);
    return true;
}
