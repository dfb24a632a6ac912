/* SPDX-License-Identifier: MIT
 *
 * Four views on one sheet, as engineers draw [ISO 128-3]: front, top, a side and an isometric view, in line with each other. By the first-angle
 * method a view stands on the far side of what it shows, by the third-angle method on the near one.
 */
#include "tap/model/sheet.h"

#include "tap/model/line/circles.h"

#define GAP 18.0        /* mm between views; chosen by eye */
#define BEYOND 3.0      /* mm: so far centre lines go beyond the shape; ISO 128-2 leaves it to the draughtsman */
#define IS_ALONG 0.9999 /* cosine of the angle between an axis and the view */
#define IS_ACROSS 0.001

typedef enum { FRONT, TOP, SIDE, ISO, VIEWS } sheet_view;

/* ---- centre lines ---- */

static vector place_on_paper(const view *v, vector p, vector origin)
{
    return (vector){vector_dot(p, v->right) * v->scale + origin.x, -vector_dot(p, v->up) * v->scale + origin.y, 0};
}

/* A circle that is seen round has a cross through its centre. */
static bool write_cross(item_writer *w, const view *v, const circle *c, vector origin)
{
    vector p = place_on_paper(v, c->centre, origin);
    double r = c->radius * v->scale + BEYOND;
    return plb_view_centre_line(w, (point){p.x - r, p.y}, (point){p.x + r, p.y}) && plb_view_centre_line(w, (point){p.x, p.y - r}, (point){p.x, p.y + r});
}

/* Tells whether both have one centre line when they are seen as `way` says: along the axis, or across. */
static bool is_same(const circle *a, const circle *b, double tolerance)
{
    vector d = vector_sub(b->centre, a->centre);
    return fabs(vector_dot(a->axis, b->axis)) > IS_ALONG && vector_length(vector_cross(d, a->axis)) <= tolerance;
}

/* Circles that are seen from the side have a line along their common axis. */
static bool write_axis(item_writer *w, const view *v, const circle_list *l, size_t i, vector origin, double tolerance)
{
    const circle *c = &l->v[i];
    double low = 0, high = 0;
    for (size_t k = 0; k < l->n; k++)
        if (is_same(c, &l->v[k], tolerance)) {
            double along = vector_dot(vector_sub(l->v[k].centre, c->centre), c->axis);
            low = lesser(low, along);
            high = greater(high, along);
        }
    double more = BEYOND / v->scale;
    vector a = place_on_paper(v, vector_add(c->centre, vector_scale(c->axis, low - more)), origin);
    vector b = place_on_paper(v, vector_add(c->centre, vector_scale(c->axis, high + more)), origin);
    return plb_view_centre_line(w, (point){a.x, a.y}, (point){b.x, b.y});
}

static bool write_centre_lines(item_writer *w, const view *v, const circle_list *l, vector origin)
{
    double tolerance = 1e-4 * v->m->size;
    for (size_t i = 0; i < l->n; i++) {
        const circle *c = &l->v[i];
        double cosine = fabs(vector_dot(c->axis, v->toward));
        bool is_first = true, is_largest = true;
        for (size_t k = 0; k < l->n; k++)
            if (k != i && is_same(c, &l->v[k], tolerance)) {
                is_first = is_first && i < k;
                is_largest = is_largest && (c->radius > l->v[k].radius || (c->radius == l->v[k].radius && i < k));
            }
        if (cosine > IS_ALONG && is_largest && !write_cross(w, v, c, origin))
            return false;
        if (cosine < IS_ACROSS && is_first && !write_axis(w, v, l, i, origin, tolerance))
            return false;
    }
    return true;
}

/* ---- the sheet ---- */

typedef struct {
    double width, height;
} extent;

static extent extent_of(const view *v) { return (extent){v->bounds.x1 - v->bounds.x0, v->bounds.y1 - v->bounds.y0}; }

static bool make_views(const mesh *m, bool is_first_angle, view v[VIEWS], error *err)
{
    const direction_of_view from[VIEWS] = {[FRONT] = {0, 0, 0}, [TOP] = {0, 90, 0}, [SIDE] = {is_first_angle ? -90 : 90, 0, 0}, [ISO] = {45, 35.264389682754654, 0}};
    for (int i = 0; i < VIEWS; i++)
        if (!plb_view_make(m, from[i], &v[i], err))
            return false;
    return true;
}

/* Gives each view its place: two columns and two rows; the front is the upper left by the first-angle method, the lower left by the third. */
static void place_views(view v[VIEWS], double unit, bool is_first_angle, double *scale, double *width, double *height)
{
    extent f = extent_of(&v[FRONT]), t = extent_of(&v[TOP]), s = extent_of(&v[SIDE]), i = extent_of(&v[ISO]);
    double left = greater(f.width, t.width), right = greater(s.width, i.width), low = greater(t.height, i.height), high = greater(f.height, s.height);
    *scale = plb_view_scale((left + right) * unit, (low + high) * unit, GAP, GAP);
    double k = *scale * unit, x[2] = {VIEW_MARGIN + left * k / 2, VIEW_MARGIN + left * k + GAP + right * k / 2};
    double first = is_first_angle ? high : low, second = is_first_angle ? low : high;
    double y[2] = {VIEW_MARGIN + first * k / 2, VIEW_MARGIN + first * k + GAP + second * k / 2};
    int front = is_first_angle ? 0 : 1;
    /* The model's middle is the middle of each view but the isometric one, whose own middle counts. */
    plb_view_place(&v[FRONT], k, x[0], y[front]);
    plb_view_place(&v[SIDE], k, x[1], y[front]);
    plb_view_place(&v[TOP], k, x[0], y[1 - front]);
    box b = v[ISO].bounds;
    plb_view_place(&v[ISO], k, x[1] - (b.x0 + b.x1) / 2 * k, y[1 - front] - (b.y0 + b.y1) / 2 * k);
    *width = 2 * VIEW_MARGIN + (left + right) * k + GAP;
    *height = 2 * VIEW_MARGIN + (low + high) * k + GAP;
}

bool plb_sheet_write(item_writer *w, const mesh *m, double unit, const model_settings *s)
{
    view v[VIEWS] = {0};
    circle_list circles = {0};
    double width, height, scale;
    bool is_first_angle = s->sheet == SHEET_FIRST_ANGLE;
    hidden_style hidden = s->hidden == HIDDEN_AUTO ? HIDDEN_DASHED : s->hidden;
    bool ok = make_views(m, is_first_angle, v, w->err) && plb_find_circles(m, &circles, w->err);
    if (ok) {
        place_views(v, unit, is_first_angle, &scale, &width, &height);
        plb_view_write_page(w, width, height, scale);
    }
    for (int i = 0; ok && i < VIEWS; i++) {
        light from = s->light;
        from.is_on = from.is_on && i == ISO; /* the others are drawings of lines */
        vector origin = {0, 0, 0};
        if (v[i].at.n) { /* where the model's middle went */
            vector p = place_on_paper(&v[i], m->places.v[0], origin);
            origin = vector_sub(v[i].at.v[0], p);
        }
        ok = plb_view_write(w, &v[i], i == ISO ? HIDDEN_NONE : hidden, from) && (i == ISO || write_centre_lines(w, &v[i], &circles, origin));
    }
    for (int i = 0; i < VIEWS; i++)
        plb_view_free(&v[i]);
    array_free(&circles);
    return ok;
}
