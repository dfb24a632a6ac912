/* SPDX-License-Identifier: MIT
 *
 * Paints for the CairoScript reader: paths become items of the display list. A group (a surface of its own that is then
 * painted) is spliced in place: its items, mapped by the pattern's matrix, under the current clip.
 */
#include "tap/common/tap_area.h"
#include "tap/svg/cairoscript_state.h"

/* A clip that was made before is looked for so far back: the same clip comes again for each element. */
#define CLIPS_BACK 8

/* Counts what a group holds against the bound for all groups alive, because groups can be painted twice in each group above. */
static bool count_held(script_state *s, script_surface *f)
{
    if (f->list == &s->page)
        return true;
    size_t held = f->list->points + (f->list->items.n + f->list->clips.n) * SCRIPT_ITEM_POINTS;
    s->held += held - f->held;
    f->held = held;
    return s->held <= LIST_MAX_POINTS || plb_fail(s->err, ERROR_LIMIT, "the drawing's groups hold more than %u points", LIST_MAX_POINTS);
}

static void drop_text(item *it)
{
    plb_text_run_free(it->text);
    it->text = NULL;
}

/* Copies the item, whose path `m` maps to the list; all else is in the list's units. */
static bool copy_item(script_state *s, const item *from, matrix m, item *to)
{
    *to = *from;
    to->path = (path){0};
    to->text = NULL;
    to->dash.v = NULL;
    to->dash.n = to->dash.capacity = 0;
    bool ok = plb_path_append(&to->path, &from->path, m) && array_reserve(&to->dash, from->dash.n);
    for (size_t i = 0; ok && i < from->dash.n; i++)
        to->dash.v[to->dash.n++] = from->dash.v[i];
    if (ok && from->text) {
        to->text = plb_text_run_copy(from->text, 1);
        ok = to->text;
        if (ok && !plb_text_run_map(to->text, m, false))
            drop_text(to);
    }
    if (ok)
        return true;
    plb_item_free(to);
    return plb_fail_memory(s->err);
}

/* Adds an item: on the page the item is written, in a group kept. `it` stays the caller's. */
static bool add_item(script_state *s, script_surface *f, const item *it, matrix m)
{
    item copy;
    if (f->list == &s->page)
        return plb_script_write_item(s, it, m);
    if (!copy_item(s, it, m, &copy))
        return false;
    if (!plb_list_add(f->list, &copy, s->err)) {
        plb_item_free(&copy);
        return false;
    }
    return count_held(s, f);
}

/* Gives the index of the clip in the surface's list, which gets the clip unless the same one is there already. `m` maps
 * the clip's path to the list. */
static bool add_clip(script_state *s, script_surface *f, const clip *c, matrix m, int *index)
{
    clip narrow = {.even_odd = c->even_odd, .parent = c->parent};
    if (!plb_path_append(&narrow.path, &c->path, m)) {
        plb_path_free(&narrow.path);
        return plb_fail_memory(s->err);
    }
    size_t n = f->list->clips.n;
    for (size_t back = 1; back <= CLIPS_BACK && back <= n; back++) {
        const clip *other = &f->list->clips.v[n - back];
        if (other->parent != narrow.parent || other->even_odd != narrow.even_odd || !plb_path_equal(&other->path, &narrow.path))
            continue;
        plb_path_free(&narrow.path);
        *index = (int)(n - back);
        return true;
    }
    if (!plb_list_add_clip(f->list, &narrow, index, s->err)) {
        plb_path_free(&narrow.path);
        return false;
    }
    return f->list == &s->page ? plb_script_write_clip(s, c, m) : count_held(s, f);
}

bool plb_script_clip(script_state *s, script_context *c)
{
    clip narrow = {.path = c->path, .even_odd = c->even_odd, .parent = c->clip};
    return add_clip(s, c->target, &narrow, c->target->to_list, &c->clip);
}

static bool add_gradient(script_state *s, script_surface *f, const gradient *g, unsigned *index)
{
    size_t n = f->list->gradients.n;
    *index = 0;
    if (!plb_script_is_sane_gradient(g))
        return true;
    if (!plb_list_add_gradient(f->list, g, index, s->err))
        return false;
    if (f->list == &s->page && f->list->gradients.n > n)
        plb_script_write_gradient(s, g);
    return true;
}

static paint source_paint(const script_pattern *p)
{
    if (!p)
        return (paint){PAINT_SOLID, 0, 0, 0, 1};
    paint colour = p->paint;
    if (p->surface)
        colour = (paint){PAINT_PATTERN, 0.5, 0.5, 0.5, 1};
    if (p->stops) {
        double k = 1.0 / p->stops;
        colour = (paint){PAINT_GRADIENT, colour.red * k, colour.green * k, colour.blue * k, colour.alpha * k};
    }
    return colour;
}

