/* SPDX-License-Identifier: MIT
 *
 * See sheet.h.
 */
#include "api/output/sheet.h"

#include "api/render/render.h"
#include "base/number/number.h"

#include <errno.h>

/* These texts say in a picture what made it. */
typedef struct {
    char software[64], value[3][64], reduction[48];
    const char *text[13];
} labels;

/* Lists the settings that make a stroke what it is; an arm that the model chose is named too. */
static void label(labels *l, const plb_drawing *d, const plb_options *o, const render_context *t)
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
    *to++ = "Plumbago-Reduction";
    *to++ = plb_format_number(l->reduction, d->reduction, 3);
    *to++ = "Plumbago-Arm";
    *to++ = plb_arm_of(&t->stroke)->name;
    *to = NULL;
}

static bool add_band(void *closure, const page *band, error *err)
{
    return plb_picture_add(closure, band, err);
}

static picture_page page_of(const plb_drawing *d, const plb_options *o, const page_plan *plan, const labels *l)
{
    return (picture_page){.width = plan->width, .height = plan->height, .background = (page_background)o->background, .colour = o->colour, .dpi = o->dpi,
                          .width_mm = d->list.width, .height_mm = d->list.height, .level = o->compress, .members = plan->members, .text = l->text};
}

bool plb_sheet_write(picture *p, const picture_format *f, const plb_drawing *d, const plb_options *o, error *err)
{
    render_context t;
    page_plan plan = {0};
    labels l;
    bool paths = plb_picture_format_has_paths(f);
    if (!plb_api_context_for(&t, d, o, err) || !(paths || plb_page_plan(d, o, &plan, err)))
        return false;
    label(&l, d, o, &t);
    picture_page sheet = page_of(d, o, &plan, &l);
    if (!plb_picture_begin_page(p, &sheet, err))
        return false;
    if (!paths)
        plb_page_plan_rows(&plan, plb_picture_rows(f, &sheet));
    bool ok = paths ? plb_sheet_trace(p, d, o, &t, err) : plb_render(d, o, &t, &plan, add_band, p, err);
    return ok && plb_picture_end_page(p, err);
}

bool plb_sheet_write_file(const byte_sink *to, const char *name, const picture_format *f, const plb_drawing *d, const plb_options *o, error *err)
{
    picture *p = plb_picture_new(f, to, name, false, err);
    bool ok = p && plb_sheet_write(p, f, d, o, err) && plb_picture_end(p, err);
    plb_picture_free(p);
    return ok;
}

static bool put_in_stream(void *closure, const void *data, size_t n)
{
    errno = 0;
    return fwrite(data, 1, n, closure) == n;
}

byte_sink plb_sheet_stream(FILE *to)
{
    return (byte_sink){put_in_stream, to};
}
