/* SPDX-License-Identifier: MIT
 *
 * Regions: which points are inside, and where segments cross the boundary.
 */
#include "check.h"

#include "plan/shape/region.h"

#include <math.h>

static double distance_to_outline(const point *v, size_t n, point p)
{
    double nearest = INFINITY;
    for (size_t i = 0; i < n; i++) {
        point d = point_sub(v[(i + 1) % n], v[i]);
        double t = point_dot(point_sub(p, v[i]), d) / point_dot(d, d);
        nearest = fmin(nearest, plb_point_distance(point_mix(v[i], v[(i + 1) % n], fmin(fmax(t, 0), 1)), p));
    }
    return nearest;
}

/* The region finds every place where the segment meets the closed polygon `v`, and others only where it runs along an edge. */
static void check_crossings(const region *r, const point *v, size_t n, point from, point to)
{
    crossings found = {0};
    double work = 0;
    point d = point_sub(to, from);
    CHECK(plb_region_cross(r, from, to, &found, &work) && work >= 1);
    for (size_t i = 0; i < n; i++) {
        point s = point_sub(v[(i + 1) % n], v[i]), w = point_sub(v[i], from);
        double det = point_cross(d, s), t = point_cross(w, s) / det, u = point_cross(w, d) / det, nearest = INFINITY;
        for (size_t k = 0; k < found.n; k++)
            nearest = fmin(nearest, fabs(found.v[k] - t));
        CHECK(!(t > 0 && t < 1 && u >= 0 && u <= 1) || nearest < 1e-9);
    }
    for (size_t k = 0; k < found.n; k++)
        CHECK(distance_to_outline(v, n, point_mix(from, to, found.v[k])) < 0.06);
    array_free(&found);
}

/* Random stars: the region's answers against a count of all edges. */
static void regions_answer_as_a_plain_count_does(void)
{
    unsigned seed = 7;
    for (int round = 0; round < 20; round++) {
        path p = {0};
        point v[60];
        for (int i = 0; i < 60; i++) {
            seed = seed * 1664525u + 1013904223u;
            double x = (seed >> 8) % 1000 / 10.0;
            seed = seed * 1664525u + 1013904223u;
            v[i] = (point){x, (seed >> 8) % 1000 / 10.0};
            CHECK(i ? plb_path_line(&p, v[i]) : plb_path_move(&p, v[i]));
        }
        region *r = plb_region_new(&p, round & 1, NULL);
        for (int q = 0; q < 500; q++) {
            seed = seed * 1664525u + 1013904223u;
            point at = {(seed >> 8) % 1000 / 10.0 + 0.037, (seed >> 18) % 1000 / 10.0 + 0.041};
            int winding = 0, crossed = 0;
            for (int i = 0; i < 60; i++) {
                point a = v[i], b = v[(i + 1) % 60];
                if ((a.y <= at.y) != (b.y <= at.y) && a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x) > at.x) {
                    crossed++;
                    winding += a.y < b.y ? 1 : -1;
                }
            }
            CHECK(plb_region_contains(r, at, 0) == (round & 1 ? crossed & 1 : winding != 0));
            seed = seed * 1664525u + 1013904223u;
            check_crossings(r, v, 60, at, (point){(seed >> 8) % 1000 / 7.0 - 20, q % 5 ? (seed >> 18) % 1000 / 7.0 - 20 : at.y});
        }
        plb_region_free(r);
        plb_path_free(&p);
    }
}

int main(void)
{
    RUN(regions_answer_as_a_plain_count_does);
    CHECK_EXIT;
}
