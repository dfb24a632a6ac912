/* SPDX-License-Identifier: MIT
 *
 * See letter.h. Each part of a fill is judged by its thickness: 2 area / perimeter is a stroke's width, and the
 * radius of the largest disc inside is half of that for a stroke but all of it for whatever has one disc that touches
 * every side (discs, squares, triangles: dots and arrowheads). Strokes are then ordered and turned as a right hand
 * letters: from the top, from the left, rings against the clock.
 */
#include "plan/letter/letter.h"

#include "base/geometry/interpolate.h"
#include "plan/item/wide.h"
#include "plan/letter/hand/hand.h"

#include <math.h>
#include <string.h>

/* All chosen by eye. */
#define THIN_PENCILS 2.2     /* a stroke up to this many pencil lines wide is thin at any size */
#define THIN_MM 1.2          /* up to this when the letters are small */
#define SMALL_MM 8.0
#define COMPACT 0.85         /* largest radius to 2 area / perimeter: above, and */
#define MAX_ROUNDNESS 3.6            /* perimeter^2 to 4 pi area: below, a dot or an arrowhead; a disc 1, a triangle 1 x 4 3.3 */
#define DOT_STEMS 5.0        /* largest size of the dots and commas among letters */
#define LONE_DOT_PENCILS 1.3 /* a dot by itself is lettering up to this size */
#define MIN_RING_MM 0.07
#define THICK 2.0            /* the largest disc of a part may be this many strokes wide */
#define ARROW_CORNERS 12     /* of an arrow that is one polygon, at most */
#define ARROW_HEAD 1.6       /* the largest disc of such an arrow, in strokes: above; a V about 1.3 */
#define BAR 5.0              /* a quadrangle this much longer than wide is a line */
#define LENIENT 1.4          /* a letter of a thin word may be so much thicker than the limit */
#define OF_ITS_KIND 0.7      /* a letter of a thick word that has this part of the word's stem is thick, too */
#define BROAD_PENCILS 1.6    /* broader strokes are made of passes side by side, */
#define BOLD_PENCILS 1.15    /* in a bold word from so much on */
#define BROAD_LEAST 0.8      /* such strokes are as broad as the word's, but for this */
#define BROAD_MOST 1.25
#define PRESSURE 1.8         /* of a word's strokes, times a line's: a person presses on letters, which are small and are to be read */
#define BOLD_PRESSURE 1.25   /* in a bold word, times that */
#define DOT_PRESSURE 1.4     /* of a dot, times its word's: a decimal point is pressed into the paper */
#define ROOM 0.34            /* hatching keeps so many sizes of its letters away from a word: it goes neither between nor into letters */
#define ROOM_MOST_MM 1.4     /* … of large ones so far */
#define ROOM_LARGEST_MM 14.0 /* larger shapes are no words */

typedef struct {
    const plan_options *options;
    glyph_store *glyphs;
    letter_run run;
    double stem;   /* of the whole run, mm */
    double height; /* of its tallest part: the shorter side of its bounds, mm */
    bool is_bar;   /* one shape of at most four sides */
    bool is_alone; /* one part */
    float pressure;
    size_t letters; /* parts that are no dots */
    size_t by_hand; /* strokes of the hand's alphabet, which come first */
    track_list strokes;
    ARRAY(double) breadths; /* of each stroke, mm; 0: the pencil's */
    double breadth;         /* of the part at work */
} lettering;

static double stem_of(const letter_part *p)
{
    return p->perimeter > 0 ? 2 * p->area / p->perimeter : 0;
}

static double size_of(box b)
{
    return fmax(b.x1 - b.x0, b.y1 - b.y0);
}

static void measure(lettering *l, const letter_parts *parts)
{
    double area = 0, perimeter = 0;
    for (size_t i = 0; i < parts->parts.n; i++) {
        const letter_part *p = &parts->parts.v[i];
        area += p->area;
        perimeter += p->perimeter;
        l->height = fmax(l->height, fmin(p->bounds.x1 - p->bounds.x0, p->bounds.y1 - p->bounds.y0));
    }
    l->is_alone = parts->parts.n == 1;
    l->is_bar = parts->parts.n == 1 && parts->parts.v[0].outline.points.n <= 4;
    l->stem = l->run.fills > 1 ? l->run.stem : perimeter > 0 ? 2 * area / perimeter : 0;
    if (l->run.fills > 1)
        l->height = fmin(l->run.size, fmax(l->height, l->run.size / 2));
}

