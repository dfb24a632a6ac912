/* SPDX-License-Identifier: MIT
 *
 * The measures of a filled shape, taken from level sections, so that holes, overlaps and either rule count as they show.
 */
#include "plan/hatch/hatch_shape.h"

#include "base/number/random.h"
#include "plan/shape/flatten.h"

#include <math.h>

/* So many sections measure a shape: enough to tell its axis to a degree or two. */
#define MEASURING_SECTIONS 24
/* Identities hash positions in this unit, mm. */
#define SHAPE_IDENTITY_UNIT_MM 0.001

static bool add_subpath(shape *s, const track *t)
{
    if (t->n < 2)
        return true;
    if (!array_reserve(&s->edges, t->n))
        return false;
    s->subpaths++;
    for (size_t i = 0; i < t->n; i++) {
        shape_edge e = {t->v[i].at, t->v[(i + 1) % t->n].at};
        plb_box_add(&s->bounds, e.from);
        s->identity = random_fold(s->identity, llround(e.from.x / SHAPE_IDENTITY_UNIT_MM), llround(e.from.y / SHAPE_IDENTITY_UNIT_MM));
        if (e.from.x == e.to.x && e.from.y == e.to.y)
            continue;
        s->perimeter += plb_point_distance(e.from, e.to);
        s->edges.v[s->edges.n++] = e;
    }
    return true;
}

static bool add_subpaths(shape *s, const path *p, error *err)
{
    track_list lines = {0};
    bool ok = plb_plan_flatten(p, true, &lines, err);
    for (size_t i = 0; ok && i < lines.tracks.n; i++) {
        track t = plb_track_at(&lines, i);
        ok = add_subpath(s, &t) || plb_fail_memory(err);
    }
    plb_tracks_free(&lines);
    return ok;
}

/* Sums over the filled part, about the middle of the bounds. */
typedef struct {
    double area, x, y, xx, xy, yy;
} moments;

static void add_span(moments *m, span s, double y, double height)
{
    double a = s.from, b = s.to, d = (b - a) * height;
    m->area += d;
    m->x += (a + b) / 2 * d;
    m->y += y * d;
    m->xx += (a * a + a * b + b * b) / 3 * d;
    m->xy += (a + b) / 2 * y * d;
    m->yy += (y * y + height * height / 12) * d;
}

static void conclude(shape *s, const moments *m, point origin)
{
    s->area = m->area;
    s->elongation = 1;
    if (!(m->area > 0))
        return;
    double x = m->x / m->area, y = m->y / m->area;
    double xx = m->xx / m->area - x * x, yy = m->yy / m->area - y * y, xy = m->xy / m->area - x * y;
    double middle = (xx + yy) / 2, apart = sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
    s->centre = (point){origin.x + x, origin.y + y};
    s->axis = 0.5 * atan2(2 * xy, xx - yy);
    s->elongation = middle - apart > middle * 1e-6 ? sqrt((middle + apart) / (middle - apart)) : 1000;
}

static bool measure(shape *s, error *err)
{
    sections k;
    moments m = {0};
    point origin = {(s->bounds.x0 + s->bounds.x1) / 2, (s->bounds.y0 + s->bounds.y1) / 2};
    double height = (s->bounds.y1 - s->bounds.y0) / MEASURING_SECTIONS;
    bool ok = plb_sections_init(&k, &s->edges, s->even_odd, plb_frame(0), 0, err);
    for (int i = 0; ok && i < MEASURING_SECTIONS && height > 0; i++) {
        double y = s->bounds.y0 + (i + 0.5) * height;
        ok = plb_sections_at(&k, y, 0, err);
        for (size_t j = 0; ok && j < k.spans.n; j++)
            add_span(&m, (span){k.spans.v[j].from - origin.x, k.spans.v[j].to - origin.x}, y - origin.y, height);
    }
    conclude(s, &m, origin);
    plb_sections_free(&k);
    return ok;
}

/* Computes the mean section where a point of the shape, picked by chance, lies. */
static bool mean_section(const shape *s, double radians, double *mean, error *err)
{
    sections k;
    double sum = 0, squares = 0;
    bool ok = plb_sections_init(&k, &s->edges, s->even_odd, plb_frame(radians), 0, err);
    for (int i = 0; ok && i < MEASURING_SECTIONS; i++) {
        ok = plb_sections_at(&k, k.bounds.y0 + (i + 0.5) / MEASURING_SECTIONS * (k.bounds.y1 - k.bounds.y0), 0, err);
        for (size_t j = 0; ok && j < k.spans.n; j++) {
            double length = k.spans.v[j].to - k.spans.v[j].from;
            sum += length;
            squares += length * length;
        }
    }
    *mean = sum > 0 ? squares / sum : 0;
    plb_sections_free(&k);
    return ok;
}

bool plb_shape_breadth(const shape *s, double *breadth, error *err)
{
    bool ok = true;
    *breadth = 1e300;
    for (int i = 0; ok && i < 4; i++) {
        double mean = 0;
        ok = mean_section(s, i * PLB_PI / 4, &mean, err);
        *breadth = fmin(*breadth, mean);
    }
    return ok;
}

/* The turns of all corners have one sign, and add up to one full turn. */
static bool turns_one_way(const shape *s)
{
    double sum = 0;
    int signs = 0;
    for (size_t i = 0; i < s->edges.n; i++) {
        const shape_edge *e = &s->edges.v[i], *f = &s->edges.v[(i + 1) % s->edges.n];
        point a = point_sub(e->to, e->from), b = point_sub(f->to, f->from);
        double turn = atan2(point_cross(a, b), point_dot(a, b));
        sum += turn;
        signs |= turn > 1e-6 ? 1 : turn < -1e-6 ? 2 : 0;
    }
    return signs != 3 && fabs(fabs(sum) - 2 * PLB_PI) < 0.1;
}

bool plb_shape_init(shape *s, const item *fill, error *err)
{
    *s = (shape){.bounds = BOX_EMPTY, .even_odd = fill->even_odd, .identity = 0x51ed270b7a2d3c1fu, .elongation = 1};
    if (!add_subpaths(s, &fill->path, err))
        return false;
    s->is_convex = s->subpaths == 1 && s->edges.n > 2 && turns_one_way(s);
    return s->edges.n == 0 || measure(s, err);
}

void plb_shape_free(shape *s)
{
    array_free(&s->edges);
}
