/* SPDX-License-Identifier: MIT
 *
 * Solid shapes: arrowheads, dots, pads, thin bars. A person scribbles them full: the point goes back and forth in one
 * movement that turns inside the shape, then follows the outline half a line's width inside. What is smaller than two
 * widths of the line is a dab: a few touches.
 */
#include "plan/hatch/hatch_lines.h"

#include "base/number/random.h"

#include <math.h>
#include <string.h>

/* A shape is solid when its mean width (twice the area over the perimeter) is below so many widths of the line: a bar of
 * 1.2 mm, a disc of 2.4 mm with HB (chosen by eye). */
#define SOLID_WIDTHS 3.5
/* … and, where it is not convex, its breadth below so many. */
#define BROAD_WIDTHS 4.5
/* A shape within this many widths of the line is a dab … */
#define DAB_WIDTHS 2.0
/* … of touches no shorter than this, mm. */
#define DAB_SHORTEST 0.1
/* Thinner than this a shape is no more than one stroke along its axis, if it is straight. */
#define STROKE_WIDTHS 1.4
/* A bent sliver thinner than this is filled by its outline alone. */
#define SLIVER_WIDTHS 0.35
/* A bar covers this part of the box about it, and is so much longer than wide; up to so many widths of the line it may be a
 * letter's stem or a dash (chosen by eye). */
#define BAR_COVER 0.7
#define BAR_ELONGATION 2.0
#define PEN_WIDTHS 1.8
/* Passes of a scribble lie so far apart, in widths of the line. */
#define PASS_WIDTHS 0.42
/* Places of a pass stray by this part of their distance, its ends by this part of the line's width. */
#define PASS_STRAY 0.2
/* A pass ends this part of their distance farther on than halfway between its ends. */
#define PASS_LEAN 0.22
#define PASS_END_STRAY 0.15
#define MAX_SCRIBBLE_PASSES 4000
/* Sections so many widths to either side tell how a pass must end, and so many widths inside them it does. */
#define SIDE_WIDTHS 0.3
#define END_INSET 0.25
/* A movement back and forth is no longer than this, mm: then the hand starts again. */
#define MOVEMENT_LONGEST 30.0
/* An inset outline has no more corners. */
#define MAX_CORNERS 400

typedef struct {
    const shape *s;
    const marks *m;
    frame f;
    double width; /* of the line, mm */
    double apart; /* of the passes, mm */
    uint64_t key;
} scribble;

/* A shape whose bounds are at most b mm broad has at most b of twice the area over the perimeter. */
double plb_solid_breadth(double width)
{
    return SOLID_WIDTHS * width;
}

bool plb_is_solid(const shape *s, double width, bool *solid, error *err)
{
    double breadth = 0;
    *solid = 2 * s->area / s->perimeter < SOLID_WIDTHS * width;
    if (!*solid || s->is_convex)
        return true;
    if (!plb_shape_breadth(s, &breadth, err)) /* a ragged edge is long though the shape be broad */
        return false;
    *solid = breadth < BROAD_WIDTHS * width;
    return true;
}

static box extent_in(const shape *s, frame f)
{
    box b = BOX_EMPTY;
    for (size_t i = 0; i < s->edges.n; i++)
        plb_box_add(&b, frame_to(f, s->edges.v[i].from));
    return b;
}

bool plb_is_blot(const item *fill, const plan_options *o, bool *blot, error *err)
{
    size_t subpaths = 0;
    shape s;
    *blot = false;
    for (size_t i = 0; i < fill->path.ops.n; i++)
        subpaths += fill->path.ops.v[i] == PATH_MOVE;
    if (subpaths != 1)
        return true;
    bool ok = plb_shape_init(&s, fill, err);
    if (ok && s.is_convex && s.area > 0) {
        box b = extent_in(&s, plb_frame(s.axis));
        bool is_bar = s.area > BAR_COVER * (b.x1 - b.x0) * (b.y1 - b.y0);
        *blot = s.elongation < BAR_ELONGATION || !is_bar || 2 * s.area / s.perimeter > PEN_WIDTHS * o->shade_width;
    }
    plb_shape_free(&s);
    return ok;
}

static double stray(const scribble *k, uint64_t index)
{
    return 2 * random_unit(k->key, index) - 1;
}

