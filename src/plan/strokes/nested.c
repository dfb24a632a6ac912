/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: closed lines inside each other. Circles about one centre, the rings of a target, the two lines of a tube: a person minds the gap
 * between them. Input: strokes, mm. Output: how far such a closed line may deviate.
 */
#include "plan/shape/grid.h"
#include "plan/strokes/passes.h"

#include <math.h>

/* Closed lines are inside each other when the centres of their boxes are nearer than this part of the smaller one, and this, mm. */
#define SAME_CENTRE 0.25
#define CENTRE_CELL_MM 4.0
/* Each may take this share of the gap. Where the gap is smaller than the last, they are one line. */
#define SHARE_OF_GAP 0.22
#define NEAREST_MM 0.1
/* So many others are looked at: a bound on the work. */
#define MAX_NESTED_LOOKS 200

typedef struct {
    box around;
    size_t stroke;
} ring;
typedef ARRAY(ring) rings;

static point centre_of(box b)
{
    return (point){(b.x0 + b.x1) / 2, (b.y0 + b.y1) / 2};
}

/* Gives the narrowest gap between two boxes of which one lies inside the other; 0 where none does. */
static double gap_between(box a, box b)
{
    double left = b.x0 - a.x0, top = b.y0 - a.y0, right = a.x1 - b.x1, bottom = a.y1 - b.y1;
    double least = fmin(fmin(left, right), fmin(top, bottom)), most = fmax(fmax(left, right), fmax(top, bottom));
    return least > NEAREST_MM ? least : most < -NEAREST_MM ? -most : 0;
}

static void look(const grid *g, const rings *all, const ring *self, stroke *s, int64_t column, int64_t row, size_t *looks)
{
    point c = centre_of(self->around);
    double size = fmin(self->around.x1 - self->around.x0, self->around.y1 - self->around.y0);
    for (uint32_t e = plb_grid_first(g, column, row); e != GRID_END && *looks < MAX_NESTED_LOOKS; e = g->entries.v[e].next) {
        const ring *other = &all->v[g->entries.v[e].value];
        double theirs = fmin(other->around.x1 - other->around.x0, other->around.y1 - other->around.y0);
        ++*looks;
        if (other == self || plb_point_distance(c, centre_of(other->around)) > fmin(SAME_CENTRE * fmin(size, theirs), CENTRE_CELL_MM))
            continue;
        float limit = (float)(SHARE_OF_GAP * gap_between(self->around, other->around));
        if (limit > 0 && (s->max_deviation == 0 || limit < s->max_deviation))
            s->max_deviation = limit;
    }
}

bool plb_plan_nested(stroke_list *list, error *err)
{
    grid g;
    rings all = {0};
    bool ok = plb_grid_init(&g, CENTRE_CELL_MM, 64);
    for (size_t i = 0; ok && i < list->strokes.n; i++) {
        const stroke *s = &list->strokes.v[i];
        if (!s->closed || s->style.kind != STROKE_LINE)
            continue;
        ring r = {BOX_EMPTY, i};
        for (size_t k = s->first; k < s->first + s->n; k++)
            plb_box_add(&r.around, list->points.v[k]);
        point c = centre_of(r.around);
        ok = plb_grid_put(&g, plb_grid_cell(&g, c.x), plb_grid_cell(&g, c.y), (uint32_t)all.n) && array_push(&all, r);
    }
    for (size_t i = 0; ok && i < all.n; i++) {
        point c = centre_of(all.v[i].around);
        int64_t column = plb_grid_cell(&g, c.x), row = plb_grid_cell(&g, c.y);
        size_t looks = 0;
        for (int k = 0; k < 9; k++)
            look(&g, &all, &all.v[i], &list->strokes.v[all.v[i].stroke], column + k % 3 - 1, row + k / 3 - 1, &looks);
    }
    plb_grid_free(&g);
    array_free(&all);
    return ok || plb_fail_memory(err);
}
