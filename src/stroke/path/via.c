/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 2, the movement of least jerk through via points (Flash and Hogan 1985, the section on curved and
 * obstacle-avoidance movements, there for one via point).
 * Input: places and the times between them. Output: velocities and accelerations at the places.
 *
 * The movement that makes the integral of (d^3 x/dt^3)^2 least and passes given places at given times is, for each
 * coordinate, a polynomial of the fifth degree between two places, with derivatives up to the fourth that are continuous at
 * each. With p, v, a at both ends of a piece of duration h, and D = p1 - p0 (Hermite's form),
 *
 *     x'''(0)  h^3 =   60 D -  36 h v0 -  24 h v1 -  9 h^2 a0 +  3 h^2 a1
 *     x'''(h)  h^3 =   60 D -  24 h v0 -  36 h v1 -  3 h^2 a0 +  9 h^2 a1
 *     x''''(0) h^4 = -360 D + 192 h v0 + 168 h v1 + 36 h^2 a0 - 24 h^2 a1
 *     x''''(h) h^4 =  360 D - 168 h v0 - 192 h v1 - 24 h^2 a0 + 36 h^2 a1
 *
 * so that continuity gives two equations for the two unknowns (v, a) of each inner place: a block-tridiagonal system,
 * solved by elimination in one pass forth and one back. At the ends the hand rests: v = a = 0.
 */
#include "stroke/path/via.h"

/* Rows jerk, snap; columns v, a. */
typedef via_block block;

static block multiply(block m, block k)
{
    return (block){m.vj * k.vj + m.aj * k.vs, m.vj * k.aj + m.aj * k.as, m.vs * k.vj + m.as * k.vs, m.vs * k.aj + m.as * k.as};
}

static block invert(block m)
{
    double d = 1 / (m.vj * m.as - m.aj * m.vs);
    return (block){m.as * d, -m.aj * d, -m.vs * d, m.vj * d};
}

/* The two right-hand sides of a row, one for each coordinate. */
typedef struct {
    point j, s;
} sides;

static sides apply(block m, sides r)
{
    return (sides){point_add(point_scale(r.j, m.vj), point_scale(r.s, m.aj)), point_add(point_scale(r.j, m.vs), point_scale(r.s, m.as))};
}

/* Computes the row of place v[0]: the place before it is v[-1]. */
static void row_of(const via *v, block *before, block *own, block *after, sides *r)
{
    double l = 1 / v[-1].duration, n = 1 / v->duration, l2 = l * l, n2 = n * n, l3 = l2 * l, n3 = n2 * n;
    point came = point_sub(v->at, v[-1].at), goes = point_sub(v[1].at, v->at);
    *before = (block){-24 * l2, -3 * l, -168 * l3, -24 * l2};
    *own = (block){36 * (n2 - l2), 9 * (l + n), -192 * (l3 + n3), 36 * (l2 - n2)};
    *after = (block){24 * n2, -3 * n, -168 * n3, 24 * n2};
    r->j = point_sub(point_scale(goes, 60 * n3), point_scale(came, 60 * l3));
    r->s = point_scale(point_add(point_scale(came, l3 * l), point_scale(goes, n3 * n)), -360);
}

void plb_via_solve(via *v, size_t n)
{
    block eliminated = {0, 0, 0, 0};
    v[0].velocity = v[0].acceleration = v[n - 1].velocity = v[n - 1].acceleration = (point){0, 0};
    for (size_t i = 1; i + 1 < n; i++) {
        block before, own, after;
        sides r, known = {v[i - 1].velocity, v[i - 1].acceleration};
        row_of(v + i, &before, &own, &after, &r);
        block b = multiply(before, eliminated);
        sides k = apply(before, known);
        own = invert((block){own.vj - b.vj, own.aj - b.aj, own.vs - b.vs, own.as - b.as});
        r = apply(own, (sides){point_sub(r.j, k.j), point_sub(r.s, k.s)});
        eliminated = multiply(own, after);
        v[i].velocity = r.j;
        v[i].acceleration = r.s;
        v[i].forward = eliminated;
    }
    for (size_t i = n - 2; i > 0; i--) {
        sides k = apply(v[i].forward, (sides){v[i + 1].velocity, v[i + 1].acceleration});
        v[i].velocity = point_sub(v[i].velocity, k.j);
        v[i].acceleration = point_sub(v[i].acceleration, k.s);
    }
}

/* One coordinate's polynomial, with velocities and accelerations in units of the piece's duration. */
static void polynomial(double p0, double p1, double v0, double v1, double a0, double a1, double c[6])
{
    double d = p1 - p0;
    c[0] = p0;
    c[1] = v0;
    c[2] = a0 / 2;
    c[3] = 10 * d - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1;
    c[4] = -15 * d + 8 * v0 + 7 * v1 + 1.5 * a0 - a1;
    c[5] = 6 * d - 3 * v0 - 3 * v1 - 0.5 * a0 + 0.5 * a1;
}

via_piece plb_via_piece(const via v[2])
{
    via_piece p;
    double h = v->duration;
    point v0 = point_scale(v->velocity, h), v1 = point_scale(v[1].velocity, h);
    point a0 = point_scale(v->acceleration, h * h), a1 = point_scale(v[1].acceleration, h * h);
    polynomial(v->at.x, v[1].at.x, v0.x, v1.x, a0.x, a1.x, p.x);
    polynomial(v->at.y, v[1].at.y, v0.y, v1.y, a0.y, a1.y, p.y);
    return p;
}

static double value(const double c[6], double t)
{
    return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))));
}

point plb_via_at(const via_piece *p, double t)
{
    return (point){value(p->x, t), value(p->y, t)};
}
