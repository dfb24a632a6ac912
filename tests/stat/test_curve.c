/* SPDX-License-Identifier: MIT
 *
 * Curves as the hand draws them: the movement of least jerk through via points, its speed, circles and how they close.
 */
#include "check.h"

#include "base/number/random.h"
#include "base/number/units.h"
#include "stroke/path/via.h"
#include "stroke/stroke.h"

/* ---- the movement (path_via.c) ---- */

/* Returns the k-th derivative by time at the share t of a piece. */
static double derivative(const double c[6], double duration, int k, double t)
{
    double sum = 0;
    for (int i = 5; i >= k; i--) {
        double factor = c[i];
        for (int m = 0; m < k; m++)
            factor *= i - m;
        sum = sum * t + factor;
    }
    return sum / pow(duration, k);
}

static void make_vias(via *v, size_t n)
{
    for (size_t i = 0; i < n; i++)
        v[i] = (via){.at = {10 * random_unit(1, i), 10 * random_unit(2, i)}, .duration = 0.3 + 2 * random_unit(3, i)};
}

static void derivatives_up_to_the_fourth_are_continuous(void)
{
    via v[9];
    make_vias(v, 9);
    plb_via_solve(v, 9);
    for (size_t i = 0; i < 8; i++) {
        via_piece p = plb_via_piece(v + i);
        CHECK(plb_point_distance(plb_via_at(&p, 0), v[i].at) < 1e-12 && plb_point_distance(plb_via_at(&p, 1), v[i + 1].at) < 1e-9);
        if (i + 1 == 8)
            break;
        via_piece next = plb_via_piece(v + i + 1);
        for (int k = 1; k <= 4; k++) {
            double here = derivative(p.x, v[i].duration, k, 1), there = derivative(next.x, v[i + 1].duration, k, 0);
            CHECK(fabs(here - there) < 1e-8 * (1 + fabs(here) + fabs(there)) * 1e3);
            here = derivative(p.y, v[i].duration, k, 1);
            there = derivative(next.y, v[i + 1].duration, k, 0);
            CHECK(fabs(here - there) < 1e-8 * (1 + fabs(here) + fabs(there)) * 1e3);
        }
    }
    CHECK(v[0].velocity.x == 0 && v[0].acceleration.y == 0 && v[8].velocity.y == 0 && v[8].acceleration.x == 0);
}

/* Returns the integral of squared jerk over all pieces. */
static double cost(const via *v, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i + 1 < n; i++) {
        via_piece p = plb_via_piece(v + i);
        for (int k = 0; k < 200; k++) {
            double t = (k + 0.5) / 200, x = derivative(p.x, v[i].duration, 3, t), y = derivative(p.y, v[i].duration, 3, t);
            sum += (x * x + y * y) * v[i].duration / 200;
        }
    }
    return sum;
}

/* Any other velocity or acceleration at a via costs more. */
static void no_other_movement_has_less_jerk(void)
{
    via v[6];
    make_vias(v, 6);
    plb_via_solve(v, 6);
    double least = cost(v, 6);
    for (uint64_t k = 0; k < 40; k++) {
        via other[6];
        memcpy(other, v, sizeof v);
        size_t i = 1 + k % 4;
        other[i].velocity.x += 0.2 * (random_unit(9, k) - 0.5);
        other[i].acceleration.y += 0.4 * (random_unit(10, k) - 0.5);
        CHECK(cost(other, 6) > least);
    }
}

/* A via that lies where and when the movement without it passes changes nothing: 10 t^3 - 15 t^4 + 6 t^5. */
static void a_via_on_the_way_changes_nothing(void)
{
    via v[3] = {{.at = {0, 0}, .duration = 0.4}, {.at = {0, 0}, .duration = 0.6}, {.at = {8, 6}}};
    double t = 0.4, s = t * t * t * (10 - 15 * t + 6 * t * t);
    v[1].at = (point){8 * s, 6 * s};
    plb_via_solve(v, 3);
    CHECK(fabs(v[1].velocity.x - 8 * 30 * t * t * (1 - t) * (1 - t)) < 1e-9);
    via_piece p = plb_via_piece(v);
    double half = 0.2, there = half * half * half * (10 - 15 * half + 6 * half * half);
    CHECK(plb_point_distance(plb_via_at(&p, 0.5), (point){8 * there, 6 * there}) < 1e-9);
}

