/* SPDX-License-Identifier: MIT
 *
 * Shows what the stages made: the display list and the strokes as text, the paths and control points as a picture.
 */
#include "api/pipeline.h"

#include "list/text/list_write.h"
#include "system/output.h"
#include "surface/picture/picture.h"
#include "surface/plot/controls.h"

#include <errno.h>
#include <string.h>

/* Adds a path of the sheet, which is `to_page` times as large on the page. */
static bool add_path(controls_picture *c, const path_samples *drawn, double to_page, error *err)
{
    ARRAY(point) at = {0};
    bool ok = array_reserve(&at, drawn->n);
    for (size_t i = 0; ok && i < drawn->n; i++)
        at.v[at.n++] = point_scale(drawn->v[i].at, to_page);
    if (ok)
        plb_controls_add_path(c, at.v, at.n);
    array_free(&at);
    return ok || plb_fail_memory(err);
}

static bool fill_picture(controls_picture *c, const plb_drawing *d, const stroke_options *o, error *err)
{
    const stroke_list *list = &d->strokes;
    double to_page = 1 / d->reduction;
    path_samples drawn = {0};
    bool ok = true;
    for (size_t i = 0; ok && i < list->strokes.n; i++)
        ok = plb_path_sample(list, &list->strokes.v[i], o, &drawn, err) && add_path(c, &drawn, to_page, err);
    for (size_t i = 0; ok && i < list->strokes.n; i++) {
        point dots[CONTROLS_MAX];
        size_t n = plb_path_control_points(list, &list->strokes.v[i], o, dots);
        for (size_t k = 0; k < n; k++)
            dots[k] = point_scale(dots[k], to_page);
        plb_controls_add_dots(c, dots, n);
    }
    array_free(&drawn);
    return ok;
}

static bool write_controls(const plb_drawing *d, const plb_options *o, FILE *to, const char *file, error *err)
{
    render_context t;
    if (!plb_api_context_for(&t, d, o, err))
        return false;
    controls_picture *c = plb_controls_new(d->list.width, d->list.height, o->dpi, err);
    bool ok = c && fill_picture(c, d, &t.stroke, err) && plb_controls_write(c, to, plb_output_shown(file), err);
    plb_controls_free(c);
    return ok;
}

static bool print_strokes(const plb_drawing *d, FILE *to)
{
    stroke_list on_page = plb_api_strokes_on_page(d);
    return plb_stroke_list_print(&on_page, to);
}

static bool write_text(bool ok, const char *file, error *err)
{
    return ok || plb_fail(err, ERROR_FILE, "%s: cannot be written: %s", plb_output_shown(file), strerror(errno));
}

bool plb_drawing_dump(const plb_drawing *d, plb_dump what, const char *file, const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    output out;
    if (what > PLB_DUMP_CONTROLS) {
        plb_fail(&err, ERROR_ARGUMENT, "there is no such dump");
        return plb_api_finish(&err, failed);
    }
    o = plb_api_options_for(d, o, &(plb_options){0}, &err);
    bool ok = o && (what != PLB_DUMP_CONTROLS || plb_picture_format_suits(plb_picture_format_named("png"), file, &err)) && plb_output_open(&out, file, &err);
    if (ok) {
        switch (what) {
        case PLB_DUMP_LIST: ok = write_text(plb_list_print(&d->list, out.to), file, &err); break;
        case PLB_DUMP_STROKES: ok = write_text(print_strokes(d, out.to), file, &err); break;
        case PLB_DUMP_CONTROLS: ok = write_controls(d, o, out.to, file, &err); break;
        }
        if (ok)
            plb_output_commit(&out, &err);
        else
            plb_output_discard(&out);
    }
    return plb_api_finish(&err, failed);
}
