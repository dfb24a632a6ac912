/* SPDX-License-Identifier: MIT
 *
 * Plan, fills: an area becomes the marks that give it its tone.
 * Input: a filled shape, mm on the page, its paint. Output: tracks, mm, with pressure. The thesis draws hatch lines that it
 * is given (000, chapter 5) and leaves how a hand hatches to studies to come (chapter 7); the constants are ours.
 *
 *     too light, or paper     nothing
 *     thin or small           scribbled solid
 *     else                    a layer of lines, in darker tones a second over it
 */
#include "plan/hatch/hatch.h"

#include "base/number/random.h"
#include "plan/hatch/hatch_lines.h"

#include <math.h>

/* A direction strays by this from shape to shape, radians. */
#define DIRECTION_STRAY 0.04
/* The second layer is turned by this against the first, radians: darks are made by going over them again in nearly the same direction, as
 * people do; crossing looks woven (chosen by eye; passes of real drawings differ by 5 to 20 degrees). */
#define SECOND_ANGLE 0.24
/* Lines of a coloured pencil lie no closer than so many widths (chosen by eye). */
#define COLOUR_CLOSEST 0.6
/* Solid shapes are pressed by their darkness, from white to black (chosen by eye). */
#define SOLID_LIGHT 0.3
#define SOLID_DARK 1.25
/* A fill that covers this part of the page and is no darker than PAPER_DARKNESS is its paper. */
#define PAPER_COVER 0.97
#define PAPER_DARKNESS 0.45
/* A gradient that is anywhere more transparent than this may fade out before the shape's edge: it gets no outline (chosen by eye). */
#define EDGE_OPACITY 0.5
/* A gradient is looked at in so many places across and down. */
#define LOOKS 16
/* The lines of a drawing's hatching are held by wider spacing to about what covers the page so many times in the darkest
 * tone, within these bounds. */
#define MAX_COVERS 3
#define MIN_BUDGET 5e4
#define MAX_BUDGET 1e6
/* … when a line is this long, mm. */
#define TYPICAL_LENGTH 12.0
/* … and one of a gradient in so many parts. */
#define GRADIENT_PARTS 4

static double overlap(box a, box b)
{
    double w = fmin(a.x1, b.x1) - fmax(a.x0, b.x0), h = fmin(a.y1, b.y1) - fmax(a.y0, b.y0);
    return w > 0 && h > 0 ? w * h : 0;
}

/* A clip's area counts no less than this part of its bounds: loops that cross themselves have an area that tells too little (chosen by eye). */
#define CLIP_LEAST 0.1

/* Gives the area between a path's straight chords, mm2: the sum over its loops, holes that turn the other way taken off. */
static double area_of(const path *p)
{
    double twice = 0;
    size_t at = 0;
    point first = {0, 0}, last = {0, 0};
    for (size_t i = 0; i < p->ops.n; i++) {
        path_op op = p->ops.v[i];
        if (op == PATH_MOVE || op == PATH_CLOSE)
            twice += point_cross(last, first);
        if (op == PATH_CLOSE) {
            last = first;
            continue;
        }
        at += op == PATH_CURVE ? 3 : 1;
        point to = p->points.v[at - 1];
        if (op == PATH_MOVE)
            first = to;
        else
            twice += point_cross(last, to);
        last = to;
    }
    return fabs(twice + point_cross(last, first)) / 2;
}

/* Gives the area of the page that the fill may paint, mm2: that of its bounds, less where a clip leaves less. */
static double painted_area(const hatcher *h, const item *fill)
{
    double area = overlap(plb_path_bounds(&fill->path), h->page);
    if (fill->clip == NO_CLIP)
        return area;
    const path *c = &h->list->clips.v[fill->clip].path;
    box b = plb_path_bounds(c);
    double bounds = (b.x1 - b.x0) * (b.y1 - b.y0);
    return fmin(area, fmax(area_of(c), CLIP_LEAST * bounds));
}

