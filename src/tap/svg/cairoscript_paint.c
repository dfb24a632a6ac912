/* SPDX-License-Identifier: MIT
 *
 * Painting for the CairoScript reader: paths become items of the display list. A group (a surface of its own that is
 * then painted) is spliced in place: its items, mapped by the pattern's matrix, under the current clip.
 */
#include "tap/svg/cairoscript_state.h"

#include <math.h>

/* How far back a clip is looked for that was made before: the same one comes again for each element. */
#define CLIPS_BACK 8

/* Groups can be painted twice in each group above: what all that are alive hold together is bounded. */
static bool count_held(script_state *s, script_surface *f)
{
    if (f->list == s->page)
        return true;
    size_t held = f->list->points + (f->list->items.n + f->list->clips.n) * SCRIPT_ITEM_POINTS;
    s->held += held - f->held;
    f->held = held;
    return s->held <= LIST_MAX_POINTS || plb_fail(s->err, ERROR_LIMIT, "the drawing's groups hold more than %u points", LIST_MAX_POINTS);
}

static bool add_item(script_state *s, script_surface *f, item *it)
{
    if (!plb_list_add(f->list, it, s->err)) {
        plb_item_free(it);
        return false;
    }
    return count_held(s, f);
}

/* Moves `narrow` into the surface's list, unless the same one is there already. */
static bool add_clip(script_state *s, script_surface *f, clip *narrow, int *index)
{
    size_t n = f->list->clips.n;
    for (size_t back = 1; back <= CLIPS_BACK && back <= n; back++) {
        const clip *c = &f->list->clips.v[n - back];
        if (c->parent != narrow->parent || c->even_odd != narrow->even_odd || !plb_path_equal(&c->path, &narrow->path))
            continue;
        plb_path_free(&narrow->path);
        *index = (int)(n - back);
        return true;
    }
    if (!plb_list_add_clip(f->list, narrow, index, s->err)) {
        plb_path_free(&narrow->path);
        return false;
    }
    return count_held(s, f);
}

