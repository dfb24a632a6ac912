/* SPDX-License-Identifier: MIT */
#include "tap/plain/plain_path.h"

#include <math.h>
#include <stdlib.h>

/* Products of differences must fit 64 bits, and cairo's numbers end at 2^23 units: pages have 4096. */
#define FARTHEST 4e6
#define STEPS 256.0 /* of a unit of cairo's fixed-point numbers */
#define MAX_POINTS ((size_t)1 << 25)

void plb_plain_begin(plain_path *p, const matrix *to_surface)
{
    p->matrix = *to_surface;
    p->n_ops = p->n_points = 0;
    p->has_current = p->failed = false;
    p->is_pending = p->is_empty = p->is_upright = true;
}

void plb_plain_free(plain_path *p)
{
    free(p->ops);
    free(p->points);
    *p = (plain_path){.failed = true};
}

/* ---- memory ------------------------------------------------------------------------------------------------- */

static bool grow(plain_path *p)
{
    size_t ops = p->ops_capacity ? p->ops_capacity * 2 : 256, points = ops * 3;
    if (points > MAX_POINTS)
        return false;
    unsigned char *o = realloc(p->ops, ops);
    if (o) {
        p->ops = o;
        p->ops_capacity = ops;
    }
    plain_point *q = o ? realloc(p->points, points * sizeof *q) : NULL;
    if (q) {
        p->points = q;
        p->points_capacity = points;
    }
    return q != NULL;
}

static void add(plain_path *p, int op, const plain_point *points, size_t n)
{
    if ((p->n_ops == p->ops_capacity || p->n_points + n > p->points_capacity) && !grow(p)) {
        p->failed = true;
        return;
    }
    p->ops[p->n_ops++] = (unsigned char)op;
    for (size_t i = 0; i < n; i++)
        p->points[p->n_points++] = points[i];
}

/* ---- as cairo makes paths ----------------------------------------------------------------------------------- */

static plain_point place(plain_path *p, double x, double y)
{
    const matrix *m = &p->matrix;
    double sx = (m->xx * x + m->xy * y) + m->x0, sy = (m->yx * x + m->yy * y) + m->y0;
    if (!(fabs(sx) <= FARTHEST && fabs(sy) <= FARTHEST)) {
        p->failed = true;
        return (plain_point){0, 0};
    }
    return (plain_point){(int32_t)lrint(sx * STEPS), (int32_t)lrint(sy * STEPS)};
}

static bool same(plain_point a, plain_point b) { return a.x == b.x && a.y == b.y; }

static void move_to(plain_path *p, plain_point to)
{
    p->current = p->start = to;
    p->has_current = p->is_pending = true;
}

/* Writes the move that was put off. */
static void start_subpath(plain_path *p)
{
    if (!p->is_pending)
        return;
    p->is_pending = false;
    p->start = p->current;
    add(p, PLAIN_MOVE, &p->current, 1);
}

static bool ends_in(const plain_path *p, int op) { return p->n_ops && p->ops[p->n_ops - 1] == op; }

static void drop_line(plain_path *p)
{
    p->n_ops--;
    p->n_points--;
}

/* Tells whether a line to `to` goes on in the direction of the last line. */
static bool goes_on(const plain_path *p, plain_point to)
{
    plain_point before = p->points[p->n_points - 2];
    int64_t ax = p->current.x - before.x, ay = p->current.y - before.y, bx = to.x - p->current.x, by = to.y - p->current.y;
    return ay * bx == by * ax && ax * bx + ay * by >= 0;
}

/* Tells whether the last operation is a line without length. */
static bool ends_in_a_dot(const plain_path *p) { return ends_in(p, PLAIN_LINE) && same(p->points[p->n_points - 2], p->current); }

static void line_to(plain_path *p, plain_point to)
{
    if (!p->has_current) {
        move_to(p, to);
        return;
    }
    start_subpath(p);
    if (p->failed || (!ends_in(p, PLAIN_MOVE) && same(p->current, to)))
        return;
    if (ends_in_a_dot(p) || (ends_in(p, PLAIN_LINE) && goes_on(p, to)))
        drop_line(p);
    p->is_upright = p->is_upright && (p->current.x == to.x || p->current.y == to.y);
    p->is_empty = p->is_empty && same(p->current, to);
    p->current = to;
    add(p, PLAIN_LINE, &to, 1);
}

void plb_plain_move(plain_path *p, double x, double y) { move_to(p, place(p, x, y)); }
void plb_plain_line(plain_path *p, double x, double y) { line_to(p, place(p, x, y)); }