hatcher plb_hatcher(const display_list *list, const plan_options *o, const tone_curve *curve, const paint_manners *manners)
{
    hatcher h = {.list = list, .options = o, .curve = *curve, .manners = *manners, .page = {0, 0, list->width, list->height}, .coarser = 1};
    technique full = plb_technique(1, o->shade_width);
    double cover = list->width * list->height / TYPICAL_LENGTH * (1 / full.spacing[0] + 1 / full.spacing[1]);
    double budget = fmin(fmax(MAX_COVERS * cover, MIN_BUDGET), MAX_BUDGET), strokes = 0;
    for (size_t i = 0; i < list->items.n; i++) {
        const item *it = &list->items.v[i];
        tone_source t = plb_tone_source(list, it, o, curve, o->colour);
        double darkest = plb_darkest(&t);
        if (it->kind != ITEM_FILL || darkest < MIN_DARKNESS)
            continue;
        technique q = plb_technique_for(darkest, plb_is_soft_tone(darkest, o), o);
        double area = painted_area(&h, it) * (t.gradient ? GRADIENT_PARTS : 1);
        for (int k = 0; k < HATCH_LAYERS; k++)
            strokes += q.spacing[k] > 0 ? area / (q.spacing[k] * TYPICAL_LENGTH) : 0;
        plb_hatch_direction_learn(&h, it);
    }
    h.coarser = fmax(1, strokes / budget);
    return h;
}

bool plb_may_be_hatched(const item *fill, const plan_options *o)
{
    box b = plb_path_bounds(&fill->path);
    double least = plb_solid_breadth(o->shade_width);
    return fmin(b.x1 - b.x0, b.y1 - b.y0) >= least && (fill->paint.kind == PAINT_GRADIENT || plb_paint_darkness(&fill->paint, o->colour) >= MIN_DARKNESS);
}

static bool is_paper(const hatcher *h, const shape *s, double darkness)
{
    box p = h->page;
    double page = (p.x1 - p.x0) * (p.y1 - p.y0), bounds = (s->bounds.x1 - s->bounds.x0) * (s->bounds.y1 - s->bounds.y0);
    bool full = s->area > PAPER_COVER * bounds; /* no hole, no corner missing */
    return darkness < PAPER_DARKNESS && full && overlap(s->bounds, p) > PAPER_COVER * page;
}

/* Gives the darkest that the gradient is inside the bounds, and its mean there. */
static double darkest_of(const tone_source *t, const shape *s, double *mean)
{
    double most = 0, sum = 0;
    for (int j = 0; j < LOOKS; j++)
        for (int i = 0; i < LOOKS; i++) {
            box b = s->bounds;
            double d = plb_darkness_at(t, (point){b.x0 + (i + .5) / LOOKS * (b.x1 - b.x0), b.y0 + (j + .5) / LOOKS * (b.y1 - b.y0)});
            most = fmax(most, d);
            sum += d;
        }
    *mean = sum / (LOOKS * LOOKS);
    return most;
}