static bool is_thin(const lettering *l, double stem)
{
    return stem <= THIN_PENCILS * l->options->shade_width || (stem <= THIN_MM && l->height <= SMALL_MM && !l->is_bar);
}

/* Tells whether a part is as thin as the word it belongs to. */
static bool is_thin_part(const lettering *l, double stem)
{
    if (is_thin(l, l->stem))
        return is_thin(l, stem / LENIENT);
    return is_thin(l, stem) && !(l->run.fills > 1 && stem > OF_ITS_KIND * l->stem);
}

/* Gives how broad the strokes of a part are made, mm; 0: the pencil's line. */
static double breadth_of(const lettering *l, double stem)
{
    double from = l->run.is_bold ? BOLD_PENCILS : BROAD_PENCILS;
    return l->stem > from * l->options->shade_width ? fmin(fmax(stem, BROAD_LEAST * l->stem), BROAD_MOST * l->stem) : 0;
}

/* Thin letters are drawn lightly: a light line is a narrow one. */
static float pressure_of(const lettering *l)
{
    double p = fmin(1, fmax(0.7, 0.6 + 0.4 * l->stem / l->options->shade_width));
    return (float)(PRESSURE * (l->run.is_bold ? BOLD_PRESSURE : p));
}

/* Gives how far hatching keeps from the strokes, mm: from those of words and single characters, not from those of bars. */
static float room_of(const lettering *l, const item *fill)
{
    double size = l->run.size > 0 ? l->run.size : l->height;
    bool is_word = fill->text || l->run.fills > 1 || !l->is_alone || (l->letters && !l->is_bar);
    return is_word && size <= ROOM_LARGEST_MM ? (float)fmin(ROOM * size, ROOM_MOST_MM) : 0;
}

/* ---- from pen strokes to tracks ---- */

/* Begins a stroke of `breadth` mm. */
static bool begin_stroke(lettering *l, bool closed, double breadth)
{
    track t = {.closed = closed, .style = {.pressure = l->pressure, .kind = STROKE_LETTER}};
    return array_push(&l->breadths, breadth) && plb_track_begin(&l->strokes, &t);
}

/* Adds a stroke of a glyph whose outline begins at `origin`. */
static bool add_stroke(lettering *l, point origin, const pen *p, const pen_stroke *s)
{
    bool ok = begin_stroke(l, s->closed, l->breadth);
    for (size_t i = 0; ok && i < s->n; i++) {
        pen_point at = p->points.v[s->first + i];
        ok = plb_track_push(&l->strokes, point_add(origin, at.at), at.corner);
    }
    return ok;
}

/* The point turns on the spot, in a ring as wide as the dot needs. */
static bool add_dot(lettering *l, box b)
{
    point middle = {(b.x0 + b.x1) / 2, (b.y0 + b.y1) / 2};
    double radius = fmax((size_of(b) - l->options->shade_width) / 2, MIN_RING_MM);
    bool ok = begin_stroke(l, true, 0);
    if (ok)
        l->strokes.tracks.v[l->strokes.tracks.n - 1].style.pressure *= (float)DOT_PRESSURE;
    for (int i = 0; ok && i <= 12; i++) {
        double a = -PLB_PI / 2 - (i % 12) * PLB_PI / 6;
        ok = plb_track_push(&l->strokes, (point){middle.x + radius * cos(a), middle.y + radius * sin(a)}, false);
    }
    return ok;
}

/* Tells a dot: about as high as wide, and of one disc or hardly longer than a stroke is thick. */
static bool is_dot(const lettering *l, box b, bool compact)
{
    double w = b.x1 - b.x0, h = b.y1 - b.y0;
    return fmax(w, h) < 1.6 * fmin(w, h) && (compact || fmax(w, h) < 1.8 * l->stem);
}

/* ---- one part ---- */

/* Computes the two middles of the short sides of a quadrangle much longer than wide; false of anything else. Drawings have
 * thousands of such bars, some as long as the page: they need no raster. */
