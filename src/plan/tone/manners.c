/* SPDX-License-Identifier: MIT
 *
 * Manners of hatching: see manners.h. Paints are the nodes of a graph, whose edges join paints that look alike and are seen side by side;
 * each paint in turn takes the first manner that none of its neighbours has (greedy colouring of graphs, Welsh & Powell 1967).
 */
#include "plan/tone/manners.h"

#include "plan/hatch/hatch_tone.h"
#include "plan/item/weight.h"

#include <math.h>

/* Tones that the pencil makes look alike if they differ by less, as shares of black (chosen by eye). */
#define ALIKE 0.08
/* In a drawing of at most so many tones all are told apart, for a legend may ask for any two; in one of more those that lie so near to
 * each other, mm. */
#define FEW_PAINTS 8
#define NEAR_MM 0.5
/* An area reaches over so many widths of the pencil, either way, for smaller fills have no hatching to be told by … */
#define AREA_WIDTHS 6.0
/* … and is somewhere broader than so many mm, for what is thinner is lettering. */
#define LETTER_MM 1.2
/* Lighter tones are paper. */
#define PAPER 0.045
/* A fill that covers so much of the page is its ground and is beside everything. */
#define GROUND_COVER 0.9
/* The box of an area is compared with those of so many others at most. */
#define MAX_COMPARED 1e7

/* The usual direction, across it, and between the two; then all four with wider spacing. */
static const manner choices[] = {
    {0, 1, true}, {PLB_PI / 2, 1, true}, {PLB_PI / 4, 1, true}, {-PLB_PI / 4, 1, true},
    {0, 1.7, true}, {PLB_PI / 2, 1.7, true}, {PLB_PI / 4, 1.7, true}, {-PLB_PI / 4, 1.7, true},
};
#define CHOICES ((int)(sizeof choices / sizeof *choices))

typedef struct {
    box bounds;
    int paint;
} area;

typedef ARRAY(area) areas;

static bool is_same_paint(const paint *a, const paint *b)
{
    return a->red == b->red && a->green == b->green && a->blue == b->blue && a->alpha == b->alpha;
}

static int find_paint(const paint_manners *m, const paint *p)
{
    for (int i = 0; i < m->n; i++)
        if (is_same_paint(&m->paints[i], p))
            return i;
    return -1;
}

static bool is_hatched(const display_list *list, size_t i, const plan_options *o, const tone_curve *curve, const cell_groups *cells)
{
    const item *it = &list->items.v[i];
    box b = plb_path_bounds(&it->path);
    double least = AREA_WIDTHS * o->shade_width, w = b.x1 - b.x0, h = b.y1 - b.y0;
    return it->kind == ITEM_FILL && it->paint.kind == PAINT_SOLID && fmin(w, h) > least && plb_fill_breadth(&it->path) > LETTER_MM && w * h < GROUND_COVER * list->width * list->height &&
           plb_tone_curve_at(curve, 1 - plb_paint_lightness(it->paint)) > PAPER && !plb_cells_group(cells, i);
}

/* Collects areas and paints; too many paints make none. */
static bool collect(const display_list *list, const plan_options *o, const tone_curve *curve, const cell_groups *cells, paint_manners *m, areas *all)
{
    for (size_t i = 0; i < list->items.n; i++) {
        if (!is_hatched(list, i, o, curve, cells))
            continue;
        const paint *p = &list->items.v[i].paint;
        int k = find_paint(m, p);
        if (k < 0 && m->n == MANNERS_MAX_PAINTS) {
            m->n = 0;
            return true;
        }
        if (k < 0) {
            k = m->n++;
            m->paints[k] = *p;
            m->manners[k] = (manner){0, 1, false};
        }
        if (!array_push(all, ((area){plb_path_bounds(&list->items.v[i].path), k})))
            return false;
    }
    return true;
}

static bool are_near(box a, box b)
{
    return a.x0 < b.x1 + NEAR_MM && b.x0 < a.x1 + NEAR_MM && a.y0 < b.y1 + NEAR_MM && b.y0 < a.y1 + NEAR_MM;
}

typedef struct {
    bool is[MANNERS_MAX_PAINTS][MANNERS_MAX_PAINTS];
} relation;

/* Finds which paints look alike and are seen together. */
static void relate(const paint_manners *m, const areas *all, const plan_options *o, const tone_curve *curve, relation *alike)
{
    double tone[MANNERS_MAX_PAINTS];
    bool is_near[MANNERS_MAX_PAINTS][MANNERS_MAX_PAINTS] = {0};
    size_t step = (size_t)fmax(1, (double)all->n * (double)all->n / MAX_COMPARED);
    for (size_t i = 0; m->n > FEW_PAINTS && i < all->n; i += step)
        for (size_t k = 0; k < i; k++)
            if (are_near(all->v[i].bounds, all->v[k].bounds))
                is_near[all->v[i].paint][all->v[k].paint] = is_near[all->v[k].paint][all->v[i].paint] = true;
    for (int i = 0; i < m->n; i++)
        tone[i] = plb_tone_within_reach(plb_tone_curve_at(curve, 1 - plb_paint_lightness(m->paints[i])), o);
    for (int i = 0; i < m->n; i++)
        for (int k = 0; k < m->n; k++)
            alike->is[i][k] = i != k && fabs(tone[i] - tone[k]) < ALIKE && (m->n <= FEW_PAINTS || is_near[i][k]);
}

/* Gives each paint the first manner that none of those like it has had. */
static void choose(paint_manners *m, const relation *alike)
{
    int chosen[MANNERS_MAX_PAINTS];
    bool is_like_another[MANNERS_MAX_PAINTS] = {false};
    for (int i = 0; i < m->n; i++) {
        bool is_taken[CHOICES + 1] = {false};
        for (int k = 0; k < i; k++)
            if (alike->is[i][k])
                is_taken[chosen[k]] = is_like_another[i] = is_like_another[k] = true;
        for (chosen[i] = 0; chosen[i] < CHOICES - 1 && is_taken[chosen[i]];)
            chosen[i]++;
    }
    for (int i = 0; i < m->n; i++)
        if (is_like_another[i])
            m->manners[i] = choices[chosen[i]];
}

bool plb_manners_find(const display_list *list, const plan_options *o, const tone_curve *curve, const cell_groups *cells, paint_manners *m, error *err)
{
    areas all = {0};
    relation alike;
    m->n = 0;
    if (o->fill != FILL_HATCH || o->colour)
        return true;
    bool ok = collect(list, o, curve, cells, m, &all) || plb_fail_memory(err);
    if (ok && m->n > 1) {
        relate(m, &all, o, curve, &alike);
        choose(m, &alike);
    }
    array_free(&all);
    return ok;
}

manner plb_manner_of(const paint_manners *m, const paint *p)
{
    int k = p->kind == PAINT_SOLID ? find_paint(m, p) : -1;
    return k < 0 ? (manner){0, 1, false} : m->manners[k];
}
