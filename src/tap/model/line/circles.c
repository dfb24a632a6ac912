/* SPDX-License-Identifier: MIT
 *
 * See circles.h.
 */
#include "tap/model/line/circles.h"

/* Corners may be off by this part of the radius. */
#define OFF_CIRCLE 0.01

typedef struct {
    uint32_t at[2]; /* the two neighbours along creases */
    uint32_t n;     /* how many creases there are */
} ring_place;

/* Gives, for each place, its neighbours along creases and borders. */
static ring_place *find_neighbours(const mesh *m)
{
    ring_place *r = plb_new(m->places.n + 1, sizeof *r);
    for (size_t i = 0; r && i < m->edges.n; i++) {
        const edge *e = &m->edges.v[i];
        if (e->kind != EDGE_CREASE && e->kind != EDGE_BORDER)
            continue;
        ring_place *a = &r[e->a], *b = &r[e->b];
        if (a->n++ < 2)
            a->at[a->n - 1] = e->b;
        if (b->n++ < 2)
            b->at[b->n - 1] = e->a;
    }
    return r;
}

/* Follows the ring from a place with two creases back to it; false where it ends or branches. */
static bool follow_ring(const ring_place *r, uint32_t from, unsigned char *is_seen, number_list *out, bool *ok)
{
    uint32_t before = from, at = from;
    out->n = 0;
    do {
        if (r[at].n != 2 || is_seen[at])
            return false;
        is_seen[at] = 1;
        if (!array_push(out, at))
            return *ok = false;
        uint32_t next = r[at].at[0] == before && at != from ? r[at].at[1] : r[at].at[0];
        before = at;
        at = next;
    } while (at != from);
    return true;
}

static bool is_circle(const mesh *m, const number_list *ring, circle *c)
{
    size_t n = ring->n;
    *c = (circle){{0, 0, 0}, {0, 0, 0}, 0};
    if (n < CIRCLE_CORNERS)
        return false;
    for (size_t i = 0; i < n; i++)
        c->centre = vector_add(c->centre, vector_scale(m->places.v[ring->v[i]], 1. / (double)n));
    for (size_t i = 0; i < n; i++) {
        vector a = vector_sub(m->places.v[ring->v[i]], c->centre), b = vector_sub(m->places.v[ring->v[(i + 1) % n]], c->centre);
        c->axis = vector_add(c->axis, vector_cross(a, b));
        c->radius += vector_length(a) / (double)n;
    }
    c->axis = vector_unit(c->axis);
    for (size_t i = 0; i < n; i++) {
        vector a = vector_sub(m->places.v[ring->v[i]], c->centre);
        if (fabs(vector_length(a) - c->radius) > OFF_CIRCLE * c->radius || fabs(vector_dot(a, c->axis)) > OFF_CIRCLE * c->radius)
            return false;
    }
    return true;
}

bool plb_find_circles(const mesh *m, circle_list *out, error *err)
{
    ring_place *r = find_neighbours(m);
    unsigned char *is_seen = plb_new(m->places.n + 1, 1);
    number_list ring = {0};
    bool ok = r && is_seen;
    for (uint32_t i = 0; ok && i < m->places.n; i++) {
        circle c;
        if (r[i].n == 2 && !is_seen[i] && follow_ring(r, i, is_seen, &ring, &ok) && is_circle(m, &ring, &c))
            ok = array_push(out, c);
    }
    plb_free(r);
    plb_free(is_seen);
    array_free(&ring);
    return ok || plb_fail_memory(err);
}
