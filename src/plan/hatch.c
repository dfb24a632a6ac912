/* SPDX-License-Identifier: MIT
 *
 * Plan, fills: an area becomes the marks that give it its tone.
 * Input: a filled shape, mm on the page, its paint. Output: tracks, mm, with pressure. The thesis draws hatch lines that it
 * is given (000, chapter 5) and leaves how a hand hatches to studies to come (chapter 7); the constants are ours.
 *
 *     too light, or paper     nothing
 *     thin or small           scribbled solid
 *     else                    a layer of lines, in darker tones a second across it
 */
#include "plan/hatch.h"

#include "base/random.h"
#include "plan/hatch_lines.h"

#include <math.h>

/* Lighter tones are left to the paper. */
#define LEAST_DARKNESS 0.045
/* A direction strays by this from shape to shape, radians. */
#define DIRECTION_STRAY 0.04
/* The second layer is turned by this against the first, radians: less than a right angle, as the wrist has it. */
#define CROSS_ANGLE 1.1
/* A fill that covers this part of the page and is no darker than PAPER_DARKNESS is its paper. */
#define PAPER_COVER 0.97
#define PAPER_DARKNESS 0.45
/* The lines of a drawing's hatching are held to about this many by wider spacing. */
#define MOST_STROKES 1.5e6
/* … when a line is this long, mm. */
#define TYPICAL_LENGTH 20.0

static double overlap(box a, box b)
{
    double w = fmin(a.x1, b.x1) - fmax(a.x0, b.x0), h = fmin(a.y1, b.y1) - fmax(a.y0, b.y0);
    return w > 0 && h > 0 ? w * h : 0;
}

hatcher plb_hatcher(const display_list *list, const plan_options *o)
{
    hatcher h = {.how = o, .page = {0, 0, list->width, list->height}, .coarser = 1};
    double strokes = 0;
    for (size_t i = 0; i < list->items.n; i++) {
        const item *it = &list->items.v[i];
        if (it->kind != ITEM_FILL || plb_paint_darkness(&it->paint, false) < LEAST_DARKNESS)
            continue;
        technique q = plb_technique_for(plb_paint_darkness(&it->paint, false), o);
        double area = overlap(plb_path_bounds(&it->path), h.page);
        for (int k = 0; k < HATCH_LAYERS; k++)
            strokes += q.spacing[k] > 0 ? area / (q.spacing[k] * TYPICAL_LENGTH) : 0;
        plb_hatch_direction_learn(&h, it);
    }
    h.coarser = fmax(1, strokes / MOST_STROKES);
    return h;
}

static bool is_paper(const hatcher *h, const shape *s, double darkness)
{
    box p = h->page;
    double page = (p.x1 - p.x0) * (p.y1 - p.y0), bounds = (s->bounds.x1 - s->bounds.x0) * (s->bounds.y1 - s->bounds.y0);
    bool full = s->area > PAPER_COVER * bounds; /* no hole, no corner missing */
    return darkness < PAPER_DARKNESS && full && overlap(s->bounds, p) > PAPER_COVER * page;
}

static bool add_tone(const hatcher *h, const shape *s, const item *fill, double darkness, const marks *m)
{
    technique q = plb_technique_for(darkness, h->how);
    uint64_t key = random_key(h->how->seed, s->identity, PURPOSE_HATCH);
    double direction = plb_hatch_direction(h, fill) + DIRECTION_STRAY * (2 * random_unit(key, 1) - 1);
    bool ok = true;
    for (int k = 0; ok && k < HATCH_LAYERS; k++) {
        hatch_layer l = {direction + k * CROSS_ANGLE, q.spacing[k] * h->coarser, q.pressure, k};
        ok = !(l.spacing > 0) || plb_hatch_lines(s, &l, h->page, m);
    }
    return ok;
}

bool plb_plan_hatch(const hatcher *h, const item *fill, uint32_t colour, bool *outline, track_sink sink, void *closure, error *err)
{
    double darkness = plb_paint_darkness(&fill->paint, colour != 0);
    marks m = {h->how, {1, colour, STROKE_HATCH}, sink, closure, err};
    shape s;
    bool ok = plb_shape_init(&s, fill, err);
    *outline = true;
    if (ok && s.area > 0 && is_paper(h, &s, darkness)) {
        *outline = false;
    } else if (ok && s.area > 0 && darkness >= LEAST_DARKNESS) {
        bool solid = false;
        m.touch.pressure = (float)plb_technique_for(darkness, h->how).pressure;
        ok = plb_is_solid(&s, h->how->pencil_width, &solid, err) && (solid ? plb_scribble(&s, h->page, &m, outline) : add_tone(h, &s, fill, darkness, &m));
    }
    plb_shape_free(&s);
    return ok;
}
