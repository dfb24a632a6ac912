/* SPDX-License-Identifier: MIT
 *
 * Fills with PostScript tiling patterns (PLRM, section 4.9): the cell, a procedure, runs once for each tile that may
 * touch the path, with the path as the clip. So the hatching of a drawing comes as its lines. Where the tiles would be
 * too many, the fill stays one item with a mean colour.
 */
#include "tap/ps/ps.h"

#include <math.h>

#define MAX_TILES 2500.0 /* of one fill; chosen by eye: more of them are a tone, not lines */

typedef struct {
    const ps_dict *pattern;
    ps_object proc;
    matrix to_device; /* from the pattern's space */
    double first_x, first_y, step_x, step_y;
    uint32_t columns, tiles;
    int clip;
    bool nothing_visible;
    paint paint;
    uint32_t states; /* graphics states while no tile is being drawn */
    bool in_tile;
} tiling;

/* Copies the pattern's dictionary; the copy keeps the matrix of its making. */
static bool op_makepattern(ps *p)
{
    ps_object *v = ps_args(p, 2), kept;
    const ps_dict *from = v[0].as.dict;
    ps_dict *copy = plb_ps_new_dict(p, from->live + 1);
    matrix m;
    if (!copy || !plb_ps_get_matrix(p, v[1], &m) || !plb_ps_new_array(p, 6, &kept))
        return false;
    plb_ps_put_matrix(kept, plb_matrix_multiply(m, ps_gs(p)->ctm));
    for (uint32_t i = 0; i < from->used; i++)
        if (from->entries[i].key.type != PS_NULL && !plb_ps_put(p, copy, from->entries[i].key, from->entries[i].value))
            return false;
    return plb_ps_put_text(p, copy, "Implementation", kept) && plb_ps_charge(p, from->used) &&
           plb_ps_give(p, 2, ps_of_dict(copy));
}

static bool number_in(ps *p, const ps_dict *d, const char *key, double *out)
{
    ps_object *v = plb_ps_get_text(p, d, key);
    if (!v || !ps_is_number(*v))
        return false;
    *out = ps_value(*v);
    return true;
}

static bool cell_box(ps *p, const ps_dict *d, box *out)
{
    ps_object *v = plb_ps_get_text(p, d, "BBox");
    if (!v || v->type != PS_ARRAY || v->n != 4)
        return false;
    const ps_object *b = v->as.array;
    *out = (box){ps_value(b[0]), ps_value(b[1]), ps_value(b[2]), ps_value(b[3])};
    return out->x1 > out->x0 && out->y1 > out->y0;
}

/* Gives the bounds of the visible part of the path, in the pattern's space. */
static box bounds_to_cover(ps *p, matrix from_device)
{
    box b = plb_path_bounds(&ps_gs(p)->path->path), c = plb_ps_clip_bounds(p), out = BOX_EMPTY;
    b = (box){fmax(b.x0, c.x0), fmax(b.y0, c.y0), fmin(b.x1, c.x1), fmin(b.y1, c.y1)};
    for (int i = 0; !plb_box_is_empty(b) && i < 4; i++)
        plb_box_add(&out, plb_matrix_apply(from_device, (point){i & 1 ? b.x1 : b.x0, i & 2 ? b.y1 : b.y0}));
    return out;
}

/* Gives the tiles that cover the bounds; false: none, or too many. */
static bool count_tiles(tiling *t, box cover, box cell)
{
    double i0 = floor((cover.x0 - cell.x1) / t->step_x) + 1, i1 = ceil((cover.x1 - cell.x0) / t->step_x) - 1;
    double j0 = floor((cover.y0 - cell.y1) / t->step_y) + 1, j1 = ceil((cover.y1 - cell.y0) / t->step_y) - 1;
    double columns = i1 - i0 + 1, rows = j1 - j0 + 1;
    if (!(columns >= 1 && rows >= 1 && columns <= MAX_TILES && rows <= MAX_TILES && columns * rows <= MAX_TILES))
        return false;
    t->first_x = i0 * t->step_x;
    t->first_y = j0 * t->step_y;
    t->columns = (uint32_t)columns;
    t->tiles = (uint32_t)(columns * rows);
    return true;
}

