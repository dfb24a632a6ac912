/* SPDX-License-Identifier: MIT
 *
 * Lettering, step 1: a fill, which may hold one glyph or a page of text, is taken apart into parts that do not touch.
 * Contours belong together when their edges cross or one lies inside the other; a sweep along x finds the pairs that
 * may.
 */
#include "plan/letter/letter_parts.h"

#include "plan/shape/flatten.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Lettering has no more than these; a larger fill is left to hatching before the fill costs time. */
#define MAX_FILL_POINTS 400000u       /* of a fill, flattened */
#define MAX_CONTOUR_POINTS 5000u /* of one contour: the @ has 120 */
#define MAX_NESTED 2000u         /* contours of a fill by the even-odd rule */
#define MAX_TESTS 40000000u      /* of edges against edges */

typedef struct {
    box bounds;
    size_t first, n; /* its points */
    double area, perimeter;
    int parent;      /* union-find */
} contour;

typedef struct {
    ARRAY(point) points;
    ARRAY(contour) contours;
    bool too_much;
    size_t tests;
} sheet;

static bool add_contour(sheet *s, const track *t)
{
    size_t n = t->closed ? t->n - 1 : t->n;
    if (n < 3 || s->too_much)
        return true;
    s->too_much = n > MAX_CONTOUR_POINTS || s->points.n + n > MAX_FILL_POINTS;
    contour c = {.bounds = BOX_EMPTY, .first = s->points.n, .n = n, .parent = (int)s->contours.n};
    if (!array_reserve(&s->points, n) || !array_reserve(&s->contours, 1))
        return false;
    for (size_t i = 0; i < n; i++) {
        point p = t->v[i].at, q = t->v[i + 1 < n ? i + 1 : 0].at;
        s->points.v[s->points.n++] = p;
        plb_box_add(&c.bounds, p);
        c.area += point_cross(point_sub(p, t->v[0].at), point_sub(q, t->v[0].at)) / 2;
        c.perimeter += plb_point_distance(p, q);
    }
    s->contours.v[s->contours.n++] = c;
    return true;
}

static bool add_contours(sheet *s, const path *p, error *err)
{
    track_list lines = {0};
    bool ok = plb_plan_flatten(p, true, &lines, err);
    for (size_t i = 0; ok && i < lines.tracks.n; i++) {
        track t = plb_track_at(&lines, i);
        ok = add_contour(s, &t) || plb_fail_memory(err);
    }
    plb_tracks_free(&lines);
    return ok;
}

static int root_of(sheet *s, int i)
{
    while (s->contours.v[i].parent != i)
        i = s->contours.v[i].parent = s->contours.v[s->contours.v[i].parent].parent;
    return i;
}

static bool contains(const sheet *s, const contour *c, point p)
{
    bool inside = false;
    const point *v = s->points.v + c->first;
    for (size_t i = 0, k = c->n - 1; i < c->n; k = i++)
        if ((v[i].y <= p.y) != (v[k].y <= p.y) && p.x < v[i].x + (p.y - v[i].y) / (v[k].y - v[i].y) * (v[k].x - v[i].x))
            inside = !inside;
    return inside;
}

static bool edges_cross(point a, point b, point c, point d)
{
    double s = point_cross(point_sub(b, a), point_sub(c, a)), t = point_cross(point_sub(b, a), point_sub(d, a));
    double u = point_cross(point_sub(d, c), point_sub(a, c)), v = point_cross(point_sub(d, c), point_sub(b, c));
    return (s > 0) != (t > 0) && (u > 0) != (v > 0);
}

static bool is_off(box b, point p, point q)
{
    return fmax(p.x, q.x) < b.x0 || fmin(p.x, q.x) > b.x1 || fmax(p.y, q.y) < b.y0 || fmin(p.y, q.y) > b.y1;
}

static bool contours_cross(sheet *s, const contour *a, const contour *b)
{
    const point *v = s->points.v + a->first, *w = s->points.v + b->first;
    for (size_t i = 0, k = a->n - 1; i < a->n; k = i++) {
        if (is_off(b->bounds, v[k], v[i]))
            continue;
        s->tests += b->n;
        for (size_t j = 0, l = b->n - 1; j < b->n; l = j++)
            if (edges_cross(v[k], v[i], w[l], w[j]))
                return true;
    }
    return false;
}

