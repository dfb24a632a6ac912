/* SPDX-License-Identifier: MIT
 *
 * The drawn page as a file or as the caller's cairo surface.
 */
#include "api/render/render.h"

#include "system/output.h"
#include "surface/picture/picture.h"

/* What a picture says of itself. */
typedef struct {
    char software[64], value[3][64];
    const char *text[11];
} labels;

/* The settings that make a stroke what it is; an arm that the model chose is told too. */
static void label(labels *l, const plb_options *o, const render_context *t)
{
    static const char *const names[][2] = {{"seed", "Plumbago-Seed"}, {"pencil", "Plumbago-Pencil"}, {"model", "Plumbago-Model"}};
    snprintf(l->software, sizeof l->software, "Plumbago %s", plb_version());
    const char **to = l->text;
    *to++ = "Software";
    *to++ = l->software;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        plb_options_get(o, names[i][0], l->value[i], sizeof l->value[i]);
        *to++ = names[i][1];
        *to++ = l->value[i];
    }
    *to++ = "Plumbago-Arm";
    *to++ = plb_arm_of(&t->stroke)->name;
    *to = NULL;
}

static bool add_band(void *closure, const page *band, error *err)
{
    return plb_picture_add(closure, band, err);
}

/* Draws into the open file. */
static bool draw_into(FILE *to, const plb_drawing *d, const plb_options *o, picture_options how, const char *name, error *err)
{
    render_context t;
    page_plan plan;
    labels l;
    if (!plb_api_context_init(&t, o, err))
        return false;
    label(&l, o, &t);
    how.text = l.text;
    bool ok = plb_page_plan(d, o, &plan, err);
    if (ok) {
        how.members = plan.members;
        plb_page_plan_rows(&plan, plb_picture_rows(plan.width, &how));
        picture *p = plb_picture_new(plan.width, plan.height, &how, to, name, err);
        ok = p && plb_render(d, o, &t, &plan, add_band, p, err) && plb_picture_end(p, err);
        plb_picture_free(p);
    }
    return ok;
}

static bool write_picture(const plb_drawing *d, const char *file, picture_format format, const plb_options *given, error *err)
{
    const plb_options *o = plb_api_options_for(d, given, err);
    if (!o)
        return false;
    picture_options how = {.format = format, .background = (page_background)o->background, .colour = o->colour, .dpi = o->dpi, .level = o->compress};
    how.width_mm = d->list.width;
    how.height_mm = d->list.height;
    output out;
    if (!plb_output_open(&out, file, err))
        return false;
    if (draw_into(out.to, d, o, how, plb_output_shown(file), err))
        return plb_output_commit(&out, err);
    plb_output_discard(&out);
    return false;
}

bool plb_drawing_write_png(const plb_drawing *d, const char *file, const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    write_picture(d, file, PICTURE_PNG, o, &err);
    return plb_api_finish(&err, failed);
}

bool plb_drawing_write_pdf(const plb_drawing *d, const char *file, const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    write_picture(d, file, PICTURE_PDF, o, &err);
    return plb_api_finish(&err, failed);
}

/* ---- onto a surface ---- */

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
    o = plb_api_options_for(d, o, &err);
    if (o && plb_api_context_init(&t, o, &err))
        result = draw_surface(d, o, &t, &err);
    plb_api_finish(&err, failed);
    return result;
}