/* Hatches the shape, whose darkest place has this darkness, with one pencil throughout. */
static bool add_tone(const hatcher *h, const shape *s, const item *fill, tone_source t, double darkness, marks m)
{
    t.is_soft = m.style.is_soft = plb_is_soft_tone(darkness, h->options);
    technique q = plb_technique_for(darkness, t.is_soft, h->options);
    manner how = plb_manner_of(&h->manners, &fill->paint);
    /* A coloured pencil covers at once: going over it again would only take its colour. */
    for (int k = 0; m.style.colour && k < HATCH_LAYERS; k++) {
        q.spacing[k] = k ? 0 : fmax(q.spacing[k], COLOUR_CLOSEST * h->options->shade_width);
        q.pressure[k] = fmin(q.pressure[k], 1);
    }
    if (how.coarser > 1)
        q = plb_single_layer(q, t.is_soft ? h->options->soft_width : h->options->shade_width, how.coarser);
    uint64_t key = random_key(h->options->seed, s->identity, PURPOSE_HATCH);
    bool is_of_manner = how.is_told && !fill->is_directed;
    double direction = (is_of_manner ? HATCH_HABIT : plb_hatch_direction(h, fill)) + (fill->is_directed ? 0 : how.turn) + DIRECTION_STRAY * (2 * random_unit(key, 1) - 1);
    bool ok = true;
    for (int k = 0; ok && k < HATCH_LAYERS; k++) {
        hatch_layer l = {direction + k * SECOND_ANGLE, q.spacing[k] * h->coarser, q.pressure[k], k, q.spacing[k], t.field ? t.field->finest : 0, t.gradient || t.field ? &t : NULL};
        ok = !(l.spacing > 0) || plb_hatch_lines(s, &l, h->page, &m);
    }
    return ok;
}

/* Makes the upright box a shape. */
static bool box_shape(shape *s, box b, error *err)
{
    point corner[4] = {{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, b.y1}, {b.x0, b.y1}};
    item it = {.kind = ITEM_FILL};
    bool ok = plb_path_move(&it.path, corner[0]) && plb_path_line(&it.path, corner[1]) && plb_path_line(&it.path, corner[2]) &&
              plb_path_line(&it.path, corner[3]) && plb_path_close(&it.path);
    *s = (shape){0};
    ok = ok ? plb_shape_init(s, &it, err) : plb_fail_memory(err);
    plb_path_free(&it.path);
    return ok;
}

bool plb_plan_hatch_cells(const hatcher *h, const item *last, const tone_field *f, track_list *out, error *err)
{
    tone_source t = {.paint = &last->paint, .field = f, .curve = &h->curve, .options = h->options};
    marks m = {h->options, {.pressure = 1, .kind = STROKE_HATCH, .breadth = 1}, out, err};
    double darkest = 0;
    shape s;
    for (size_t k = 0; k < (size_t)f->columns * (size_t)f->rows; k++)
        darkest = fmax(darkest, (double)f->darkness[k]);
    darkest = plb_tone_curve_at(&h->curve, darkest);
    bool ok = box_shape(&s, f->bounds, err) && (darkest < MIN_DARKNESS || add_tone(h, &s, last, t, darkest, m));
    plb_shape_free(&s);
    return ok;
}

bool plb_plan_hatch(const hatcher *h, const item *fill, uint32_t colour, bool *outline, track_list *out, error *err)
{
    tone_source t = plb_tone_source(h->list, fill, h->options, &h->curve, colour != 0);
    double darkness = plb_tone_curve_at(&h->curve, plb_paint_darkness(&fill->paint, colour != 0)), mean = darkness;
    marks m = {h->options, {.pressure = 1, .colour = colour, .kind = STROKE_HATCH, .breadth = 1}, out, err};
    shape s;
    bool ok = plb_shape_init(&s, fill, err);
    *outline = true;
    if (ok && s.area > 0 && t.gradient)
        darkness = darkest_of(&t, &s, &mean);
    bool has_edge = !t.gradient || plb_gradient_is_opaque(t.gradient, EDGE_OPACITY);
    if (ok && s.area > 0 && has_edge && is_paper(h, &s, mean)) {
        *outline = false;
    } else if (ok && s.area > 0 && darkness >= MIN_DARKNESS) {
        bool solid = false;
        m.style.pressure = (float)(SOLID_LIGHT + (SOLID_DARK - SOLID_LIGHT) * mean);
        ok = plb_is_solid(&s, h->options->shade_width, &solid, err) && (solid ? plb_scribble(&s, h->page, &m, outline) : add_tone(h, &s, fill, t, darkness, m));
    }
    *outline = *outline && has_edge;
    plb_shape_free(&s);
    return ok;
}
