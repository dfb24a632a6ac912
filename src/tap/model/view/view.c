/* SPDX-License-Identifier: MIT
 *
 * See view.h.
 */
#include "tap/model/view/view.h"

#define RADIANS (PLB_PI / 180)

void plb_view_free(view *v)
{
    array_free(&v->at);
    array_free(&v->is_front);
}

vector plb_view_to_eye(const view *v, vector place)
{
    return v->distance > 0 ? vector_unit(vector_sub(vector_scale(v->toward, v->distance), place)) : v->toward;
}

/* A place with depth z comes nearer to the middle by distance / (distance - z); its depth by the same factor, which keeps planes flat. */
static vector project(const view *v, vector p)
{
    vector q = {vector_dot(p, v->right), -vector_dot(p, v->up), vector_dot(p, v->toward)};
    return v->distance > 0 ? vector_scale(q, v->distance / (v->distance - q.z)) : q;
}

/* The radius of the ball around the middle that holds all. */
static double radius_of(const mesh *m)
{
    double r = 0;
    for (size_t i = 0; i < m->places.n; i++)
        r = greater(r, vector_length(m->places.v[i]));
    return r;
}

bool plb_view_make(const mesh *m, direction_of_view from, view *v, error *err)
{
    double a = from.azimuth * RADIANS, e = from.elevation * RADIANS;
    *v = (view){.m = m, .scale = 1, .bounds = BOX_EMPTY};
    v->right = (vector){cos(a), sin(a), 0};
    v->toward = (vector){sin(a) * cos(e), -cos(a) * cos(e), sin(e)};
    v->up = vector_cross(v->toward, v->right);
    /* The ball touches the rays at the edge of the view. */
    v->distance = from.perspective > 0 ? radius_of(m) / sin(from.perspective * RADIANS / 2) * (1 + 1e-9) : 0;
    if (!array_reserve(&v->at, m->places.n) || !array_reserve(&v->is_front, m->triangles.n))
        return plb_fail_memory(err);
    for (size_t i = 0; i < m->places.n; i++) {
        vector p = project(v, m->places.v[i]);
        v->at.v[v->at.n++] = p;
        plb_box_add(&v->bounds, (point){p.x, p.y});
    }
    for (size_t i = 0; i < m->triangles.n; i++)
        v->is_front.v[v->is_front.n++] = vector_dot(m->normals.v[i], plb_view_to_eye(v, mesh_corner(m, i, 0))) > 0;
    return true;
}

void plb_view_place(view *v, double scale, double x, double y)
{
    for (size_t i = 0; i < v->at.n; i++) {
        vector *p = &v->at.v[i];
        *p = (vector){p->x * scale + x, p->y * scale + y, p->z * scale};
    }
    v->scale *= scale;
    v->bounds = (box){v->bounds.x0 * scale + x, v->bounds.y0 * scale + y, v->bounds.x1 * scale + x, v->bounds.y1 * scale + y};
}

/* ---- size on paper ---- */

#define PAPER_LONG 420.0 /* mm: A3 (ISO 216), either way up */
#define PAPER_SHORT 297.0
#define SMALL 150.0      /* mm: what is smaller at 1:1 is enlarged until it is not; chosen by eye, as for DXF */

double plb_view_scale(double width, double height, double blank_width, double blank_height)
{
    static const double steps[] = {1, 2, 5}; /* ISO 5455, table 1 */
    double room_long = PAPER_LONG - 2 * VIEW_MARGIN, room_short = PAPER_SHORT - 2 * VIEW_MARGIN, best = 0;
    double largest = greater(width, height);
    for (int k = -18; k <= 18; k++)
        for (int i = 0; i < 3; i++) {
            double s = steps[i] * pow(10, k), w = width * s + blank_width, h = height * s + blank_height;
            bool fits = greater(w, h) <= room_long && lesser(w, h) <= room_short;
            bool is_large = best >= 1 && largest * best >= SMALL;
            if (fits && !is_large)
                best = s;
        }
    return best > 0 ? best : room_short / greater(largest, 1e-300);
}
