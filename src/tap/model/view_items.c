/* SPDX-License-Identifier: MIT
 *
 * See view_items.h: a view's lines are found, joined to rows, and hidden where something lies before them; light falls on what is seen; tones
 * and lines become items of the list.
 */
#include "tap/model/view_items.h"

#include "tap/model/hidden/covered.h"

/* Widths of lines on paper, mm, of the row in ISO 128-2. The outline of the whole is the broadest. */
#define WIDTH_EDGE 0.35
#define WIDTH_OUTLINE 0.5
/* A line has nothing on one side when there is nothing so far beside it, mm, along this part of it (chosen by eye). */
#define BESIDE 0.35
#define MOSTLY 0.6
#define WIDTH_FINE 0.18
/* Hidden lines [ISO 128-2, line type 02]: dashes of 12 widths with gaps of 3. */
#define DASH_ON (12 * WIDTH_FINE)
#define DASH_OFF (3 * WIDTH_FINE)
#define FAINT 0.72 /* lightness of hidden lines that are drawn through; chosen by eye */

/* ---- items ---- */

/* Tells whether a line is mostly the outline of all that is seen. */
static bool is_outline(const run_list *l, const run *r, const surface_buffer *b)
{
    double all = 0, free = 0;
    for (size_t i = 0; i + 1 < r->n + r->is_closed && b->triangle; i++) {
        point p = l->points.v[r->first + i], q = l->points.v[r->first + (i + 1) % r->n], d = point_sub(q, p), middle = point_mix(p, q, .5);
        double length = plb_point_length(d);
        point side = length > 0 ? (point){-d.y / length * BESIDE, d.x / length * BESIDE} : (point){0, 0};
        bool is_free = plb_buffer_at(b, point_add(middle, side)) == NO_TRIANGLE || plb_buffer_at(b, point_sub(middle, side)) == NO_TRIANGLE;
        all += length;
        free += is_free ? length : 0;
    }
    return free > MOSTLY * all;
}

static bool write_run(item_writer *w, const run_list *l, const run *r, hidden_style hidden, const surface_buffer *b)
{
    item *it = &w->item;
    double grey = r->is_hidden && hidden == HIDDEN_FAINT ? FAINT : 0;
    plb_path_clear(&it->path);
    it->dash.n = 0;
    it->kind = ITEM_STROKE;
    it->clip = NO_CLIP;
    it->cap = LINE_CAP_ROUND;
    it->paint = (paint){PAINT_SOLID, grey, grey, grey, 1};
    it->width = r->is_hidden || r->kind == LINE_MATERIAL ? WIDTH_FINE : is_outline(l, r, b) ? WIDTH_OUTLINE : WIDTH_EDGE;
    if (r->is_hidden && hidden == HIDDEN_DASHED && (!array_push(&it->dash, DASH_ON) || !array_push(&it->dash, DASH_OFF)))
        return plb_fail_memory(w->err);
    for (size_t i = 0; i < r->n; i++) {
        point p = l->points.v[r->first + i];
        bool is_last = i + 1 == r->n && r->is_closed;
        if (!(i == 0 ? plb_path_move(&it->path, p) : is_last ? plb_path_close(&it->path) : plb_path_line(&it->path, p)))
            return plb_fail_memory(w->err);
    }
    plb_list_writer_item(w->w, it);
    return true;
}

void plb_view_write_page(item_writer *w, double width, double height, double scale)
{
    const double largest = 1e12;
    plb_list_writer_page(w->w, width, height);
    if (scale >= 1 / largest && scale <= largest)
        plb_list_writer_scale(w->w, scale);
}

bool plb_view_centre_line(item_writer *w, point a, point b)
{
    static const double dashes[] = {24 * WIDTH_FINE, 3 * WIDTH_FINE, .5 * WIDTH_FINE, 3 * WIDTH_FINE};
    item *it = &w->item;
    plb_path_clear(&it->path);
    it->dash.n = 0;
    it->kind = ITEM_STROKE;
    it->clip = NO_CLIP;
    it->cap = LINE_CAP_BUTT;
    it->paint = (paint){PAINT_SOLID, 0, 0, 0, 1};
    it->width = WIDTH_FINE;
    bool ok = plb_path_move(&it->path, a) && plb_path_line(&it->path, b);
    for (int i = 0; ok && i < 4; i++)
        ok = array_push(&it->dash, dashes[i]);
    if (ok)
        plb_list_writer_item(w->w, it);
    return ok || plb_fail_memory(w->err);
}

