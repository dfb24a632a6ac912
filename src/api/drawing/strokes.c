/* SPDX-License-Identifier: MIT
 *
 * This file gives the strokes of a drawing one at a time: the line that is meant, and the path that the hand makes of
 * it.
 */
#include "api/pipeline.h"

/* The callers' types and the library's have the same layout and values. */
_Static_assert(sizeof(plb_point) == sizeof(point), "plb_point and point must agree");
_Static_assert((int)PLB_STROKE_LINE == STROKE_LINE && (int)PLB_STROKE_HATCH == STROKE_HATCH && (int)PLB_STROKE_LETTER == STROKE_LETTER &&
                   (int)PLB_STROKE_GUIDE == STROKE_GUIDE,
               "plb_stroke_kind and stroke_kind must agree");

bool plb_drawing_stroke(const plb_drawing *d, size_t index, plb_stroke *out)
{
    if (index >= d->strokes.strokes.n)
        return false;
    const stroke *s = &d->strokes.strokes.v[index];
    stroke_list on_page = plb_api_strokes_on_page(d);
    *out = (plb_stroke){.kind = (plb_stroke_kind)s->style.kind, .pressure = (double)s->style.pressure, .colour = s->style.colour, .closed = s->closed,
                        .width = plb_profile_width(s->style.is_soft ? d->soft : d->options->profile) * (double)s->style.breadth / d->reduction, .n = s->n, .points = (const plb_point *)(const void *)(on_page.points.v + s->first)};
    return true;
}

static plb_point *trace(const plb_drawing *d, size_t index, size_t *n, const plb_options *o, error *err)
{
    render_context t;
    path_samples drawn = {0};
    plb_point *points = NULL;
    if (!plb_api_context_for(&t, d, o, err))
        return NULL;
    if (plb_path_sample(&d->strokes, &d->strokes.strokes.v[index], &t.stroke, &drawn, err)) {
        points = plb_new(drawn.n + 1, sizeof *points);
        if (!points)
            plb_fail_memory(err);
        for (size_t i = 0; points && i < drawn.n; i++)
            points[i] = (plb_point){drawn.v[i].at.x / d->reduction, drawn.v[i].at.y / d->reduction};
        *n = points ? drawn.n : 0;
    }
    array_free(&drawn);
    return points;
}

plb_point *plb_drawing_trace(const plb_drawing *d, size_t index, size_t *n, const plb_options *given, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    const plb_options *o = plb_api_options_for(d, given, &(plb_options){0}, &err);
    plb_point *points = NULL;
    *n = 0;
    if (o && index >= d->strokes.strokes.n)
        plb_fail(&err, ERROR_ARGUMENT, "%s: there is no stroke %zu", d->name, index);
    else if (o)
        points = trace(d, index, n, o, &err);
    plb_api_finish(&err, failed);
    return points;
}
