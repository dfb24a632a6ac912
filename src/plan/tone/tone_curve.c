/* SPDX-License-Identifier: MIT
 *
 * The curve of tones: see tone_curve.h. Every fill large enough for a tone is an area; all else, lettering and lines, lies on the area
 * that was painted last below it. The darkest area that carries dark things becomes light enough for them, all lighter ones with it; the
 * lightest that carries white words stays dark enough.
 */
#include "plan/tone/tone_curve.h"

#include "plan/item/weight.h"
#include "plan/shape/region.h"

#include <math.h>

/* The darkest tone on which the pencil's lines are seen at a glance, that on which words are, for which the hatching is interrupted
 * (strokes/clearance.c), and the lightest that white words stand out from: shares of black (chosen by eye; lighter would flatten the tones, darker
 * drown the lines). */
#define CARRIES_DARK 0.26
#define CARRIES_WORDS 0.5
#define CARRIES_WHITE 0.5
/* A fill that reaches over so many widths of the pencil, either way, is an area, unless it is thinner everywhere than so many mm: lettering. */
#define AREA_WIDTHS 6.0
#define LETTER_MM 1.2
/* Tones up to this part of CARRIES_DARK stay as they are. */
#define UNCHANGED 0.5
/* A mark is dark on an area, or light, that differs by so much (chosen by eye: less is hardly seen in the drawing itself). */
#define CONTRAST 0.2
/* Words lighter than this are white. They are left open where they are at least so high, mm (chosen by eye: the holes of smaller ones
 * close up); letters of a word lie no farther apart than this part of their height; capitals are so high in sizes of the font. */
#define WHITE 0.2
#define OPEN_HEIGHT_MM 4.0
#define CAPITAL_EMS 0.73
#define WORD_GAP 0.5
/* Letters on a picture are no higher, mm. */
#define WORD_HIGHEST_MM 8.0
/* A line is looked at in so many places, and lies on an area that holds so many of them. */
#define LOOKS 12
#define LEAST_LOOKS 2
/* So many areas are compared with marks; beyond, marks are passed over evenly. */
#define MAX_COMPARED 2e7

typedef struct {
    size_t order;
    box bounds;
    double darkness;
    region *region; /* made when first needed */
} area;

typedef struct {
    const display_list *list;
    const plan_options *options;
    ARRAY(area) areas;
    double darkest, darkest_of_words, lightest; /* that carries dark lines; that carries dark words; that carries white words */
    bool *is_inked;           /* of each item: it is white and lies on something dark; then, only where it is too small */
    size_t *below;            /* of each such item: the area that it lies on */
    error *err;
} survey;

tone_curve plb_tone_curve_plain(void)
{
    return (tone_curve){.n = 2, .in = {0, 1}, .out = {0, 1}};
}

double plb_tone_curve_at(const tone_curve *curve, double darkness)
{
    int k = 1;
    while (k < curve->n - 1 && curve->in[k] < darkness)
        k++;
    double step = curve->in[k] - curve->in[k - 1], part = step > 0 ? (darkness - curve->in[k - 1]) / step : 1;
    return curve->out[k - 1] + part * (curve->out[k] - curve->out[k - 1]);
}

static bool is_area(const item *it, const plan_options *o)
{
    box b = plb_path_bounds(&it->path);
    return it->kind == ITEM_FILL && fmin(b.x1 - b.x0, b.y1 - b.y0) > AREA_WIDTHS * o->shade_width && plb_fill_breadth(&it->path) > LETTER_MM;
}

static bool find_areas(survey *s)
{
    for (size_t i = 0; i < s->list->items.n; i++) {
        const item *it = &s->list->items.v[i];
        area a = {.order = i, .bounds = plb_path_bounds(&it->path), .darkness = 1 - plb_paint_lightness(it->paint)};
        if (is_area(it, s->options) && !array_push(&s->areas, a))
            return false;
    }
    return true;
}