static bool is_long_bar(const letter_part *part, point *from, point *to)
{
    const point *p = part->outline.points.v;
    if (part->outline.starts.n != 1 || part->outline.points.n != 4)
        return false;
    double side[4];
    for (int i = 0; i < 4; i++)
        side[i] = plb_point_distance(p[i], p[(i + 1) % 4]);
    int k = side[0] + side[2] < side[1] + side[3] ? 0 : 1; /* the first short side */
    *from = point_mix(p[k], p[k + 1], 0.5);
    *to = point_mix(p[k + 2], p[(k + 3) % 4], 0.5);
    return BAR * fmax(side[k], side[k + 2]) < fmin(side[k + 1], side[(k + 3) % 4]);
}

static bool add_bar(lettering *l, point from, point to, double width)
{
    double off = fmin(NIB_PENCILS * l->options->shade_width, width) / 2 / plb_point_distance(from, to);
    l->letters++;
    return begin_stroke(l, false, breadth_of(l, width)) && plb_track_push(&l->strokes, point_mix(from, to, off), false) &&
           plb_track_push(&l->strokes, point_mix(to, from, off), false);
}

static bool draw_axis(lettering *l, point origin, const glyph *g, error *err)
{
    const pen *p = plb_glyph_axis(l->glyphs, g, err);
    bool ok = p;
    for (size_t i = 0; ok && i < p->strokes.n; i++)
        if (p->strokes.v[i].n > 1)
            ok = add_stroke(l, origin, p, &p->strokes.v[i]) || plb_fail_memory(err);
    return ok;
}

/* A polygon of few corners by itself with one place much broader than the rest: an arrow and its head. Letters of straight
 * sides are nowhere so much broader, not even where the strokes of a V meet. */
static bool is_arrow(const lettering *l, const letter_part *part, double radius, double stem)
{
    return l->is_alone && part->outline.starts.n == 1 && part->outline.points.n <= ARROW_CORNERS && 2 * radius > ARROW_HEAD * stem;
}

static bool draw_part(lettering *l, const letter_part *part, bool *taken, error *err)
{
    point from, to;
    if (is_long_bar(part, &from, &to)) {
        *taken = is_thin_part(l, stem_of(part));
        return !*taken || add_bar(l, from, to, stem_of(part)) || plb_fail_memory(err);
    }
    const glyph *g = plb_glyph(l->glyphs, part, err);
    if (!g)
        return false;
    double radius = g->largest, stem = g->stem;
    bool ok = true, compact = radius > COMPACT * stem && part->perimeter < MAX_ROUNDNESS * 2 * PLB_PI * stem; /* P^2/A = 2 P / stem */
    *taken = g->is_rastered && is_thin_part(l, stem) && !is_arrow(l, part, radius, stem) && 2 * radius <= THICK * fmax(l->stem, THIN_PENCILS * l->options->shade_width);
    if (*taken && compact)
        *taken = size_of(part->bounds) <= fmax(DOT_STEMS * l->stem, LONE_DOT_PENCILS * l->options->shade_width);
    size_t before = l->strokes.tracks.n;
    l->breadth = breadth_of(l, stem);
    if (*taken && !is_dot(l, part->bounds, compact))
        ok = draw_axis(l, part->outline.points.v[0], g, err);
    if (ok && *taken && l->strokes.tracks.n == before) /* of a comma there is a line */
        ok = add_dot(l, part->bounds) || plb_fail_memory(err);
    l->letters += *taken && !compact;
    return ok;
}

static bool draw_parts(lettering *l, const letter_parts *parts, bool *taken, error *err)
{
    bool ok = true;
    *taken = parts->parts.n > 0 && (is_thin(l, l->stem) || l->run.fills > 1);
    for (size_t i = 0; ok && *taken && i < parts->parts.n; i++)
        if (parts->parts.v[i].area > 0)
            ok = draw_part(l, &parts->parts.v[i], taken, err);
    if (l->letters == 0)
        for (size_t i = 0; i < parts->parts.n; i++)
            *taken = *taken && size_of(parts->parts.v[i].bounds) <= LONE_DOT_PENCILS * l->options->shade_width;
    return ok;
}

/* ---- how a hand goes ---- */

static void reverse(track_point *v, size_t n)
{
    for (size_t i = 0, k = n - 1; i < k; i++, k--) {
        track_point p = v[i];
        v[i] = v[k];
        v[k] = p;
    }
}

static double turning(const track_point *v, size_t n)
{
    double sum = 0;
    for (size_t i = 1; i < n; i++)
        sum += point_cross(v[i - 1].at, v[i].at);
    return sum; /* > 0: clockwise, as y points down */
}

