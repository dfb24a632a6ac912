/* SPDX-License-Identifier: MIT
 *
 * The reduction: see reduction.h. Every subpath is flattened once and shown to three measurements; the largest need decides.
 * Nothing here depends on the seed or on pixels, and all of it is linear, or sorting, in what is drawn.
 */
#include "plan/reduction/reduction.h"

#include "plan/item/weight.h"
#include "plan/reduction/needs.h"

#include <math.h>

/* A drawing that needs a sheet larger by less than this is drawn at its own size: it has its true size. The usual lettering
 * of plans, 2.5 mm high with lower-case letters of 1.75 mm [ISO 3098], is written as well as that of 2. */
#define MIN_FACTOR 1.25
/* Factors are multiples of this, so that a small change to a drawing does not change all of its strokes. */
#define FACTOR_STEP 0.1
/* Curves become chords: so many, and more for long ones (off by less than a tenth of a pencil's width). */
#define MIN_CHORDS 3
#define MAX_CHORDS 64
#define CHORD_MM 0.35

typedef struct {
    const display_list *list;
    const plan_options *options;
    ARRAY(box) clips;     /* the bounds of each, narrowed by its parents' */
    ARRAY(point) points;  /* of the subpath at work */
    small_parts parts;
    letter_heights letters;
    line_gaps *gaps;
} survey;

/* ---- subpaths ---- */

static bool add_curve(survey *v, const point c[3])
{
    point a = v->points.v[v->points.n - 1];
    double polygon = plb_point_distance(a, c[0]) + plb_point_distance(c[0], c[1]) + plb_point_distance(c[1], c[2]);
    int n = (int)fmin(fmax(ceil(sqrt(polygon / CHORD_MM)), MIN_CHORDS), MAX_CHORDS);
    bool ok = array_reserve(&v->points, (size_t)n);
    for (int k = 1; ok && k <= n; k++) {
        double t = (double)k / n, s = 1 - t;
        point p = point_add(point_scale(a, s * s * s), point_scale(c[0], 3 * s * s * t));
        v->points.v[v->points.n++] = point_add(p, point_add(point_scale(c[1], 3 * s * t * t), point_scale(c[2], t * t * t)));
    }
    return ok;
}

/* Measures the points at hand. */
static void measure(const survey *v, subpath *s)
{
    s->v = v->points.v;
    s->n = v->points.n;
    s->bounds = BOX_EMPTY;
    s->length = s->area = 0;
    for (size_t i = 0; i < s->n; i++) {
        plb_box_add(&s->bounds, s->v[i]);
        if (i == 0)
            continue;
        s->length += plb_point_distance(s->v[i - 1], s->v[i]);
        s->area += point_cross(point_sub(s->v[i - 1], s->v[0]), point_sub(s->v[i], s->v[0])) / 2;
    }
}

static bool is_on(box b, box region)
{
    return b.x1 >= region.x0 && b.y1 >= region.y0 && b.x0 <= region.x1 && b.y0 <= region.y1;
}

/* Shows the subpath at hand to those that it concerns, and begins another. */
static bool show(survey *v, subpath *s, bool is_line)
{
    box page = {0, 0, v->list->width, v->list->height};
    bool ok = true;
    if (s->it->kind == ITEM_FILL && v->points.n > 2 && plb_point_distance(v->points.v[0], v->points.v[v->points.n - 1]) > 0) {
        ok = array_push(&v->points, v->points.v[0]);
        s->lines++;
    }
    measure(v, s);
    s->closed = s->it->kind == ITEM_FILL || s->closed || plb_point_distance(s->v[0], s->v[s->n - 1]) <= 0;
    bool is_seen = s->n > 1 && is_on(s->bounds, page) && (s->it->clip == NO_CLIP || is_on(s->bounds, v->clips.v[s->it->clip]));
    ok = ok && (!is_seen || (plb_small_parts_add(&v->parts, s) && (!is_line || plb_line_gaps_add(v->gaps, s))));
    *s = (subpath){.it = s->it, .number = s->number};
    v->points.n = 0;
    return ok;
}

