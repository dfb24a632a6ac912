/* SPDX-License-Identifier: MIT
 *
 * Writes the strokes as paths that follow the arm, not the drawing's own lines. Each stroke is one path, as broad as
 * the pencil's line, and its opacity tells how dark the stroke is: where strokes cross the page is darker, as graphite
 * over graphite is.
 */
#include "api/output/sheet.h"

#include "base/geometry/fit_curves.h"

#include <stdio.h>

/* The curves lie at most so far from the samples of the hand's path, mm: less than any plotter's step. */
#define MAX_ERROR 0.005
/* Opacities have this lower bound, because fainter paths are hardly seen on screens. */
#define FAINTEST 0.05
/* So many strokes are written between two reports of progress. */
#define REPORT_EVERY 64

typedef ARRAY(uint32_t) colour_list;

typedef struct {
    path_samples drawn;
    ARRAY(fit_sample) samples;
    path curves;
} tracer;

static bool is_listed(const colour_list *list, uint32_t colour)
{
    for (size_t i = list->n; i > 0; i--)
        if (list->v[i - 1] == colour)
            return true;
    return false;
}

/* Lists the pencils' colours in the order in which a stroke first needs them. */
static bool list_colours(colour_list *list, const stroke_list *strokes)
{
    uint32_t last = 0;
    for (size_t i = 0; i < strokes->strokes.n; i++) {
        uint32_t colour = strokes->strokes.v[i].style.colour;
        if ((list->n > 0 && colour == last) || is_listed(list, colour))
            continue;
        if (!array_push(list, colour))
            return false;
        last = colour;
    }
    return true;
}

/* Takes the samples to the page, `to_page` times as large as the sheet, without those that lie where the one before lies. */
static bool take_samples(tracer *t, double to_page)
{
    t->samples.n = 0;
    if (!array_reserve(&t->samples, t->drawn.n))
        return false;
    for (size_t i = 0; i < t->drawn.n; i++) {
        const path_sample *s = &t->drawn.v[i];
        if (t->samples.n == 0 || plb_point_distance(s->at, t->drawn.v[i - 1].at) > 0)
            t->samples.v[t->samples.n++] = (fit_sample){point_scale(s->at, to_page), s->tangent, s->along * to_page};
    }
    return true;
}

/* Gives the share of the paper that a line covers at the stroke's mean pressure. */
static double opacity_of(const stroke *s, const path_samples *drawn, const render_context *t)
{
    double pressure = (double)(s->style.pressure > 0 ? s->style.pressure : 1) * (t->stroke.pressure > 0 ? t->stroke.pressure : 1);
    pressure *= (double)(drawn->pressure_first + drawn->pressure_last) / 2;
    double cover = plb_pigment_cover(&t->ink, s->style.colour, plb_profile_centre(t->profile->p)) * pressure;
    return cover < FAINTEST ? FAINTEST : cover > 1 ? 1 : cover;
}

static bool add_stroke(tracer *tr, picture *p, const plb_drawing *d, const stroke *s, const render_context *t, error *err)
{
    if (!plb_path_sample(&d->strokes, s, &t->stroke, &tr->drawn, err))
        return false;
    plb_path_clear(&tr->curves);
    if (!take_samples(tr, 1 / d->reduction))
        return plb_fail_memory(err);
    if (tr->samples.n < 2)
        return true;
    if (!plb_fit_curves(tr->samples.v, tr->samples.n, MAX_ERROR, &tr->curves))
        return plb_fail_memory(err);
    double width = plb_profile_width(t->profile) * (double)s->style.breadth / d->reduction;
    return plb_picture_add_path(p, &tr->curves, width, opacity_of(s, &tr->drawn, t), err);
}

static bool begin_layer(picture *p, uint32_t colour, double reduction, const render_context *t, error *err)
{
    char label[128];
    uint32_t darkest = (uint32_t)t->ink.darkest;
    if (colour)
        snprintf(label, sizeof label, "%s #%06x", plb_profile_name(t->profile), (unsigned)colour);
    else
        snprintf(label, sizeof label, "%s", plb_profile_name(t->profile));
    picture_layer layer = {label, colour ? colour : darkest * 0x10101u, plb_profile_width(t->profile) / reduction};
    return plb_picture_begin_layer(p, &layer, err);
}

bool plb_sheet_trace(picture *p, const plb_drawing *d, const plb_options *o, const render_context *t, error *err)
{
    tracer tr = {0};
    colour_list colours = {0};
    bool ok = list_colours(&colours, &d->strokes) || plb_fail_memory(err);
    size_t n = d->strokes.strokes.n, done = 0;
    for (size_t k = 0; ok && k < colours.n; k++) {
        ok = begin_layer(p, colours.v[k], d->reduction, t, err);
        for (size_t i = 0; ok && i < n; i++) {
            const stroke *s = &d->strokes.strokes.v[i];
            if (s->style.colour != colours.v[k])
                continue;
            ok = (done++ % REPORT_EVERY || plb_api_report(o, PROGRESS_PLANNED + (1 - PROGRESS_PLANNED) * (double)done / (double)n, err)) &&
                 add_stroke(&tr, p, d, s, t, err);
        }
    }
    ok = ok && plb_api_report(o, 1, err);
    array_free(&colours);
    array_free(&tr.drawn);
    array_free(&tr.samples);
    plb_path_free(&tr.curves);
    return ok;
}