/* Gives the paint as the operator applies it. To multiply by a colour is to lay a glass over what is there, as dark and
 * as strongly coloured as can be: over white the glass looks like the colour, and it hides nothing. */
static paint as_applied(const script_context *c, paint p)
{
    double lightest = fmin(p.red, fmin(p.green, p.blue)), opaque = 1 - lightest;
    if (!c->multiplies || p.kind != PAINT_SOLID || !(opaque > 0))
        return c->multiplies && p.kind == PAINT_SOLID ? (paint){PAINT_SOLID, 1, 1, 1, 0} : p;
    return (paint){PAINT_SOLID, (p.red - lightest) / opaque, (p.green - lightest) / opaque, (p.blue - lightest) / opaque, p.alpha * opaque};
}

/* Gives the source's gradient, with its place on the surface's list. 0: there is none, or one that is squeezed flat. */
static bool add_source(script_state *s, script_surface *f, const script_pattern *p, const path *fills, unsigned *index)
{
    matrix back;
    *index = 0;
    if (!p || !p->gradient || !plb_matrix_invert(f->to_list, &back))
        return true;
    gradient g = *p->gradient;
    g.to_space = plb_matrix_multiply(back, plb_script_gradient_matrix(s, p, fills));
    return add_gradient(s, f, &g, index);
}

static bool is_group(const script_pattern *p)
{
    return p && p->surface && !p->repeats;
}

/* cairo ends a closed path with a move back to its start; alone, that move draws nothing. */
static void drop_last_move(path *p)
{
    if (!p->ops.n || p->ops.v[p->ops.n - 1] != PATH_MOVE)
        return;
    p->ops.n--;
    p->points.n--;
}

/* Makes an item of the target's list from the context's path, borrowed and in the surface's units, and its paint. */
static bool start_item(script_state *s, const script_context *c, item_kind kind, item *it)
{
    *it = (item){.kind = kind, .path = c->path, .paint = as_applied(c, source_paint(c->source)), .clip = c->clip};
    drop_last_move(&it->path);
    return add_source(s, c->target, c->source, &c->path, &it->gradient);
}

/* ---- groups ----------------------------------------------------------------------------------------------- */

/* Adds the group's clips to the target's list; where[i] is the new index of the group's clip i. */
static bool splice_clips(script_state *s, script_surface *to, const display_list *group, matrix m, int outer, int *where)
{
    for (size_t i = 0; i < group->clips.n; i++) {
        clip narrow = group->clips.v[i];
        narrow.parent = narrow.parent == NO_CLIP ? outer : where[narrow.parent];
        if (!add_clip(s, to, &narrow, m, &where[i]))
            return false;
    }
    return true;
}

/* Gives the group's gradient of an item in the target's list. */
static bool splice_gradient(script_state *s, script_surface *to, const display_list *group, matrix m, double alpha, item *it)
{
    const gradient *from = plb_item_gradient(group, it);
    matrix back;
    it->gradient = 0;
    if (!from || !plb_matrix_invert(m, &back))
        return true;
    gradient g = *from;
    g.to_space = plb_matrix_multiply(back, from->to_space);
    g.opacity *= alpha;
    return add_gradient(s, to, &g, &it->gradient);
}

/* Makes an item of the group, with its path still in the group's units; its dashes and what it says are the caller's. */
static bool splice_item(script_state *s, const item *from, double scale, item *it)
{
    *it = *from;
    it->width *= scale;
    it->dash_offset *= scale;
    it->dash.v = NULL;
    it->dash.n = it->dash.capacity = 0;
    it->text = from->text ? plb_text_run_copy(from->text, scale) : NULL;
    if ((from->text && !it->text) || !array_reserve(&it->dash, from->dash.n)) {
        drop_text(it);
        return plb_fail_memory(s->err);
    }
    for (size_t i = 0; i < from->dash.n; i++)
        it->dash.v[it->dash.n++] = from->dash.v[i] * scale;
    return true;
}