/* ---- the drawn curve ---- */

typedef struct {
    point v[400];
    stroke s;
    stroke_list list;
    stroke_options o;
    path_samples path;
} curve;

static void draw(curve *c, uint64_t identity)
{
    c->s.style = STROKE_STYLE_USUAL;
    c->s.identity = random_mix(identity);
    c->list = (stroke_list){.strokes = {&c->s, 1, 1}, .points = {c->v, c->s.n, c->s.n}};
    c->o.seed = 2;
    c->o.model = &plb_model_graphite;
    c->o.arm = &plb_arm_hand;
    c->o.dpi = 300;
    CHECK(plb_path_sample(&c->list, &c->s, &c->o, &c->path, NULL));
}

/* An arc of an ellipse as a polyline; closed when it is all of it. */
static void make_arc(curve *c, double rx, double ry, double degrees)
{
    c->s.n = 361;
    c->s.closed = degrees == 360;
    for (size_t i = 0; i < c->s.n; i++) {
        double a = degrees / 360 * (double)i / 360 * 2 * PLB_PI;
        c->v[i] = (point){100 + rx * cos(a), 100 + ry * sin(a)};
    }
    if (c->s.closed)
        c->v[360] = c->v[0];
}

/* How far the distances of the samples from the centre spread about the radius, as a share of it. */
static double roundness(const curve *c, double r)
{
    double worst = 0;
    for (size_t i = 0; i < c->path.n; i++)
        worst = fmax(worst, fabs(plb_point_distance(c->path.v[i].at, (point){100, 100}) / r - 1));
    return worst;
}

static void circles_are_careful(void)
{
    static const struct {
        double r, most;
    } sizes[] = {{30, 0.05}, {10, 0.07}, {3, 0.12}, {1, 0.2}};
    curve c = {.o = {.squiggle = -1, .handed = HANDED_RIGHT}};
    for (size_t i = 0; i < 4; i++) {
        double sum = 0;
        make_arc(&c, sizes[i].r, sizes[i].r, 360);
        for (uint64_t k = 0; k < 100; k++) {
            draw(&c, k);
            sum += roundness(&c, sizes[i].r) / 100;
        }
        CHECK_RANGE(sum, 0.005, sizes[i].most);
    }
    c.o.squiggle = 0.001; /* the movement alone, with next to no deviation: a circle */
    make_arc(&c, 20, 20, 360);
    draw(&c, 1);
    CHECK_RANGE(roundness(&c, 20), 0, 0.004);
    array_free(&c.path);
}

/* The hand passes the beginning by some millimetres, a little beside it, and begins near the top. */
static void circles_close_with_an_overlap(void)
{
    curve c = {.o = {.squiggle = -1, .handed = HANDED_RIGHT}};
    double beside = 0;
    for (uint64_t k = 0; k < 100; k++) {
        make_arc(&c, 12, 12, 360);
        draw(&c, k);
        CHECK(!c.path.closed);
        double round = 2 * PLB_PI * 12, length = c.path.v[c.path.n - 1].along;
        CHECK_RANGE(length - round, 0.5, 10);
        CHECK(c.path.v[0].at.y < 95);
        double nearest = 1e300; /* of the last turn, to the beginning */
        for (size_t i = 0; i < c.path.n; i++)
            if (c.path.v[i].along > length / 2)
                nearest = fmin(nearest, plb_point_distance(c.path.v[i].at, c.path.v[0].at));
        beside += nearest / 100;
        CHECK_RANGE(nearest, 0, 1.5);
    }
    CHECK_RANGE(beside, 0.05, 0.6);
    c.s.n = 0;
    c.o.model = &plb_model_hla; /* the papers' model closes its curves */
    make_arc(&c, 12, 12, 360);
    c.list = (stroke_list){.strokes = {&c.s, 1, 1}, .points = {c.v, c.s.n, c.s.n}};
    CHECK(plb_path_sample(&c.list, &c.s, &c.o, &c.path, NULL) && c.path.closed);
    array_free(&c.path);
}