/* A touch is full at once: the point is pressed down rather than drawn. */
static bool press(const scribble *k, point a, point b)
{
    track_point ends[2] = {{a, false}, {b, false}};
    track t = {.v = ends, .n = 2, .style = k->m->style, .corner_first = true, .corner_last = true};
    return plb_track_copy(k->m->out, &t) || plb_fail_memory(k->m->err);
}

/* A dot is made with a part of the lead that fits it: of so much of its size (chosen by eye: a stop stays a stop, and no larger than it was). */
#define DAB_POINT 0.6

/* Draws the box of the shape's own area in a few touches: one for each width of the line across, at least one. */
static bool dab(const scribble *all, box b)
{
    scribble with = *all, *k = &with;
    marks m = *all->m;
    double w = b.x1 - b.x0, h = b.y1 - b.y0, part_filled = w * h > 0 ? sqrt(fmin(k->s->area / (w * h), 1)) : 1;
    k->width = fmin(fmax(DAB_POINT * sqrt(k->s->area), m.options->point * all->width), all->width);
    m.style.breadth = (float)(k->width / all->width);
    k->m = &m;
    point c = {(b.x0 + b.x1) / 2, (b.y0 + b.y1) / 2};
    b = (box){c.x - part_filled * w / 2, c.y - part_filled * h / 2, c.x + part_filled * w / 2, c.y + part_filled * h / 2};
    double length = fmax(b.x1 - b.x0 - 0.7 * k->width, DAB_SHORTEST), across = fmax(b.y1 - b.y0 - 0.9 * k->width, 0);
    int touches = across > 0.5 * k->width ? 3 : across > 0 || length > DAB_SHORTEST ? 2 : 1;
    double u = (b.x0 + b.x1) / 2, v = (b.y0 + b.y1) / 2;
    bool ok = true;
    for (int i = 0; ok && i < touches; i++) {
        uint64_t n = (uint64_t)i * 4;
        double part = touches > 1 ? (double)i / (touches - 1) - .5 : 0;
        double at = v + part * across + 0.06 * k->width * stray(k, n), lean = 0.06 * k->width * stray(k, n + 1);
        double middle = u + 0.05 * length * stray(k, n + 2), half = length / 2 * (1 + 0.1 * stray(k, n + 3));
        ok = press(k, frame_from(k->f, (point){middle - half, at - lean}), frame_from(k->f, (point){middle + half, at + lean}));
    }
    return ok;
}

static bool single_stroke(const scribble *k, box b)
{
    double v = (b.y0 + b.y1) / 2, inset = fmin(k->width / 2, (b.x1 - b.x0) / 4);
    point from = frame_from(k->f, (point){b.x0 + inset, v}), to = frame_from(k->f, (point){b.x1 - inset, v});
    return plb_mark_line(k->m, from, to, k->m->style.pressure * (b.y1 - b.y0 > k->width ? 1.15 : 1));
}

/* ---- back and forth ---- */

/* A scribble under way: it goes on where the next line's section overlaps its last one. */
typedef struct {
    span last;
    bool met;   /* by a section of the line at work */
    double length; /* of the movement so far, mm */
    ARRAY(track_point) turns; /* so far, in the page's frame */
} zigzag;

typedef ARRAY(zigzag) zigzags;

static bool turn_at(const scribble *k, zigzag *c, double u, double v)
{
    track_point p = {frame_from(k->f, (point){u, v}), false};
    size_t n = c->turns.n;
    double step = n ? plb_point_distance(c->turns.v[n - 1].at, p.at) : 0;
    if (n && step < SAME_POINT_MM)
        return true;
    c->length += step;
    if (c->length > MOVEMENT_LONGEST) {
        p.corner = true;
        c->length = 0;
    }
    return array_push(&c->turns, p);
}

/* Gives the part of a pass that a section beside the pass leaves: where the edge runs slantwise, the pass must end earlier. */
static span within_side(span s, const sections *side)
{
    span best = s;
    double most = 0;
    for (size_t i = 0; i < side->spans.n; i++) {
        span both = {fmax(s.from, side->spans.v[i].from), fmin(s.to, side->spans.v[i].to)};
        if (both.to - both.from > most) {
            most = both.to - both.from;
            best = both;
        }
    }
    return best;
}

