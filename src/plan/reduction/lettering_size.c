/* SPDX-License-Identifier: MIT
 *
 * Reduction: how high the lettering is. Some fills say which letters they show, and how large the font is; of others only the
 * shapes are known. Lettering is told from other small shapes
 * by how it stands: a run of parts, one beside the other, nearly all with their feet or heads on one line, and not all
 * alike. In a run with ascenders or capitals the lower-case letters are the shorter ones; a run of one height alone, such
 * as a number, is compared with the other runs, and its height counts as that of capitals where nothing tells.
 */
#include "plan/reduction/needs.h"

#include "base/sort.h"

#include <math.h>
#include <stdlib.h>

/* Lower-case letters must be so high, mm: what a hand with a pencil writes small and clear. */
#define X_HEIGHT_MM 2.0
/* Capitals and figures are so many times as high as an x (Helvetica 1.37, Times 1.48, DejaVu 1.33). */
#define CAPITALS 1.4
/* Where a font's size is known, an x is this part of it high (Times .45, Helvetica .52, DejaVu .55). */
#define X_HEIGHT_EMS 0.5
/* The share of the letters that may be smaller. */
#define SMALLER 0.05
/* Letters have a height within these bounds, mm: below no reduction makes them readable, above none is needed. */
#define LOWEST_MM 0.35
#define HIGHEST_MM 12.0
/* All of these are chosen by eye, on fonts from light to heavy and on maps, meshes and clouds of markers, which must not pass. */
#define MIN_SLENDER 2.2  /* a letter's size to its stroke's width, at least … */
#define MAX_SLENDER 40.0 /* … and at most */
#define PLAIN_SIDES 7    /* a contour of so many straight sides may be a bar, an arrow, a triangle */
#define PLAIN_LINES 3    /* so many straight lines may be a tick, a cross */
#define GAP 1.2          /* between neighbours, of the run's size: a blank and a wide letter's side */
#define OFF_LINE 0.12    /* a letter stands on the line when it misses the line by less than this share of the height */
#define ON_LINE 0.7      /* the share of the letters that must stand so; all where they are few */
#define FEW 3            /* so many letters are lettering only where others have their height: */
#define ENOUGH 6         /* so many letters of runs, long or short */
#define SHORT_LEAST 0.55 /* lower-case letters, as a share of the tallest */
#define SHORT_MOST 0.88
#define ALIKE 0.04       /* shapes whose sides differ by less are alike */
/* Heights are counted in steps of 3 %. */
#define HEIGHT_STEP 0.03
#define HEIGHTS 130

enum { RIGHTWARD = 1, UPWARD = 2, DOWNWARD = 4 };

typedef struct {
    double height; /* mm */
    size_t n;      /* letters */
    bool is_sure;  /* they are letters; else they are where there is lettering of their height */
    size_t first, end; /* their parts */
} height_count;

typedef struct {
    small_parts *parts;
    letter_heights *x_heights; /* of each letter, mm; borrowed */
    ARRAY(height_count) even;  /* runs whose letters all have one height, and letters by themselves (n = 1) */
    size_t few[HEIGHTS];                /* letters of short runs, by their height */
    size_t low[HEIGHTS], tall[HEIGHTS]; /* letters of lower-case and of capital height, where both are known */
    ARRAY(double) bottom, top, short_height; /* of the run at work */
} lettering_survey;

static double stem_of(const small_part *p)
{
    return p->is_fill ? 2 * fabs(p->area) / fmax(p->perimeter, 1e-9) : fmax(p->width, 1e-9);
}

/* Tells a part whose shape and size let it be a letter. Dots, bars, ticks, plain markers may stand in a run, but tell nothing. */
static bool is_letter(const small_part *p)
{
    double w = p->bounds.x1 - p->bounds.x0, h = p->bounds.y1 - p->bounds.y0, size = fmax(w, h);
    if (fmin(w, h) < LOWEST_MM / 2 || size < LOWEST_MM || size > HIGHEST_MM)
        return false;
    bool is_plain = (p->curves == 0 && (p->is_fill ? p->contours == 1 && p->lines <= PLAIN_SIDES : p->lines <= PLAIN_LINES + (p->is_open ? 0u : 1u))) || (!p->is_fill && !p->is_open && p->contours == 1);
    bool is_slender = size > MIN_SLENDER * stem_of(p) && (!p->is_fill || size < MAX_SLENDER * stem_of(p));
    return !is_plain && is_slender && (p->is_fill || p->perimeter < 8 * size);
}