/* Walks along an item's path. */
static bool survey_item(survey *v, size_t number)
{
    const item *it = &v->list->items.v[number];
    subpath s = {.it = it, .number = (unsigned)number};
    const point *at = it->path.points.v;
    point start = {0, 0};
    bool ok = true, is_line = it->kind == ITEM_STROKE && !plb_is_wide(it, v->options);
    v->points.n = 0;
    for (size_t i = 0; ok && i < it->path.ops.n; i++) {
        path_op op = (path_op)it->path.ops.v[i];
        if (op == PATH_MOVE && v->points.n > 0)
            ok = show(v, &s, is_line);
        if (op == PATH_MOVE)
            start = *at;
        else if (v->points.n == 0) /* a line follows a closed subpath */
            ok = array_push(&v->points, start);
        if (op == PATH_CURVE)
            ok = ok && add_curve(v, at);
        else
            ok = ok && array_push(&v->points, op == PATH_CLOSE ? start : *at);
        s.curves += op == PATH_CURVE;
        s.lines += op == PATH_LINE || op == PATH_CLOSE;
        at += op == PATH_CURVE ? 3 : op != PATH_CLOSE;
        if (op == PATH_CLOSE) {
            s.closed = true;
            ok = ok && show(v, &s, is_line);
        }
    }
    return ok && (v->points.n == 0 || show(v, &s, is_line));
}

/* ---- the drawing ---- */

/* Tells whether the item is shown to the measurements: what is not seen is not, nor the outline of what has just been filled. */
static bool counts(const survey *v, size_t i)
{
    const item *it = &v->list->items.v[i];
    bool is_drawn = it->paint.alpha > 0 && (it->kind == ITEM_FILL ? v->options->fill != FILL_NONE || v->options->text != TEXT_NONE : plb_leaves_mark(it));
    return is_drawn && !(i > 0 && it->kind == ITEM_STROKE && it[-1].kind == ITEM_FILL && plb_path_equal(&it->path, &it[-1].path) && plb_leaves_mark(it - 1));
}

static bool bound_clips(survey *v)
{
    bool ok = array_reserve(&v->clips, v->list->clips.n);
    for (size_t i = 0; ok && i < v->list->clips.n; i++) {
        const clip *c = &v->list->clips.v[i];
        box b = plb_path_bounds(&c->path);
        if (c->parent != NO_CLIP) {
            box p = v->clips.v[c->parent];
            b = (box){fmax(b.x0, p.x0), fmax(b.y0, p.y0), fmin(b.x1, p.x1), fmin(b.y1, p.y1)};
        }
        v->clips.v[v->clips.n++] = b;
    }
    return ok;
}

/* Measures all lines, roughly: along the control points. */
static double length_of_lines(const survey *v)
{
    double sum = 0;
    for (size_t i = 0; i < v->list->items.n; i++) {
        const item *it = &v->list->items.v[i];
        for (size_t k = 1; it->kind == ITEM_STROKE && counts(v, i) && k < it->path.points.n; k++)
            sum += plb_point_distance(it->path.points.v[k - 1], it->path.points.v[k]);
    }
    return sum;
}

static double factor_of(const reduction_needs *n)
{
    double most = fmax(n->lettering, fmax(n->lines, n->shapes));
    if (most < MIN_FACTOR)
        return 1;
    return fmin(ceil(most / FACTOR_STEP - 1e-6) * FACTOR_STEP, REDUCTION_MAX);
}

bool plb_plan_reduction(const display_list *list, const plan_options *o, reduction_needs *out, error *err)
{
    survey v = {.list = list, .options = o};
    *out = (reduction_needs){.factor = 1};
    v.gaps = plb_line_gaps_new(list, o->pencil_width, length_of_lines(&v));
    bool ok = v.gaps && bound_clips(&v);
    for (size_t i = 0; ok && i < list->items.n; i++)
        ok = !counts(&v, i) || (list->items.v[i].text ? plb_lettering_add_text(&v.letters, list->items.v[i].text) : survey_item(&v, i));
    ok = ok && plb_lettering_need(&v.parts, &v.letters, &out->lettering) && plb_shapes_need(&v.parts, o->pencil_width, &out->shapes) && plb_line_gaps_need(v.gaps, &out->lines);
    if (o->text == TEXT_NONE)
        out->lettering = 0;
    out->factor = factor_of(out);
    plb_line_gaps_free(v.gaps);
    array_free(&v.clips);
    array_free(&v.points);
    array_free(&v.parts);
    array_free(&v.letters);
    return ok || plb_fail_memory(err);
}