/* Turns a stroke downwards, or to the right where the stroke is more level. */
static void turn_by_hand(track_list *strokes, size_t i)
{
    const track *t = &strokes->tracks.v[i];
    track_point *v = strokes->points.v + t->first;
    point d = point_sub(v[t->n - 1].at, v[0].at);
    if (t->closed ? turning(v, t->n) > 0 : d.x + 1.5 * d.y < 0)
        reverse(v, t->n);
}

/* A word's strokes are made with more or less of the point, by this part of their own breadth, up to the whole lead (chosen by eye). */
#define LETTER_BREADTH 0.8
/* Who letters with a blunt lead turns it to its edge, which is so broad (chosen by eye). */
#define EDGE_BREADTH 0.72

static float point_for(const lettering *l)
{
    const plan_options *o = l->options;
    return o->point < 1 ? (float)clamp(LETTER_BREADTH * l->stem / o->shade_width, o->point, 1) : (float)EDGE_BREADTH;
}

/* A broad stroke keeps its weight: passes side by side, in the stroke's style. */
static bool take_stroke(const lettering *l, size_t i, const item *fill, track_list *out, error *err)
{
    track t = plb_track_at(&l->strokes, i);
    t.style.breadth = point_for(l);
    t.style.clear = room_of(l, fill);
    if (l->breadths.v[i] <= l->options->shade_width)
        return plb_track_copy(out, &t) || plb_fail_memory(err);
    item broad = {.kind = ITEM_STROKE, .paint = fill->paint, .width = l->breadths.v[i], .cap = LINE_CAP_BUTT};
    size_t first = out->tracks.n;
    bool ok = plb_plan_passes(&broad, &t, l->options, out, err);
    for (size_t k = first; k < out->tracks.n; k++)
        out->tracks.v[k].style = t.style;
    return ok;
}

/* Letters the characters that the alphabet has, and draws the middle lines of the rest. *taken is false, and no stroke there, where the rest is
 * not like lettering. */
static bool draw_by_hand(lettering *l, const item *fill, bool *taken, error *err)
{
    item rest = {.kind = ITEM_FILL, .paint = fill->paint, .even_odd = fill->even_odd};
    letter_parts parts = {0};
    double breadth = breadth_of(l, l->stem), inset = fmax(fmin(l->stem, l->options->pencil_width), breadth) / 2;
    *taken = is_thin(l, l->stem);
    if (!*taken)
        return true;
    bool ok = plb_hand_letters(fill, inset, l->options->seed, &l->strokes, &rest.path) || plb_fail_memory(err);
    for (size_t i = 0; ok && i < l->strokes.tracks.n; i++) {
        l->strokes.tracks.v[i].style.pressure = l->pressure;
        ok = array_push(&l->breadths, breadth) || plb_fail_memory(err);
    }
    l->by_hand = l->strokes.tracks.n;
    l->letters += l->by_hand > 0;
    if (ok && rest.path.ops.n)
        ok = plb_letter_split(&parts, &rest, err) && (!parts.parts.n || draw_parts(l, &parts, taken, err));
    plb_letter_parts_free(&parts);
    plb_path_free(&rest.path);
    if (*taken && l->strokes.tracks.n)
        return ok;
    plb_tracks_clear(&l->strokes);
    l->breadths.n = l->by_hand = l->letters = 0;
    *taken = false;
    return ok;
}

bool plb_plan_letter(const item *fill, letter_run run, const plan_options *o, glyph_store *glyphs, bool *taken, track_list *out, error *err)
{
    lettering l = {.options = o, .glyphs = glyphs, .run = run};
    letter_parts parts;
    *taken = false;
    if (!plb_letter_split(&parts, fill, err))
        return false;
    measure(&l, &parts);
    l.pressure = pressure_of(&l);
    bool ok = !fill->text || o->lettering != LETTERING_HAND || !parts.parts.n || draw_by_hand(&l, fill, taken, err);
    ok = ok && (*taken || draw_parts(&l, &parts, taken, err));
    for (size_t i = 0; ok && *taken && i < l.strokes.tracks.n; i++) {
        if (i >= l.by_hand)
            turn_by_hand(&l.strokes, i);
        ok = take_stroke(&l, i, fill, out, err);
    }
    plb_tracks_free(&l.strokes);
    array_free(&l.breadths);
    plb_letter_parts_free(&parts);
    return ok;
}