/* Gives the last area below item number `i` at a place, if the place is well inside; NULL: none. */
static const area *area_below(survey *s, size_t i, size_t first, point at)
{
    for (size_t k = first; k-- > 0;) {
        area *a = &s->areas.v[k];
        const box *b = &a->bounds;
        if (a->order >= i || at.x < b->x0 || at.x > b->x1 || at.y < b->y0 || at.y > b->y1)
            continue;
        const item *it = &s->list->items.v[a->order];
        if (!a->region)
            a->region = plb_region_new(&it->path, it->even_odd, s->err);
        if (a->region && plb_region_contains(a->region, at, 0))
            return plb_region_covers(a->region, at, s->options->pencil_width) ? a : NULL;
    }
    return NULL;
}

static void note(double *darkest, double dark, const area *a)
{
    if (dark > a->darkness + CONTRAST)
        *darkest = fmax(*darkest, a->darkness);
}

static bool is_white_on_dark(double dark, const area *a) { return dark < WHITE && a->darkness > dark + CONTRAST; }

/* Tells whether a mark no larger than a letter is white upon white in a drawing whose raster pictures are left out: it was seen on one of those, which leaves
 * paper behind, and is written dark. */
static bool is_white_on_picture(const survey *s, const item *it, double dark, const area *a)
{
    box b = plb_path_bounds(&it->path);
    return s->list->omissions.n[OMISSION_IMAGE] && dark < WHITE && a->darkness < WHITE && b.y1 - b.y0 < WORD_HIGHEST_MM;
}

/* Looks at what lies below the middle of a letter. */
static void look_below_letter(survey *s, size_t i, size_t first)
{
    const item *it = &s->list->items.v[i];
    box b = plb_path_bounds(&it->path);
    const area *a = area_below(s, i, first, (point){(b.x0 + b.x1) / 2, (b.y0 + b.y1) / 2});
    double dark = 1 - plb_paint_lightness(it->paint);
    if (!a)
        return;
    note(&s->darkest_of_words, dark, a);
    s->is_inked[i] = is_white_on_dark(dark, a) || is_white_on_picture(s, it, dark, a);
    s->below[i] = (size_t)(a - s->areas.v);
}

/* Gives the height of a letter, mm; of a fill that says that it is a string of them that of its capitals, for brackets and tails make no word
 * larger. */
static double letter_height(const item *it)
{
    box b = plb_path_bounds(&it->path);
    return it->text ? fmin(b.y1 - b.y0, CAPITAL_EMS * it->text->em) : b.y1 - b.y0;
}

/* Gives the end of the word of white letters that begins with item number `i`, and its height. */
static size_t word_end(const survey *s, size_t i, double *height)
{
    box last = plb_path_bounds(&s->list->items.v[i].path);
    *height = letter_height(&s->list->items.v[i]);
    for (i++; i < s->list->items.n && s->is_inked[i]; i++) {
        box b = plb_path_bounds(&s->list->items.v[i].path);
        double gap = WORD_GAP * fmax(*height, b.y1 - b.y0);
        if (s->below[i] != s->below[i - 1] || b.x0 > last.x1 + gap || last.x0 > b.x1 + gap || b.y0 > last.y1 + gap || last.y0 > b.y1 + gap)
            break;
        *height = fmax(*height, letter_height(&s->list->items.v[i]));
        last = b;
    }
    return i;
}

/* Large white words are left open; what they lie on must stay dark. */
static void settle_words(survey *s)
{
    for (size_t i = 0, end; i < s->list->items.n; i = end) {
        double height = 0;
        end = s->is_inked[i] ? word_end(s, i, &height) : i + 1;
        for (size_t k = i; k < end && height >= OPEN_HEIGHT_MM && s->areas.v[s->below[k]].darkness > WHITE; k++) {
            s->lightest = fmin(s->lightest, s->areas.v[s->below[k]].darkness);
            s->is_inked[k] = false;
        }
    }
}

