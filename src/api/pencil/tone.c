/* SPDX-License-Identifier: MIT
 *
 * Measures the scale of tones (tone.h). A swatch is planned and drawn like any fill, once for each technique from faint
 * to dark, and its mean darkness is read in the middle. So a tone is met with any pencil, paper, pressure or model.
 */
#include "api/pencil/tone.h"

#include "base/number/units.h"
#include "plan/hatch/hatch.h"
#include "plan/hatch/hatch_tone.h"

#include <math.h>

/* Swatches of a measurement that a drawing waits for: their side, mm, and a coarse resolution, because only the mean counts. */
#define SWATCH_SIDE 14.0
#define SWATCH_DPI 100.0
/* A margin of so many mm is not measured: there ends stray, and the outline runs. */
#define SWATCH_EDGE 0.8
/* Each step is darker than the one before by at least so much, even where a swatch came out lighter by chance. */
#define MIN_STEP 0.004
/* All swatches have this seed: the scale belongs to the pencil, not to the drawing. */
#define SWATCH_SEED 1

bool plb_api_needs_tone(const display_list *list, const plan_options *options)
{
    if (options->fill == FILL_HATCH && plb_cells_may_be(list))
        return true;
    for (size_t i = 0; options->fill == FILL_HATCH && i < list->items.n; i++) {
        const item *it = &list->items.v[i];
        if (it->kind == ITEM_FILL && plb_may_be_hatched(it, options))
            return true;
    }
    return false;
}

/* ---- a swatch ---- */

typedef struct {
    uint16_t *deposit; /* side x side */
    int side;          /* px */
    double dpi;
    const graphite *ink;
} swatch;

static bool lay(void *closure, const patch *p)
{
    swatch *s = closure;
    for (int y = 0; y < p->height; y++)
        for (int x = 0; x < p->width; x++) {
            int at_x = p->x + x, at_y = p->y + y;
            if (at_x < 0 || at_y < 0 || at_x >= s->side || at_y >= s->side)
                continue;
            uint16_t *to = &s->deposit[at_y * s->side + at_x];
            unsigned sum = *to + (unsigned)s->ink->deposit[p->grey[y * p->width + x]];
            *to = (uint16_t)(sum > 65535 ? 65535 : sum);
        }
    return true;
}

static double mean_darkness(const swatch *s)
{
    int edge = (int)ceil(SWATCH_EDGE / MM_PER_INCH * s->dpi);
    double sum = 0, n = 0;
    for (int y = edge; y < s->side - edge; y++)
        for (int x = edge; x < s->side - edge; x++) {
            sum += 255 - s->ink->grey[s->deposit[y * s->side + x]];
            n++;
        }
    return n > 0 ? sum / n / 255 : 0;
}

static bool draw_strokes(const stroke_list *strokes, const render_context *t, swatch *s, error *err)
{
    stroke_options options = t->stroke;
    stroke_scratch scratch = {0};
    bool ok = true;
    options.dpi = s->dpi;
    options.seed = SWATCH_SEED;
    for (size_t i = 0; ok && i < strokes->strokes.n; i++)
        ok = plb_stroke_draw(strokes, &strokes->strokes.v[i], &options, &scratch, lay, s, err);
    plb_stroke_scratch_free(&scratch);
    return ok;
}

/* Plans the strokes of a page of `side` mm that is filled with a grey. */
static bool plan_swatch(double side, double darkness, const plan_options *options, stroke_list *out, error *err)
{
    display_list list;
    double grey = 1 - darkness;
    item it = {.kind = ITEM_FILL, .paint = {PAINT_SOLID, grey, grey, grey, 1}, .clip = NO_CLIP};
    plb_list_init(&list);
    list.width = list.height = side;
    double a = SWATCH_EDGE / 2, b = side - a; /* with a margin: a fill of the whole page counts as the paper */
    bool ok = (plb_path_move(&it.path, (point){a, a}) && plb_path_line(&it.path, (point){b, a}) && plb_path_line(&it.path, (point){b, b}) &&
               plb_path_line(&it.path, (point){a, b})) || plb_fail_memory(err);
    ok = ok && plb_list_add(&list, &it, err);
    if (!ok)
        plb_item_free(&it);
    ok = ok && plb_plan(&list, options, NULL, out, err);
    plb_list_free(&list);
    return ok;
}

static bool measure(double side, double dpi, double darkness, const plan_options *options, const render_context *t, double *result, error *err)
{
    stroke_list strokes = {0};
    swatch s = {.side = (int)ceil(side / MM_PER_INCH * dpi), .dpi = dpi, .ink = &t->ink};
    s.deposit = plb_new((size_t)s.side * (size_t)s.side, sizeof *s.deposit);
    bool ok = (s.deposit || plb_fail_memory(err)) && plan_swatch(side, darkness, options, &strokes, err) && draw_strokes(&strokes, t, &s, err);
    if (ok)
        *result = mean_darkness(&s);
    plb_stroke_list_free(&strokes);
    plb_free(s.deposit);
    return ok;
}

bool plb_api_measure_tone(const plb_options *o, const plan_options *options, double side, double dpi, tone_scale *out, error *err)
{
    render_context t;
    if (!plb_api_context_init(&t, o, err))
        return false;
    plan_options plain = *options;
    plain.seed = SWATCH_SEED;
    plain.colour = false;
    plain.soft_width = 0; /* the scale is this pencil's alone */
    for (int k = 0; k < TONE_STEPS; k++) /* a scale on which darkness is effort */
        plain.tone.darkness[k] = TONE_FAINTEST + (1 - TONE_FAINTEST) * k / (TONE_STEPS - 1);
    bool ok = true;
    for (int k = 0; ok && k < TONE_STEPS; k++) {
        ok = measure(side, dpi, plain.tone.darkness[k], &plain, &t, &out->darkness[k], err);
        if (k > 0)
            out->darkness[k] = fmax(out->darkness[k], out->darkness[k - 1] + MIN_STEP);
    }
    return ok;
}

bool plb_api_find_tone(const plb_options *o, plan_options *options, error *err)
{
    const tone_scale *known = plb_api_tone_known(o);
    tone_scale measured;
    if (!known && !plb_api_measure_tone(o, options, SWATCH_SIDE, SWATCH_DPI, &measured, err))
        return false;
    options->tone = known ? *known : measured;
    return true;
}