static bool plan(ps *p, tiling *t)
{
    const ps_dict *d = t->pattern = ps_gs(p)->pattern.as.dict;
    ps_object *m = plb_ps_get_text(p, d, "Implementation"), *proc = plb_ps_get_text(p, d, "PaintProc");
    matrix inverse;
    box cell;
    if (!m || m->type != PS_ARRAY || m->n != 6 || !proc || !ps_is_proc(*proc) || !cell_box(p, d, &cell))
        return false;
    if (!number_in(p, d, "XStep", &t->step_x) || !number_in(p, d, "YStep", &t->step_y))
        return false;
    t->proc = *proc;
    t->step_x = fabs(t->step_x);
    t->step_y = fabs(t->step_y);
    const ps_object *v = m->as.array;
    t->to_device = (matrix){ps_value(v[0]), ps_value(v[1]), ps_value(v[2]), ps_value(v[3]), ps_value(v[4]), ps_value(v[5])};
    return plb_matrix_invert(t->to_device, &inverse) && count_tiles(t, bounds_to_cover(p, inverse), cell);
}

static void leave_tile(ps *p, tiling *t)
{
    if (t->in_tile)
        plb_ps_restore_to(p, t->states);
    t->in_tile = false;
}

static void drop_tiling(ps *p, ps_frame *f)
{
    leave_tile(p, f->data);
}

/* Makes a state like the one a page starts with, at tile `i`, in the fill's clip and colour. */
static bool enter_tile(ps *p, tiling *t, uint32_t i)
{
    double x = t->first_x + t->step_x * (i % t->columns), y = t->first_y + t->step_y * (i / t->columns);
    t->states = p->state_count;
    if (!plb_ps_save_state(p))
        return false;
    t->in_tile = true;
    plb_ps_reset_graphics(p);
    ps_state *g = ps_gs(p);
    g->clip = t->clip;
    g->nothing_visible = t->nothing_visible;
    g->paint = t->paint;
    return plb_ps_set_ctm(p, plb_matrix_multiply((matrix){1, 0, 0, 1, x, y}, t->to_device));
}

static bool step_tiling(ps *p, ps_frame *f)
{
    tiling *t = f->data;
    leave_tile(p, t);
    if (f->index >= t->tiles) {
        plb_ps_pop_frame(p);
        return true;
    }
    return enter_tile(p, t, f->index++) && plb_ps_push(p, ps_of_dict((ps_dict *)t->pattern)) && plb_ps_execute(p, t->proc);
}

bool plb_ps_fill_with_tiles(ps *p, bool even_odd, bool *done)
{
    tiling t = {0}, *kept;
    ps_state *g = ps_gs(p);
    int clip_before = g->clip;
    *done = false;
    if (g->is_outline || !plan(p, &t))
        return p->err.kind == ERROR_NONE;
    bool good = plb_ps_clip_to_path(p, even_odd);
    t.clip = g->clip;
    t.nothing_visible = g->nothing_visible;
    g->clip = clip_before;
    g->nothing_visible = false;
    if (!good || !(kept = plb_ps_new(p, 1, sizeof *kept)))
        return false;
    t.paint = g->paint;
    t.paint.kind = PAINT_SOLID;
    *kept = t;
    ps_frame *f = plb_ps_push_frame(p, step_tiling);
    if (!f)
        return false;
    f->data = kept;
    f->drop = drop_tiling;
    return *done = true;
}

const ps_operator plb_ps_pattern_operators[] = {
    {"makepattern", "da", op_makepattern},
    {NULL, NULL, NULL},
};
