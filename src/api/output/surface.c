/* SPDX-License-Identifier: MIT
 *
 * Draws the page as a new cairo surface for the caller.
 */
#include "api/render/render.h"

typedef struct {
    cairo_surface_t *surface;
    page_background background;
} surface_target;

static bool copy_band(void *closure, const page *band, error *err)
{
    const surface_target *to = closure;
    return plb_page_to_cairo(band, to->background, to->surface) || plb_fail_memory(err);
}

static cairo_surface_t *draw_surface(const plb_drawing *d, const plb_options *o, const render_context *t, error *err)
{
    page_plan plan;
    if (!plb_page_plan(d, o, &plan, err))
        return NULL;
    plb_page_plan_rows(&plan, 1);
    surface_target to = {plb_page_surface_new(plan.width, plan.height, err), (page_background)o->background};
    if (to.surface && plb_render(d, o, t, &plan, copy_band, &to, err))
        return to.surface;
    cairo_surface_destroy(to.surface);
    return NULL;
}

cairo_surface_t *plb_drawing_render(const plb_drawing *d, const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    render_context t;
    cairo_surface_t *result = NULL;
    o = plb_api_options_for(d, o, &(plb_options){0}, &err);
    if (o && plb_api_context_for(&t, d, o, &err))
        result = draw_surface(d, o, &t, &err);
    plb_api_finish(&err, failed);
    return result;
}
