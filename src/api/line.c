/* SPDX-License-Identifier: MIT
 *
 * One line, drawn straight onto the caller's surface.
 */
#include "api/drawing.h"

#include "base/number/random.h"
#include "base/number/units.h"

#include <math.h>

typedef struct {
    cairo_surface_t *surface;
    const graphite *ink;
} line_target;

static bool lay_on_surface(void *closure, const patch *p)
{
    const line_target *to = closure;
    return plb_lay_on_cairo(to->surface, to->ink, p);
}

/* The identity of a line is a hash of its ends and the caller's number, as that of a planned stroke is of its shape. */
static uint64_t identity_of(const point ends[2], uint64_t number)
{
    uint64_t h = random_mix(number + 1);
    for (int i = 0; i < 2; i++)
        h = random_fold(h, llround(ends[i].x * 1000), llround(ends[i].y * 1000));
    return h | 1;
}

bool plb_draw_line(cairo_surface_t *surface, double x0, double y0, double x1, double y1, uint64_t number, const plb_options *o,
                   plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    double mm = MM_PER_INCH / o->dpi;
    point ends[2] = {{x0 * mm, y0 * mm}, {x1 * mm, y1 * mm}};
    bool sane = fabs(x0) < 1e6 && fabs(y0) < 1e6 && fabs(x1) < 1e6 && fabs(y1) < 1e6;
    if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS || cairo_surface_get_type(surface) != CAIRO_SURFACE_TYPE_IMAGE || !sane)
        plb_fail(&err, ERROR_ARGUMENT, "a line needs an image surface and ends within a million pixels");
    render_context t;
    if (err.kind == ERROR_NONE && plb_api_context_init(&t, o, &err)) {
        stroke one = {.style = STROKE_STYLE_USUAL, .identity = identity_of(ends, number), .n = 2};
        stroke_list list = {.strokes = {&one, 1, 1}, .points = {ends, 2, 2}};
        stroke_scratch scratch = {0};
        line_target to = {surface, &t.ink};
        cairo_surface_flush(surface);
        if (plb_point_distance(ends[0], ends[1]) > 0 && !plb_stroke_draw(&list, &one, &t.stroke, &scratch, lay_on_surface, &to, &err))
            plb_fail(&err, ERROR_ARGUMENT, "cairo cannot draw on this surface");
        cairo_surface_mark_dirty(surface);
        plb_stroke_scratch_free(&scratch);
        plb_api_context_free(&t);
    }
    return plb_api_finish(&err, failed);
}