void plb_plain_curve(plain_path *p, const double at[6])
{
    plain_point c[3] = {place(p, at[0], at[1]), place(p, at[2], at[3]), place(p, at[4], at[5])};
    if (p->has_current && same(p->current, c[2]) && same(c[0], c[2]) && same(c[1], c[2])) {
        line_to(p, c[2]);
        return;
    }
    if (!p->has_current)
        move_to(p, c[0]);
    start_subpath(p);
    if (p->failed)
        return;
    if (ends_in_a_dot(p))
        drop_line(p);
    p->is_upright = p->is_empty = false;
    p->current = c[2];
    add(p, PLAIN_CURVE, c, 3);
}

void plb_plain_close(plain_path *p)
{
    if (!p->has_current)
        return;
    line_to(p, p->start); /* straightens what it can; then it is the closing line itself */
    if (p->failed)
        return;
    if (ends_in(p, PLAIN_LINE))
        drop_line(p);
    p->is_pending = true;
    add(p, PLAIN_CLOSE, NULL, 0);
}

/* ---- arcs --------------------------------------------------------------------------------------------------- */

typedef struct {
    double centre[2], radii[2], cosine, sine; /* of the rotation */
    double from, turn;                        /* angles */
} centred_arc;

static double angle_of(double cosine) { return acos(fmin(fmax(cosine, -1), 1)); }

/* Finds where an arc starts and how far it turns; u and v point from the centre to the ends, on the unit circle. False: there is no arc. */
static bool find_angles(const plain_arc *a, const double u[2], const double v[2], centred_arc *c)
{
    double u_length = sqrt(fabs(u[0] * u[0] + u[1] * u[1])), v_length = sqrt(fabs(v[0] * v[0] + v[1] * v[1]));
    if (u_length == 0 || v_length == 0)
        return false;
    c->from = angle_of(u[0] / u_length);
    if (u[1] < 0)
        c->from = -c->from;
    c->turn = angle_of((u[0] * v[0] + u[1] * v[1]) / (u_length * v_length));
    if (u[0] * v[1] - u[1] * v[0] < 0)
        c->turn = -c->turn;
    if (a->is_positive && c->turn < 0)
        c->turn += PLB_PI * 2;
    else if (!a->is_positive && c->turn > 0)
        c->turn -= PLB_PI * 2;
    return true;
}

/* Finds centre and angles of an arc (SVG 1.1, appendix F.6.5 and F.6.6): radii that are too small are enlarged. False:
 * there is nothing to draw. */
static bool centre_arc(const plain_arc *a, centred_arc *c)
{
    double x1 = a->from[0], y1 = a->from[1], x2 = a->to[0], y2 = a->to[1], phi = a->rotation * PLB_PI / 180;
    double mx = (x1 - x2) / 2, my = (y1 - y2) / 2, rx = fabs(a->radii[0]), ry = fabs(a->radii[1]);
    c->cosine = cos(phi);
    c->sine = sin(phi);
    double px = c->cosine * mx + c->sine * my, py = -c->sine * mx + c->cosine * my;
    double lambda = (px / rx) * (px / rx) + (py / ry) * (py / ry);
    if (lambda > 1) {
        rx *= sqrt(lambda);
        ry *= sqrt(lambda);
    }
    double d = (rx * py) * (rx * py) + (ry * px) * (ry * px);
    if (d == 0)
        return false;
    double k = sqrt(fabs((rx * ry) * (rx * ry) / d - 1));
    if (a->is_positive == a->is_large)
        k = -k;
    double cx = k * rx * py / ry, cy = -k * ry * px / rx;
    c->radii[0] = rx;
    c->radii[1] = ry;
    c->centre[0] = c->cosine * cx - c->sine * cy + (x1 + x2) / 2;
    c->centre[1] = c->sine * cx + c->cosine * cy + (y1 + y2) / 2;
    double u[2] = {(px - cx) / rx, (py - cy) / ry}, v[2] = {(-px - cx) / rx, (-py - cy) / ry};
    return find_angles(a, u, v, c);
}

