/* SPDX-License-Identifier: MIT
 *
 * Draws single lines straight onto the caller's surface.
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

/* Makes a line's identity a hash of its ends and the caller's line_id, as a planned stroke's identity is a hash of its shape. */
static uint64_t identity_of(const point ends[2], uint64_t line_id)
{
    uint64_t h = random_mix(line_id + 1);
    for (int i = 0; i < 2; i++)
        h = random_fold(h, llround(ends[i].x * 1000), llround(ends[i].y * 1000));
    return h | 1;
}

/* Tells whether cairo has an image there that graphite can be laid on. A surface that was finished has lost its pixels,
 * and reports this only once something changes the surface. */
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

static bool check_ends(const double px[4], error *err)
{
    bool sane = fabs(px[0]) < 1e6 && fabs(px[1]) < 1e6 && fabs(px[2]) < 1e6 && fabs(px[3]) < 1e6;
    return sane || plb_fail(err, ERROR_ARGUMENT, "a line's ends must lie within a million pixels");
}

/* A line_tools holds the surface and all that a call draws its lines with. */
typedef struct {
    const render_context *t;
    line_target to;
    stroke_scratch scratch;
    double mm; /* of a pixel */
    double point; /* breadth of a fresh point: each line is drawn with one */
} line_tools;

static bool draw(line_tools *l, const double px[4], uint64_t line_id, error *err)
{
    point ends[2] = {{px[0] * l->mm, px[1] * l->mm}, {px[2] * l->mm, px[3] * l->mm}};
    stroke one = {.style = STROKE_STYLE_USUAL, .identity = identity_of(ends, line_id), .n = 2};
    one.style.breadth = (float)l->point;
    stroke_list list = {.strokes = {&one, 1, 1}, .points = {ends, 2, 2}};
    return plb_point_distance(ends[0], ends[1]) <= 0 || plb_stroke_draw(&list, &one, &l->t->stroke, &l->scratch, lay_on_surface, &l->to, err);
}

static bool draw_all(cairo_surface_t *surface, const double (*ends)[4], size_t n, uint64_t line_id, const plb_options *o, error *err)
{
    render_context t;
    if (!plb_api_context_init(&t, o, err))
        return false;
    line_tools tools = {.t = &t, .to = {surface, &t.ink}, .mm = MM_PER_INCH / o->dpi, .point = plb_api_point(o)};
    bool ok = true;
    for (size_t i = 0; ok && i < n; i++)
        ok = draw(&tools, ends[i], line_id + i, err);
    cairo_surface_mark_dirty(surface);
    plb_stroke_scratch_free(&tools.scratch);
    return ok;
}

bool plb_draw_lines(cairo_surface_t *surface, const double (*ends)[4], size_t n, uint64_t line_id, const plb_options *given, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    plb_options *own;
    const plb_options *o = plb_api_options_checked(given, &own, &err);
    bool ok = o && check_surface(surface, &err);
    for (size_t i = 0; ok && i < n; i++)
        ok = check_ends(ends[i], &err);
    if (ok)
        draw_all(surface, ends, n, line_id, o, &err);
    plb_options_free(own);
    return plb_api_finish(&err, failed);
}

bool plb_draw_line(cairo_surface_t *surface, double x0, double y0, double x1, double y1, uint64_t line_id, const plb_options *o,
                   plb_error *failed)
{
    return plb_draw_lines(surface, (const double[][4]){{x0, y0, x1, y1}}, 1, line_id, o, failed);
}