/* Speed goes with the radius of curvature to the power of 1/3: samples of the movement itself, at even times. */
static void speed_follows_the_two_thirds_law(void)
{
    enum { VIAS = 40 };
    via v[VIAS + 1];
    double along[VIAS + 1] = {0}, radius[VIAS + 1];
    for (int i = 0; i <= VIAS; i++) { /* an ellipse, with the times that the law asks for, as put() in path_curve.c */
        double a = 2 * PLB_PI * i / VIAS, dx = 30 * sin(a), dy = 12 * cos(a), speed = sqrt(dx * dx + dy * dy);
        v[i] = (via){.at = {30 * cos(a), 12 * sin(a)}};
        radius[i] = speed * speed * speed / (30 * 12);
        along[i] = i ? along[i - 1] + plb_point_distance(v[i].at, v[i - 1].at) : 0;
        if (i)
            v[i - 1].duration = (along[i] - along[i - 1]) / cbrt((radius[i] + radius[i - 1]) / 2);
    }
    plb_via_solve(v, VIAS + 1);
    double sx = 0, sy = 0, sxx = 0, sxy = 0, n = 0;
    for (int i = 6; i <= VIAS - 6; i++, n++) {
        double x = log(radius[i]), y = log(plb_point_length(v[i].velocity));
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    CHECK_RANGE((n * sxy - sx * sy) / (n * sxx - sx * sx), 0.28, 0.39);
}

static double distance_to(const curve *c, point at)
{
    double nearest = 1e300;
    for (size_t i = 0; i < c->s.n; i++)
        nearest = fmin(nearest, plb_point_distance(c->v[i], at));
    return nearest;
}

/* An open curve keeps to its course, ends exactly at corners, and with --squiggle 0 is the curve itself. */
static void open_curves_keep_their_course(void)
{
    curve c = {.o = {.squiggle = -1, .handed = HANDED_RIGHT}, .s = {.corner_first = true, .corner_last = true}};
    make_arc(&c, 25, 10, 200);
    for (uint64_t k = 0; k < 100; k++) {
        draw(&c, k);
        for (size_t i = 0; i < c.path.n; i++)
            CHECK(distance_to(&c, c.path.v[i].at) < 0.035 * 50);
        CHECK(plb_point_distance(c.path.v[0].at, c.v[0]) < 1e-9 && plb_point_distance(c.path.v[c.path.n - 1].at, c.v[360]) < 1e-9);
    }
    c.o.squiggle = 0;
    draw(&c, 1);
    for (size_t i = 0; i < c.path.n; i++)
        CHECK(distance_to(&c, c.path.v[i].at) < 0.13); /* half a step of the polyline's vertices */
    array_free(&c.path);
}

/* Straight, round a bend of 1 mm, and straight again: the hand leaves neither by much, wherever the bend is. */
static void tight_bends_do_not_swing_the_straights(void)
{
    curve c = {.o = {.squiggle = 0.001}, .s = {.corner_first = true, .corner_last = true}};
    size_t n = 0;
    c.v[n++] = (point){0, 0};
    for (int k = 0; k <= 8; k++)
        c.v[n++] = (point){50 + sin(k * PLB_PI / 16), 1 - cos(k * PLB_PI / 16)};
    c.v[n++] = (point){51, 40};
    c.s.n = n;
    draw(&c, 1);
    for (size_t i = 0; i < c.path.n; i++) {
        point p = c.path.v[i].at;
        double off = p.x < 50 ? fabs(p.y) : p.y > 1 ? fabs(p.x - 51) : fabs(plb_point_distance(p, (point){50, 1}) - 1);
        CHECK_RANGE(off, 0, 0.08);
    }
    CHECK(c.path.n < 200);
    array_free(&c.path);
}

int main(void)
{
    RUN(derivatives_up_to_the_fourth_are_continuous);
    RUN(no_other_movement_has_less_jerk);
    RUN(a_via_on_the_way_changes_nothing);
    RUN(circles_are_careful);
    RUN(circles_close_with_an_overlap);
    RUN(speed_follows_the_two_thirds_law);
    RUN(open_curves_keep_their_course);
    RUN(tight_bends_do_not_swing_the_straights);
    CHECK_EXIT;
}