static int height_index(double mm)
{
    int k = (int)lround(log(mm / LOWEST_MM) / log(1 + HEIGHT_STEP));
    return k < 1 ? 1 : k > HEIGHTS - 2 ? HEIGHTS - 2 : k;
}

static size_t count_near(const size_t *heights, double mm)
{
    int k = height_index(mm);
    return heights[k - 1] + heights[k] + heights[k + 1];
}

/* ---- runs ---- */

/* Tells in which of the three directions of reading `b` may follow `a` in a run of letters of about `size` mm. */
static int ways_from(box a, box b, double size)
{
    double right = b.x0 - a.x1, up = a.y0 - b.y1, down = b.y0 - a.y1;
    double move_x = (b.x0 + b.x1 - a.x0 - a.x1) / 2, move_y = (b.y0 + b.y1 - a.y0 - a.y1) / 2;
    double beside_y = fmin(a.y1, b.y1) - fmax(a.y0, b.y0), beside_x = fmin(a.x1, b.x1) - fmax(a.x0, b.x0);
    int ways = 0;
    if (beside_y > -size / 2 && move_x > -size / 3 && right < GAP * size && right > -size)
        ways |= RIGHTWARD;
    if (beside_x > -size / 2 && move_y < size / 3 && up < GAP * size && up > -size)
        ways |= UPWARD;
    if (beside_x > -size / 2 && move_y > -size / 3 && down < GAP * size && down > -size)
        ways |= DOWNWARD;
    return ways;
}

/* Gives the part as it stands on a line read in the direction `way`: heights grow upward from there. */
static box upright(box b, int way)
{
    if (way == RIGHTWARD)
        return (box){b.x0, -b.y1, b.x1, -b.y0};
    return way == UPWARD ? (box){-b.y1, -b.x1, -b.y0, -b.x0} : (box){b.y0, b.x0, b.y1, b.x1};
}

static double median(double *v, size_t n)
{
    return plb_low_quantile(v, n, 0.5);
}

static bool collect(lettering_survey *s, size_t first, size_t end, int way, double *size, bool *differ)
{
    double least[2] = {1e300, 1e300}, most[2] = {0, 0};
    s->bottom.n = s->top.n = s->short_height.n = 0;
    for (size_t i = first; i < end; i++) {
        if (!is_letter(&s->parts->v[i]))
            continue;
        box b = upright(s->parts->v[i].bounds, way);
        double side[2] = {b.x1 - b.x0, b.y1 - b.y0};
        if (!array_push(&s->bottom, b.y0) || !array_push(&s->top, b.y1))
            return false;
        for (int k = 0; k < 2; k++) {
            least[k] = fmin(least[k], side[k]);
            most[k] = fmax(most[k], side[k]);
        }
    }
    *size = most[1];
    *differ = most[0] - least[0] > ALIKE * most[0] || most[1] - least[1] > ALIKE * most[1];
    return true;
}

static void mark_lettering(lettering_survey *s, size_t first, size_t end)
{
    for (size_t i = first; i < end; i++)
        s->parts->v[i].is_lettering = true;
}

