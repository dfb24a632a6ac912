/* SPDX-License-Identifier: MIT
 *
 * One line, drawn straight onto the caller's surface.
 */
#include "api/pipeline.h"

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
    plb_lay_on_cairo(to->surface, to->ink, p);
    return true;
}

/* The identity of a line is a hash of its ends and the caller's number, as that of a planned stroke is of its shape. */
static uint64_t identity_of(const point ends[2], uint64_t number)
{
    uint64_t h = random_mix(number + 1);
    for (int i = 0; i < 2; i++)
        h = random_fold(h, llround(ends[i].x * 1000), llround(ends[i].y * 1000));
    return h | 1;
}

/* Whether cairo has an image there that graphite can be laid on. A surface that was finished has lost its pixels, and says so
 * only once it is to be changed. */
static bool check_surface(cairo_surface_t *surface, error *err)
{
    if (!surface || cairo_surface_get_type(surface) != CAIRO_SURFACE_TYPE_IMAGE)
        return plb_fail(err, ERROR_ARGUMENT, "a line needs an image surface");
    cairo_surface_flush(surface);
    cairo_surface_mark_dirty(surface);
    cairo_status_t status = cairo_surface_status(surface);
    if (status != CAIRO_STATUS_SUCCESS)
        return plb_fail(err, ERROR_ARGUMENT, "the surface cannot be drawn on: %s", cairo_status_to_string(status));
    cairo_format_t format = cairo_image_surface_get_format(surface);
    if (format != CAIRO_FORMAT_ARGB32 && format != CAIRO_FORMAT_RGB24 && format != CAIRO_FORMAT_A8)
        return plb_fail(err, ERROR_ARGUMENT, "a surface for lines has the format ARGB32, RGB24 or A8");
    return true;
}

static bool check_ends(const point ends[2], error *err)
{
    bool sane = fabs(ends[0].x) < 1e6 && fabs(ends[0].y) < 1e6 && fabs(ends[1].x) < 1e6 && fabs(ends[1].y) < 1e6;
    return sane || plb_fail(err, ERROR_ARGUMENT, "a line's ends must lie within a million pixels");
}

/* `ends`: mm. */
static bool draw(cairo_surface_t *surface, const point ends[2], uint64_t number, const render_context *t, error *err)
{
    point at[2] = {ends[0], ends[1]};
    stroke one = {.style = STROKE_STYLE_USUAL, .identity = identity_of(ends, number), .n = 2};
    stroke_list list = {.strokes = {&one, 1, 1}, .points = {at, 2, 2}};
    stroke_scratch scratch = {0};
    line_target to = {surface, &t->ink};
    bool ok = plb_point_distance(ends[0], ends[1]) <= 0 || plb_stroke_draw(&list, &one, &t->stroke, &scratch, lay_on_surface, &to, err);
    cairo_surface_mark_dirty(surface);
    plb_stroke_scratch_free(&scratch);
    return ok;
}

bool plb_draw_line(cairo_surface_t *surface, double x0, double y0, double x1, double y1, uint64_t number, const plb_options *o,
                   plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    render_context t;
    point px[2] = {{x0, y0}, {x1, y1}};
    if (check_surface(surface, &err) && check_ends(px, &err) && plb_api_context_init(&t, o, &err)) {
        double mm = MM_PER_INCH / o->dpi;
        draw(surface, (point[]){{x0 * mm, y0 * mm}, {x1 * mm, y1 * mm}}, number, &t, &err);
    }
    return plb_api_finish(&err, failed);
}