static void relate(sheet *s, int i, int k)
{
    contour *a = &s->contours.v[i], *b = &s->contours.v[k];
    s->tests++;
    if (a->bounds.y1 < b->bounds.y0 || b->bounds.y1 < a->bounds.y0)
        return;
    int ra = root_of(s, i), rb = root_of(s, k);
    if (ra == rb)
        return;
    s->tests += a->n + b->n;
    if (contains(s, a, s->points.v[b->first]) || contains(s, b, s->points.v[a->first]) || contours_cross(s, a, b))
        s->contours.v[ra > rb ? ra : rb].parent = ra > rb ? rb : ra; /* the first drawn is the root */
}

typedef struct {
    double x0;
    int index;
} by_left;

static int compare_left(const void *a, const void *b)
{
    const by_left *p = a, *q = b;
    return p->x0 != q->x0 ? (p->x0 > q->x0) - (p->x0 < q->x0) : p->index - q->index;
}

static bool relate_all(sheet *s)
{
    size_t n = s->contours.n;
    by_left *order = plb_new(n + 1, sizeof *order);
    if (!order)
        return false;
    for (size_t i = 0; i < n; i++)
        order[i] = (by_left){s->contours.v[i].bounds.x0, (int)i};
    qsort(order, n, sizeof *order, compare_left);
    for (size_t i = 0; i < n && s->tests < MAX_TESTS; i++) {
        double right = s->contours.v[order[i].index].bounds.x1;
        for (size_t k = i + 1; k < n && order[k].x0 <= right && s->tests < MAX_TESTS; k++)
            relate(s, order[i].index, order[k].index);
    }
    s->too_much = s->tests >= MAX_TESTS;
    plb_free(order);
    return true;
}

static bool add_to_part(letter_part *part, const sheet *s, const contour *c)
{
    if (!array_push(&part->outline.starts, part->outline.points.n) || !array_reserve(&part->outline.points, c->n))
        return false;
    memcpy(part->outline.points.v + part->outline.points.n, s->points.v + c->first, c->n * sizeof(point));
    part->outline.points.n += c->n;
    plb_box_add(&part->bounds, (point){c->bounds.x0, c->bounds.y0});
    plb_box_add(&part->bounds, (point){c->bounds.x1, c->bounds.y1});
    part->area += c->area;
    part->perimeter += c->perimeter;
    return true;
}

/* By the even-odd rule a contour inside an odd number of others is a hole, whichever way it runs. */
static void sign_areas(sheet *s)
{
    size_t n = s->contours.n;
    s->too_much = n > MAX_NESTED;
    for (size_t i = 0; i < n && !s->too_much; i++) {
        contour *c = &s->contours.v[i];
        bool hole = false;
        for (size_t k = 0; k < n; k++)
            if (k != i && root_of(s, (int)k) == root_of(s, (int)i))
                hole ^= contains(s, &s->contours.v[k], s->points.v[c->first]);
        c->area = hole ? -fabs(c->area) : fabs(c->area);
    }
}

static bool collect(letter_parts *p, sheet *s, bool even_odd)
{
    int *part_of = plb_new(s->contours.n + 1, sizeof *part_of); /* of roots, counted from 1 */
    bool ok = part_of;
    for (size_t i = 0; ok && i < s->contours.n; i++) {
        int root = root_of(s, (int)i);
        letter_part fresh = {.bounds = BOX_EMPTY, .outline = {.even_odd = even_odd}};
        if (!part_of[root]) {
            ok = array_push(&p->parts, fresh);
            part_of[root] = (int)p->parts.n;
        }
        ok = ok && add_to_part(&p->parts.v[part_of[root] - 1], s, &s->contours.v[i]);
    }
    plb_free(part_of);
    for (size_t i = 0; i < p->parts.n; i++)
        p->parts.v[i].area = fabs(p->parts.v[i].area);
    return ok;
}

void plb_letter_parts_free(letter_parts *p)
{
    for (size_t i = 0; i < p->parts.n; i++)
        plb_contour_set_free(&p->parts.v[i].outline);
    array_free(&p->parts);
}

bool plb_letter_split(letter_parts *p, const item *fill, error *err)
{
    sheet s = {0};
    memset(p, 0, sizeof *p);
    bool ok = fill->path.points.n > MAX_FILL_POINTS || add_contours(&s, &fill->path, err);
    if (ok && !s.too_much)
        ok = relate_all(&s);
    if (ok && !s.too_much && fill->even_odd)
        sign_areas(&s);
    if (ok && !s.too_much)
        ok = collect(p, &s, fill->even_odd);
    array_free(&s.points);
    array_free(&s.contours);
    if (!ok)
        plb_letter_parts_free(p);
    return ok || plb_fail_memory(err);
}