bool plb_script_clip(script_state *s, script_context *c)
{
    clip narrow = {.even_odd = c->even_odd, .parent = c->clip};
    if (!plb_path_append(&narrow.path, &c->path, c->target->to_list)) {
        plb_path_free(&narrow.path);
        return plb_fail_memory(s->err);
    }
    return add_clip(s, c->target, &narrow, &c->clip);
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

/* The source's gradient, with its place on the surface's list. 0: none, or one that is squeezed flat. */
static bool add_gradient(script_state *s, script_surface *f, const script_pattern *p, const path *fills, unsigned *index)
{
    matrix back;
    *index = 0;
    if (!p || !p->gradient || !plb_matrix_invert(f->to_list, &back))
        return true;
    gradient g = *p->gradient;
    g.to_space = plb_matrix_multiply(back, plb_script_gradient_matrix(s, p, fills));
    return plb_list_add_gradient(f->list, &g, index, s->err);
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

/* How far points may lie off a line, in steps of cairo's numbers (1/256), to count as on it. */
#define FLAT (4.0 / 256)

/* Do all points from `from` to `to` lie on one line? */
static bool is_flat(const point *from, const point *to)
{
    point far = {0, 0};
    for (const point *p = from; p < to; p++)
        if (plb_point_length(point_sub(*p, *from)) > plb_point_length(far))
            far = point_sub(*p, *from);
    double length = plb_point_length(far);
    for (const point *p = from; p < to; p++)
        if (fabs(point_cross(far, point_sub(*p, *from))) > FLAT * length)
            return false;
    return true;
}

/* True when no subpath has an area: a lone line is "filled" by many drawings, because filling is SVG's default. */
static bool has_no_area(const path *p)
{
    static const size_t points_of[] = {[PATH_MOVE] = 1, [PATH_LINE] = 1, [PATH_CURVE] = 3, [PATH_CLOSE] = 0};
    size_t start = 0, at = 0;
    if (!p->points.n)
        return true;
    for (size_t i = 0; i < p->ops.n; i++) {
        if (p->ops.v[i] == PATH_MOVE) {
            if (!is_flat(p->points.v + start, p->points.v + at))
                return false;
            start = at;
        }
        at += points_of[p->ops.v[i]];
    }
    return is_flat(p->points.v + start, p->points.v + at);
}

/* The context's path and paint as an item of the target's list. */
static bool start_item(script_state *s, const script_context *c, item_kind kind, item *it)
{
    *it = (item){.kind = kind, .paint = source_paint(c->source), .clip = c->clip};
    if (!add_gradient(s, c->target, c->source, &c->path, &it->gradient))
        return false;
    if (!plb_path_append(&it->path, &c->path, c->target->to_list)) {
        plb_path_free(&it->path);
        return plb_fail_memory(s->err);
    }
    drop_last_move(&it->path);
    return true;
}

/* ---- groups ----------------------------------------------------------------------------------------------- */

static bool copy_item(script_state *s, const item *from, matrix m, item *to)
{
    *to = *from;
    to->path = (path){0};
    to->dash.v = NULL;
    to->dash.n = to->dash.capacity = 0;
    double f = plb_matrix_expansion(m);
    to->width *= f;
    to->dash_offset *= f;
    bool ok = plb_path_append(&to->path, &from->path, m) && array_reserve(&to->dash, from->dash.n);
    for (size_t i = 0; ok && i < from->dash.n; i++)
        to->dash.v[to->dash.n++] = from->dash.v[i] * f;
    if (ok)
        return true;
    plb_item_free(to);
    return plb_fail_memory(s->err);
}

/* The group's clips in the target's list; where[i] is the new index of the group's clip i. */
static bool splice_clips(script_state *s, script_surface *to, const display_list *group, matrix m, int outer, int *where)
{
    for (size_t i = 0; i < group->clips.n; i++) {
        const clip *from = &group->clips.v[i];
        clip narrow = {.even_odd = from->even_odd, .parent = from->parent == NO_CLIP ? outer : where[from->parent]};
        if (!plb_path_append(&narrow.path, &from->path, m)) {
            plb_path_free(&narrow.path);
            return plb_fail_memory(s->err);
        }
        if (!add_clip(s, to, &narrow, &where[i]))
            return false;
    }
    return true;
}

/* The group's gradient of an item in the target's list. */
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
    return plb_list_add_gradient(to->list, &g, &it->gradient, s->err);
}

static bool splice(script_state *s, const script_context *c, int outer, double alpha)
{
    const script_surface *from = c->source->surface;
    script_surface *to = c->target;
    matrix out;
    if (from->is_image) {
        s->page->omissions.n[OMISSION_IMAGE]++;
        return true;
    }
    if (from->list == to->list || from->list == s->page)
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
    for (size_t i = 0; ok && i < group->items.n; i++) {
        item it;
        ok = copy_item(s, &group->items.v[i], out, &it);
        if (!ok)
            break;
        it.clip = it.clip == NO_CLIP ? outer : where[it.clip];
        it.paint.alpha *= alpha;
        ok = splice_gradient(s, to, group, out, alpha, &it);
        if (!ok)
            plb_item_free(&it);
        ok = ok && add_item(s, to, &it);
    }
    plb_free(where);
    return ok;
}

/* ---- the operators ---------------------------------------------------------------------------------------- */

static bool leaves_ink(script_state *s, const script_context *c)
{
    s->page->omissions.n[OMISSION_BLEND] += c->blends;
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
    if (has_no_area(&c->path))
        return true;
    item it;
    if (!start_item(s, c, ITEM_FILL, &it))
        return false;
    it.even_odd = c->even_odd;
    return add_item(s, c->target, &it);
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
    if (!set_dash(s, c, scale, &it)) {
        plb_item_free(&it);
        return false;
    }
    return add_item(s, c->target, &it);
}

/* A box as large as the surface, in its list's units. */
static bool surface_box(const script_state *s, const script_surface *f, path *out)
{
    bool is_page = f->list == s->page;
    double w = is_page ? s->page->width : f->width, h = is_page ? s->page->height : f->height;
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
    if (!add_gradient(s, c->target, c->source, &it.path, &it.gradient))
        return false;
    if (it.gradient && alpha < 1) {
        gradient g = c->target->list->gradients.v[it.gradient - 1];
        g.opacity *= alpha;
        if (!plb_list_add_gradient(c->target->list, &g, &it.gradient, s->err))
            return false;
    }
    if (!surface_box(s, c->target, &it.path)) {
        plb_item_free(&it);
        return plb_fail_memory(s->err);
    }
    return add_item(s, c->target, &it);
}