/* Takes in a run of letters that stands on a line, or finds that it does not. */
static bool judge(lettering_survey *s, size_t first, size_t end, int way)
{
    double size = 0;
    bool differ = false;
    if (!collect(s, first, end, way, &size, &differ))
        return false;
    size_t n = s->bottom.n, on = 0, raised = 0;
    if (n == 1)
        return size > HIGHEST_MM || array_push(&s->even, ((height_count){size, 1, false, first, end}));
    if (n == 0 || !array_reserve(&s->short_height, 2 * n))
        return n == 0;
    double *spare = s->short_height.v;
    for (size_t i = 0; i < n; i++) {
        spare[i] = s->bottom.v[i];
        spare[n + i] = s->top.v[i];
    }
    double foot = median(spare, n), head = median(spare + n, n), off = OFF_LINE * size, tallest = 0;
    for (size_t i = 0; i < n; i++) {
        bool stands = fabs(s->bottom.v[i] - foot) < off;
        raised += !stands && fabs(s->top.v[i] - head) > off && s->top.v[i] - s->bottom.v[i] < SHORT_MOST * size;
        on += stands || fabs(s->top.v[i] - head) < off;
        tallest = stands ? fmax(tallest, s->top.v[i] - s->bottom.v[i]) : tallest;
    }
    if ((double)on < ON_LINE * (double)n || (n <= FEW && on + (on > 1 ? raised : 0) < n) || tallest < LOWEST_MM)
        return true;
    for (size_t i = 0; i < n; i++) {
        double h = s->top.v[i] - s->bottom.v[i];
        if (fabs(s->bottom.v[i] - foot) < off && h > SHORT_LEAST * tallest && h < SHORT_MOST * tallest)
            s->short_height.v[s->short_height.n++] = h;
    }
    s->few[height_index(tallest)] += differ && on <= FEW && (on == FEW || s->parts->v[first].is_fill) ? on : 0;
    if (s->short_height.n == 0 || !differ || on <= FEW)
        return array_push(&s->even, ((height_count){tallest, n, differ && on > FEW, first, end}));
    double x = median(s->short_height.v, s->short_height.n);
    mark_lettering(s, first, end);
    s->low[height_index(x)] += n;
    s->tall[height_index(tallest)] += n;
    for (size_t i = 0; i < n; i++)
        if (!array_push(s->x_heights, x))
            return false;
    return true;
}

/* Walks along the parts and cuts them into runs. */
static bool find_runs(lettering_survey *s)
{
    const small_parts *parts = s->parts;
    size_t first = 0;
    int ways = 0;
    double size = 0;
    for (size_t i = 0; i < parts->n; i++) {
        const small_part *p = &parts->v[i];
        double own = plb_box_size(p->bounds), near = fmax(size, is_letter(p) ? own : 0);
        bool goes_on = i > first && p->is_fill == p[-1].is_fill && (is_letter(p) ? own < 4 * size || size <= 0 : own <= 2 * size);
        int now = goes_on ? (i == first + 1 ? ~0 : ways) & ways_from(p[-1].bounds, p->bounds, near > 0 ? near : own) : 0;
        if (now == 0) {
            if (!judge(s, first, i, ways & RIGHTWARD || ways == 0 ? RIGHTWARD : ways & UPWARD ? UPWARD : DOWNWARD))
                return false;
            first = i;
            size = 0;
        }
        ways = now;
        if (is_letter(p))
            size = fmax(size, own);
    }
    return judge(s, first, parts->n, ways & RIGHTWARD || ways == 0 ? RIGHTWARD : ways & UPWARD ? UPWARD : DOWNWARD);
}

/* Takes in the runs of one height, by what is known of the others. */
static bool settle_even_runs(lettering_survey *s)
{
    size_t runs[HEIGHTS] = {0};
    bool ok = true;
    for (size_t i = 0; i < s->even.n; i++)
        if (s->even.v[i].is_sure)
            runs[height_index(s->even.v[i].height)] += s->even.v[i].n;
    for (size_t i = 0; ok && i < s->even.n; i++) {
        height_count e = s->even.v[i];
        size_t low = count_near(s->low, e.height), tall = count_near(s->tall, e.height);
        /* A shape by itself, or two, are letters where there is lettering of their height. */
        bool has_like = low + tall + count_near(runs, e.height) + count_near(s->few, e.height) >= ENOUGH;
        if (!e.is_sure && !has_like)
            continue;
        mark_lettering(s, e.first, e.end);
        for (size_t k = 0; ok && k < e.n; k++)
            ok = array_push(s->x_heights, low > tall ? e.height : e.height / CAPITALS);
    }
    return ok;
}

bool plb_lettering_add_text(letter_heights *known, const text_run *text)
{
    size_t n = text->characters.n;
    if (!array_reserve(known, n))
        return false;
    for (size_t i = 0; i < n; i++)
        known->v[known->n++] = X_HEIGHT_EMS * text->em;
    return true;
}

bool plb_lettering_need(small_parts *parts, letter_heights *known, double *need)
{
    lettering_survey s = {.parts = parts, .x_heights = known};
    bool ok = parts->n == 0 || (find_runs(&s) && settle_even_runs(&s));
    double x = ok ? plb_low_quantile(known->v, known->n, SMALLER) : 0;
    *need = x > 0 ? X_HEIGHT_MM / x : 0;
    array_free(&s.even);
    array_free(&s.bottom);
    array_free(&s.top);
    array_free(&s.short_height);
    return ok;
}