/* Paints the item at work with the area's tone: an even one, or one that changes. */
static void set_tone(item_writer *w, const tone_area *a)
{
    w->item.gradient = 0;
    w->item.paint = (paint){PAINT_SOLID, (double)a->colour.red, (double)a->colour.green, (double)a->colour.blue, 1};
    if (!a->is_round)
        return;
    gradient g = {.extend = GRADIENT_PAD, .to_space = MATRIX_IDENTITY, .from = a->from, .to = a->to, .opacity = 1};
    for (int i = 0; i < 2; i++)
        plb_gradient_add_stop(&g, (gradient_stop){i, a->colours[i].red, a->colours[i].green, a->colours[i].blue, 1});
    plb_list_writer_gradient(w->w, &g);
    w->item.paint.kind = PAINT_GRADIENT;
    w->item.gradient = ++w->gradients;
}

/* An area is a box that its outline clips, for an outline of its own would be drawn. */
static bool write_area(item_writer *w, const tone_list *l, const tone_area *a)
{
    clip c = {.even_odd = true, .parent = NO_CLIP};
    bool ok = true;
    const double beyond = 1.5; /* mm: so that the box's sides are not seen */
    if (a->colour.red >= 1 && a->colour.green >= 1 && a->colour.blue >= 1)
        return true;
    for (size_t i = a->first; ok && i < a->first + a->n; i++) {
        tone_loop loop = l->loops.v[i];
        for (size_t k = 0; ok && k < loop.n; k++) {
            point p = l->points.v[loop.first + k];
            ok = k ? plb_path_line(&c.path, p) : plb_path_move(&c.path, p);
        }
        ok = ok && plb_path_close(&c.path);
    }
    box b = plb_path_bounds(&c.path);
    path *p = &w->item.path;
    plb_path_clear(p);
    ok = ok && plb_path_move(p, (point){b.x0 - beyond, b.y0 - beyond}) && plb_path_line(p, (point){b.x1 + beyond, b.y0 - beyond}) &&
         plb_path_line(p, (point){b.x1 + beyond, b.y1 + beyond}) && plb_path_line(p, (point){b.x0 - beyond, b.y1 + beyond}) && plb_path_close(p);
    if (ok) {
        plb_list_writer_clip(w->w, &c);
        w->item.kind = ITEM_FILL;
        w->item.clip = w->clips++;
        w->item.is_directed = a->is_directed;
        w->item.direction = a->direction;
        set_tone(w, a);
        plb_list_writer_item(w->w, &w->item);
    }
    plb_path_free(&c.path);
    return ok || plb_fail_memory(w->err);
}

/* ---- one view ---- */

bool plb_view_lines(const view *v, bool keep_hidden, run_list *runs, error *err)
{
    line_pieces pieces = {0};
    chain_list chains = {0};
    box_tree tree = {0};
    bool ok = plb_line_edges(v, &pieces, err) && plb_line_contours(v, &pieces, err) && plb_line_meetings(v, &pieces, err) &&
              plb_line_chain(&pieces, &chains, err) && plb_tree_build(&tree, v, true, err) && plb_hide(v, &tree, &pieces, &chains, keep_hidden, runs, err) &&
              (!keep_hidden || plb_drop_covered(runs, err));
    plb_tree_free(&tree);
    plb_chain_list_free(&chains);
    array_free(&pieces);
    return ok;
}

bool plb_view_write(item_writer *w, const view *v, hidden_style hidden, light from)
{
    run_list runs = {0};
    tone_list tones = {0};
    surface_buffer buffer = {0};
    bool ok = plb_view_lines(v, hidden != HIDDEN_NONE, &runs, w->err);
    if (ok && v->m->triangles.n)
        ok = plb_buffer_fill(v, &buffer, w->err) && (!from.is_on || plb_shade(v, &buffer, from, &tones, w->err));
    for (size_t i = 0; ok && i < tones.areas.n; i++)
        ok = write_area(w, &tones, &tones.areas.v[i]);
    /* Lines come last: nothing hides them any more. */
    for (int pass = 0; ok && pass < 2; pass++)
        for (size_t i = 0; ok && i < runs.runs.n; i++)
            ok = runs.runs.v[i].is_hidden != (pass == 0) || write_run(w, &runs, &runs.runs.v[i], hidden, &buffer);
    plb_buffer_free(&buffer);
    plb_tone_list_free(&tones);
    plb_run_list_free(&runs);
    return ok;
}