/* Ends a pass inside the shape by about half the line's width; the shorter the pass, the less. */
static span narrowed(const scribble *k, span s, const sections side[2], uint64_t index)
{
    s = within_side(within_side(s, &side[0]), &side[1]);
    double length = s.to - s.from, inset = fmin(k->width * END_INSET, length * 0.3);
    double uneven = fmin(k->width, length / 3) * PASS_END_STRAY;
    return (span){s.from + inset + uneven * stray(k, index), s.to - inset + uneven * stray(k, index + 1)};
}

/* The point goes on from both ends: it is not lifted. */
static bool finish(const scribble *k, zigzag *c)
{
    size_t n = c->turns.n;
    bool ok = true;
    if (n >= 2) {
        track t = {.v = c->turns.v, .n = n, .corner_first = true, .corner_last = true, .style = k->m->style};
        c->turns.v[0].corner = c->turns.v[n - 1].corner = false;
        ok = plb_track_copy(k->m->out, &t) || plb_fail_memory(k->m->err);
    }
    array_free(&c->turns);
    return ok;
}

/* Every other pass goes back. The point goes round its turns in two bends: it is never simply reversed. */
static bool pass_along(const scribble *k, zigzag *c, span in, double v, bool back)
{
    double lean = k->apart * PASS_LEAN;
    return turn_at(k, c, back ? in.to : in.from, v - lean) && turn_at(k, c, back ? in.from : in.to, v + lean);
}

/* The passes' sections: the one at work, at v, and those a little to either side. */
typedef struct {
    sections cut, side[2];
    double v;
    uint64_t line;
} pass_sections;

static bool sections_init(pass_sections *at, const scribble *k)
{
    error *err = k->m->err;
    return plb_sections_init(&at->cut, &k->s->edges, k->s->even_odd, k->f, 0, err) && plb_sections_init(&at->side[0], &k->s->edges, k->s->even_odd, k->f, 0, err) &&
           plb_sections_init(&at->side[1], &k->s->edges, k->s->even_odd, k->f, 0, err);
}

static void sections_free(pass_sections *at)
{
    plb_sections_free(&at->cut);
    plb_sections_free(&at->side[0]);
    plb_sections_free(&at->side[1]);
}

static bool sections_at(pass_sections *at, const scribble *k, uint64_t line, double v)
{
    double beside = k->width * SIDE_WIDTHS;
    at->v = v;
    at->line = line;
    return plb_sections_at(&at->cut, v, 0, k->m->err) && plb_sections_at(&at->side[0], v - beside, 0, k->m->err) &&
           plb_sections_at(&at->side[1], v + beside, 0, k->m->err);
}

/* Adds the pass of one section: on from the zigzag that the section overlaps, or in a new one. */
static bool add_pass(const scribble *k, zigzags *open, const pass_sections *at, size_t index)
{
    span s = at->cut.spans.v[index], in = narrowed(k, s, at->side, at->line * 1024 + index * 2);
    double v = at->v;
    bool back = at->line % 2;
    for (size_t i = 0; i < open->n; i++) {
        zigzag *c = &open->v[i];
        if (c->met || s.from > c->last.to || s.to < c->last.from)
            continue;
        c->met = true;
        c->last = s;
        return pass_along(k, c, in, v, back);
    }
    zigzag c = {.last = s, .met = true};
    bool ok = pass_along(k, &c, in, v, back) && array_push(open, c);
    if (!ok)
        array_free(&c.turns);
    return ok;
}

/* Ends the zigzags that the line at work did not meet. */
static bool end_unmet(const scribble *k, zigzags *open, bool all)
{
    size_t kept = 0;
    bool ok = true;
    for (size_t i = 0; i < open->n; i++) {
        zigzag *c = &open->v[i];
        if (c->met && !all) {
            c->met = false;
            open->v[kept++] = *c;
        } else if (ok) {
            ok = finish(k, c);
        } else {
            array_free(&c->turns);
        }
    }
    open->n = kept;
    return ok;
}