/* Looks at what lies below places along a line: the middles of its pieces. */
static void look_below_line(survey *s, size_t i, size_t first)
{
    const item *it = &s->list->items.v[i];
    size_t n = it->path.points.n, step = n > LOOKS ? n / LOOKS : 1, times = 0;
    double pieces = n <= 3 ? LOOKS / 2 : 2;
    const area *last = NULL;
    for (size_t k = 1; k < n; k += step)
        for (int p = 0; p < (int)pieces; p++) {
            const area *a = area_below(s, i, first, point_mix(it->path.points.v[k - 1], it->path.points.v[k], (p + .5) / pieces));
            times = a && a == last ? times + 1 : a != NULL;
            last = a;
            if (times >= LEAST_LOOKS)
                note(&s->darkest, 1 - plb_paint_lightness(it->paint), a);
        }
}

static void look_below_marks(survey *s)
{
    size_t n = s->list->items.n, first = 0;
    size_t step = (size_t)fmax(1, (double)n * (double)s->areas.n * LOOKS / MAX_COMPARED);
    for (size_t i = 0; i < n; i++) {
        const item *it = &s->list->items.v[i];
        while (first < s->areas.n && s->areas.v[first].order < i)
            first++; /* areas before number `first` lie below */
        if (first == 0 || i % step || is_area(it, s->options))
            continue;
        if (it->kind == ITEM_FILL)
            look_below_letter(s, i, first);
        else if (plb_leaves_mark(it))
            look_below_line(s, i, first);
    }
}

static void add_knot(tone_curve *c, double in, double out)
{
    c->in[c->n] = in;
    c->out[c->n++] = out;
}

/* Tells whether any area is so dark that it matters what lies on it, or may have been a picture. */
static bool is_due(const survey *s)
{
    bool dark = s->list->omissions.n[OMISSION_IMAGE] > 0;
    for (size_t k = 0; k < s->areas.n && !dark; k++)
        dark = s->areas.v[k].darkness > CARRIES_DARK;
    return dark;
}

bool plb_tone_curve_find(const display_list *list, const plan_options *o, tone_curve *curve, bool *is_inked, error *err)
{
    survey s = {.list = list, .options = o, .lightest = 1, .is_inked = is_inked, .err = err};
    *curve = plb_tone_curve_plain();
    if (o->fill != FILL_HATCH || o->colour)
        return true;
    s.below = plb_new(list->items.n, sizeof *s.below);
    bool ok = (s.below && find_areas(&s)) || plb_fail_memory(err);
    if (ok && is_due(&s)) {
        look_below_marks(&s);
        settle_words(&s);
    }
    plb_free(s.below);
    *curve = (tone_curve){.n = 1};
    if (s.darkest > CARRIES_DARK) {
        add_knot(curve, UNCHANGED * CARRIES_DARK, UNCHANGED * CARRIES_DARK);
        add_knot(curve, s.darkest, CARRIES_DARK);
    }
    if (s.darkest_of_words > fmax(CARRIES_WORDS, s.darkest)) {
        if (curve->n == 1)
            add_knot(curve, UNCHANGED * CARRIES_WORDS, UNCHANGED * CARRIES_WORDS);
        add_knot(curve, s.darkest_of_words, CARRIES_WORDS);
    }
    if (s.lightest < CARRIES_WHITE && s.lightest > curve->in[curve->n - 1])
        add_knot(curve, s.lightest, CARRIES_WHITE);
    else if (s.lightest < 1 && s.lightest > curve->in[curve->n - 1])
        add_knot(curve, s.lightest, s.lightest);
    add_knot(curve, 1, 1);
    for (size_t k = 0; k < s.areas.n; k++)
        plb_region_free(s.areas.v[k].region);
    array_free(&s.areas);
    return ok;
}
