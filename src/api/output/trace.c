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

/* A layer holds the strokes of one pencil: of a colour, or graphite of the pencil that draws or of the soft one. */
typedef struct {
    uint32_t colour;
    bool is_soft;
} layer_key;
typedef ARRAY(layer_key) layer_list;

typedef struct {
    path_samples drawn;
    ARRAY(fit_sample) samples;
    path curves;
    /* The pencil of the layer at work, and its graphite. */
    const plb_profile *pencil;
    const graphite *ink;
} tracer;

static bool is_of(layer_key k, const stroke *s)
{
    return s->style.colour == k.colour && s->style.is_soft == k.is_soft;
}

static bool is_listed(const layer_list *list, const stroke *s)
{
    for (size_t i = list->n; i > 0; i--)
        if (is_of(list->v[i - 1], s))
            return true;
    return false;
}

/* Lists the pencils in the order in which a stroke first needs them. */
static bool list_layers(layer_list *list, const stroke_list *strokes)
{
    for (size_t i = 0; i < strokes->strokes.n; i++) {
        const stroke *s = &strokes->strokes.v[i];
        layer_key k = {s->style.colour, s->style.is_soft};
        if (!is_listed(list, s) && !array_push(list, k))
            return false;
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
static double opacity_of(const tracer *tr, const stroke *s, const path_samples *drawn, const render_context *t)
{
    double pressure = (double)(s->style.pressure > 0 ? s->style.pressure : 1) * (t->stroke.pressure > 0 ? t->stroke.pressure : 1);
    pressure *= (double)(drawn->pressure_first + drawn->pressure_last) / 2;
    double cover = plb_pigment_cover(tr->ink, s->style.colour, plb_profile_centre(tr->pencil->p)) * pressure;
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
    double width = plb_profile_width(tr->pencil) * (double)s->style.breadth / d->reduction;
    return plb_picture_add_path(p, &tr->curves, width, opacity_of(tr, s, &tr->drawn, t), err);
}

static bool begin_layer(picture *p, const tracer *tr, uint32_t colour, double reduction, error *err)
{
    char label[128];
    uint32_t darkest = (uint32_t)tr->ink->darkest;
    if (colour)
        snprintf(label, sizeof label, "%s #%06x", plb_profile_name(tr->pencil), (unsigned)colour);
    else
        snprintf(label, sizeof label, "%s", plb_profile_name(tr->pencil));
    picture_layer layer = {label, colour ? colour : darkest * 0x10101u, plb_profile_width(tr->pencil) / reduction};
    return plb_picture_begin_layer(p, &layer, err);
}

/* Writes the strokes of one pencil; `done` counts those of all. */
static bool trace_layer(tracer *tr, picture *p, const plb_drawing *d, layer_key k, const plb_options *o, const render_context *t, size_t *done, error *err)
{
    size_t n = d->strokes.strokes.n;
    bool ok = begin_layer(p, tr, k.colour, d->reduction, err);
    for (size_t i = 0; ok && i < n; i++) {
        const stroke *s = &d->strokes.strokes.v[i];
        if (is_of(k, s))
            ok = ((*done)++ % REPORT_EVERY || plb_api_report(o, PROGRESS_PLANNED + (1 - PROGRESS_PLANNED) * (double)*done / (double)n, err)) &&
                 add_stroke(tr, p, d, s, t, err);
    }
    return ok;
}

bool plb_sheet_trace(picture *p, const plb_drawing *d, const plb_options *o, const render_context *t, error *err)
{
    tracer tr = {0};
    layer_list layers = {0};
    graphite *soft = d->soft ? plb_new(1, sizeof *soft) : NULL;
    size_t done = 0;
    bool ok = (list_layers(&layers, &d->strokes) && (soft || !d->soft)) || plb_fail_memory(err);
    if (soft)
        plb_graphite_init(soft, d->soft->p);
    for (size_t k = 0; ok && k < layers.n; k++) {
        tr.pencil = layers.v[k].is_soft ? d->soft : t->profile;
        tr.ink = layers.v[k].is_soft ? soft : &t->ink;
        ok = trace_layer(&tr, p, d, layers.v[k], o, t, &done, err);
    }
    ok = ok && plb_api_report(o, 1, err);
    plb_free(soft);
    array_free(&layers);
    array_free(&tr.drawn);
    array_free(&tr.samples);
    plb_path_free(&tr.curves);
    return ok;
}