static void draw_segment(plain_path *p, const centred_arc *c, double from, double to)
{
    double half = 0.5 * (to - from), s = sin(half * 0.5), t = (8.0 / 3.0) * (s * s) / sin(half);
    double rx = c->radii[0], ry = c->radii[1], cos0 = cos(from), sin0 = sin(from), cos1 = cos(to), sin1 = sin(to);
    double x1 = rx * (cos0 - t * sin0), y1 = ry * (sin0 + t * cos0), x3 = rx * cos1, y3 = ry * sin1;
    double x2 = x3 + rx * (t * sin1), y2 = y3 + ry * (-t * cos1);
    double at[6] = {
        c->centre[0] + c->cosine * x1 - c->sine * y1, c->centre[1] + c->sine * x1 + c->cosine * y1,
        c->centre[0] + c->cosine * x2 - c->sine * y2, c->centre[1] + c->sine * x2 + c->cosine * y2,
        c->centre[0] + c->cosine * x3 - c->sine * y3, c->centre[1] + c->sine * x3 + c->cosine * y3,
    };
    plb_plain_curve(p, at);
}

void plb_plain_draw_arc(plain_path *p, const plain_arc *a)
{
    static const double least = 2.220446049250313e-16; /* of a radius' square */
    centred_arc c;
    if (a->radii[0] * a->radii[0] < least || a->radii[1] * a->radii[1] < least) {
        plb_plain_line(p, a->to[0], a->to[1]);
        return;
    }
    /* Only ends that are the same number leave nothing: full circles are often written as arcs with the smallest of gaps. */
    if (a->from[0] == a->to[0] && a->from[1] == a->to[1])
        return;
    if (!centre_arc(a, &c))
        return;
    double pieces = ceil(fabs(c.turn / (PLB_PI * 0.5 + 0.001)));
    if (!(pieces >= 0 && pieces <= 5)) { /* not a number */
        p->failed = true;
        return;
    }
    double step = c.turn / pieces, angle = c.from;
    for (int i = 0; i < (int)pieces; i++, angle += step)
        draw_segment(p, &c, angle, angle + step);
}

/* ---- shapes ------------------------------------------------------------------------------------------------- */

static void draw_corner(plain_path *p, const double radii[2], double x1, double y1, double x2, double y2)
{
    plain_arc a = {.from = {x1, y1}, .to = {x2, y2}, .radii = {radii[0], radii[1]}, .is_positive = true};
    plb_plain_draw_arc(p, &a);
}

static void draw_round_rectangle(plain_path *p, const double at[4], const double r[2])
{
    double left = at[0], top = at[1], right = at[0] + at[2], bottom = at[1] + at[3];
    double x1 = left + r[0], x2 = right - r[0], y1 = top + r[1], y2 = bottom - r[1];
    plb_plain_move(p, x1, top);
    plb_plain_line(p, x2, top);
    draw_corner(p, r, x2, top, right, y1);
    plb_plain_line(p, right, y2);
    draw_corner(p, r, right, y2, x2, bottom);
    plb_plain_line(p, x1, bottom);
    draw_corner(p, r, x1, bottom, left, y2);
    plb_plain_line(p, left, y1);
    draw_corner(p, r, left, y1, x1, top);
    plb_plain_close(p);
}

void plb_plain_rectangle(plain_path *p, const double at[4], double rx, double ry)
{
    double r[2] = {fmin(rx, at[2] / 2), fmin(ry, at[3] / 2)};
    if (r[0] > 0 && r[1] > 0) {
        draw_round_rectangle(p, at, r);
        return;
    }
    plb_plain_move(p, at[0], at[1]);
    plb_plain_line(p, at[0] + at[2], at[1]);
    plb_plain_line(p, at[0] + at[2], at[1] + at[3]);
    plb_plain_line(p, at[0], at[1] + at[3]);
    plb_plain_line(p, at[0], at[1]);
    plb_plain_close(p);
}

/* Draws the ellipse as four curves, with the constant of librsvg: 4/3 (sqrt(2) - 1). */
void plb_plain_ellipse(plain_path *p, const double at[4])
{
    static const double k = 0.5522847498;
    double x = at[0], y = at[1], rx = at[2], ry = at[3];
    plb_plain_move(p, x + rx, y);
    plb_plain_curve(p, (double[6]){x + rx, y + k * ry, x + k * rx, y + ry, x, y + ry});
    plb_plain_curve(p, (double[6]){x - k * rx, y + ry, x - rx, y + k * ry, x - rx, y});
    plb_plain_curve(p, (double[6]){x - rx, y - k * ry, x - k * rx, y - ry, x, y - ry});
    plb_plain_curve(p, (double[6]){x + k * rx, y - ry, x + rx, y - k * ry, x + rx, y});
    plb_plain_close(p);
}