static bool splice(script_state *s, const script_context *c, int outer, double alpha)
{
    const script_surface *from = c->source->surface;
    script_surface *to = c->target;
    matrix out;
    if (from->is_image) {
        s->page.omissions.n[OMISSION_IMAGE]++;
        return true;
    }
    if (from->list == to->list || from->list == &s->page)
        return plb_fail(s->err, ERROR_SYNTAX, "a group is painted on itself");
    if (!plb_matrix_invert(c->source->matrix, &out))
        return true;
    out = plb_matrix_multiply(out, to->to_list);
    const display_list *group = from->list;
    int *where = plb_new(group->clips.n, sizeof *where);
    if (!where)
        return plb_fail_memory(s->err);
    to->list->omissions.n[OMISSION_FAR] += group->omissions.n[OMISSION_FAR];
    bool ok = splice_clips(s, to, group, out, outer, where);
    double scale = plb_matrix_expansion(out);
    for (size_t i = 0; ok && i < group->items.n; i++) {
        item it;
        ok = splice_item(s, &group->items.v[i], scale, &it);
        if (!ok)
            break;
        it.clip = it.clip == NO_CLIP ? outer : where[it.clip];
        it.paint.alpha *= alpha;
        it.paint = as_applied(c, it.paint);
        ok = splice_gradient(s, to, group, out, alpha, &it) && add_item(s, to, &it, out);
        array_free(&it.dash);
        drop_text(&it);
    }
    plb_free(where);
    return ok;
}

/* ---- the operators ---------------------------------------------------------------------------------------- */

static bool leaves_ink(script_state *s, const script_context *c)
{
    s->page.omissions.n[OMISSION_BLEND] += c->blends;
    return c->draws;
}

bool plb_script_fill(script_state *s, script_context *c)
{
    if (!leaves_ink(s, c))
        return true;
    if (is_group(c->source)) {
        int outer = c->clip;
        if (!plb_script_clip(s, c) || !splice(s, c, c->clip, 1))
            return false;
        c->clip = outer;
        return true;
    }
    if (plb_tap_has_no_area(&c->path))
        return true;
    item it;
    if (!start_item(s, c, ITEM_FILL, &it))
        return false;
    it.even_odd = c->even_odd;
    it.text = s->say ? s->say(s->say_closure, &it.path) : NULL;
    if (it.text)
        it.text->em *= plb_matrix_expansion(c->target->to_list);
    bool ok = add_item(s, c->target, &it, c->target->to_list);
    drop_text(&it);
    return ok;
}

static bool set_dash(script_state *s, const script_context *c, double scale, item *it)
{
    size_t n = c->dash.n, twice = n % 2 ? 2 : 1;
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += c->dash.v[i];
    if (!(sum > 0))
        return true;
    if (!array_reserve(&it->dash, n * twice))
        return plb_fail_memory(s->err);
    for (size_t i = 0; i < n * twice; i++)
        it->dash.v[it->dash.n++] = c->dash.v[i % n] * scale;
    it->dash_offset = c->dash_offset * scale;
    return true;
}

bool plb_script_stroke(script_state *s, script_context *c)
{
    if (!leaves_ink(s, c))
        return true;
    item it;
    if (!start_item(s, c, ITEM_STROKE, &it))
        return false;
    double scale = plb_matrix_expansion(c->ctm) * plb_matrix_expansion(c->target->to_list);
    it.cap = c->cap;
    it.width = c->width * scale;
    bool ok = set_dash(s, c, scale, &it) && add_item(s, c->target, &it, c->target->to_list);
    array_free(&it.dash);
    return ok;
}

/* Makes a box as large as the surface, in its list's units. */
static bool surface_box(const script_state *s, const script_surface *f, path *out)
{
    bool is_page = f->list == &s->page;
    double w = is_page ? s->page.width : f->width, h = is_page ? s->page.height : f->height;
    return plb_path_move(out, (point){0, 0}) && plb_path_line(out, (point){w, 0}) && plb_path_line(out, (point){w, h}) &&
           plb_path_line(out, (point){0, h}) && plb_path_close(out);
}

bool plb_script_paint(script_state *s, script_context *c, double alpha)
{
    if (!leaves_ink(s, c))
        return true;
    if (is_group(c->source))
        return splice(s, c, c->clip, alpha);
    item it = {.kind = ITEM_FILL, .paint = source_paint(c->source), .clip = c->clip};
    it.paint.alpha *= alpha;
    if (!add_source(s, c->target, c->source, &it.path, &it.gradient))
        return false;
    if (it.gradient && alpha < 1) {
        gradient g = c->target->list->gradients.v[it.gradient - 1];
        g.opacity *= alpha;
        if (!add_gradient(s, c->target, &g, &it.gradient))
            return false;
    }
    bool ok = surface_box(s, c->target, &it.path) || plb_fail_memory(s->err);
    ok = ok && add_item(s, c->target, &it, MATRIX_IDENTITY);
    plb_path_free(&it.path);
    return ok;
}