static bool back_and_forth(scribble *k, box page)
{
    pass_sections at = {0};
    zigzags open = {0};
    bool ok = sections_init(&at, k);
    double low = fmax(at.cut.bounds.y0, page.y0), high = fmin(at.cut.bounds.y1, page.y1), breadth = high - low - k->width;
    double passes = breadth > 0 ? fmin(ceil(breadth / (PASS_WIDTHS * k->width)), MAX_SCRIBBLE_PASSES) : 0;
    double apart = passes > 0 ? breadth / passes : 0, first = passes > 0 ? low + k->width / 2 : (low + high) / 2;
    k->apart = apart;
    for (uint64_t i = 0; ok && (double)i <= passes; i++) {
        double v = first + apart * ((double)i + (i > 0 && (double)i < passes ? PASS_STRAY * stray(k, i) : 0));
        ok = sections_at(&at, k, i, v);
        for (size_t j = 0; ok && j < at.cut.spans.n; j++)
            ok = add_pass(k, &open, &at, j) || plb_fail_memory(k->m->err);
        ok = end_unmet(k, &open, false) && ok;
    }
    ok = end_unmet(k, &open, true) && ok;
    array_free(&open);
    sections_free(&at);
    return ok;
}

/* ---- the outline, half a line's width inside ---- */

static point unit(point v)
{
    double l = plb_point_length(v);
    return l > 0 ? point_scale(v, 1 / l) : v;
}

/* Gives the corner after edge i, moved inward in its mitre; `inward` is 1 or -1. */
static point inset_corner(const shape *s, size_t i, double by)
{
    const shape_edge *e = &s->edges.v[i], *f = &s->edges.v[(i + 1) % s->edges.n];
    point a = unit(point_sub(e->to, e->from)), b = unit(point_sub(f->to, f->from));
    point normal = {-a.y - b.y, a.x + b.x};
    double squared = point_dot(normal, normal);
    return squared < 0.2 ? e->to : point_add(e->to, point_scale(normal, 2 * by / squared));
}

static double signed_area(const shape *s)
{
    double sum = 0;
    for (size_t i = 0; i < s->edges.n; i++)
        sum += point_cross(point_sub(s->edges.v[i].from, s->centre), point_sub(s->edges.v[i].to, s->centre));
    return sum / 2;
}

/* Hands on the inset outline of a convex shape; false in *done where it has none. */
static bool follow_inside(const scribble *k, bool *done)
{
    const shape *s = k->s;
    track_point corners[MAX_CORNERS + 1];
    double by = (signed_area(s) > 0 ? 1 : -1) * k->width / 2;
    size_t n = 0;
    *done = false;
    if (!s->is_convex || s->edges.n > MAX_CORNERS)
        return true;
    for (size_t i = 0; i < s->edges.n; i++) {
        point at = inset_corner(s, i, by);
        const shape_edge *e = &s->edges.v[i], *f = &s->edges.v[(i + 1) % s->edges.n];
        point in = unit(point_sub(e->to, e->from)), out = unit(point_sub(f->to, f->from));
        bool forward = n == 0 || point_dot(point_sub(at, corners[n - 1].at), in) > SAME_POINT_MM;
        if (forward)
            corners[n++] = (track_point){at, point_dot(in, out) < cos(CORNER_DEGREES * PLB_PI / 180)};
    }
    if (n < 3 || plb_point_distance(corners[0].at, corners[n - 1].at) < SAME_POINT_MM)
        return true;
    corners[n] = corners[0];
    track t = {.v = corners, .n = n + 1, .closed = true, .style = k->m->style};
    *done = true;
    return plb_track_copy(k->m->out, &t) || plb_fail_memory(k->m->err);
}

bool plb_scribble(const shape *s, box page, const marks *m, bool *outline)
{
    double width = m->options->shade_width, angle = s->elongation > LONG_ELONGATION ? s->axis : HATCH_HABIT;
    scribble k = {s, m, plb_frame(angle), width, 0, random_key(m->options->seed, s->identity, PURPOSE_HATCH)};
    box b = extent_in(s, k.f);
    bool is_bar = s->area > BAR_COVER * (b.x1 - b.x0) * (b.y1 - b.y0), done = false;
    *outline = false;
    if (b.x1 - b.x0 < DAB_WIDTHS * width && b.y1 - b.y0 < DAB_WIDTHS * width)
        return dab(&k, b);
    if (is_bar && b.y1 - b.y0 < STROKE_WIDTHS * width)
        return single_stroke(&k, b);
    *outline = true;
    if (2 * s->area / s->perimeter < SLIVER_WIDTHS * width)
        return true; /* its outline alone fills it */
    bool ok = back_and_forth(&k, plb_frame_box(k.f, page)) && follow_inside(&k, &done);
    *outline = !done;
    return ok;
}
