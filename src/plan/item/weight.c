/* SPDX-License-Identifier: MIT
 *
 * Weight and tone: see weight.h. A pencil has one width; a line that is wider than most of the drawing's is pressed
 * harder, a finer one less, a paler one less too. Where all lines are alike and black all have the usual pressure.
 */
#include "plan/item/weight.h"

#include <math.h>
#include <stdlib.h>

/* Paint lighter than this leaves no mark on white paper (a faint grey grid of 0.9 still does). */
#define NO_MARK_LIGHTNESS 0.985
/* A line is wide from so many widths of the pencil's line on (chosen by eye: up to there pressure can tell). */
#define WIDE_WIDTHS 2.5
/* Pressure goes with the square root of the relative width, with this power of the darkness, and within bounds
 * (chosen by eye). */
#define TONE_POWER 0.7
#define MIN_TONE 0.3
#define MIN_WEIGHT 0.6
#define MAX_WEIGHT 1.6
/* On a sheet that is reduced lines are pressed by this power of the reduction: they become finer, and would be paler than those of a drawing of the same
 * size (chosen by eye; the sheet's own darkness needs the power 1.8, which fills the grain). */
#define REDUCED_POWER 1.0
/* Colours less saturated than this are drawn with graphite. */
#define MIN_CHROMA 0.12

bool plb_leaves_mark(const item *it)
{
    return plb_paint_lightness(it->paint) <= NO_MARK_LIGHTNESS;
}

bool plb_is_wide(const item *it, const plan_options *o)
{
    return it->kind == ITEM_STROKE && it->width > WIDE_WIDTHS * o->pencil_width;
}

typedef struct {
    double width, length;
} share;

static int compare_shares(const void *a, const void *b)
{
    double x = ((const share *)a)->width, y = ((const share *)b)->width;
    return (x > y) - (x < y);
}

/* Measures the control polygon: near enough for a median. */
static double rough_length(const path *p)
{
    double sum = 0;
    const point *at = p->points.v;
    for (size_t i = 0; i < p->ops.n; i++)
        for (int k = 0, n = p->ops.v[i] == PATH_CURVE ? 3 : p->ops.v[i] != PATH_CLOSE; k < n; k++, at++)
            if (p->ops.v[i] != PATH_MOVE)
                sum += plb_point_distance(at[-1], at[0]);
    return sum;
}

double plb_fill_breadth(const path *p)
{
    double area = 0, length = 0;
    const point *at = p->points.v;
    point first = {0, 0};
    for (size_t i = 0; i < p->ops.n; i++) {
        if (p->ops.v[i] == PATH_MOVE)
            first = *at++;
        else if (p->ops.v[i] != PATH_CLOSE)
            for (int k = 0, n = p->ops.v[i] == PATH_CURVE ? 3 : 1; k < n; k++, at++) {
                area += point_cross(point_sub(at[-1], first), point_sub(at[0], first)) / 2;
                length += plb_point_distance(at[-1], at[0]);
            }
        else
            length += plb_point_distance(at[-1], first);
    }
    return length > 0 ? 2 * fabs(area) / length : 0;
}

bool plb_usual_width(const display_list *list, const plan_options *o, double *width, error *err)
{
    ARRAY(share) shares = {0};
    double whole = 0, sum = 0;
    bool ok = true;
    for (size_t i = 0; ok && i < list->items.n; i++) {
        const item *it = &list->items.v[i];
        if (it->kind != ITEM_STROKE || !plb_leaves_mark(it) || plb_is_wide(it, o))
            continue;
        share s = {it->width, rough_length(&it->path)};
        whole += s.length;
        ok = array_push(&shares, s);
    }
    *width = o->pencil_width;
    if (ok && shares.n)
        qsort(shares.v, shares.n, sizeof *shares.v, compare_shares);
    for (size_t i = 0; ok && i < shares.n && sum <= whole / 2; i++) {
        *width = shares.v[i].width;
        sum += shares.v[i].length;
    }
    array_free(&shares);
    return ok || plb_fail_memory(err);
}

static double within(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

/* Gives the colour 0xRRGGBB as it looks over white; 0 for what graphite can do. */
static uint32_t colour_of(paint p)
{
    double c[3] = {p.red, p.green, p.blue}, low = 1, high = 0;
    uint32_t rgb = 0;
    for (int i = 0; i < 3; i++) {
        low = fmin(low, c[i]);
        high = fmax(high, c[i]);
        rgb = rgb << 8 | (uint32_t)lround(within(c[i], 0, 1) * 255);
    }
    return high - low < MIN_CHROMA ? 0 : rgb;
}

stroke_style plb_style_of(const item *it, const plan_options *o, double usual)
{
    stroke_style t = STROKE_STYLE_USUAL;
    double weight = it->kind == ITEM_FILL || !(usual > 0) || plb_is_wide(it, o) ? 1 : sqrt(it->width / usual);
    t.colour = o->colour ? colour_of(it->paint) : 0;
    double dark = t.colour ? it->paint.alpha : 1 - plb_paint_lightness(it->paint);
    double tone = fmax(pow(within(dark, 0, 1), TONE_POWER), MIN_TONE);
    t.pressure = (float)(tone * within(weight, MIN_WEIGHT, MAX_WEIGHT) * pow(o->reduction, REDUCED_POWER));
    return t;
}
