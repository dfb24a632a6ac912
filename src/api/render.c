/* SPDX-License-Identifier: MIT
 *
 * From strokes to a picture: each stroke's patches are laid on the page, and the page is written.
 */
#include "api/drawing.h"

#include "base/output.h"
#include "base/random.h"
#include "base/units.h"

#include <math.h>
#include <string.h>

/* The caller hears of progress every so many strokes. */
#define PROGRESS_STRIDE 256

static bool lay(void *closure, const patch *p)
{
    plb_page_lay(closure, p);
    return true;
}

static void report(const plb_options *o, double done)
{
    if (o->progress)
        o->progress(o->closure, done);
}

static bool draw_strokes(const plb_drawing *d, const plb_options *o, const drawing_tools *t, page *to, error *err)
{
    double px = o->dpi / MM_PER_INCH;
    if (!plb_page_init(to, d->list.width * px, d->list.height * px, &t->ink, err))
        return false;
    stroke_scratch scratch = {0};
    bool ok = true;
    for (size_t i = 0; ok && i < d->strokes.strokes.n; i++) {
        if (i % PROGRESS_STRIDE == 0)
            report(o, (double)i / (double)d->strokes.strokes.n);
        ok = plb_stroke_draw(&d->strokes, &d->strokes.strokes.v[i], &t->stroke, &scratch, lay, to, err);
    }
    plb_stroke_scratch_free(&scratch);
    report(o, 1);
    return ok;
}

/* Draws all strokes onto a new page. */
static bool draw(const plb_drawing *d, const plb_options *o, const drawing_tools *t, page *to, error *err)
{
    error why = {ERROR_NONE, ""};
    return draw_strokes(d, o, t, to, &why) || plb_fail(err, why.kind, "%s: %s", d->name, why.text);
}

static bool write_page(const page *p, const plb_options *o, const drawing_tools *t, const char *file, error *err)
{
    static const char *const arms[] = {"", "hand", "jerk", "spring"};
    char seed[32], software[64];
    snprintf(seed, sizeof seed, "%llu", (unsigned long long)o->seed);
    snprintf(software, sizeof software, "Plumbago %s", plb_version());
    const char *text[] = {"Software", software, "Plumbago-Seed", seed, "Plumbago-Pencil", plb_profile_name(t->profile),
                          "Plumbago-Model", o->model == PLB_MODEL_HLA ? "hla" : "graphite", "Plumbago-Arm",
                          arms[plb_api_arm(o)], NULL};
    png_options png = {o->background == PLB_BACKGROUND_NONE ? PAGE_TRANSPARENT : PAGE_WHITE, o->dpi, text};
    output out;
    if (!plb_output_open(&out, file, err))
        return false;
    if (plb_page_write_png(p, &png, out.to, plb_output_shown(file), err))
        return plb_output_commit(&out, err);
    plb_output_discard(&out);
    return false;
}

bool plb_drawing_write_png(const plb_drawing *d, const char *file, const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    drawing_tools t;
    page p = {0};
    if (plb_api_tools_init(&t, o, &err)) {
        if (draw(d, o, &t, &p, &err))
            write_page(&p, o, &t, file, &err);
        plb_page_free(&p);
        plb_api_tools_free(&t);
    }
    return plb_api_finish(&err, failed);
}

cairo_surface_t *plb_drawing_render(const plb_drawing *d, const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    drawing_tools t;
    page p = {0};
    cairo_surface_t *result = NULL;
    if (plb_api_tools_init(&t, o, &err)) {
        if (draw(d, o, &t, &p, &err))
            result = plb_page_to_cairo(&p, o->background == PLB_BACKGROUND_NONE ? PAGE_TRANSPARENT : PAGE_WHITE, &err);
        plb_page_free(&p);
        plb_api_tools_free(&t);
    }
    plb_api_finish(&err, failed);
    return result;
}

/* ---- one line ---- */

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
    drawing_tools t;
    if (err.kind == ERROR_NONE && plb_api_tools_init(&t, o, &err)) {
        stroke one = {.touch = TOUCH_USUAL, .identity = identity_of(ends, number), .n = 2};
        stroke_list list = {.strokes = {&one, 1, 1}, .points = {ends, 2, 2}};
        stroke_scratch scratch = {0};
        line_target to = {surface, &t.ink};
        cairo_surface_flush(surface);
        if (plb_point_distance(ends[0], ends[1]) > 0 && !plb_stroke_draw(&list, &one, &t.stroke, &scratch, lay_on_surface, &to, &err))
            plb_fail(&err, ERROR_ARGUMENT, "cairo cannot draw on this surface");
        cairo_surface_mark_dirty(surface);
        plb_stroke_scratch_free(&scratch);
        plb_api_tools_free(&t);
    }
    return plb_api_finish(&err, failed);
}
