/* SPDX-License-Identifier: MIT
 *
 * The ground: a sheet with the statistics of scanned paper, the same at any resolution and however a row is cut, smeared beside darks, with ghosts of long
 * lines only.
 */
#include "check.h"

#include "plan/strokes/passes.h"
#include "surface/ground.h"

#define SIDE_MM 60.0
#define SIDE 708 /* px at 300 dpi */

static void add(stroke_list *list, double x0, double y0, double x1, double y1, float pressure)
{
    point ends[2] = {{x0, y0}, {x1, y1}};
    stroke s = {.style = STROKE_STYLE_USUAL, .identity = 1 + list->strokes.n};
    s.style.pressure = pressure;
    CHECK(plb_plan_append(list, &s, ends, 2));
}

static stroke_list page(void)
{
    return (stroke_list){.width = SIDE_MM, .height = SIDE_MM};
}

/* Gives the mean light of a box in mm, seen with pixels of `step` mm, and its standard deviation. */
static double mean_light(const ground *g, box b, double step, double *deviation)
{
    double sum = 0, squares = 0, n = 0;
    float row[GROUND_PIECE];
    for (double y = b.y0 + step / 2; y < b.y1; y += step)
        for (double x = b.x0 + step / 2; x < b.x1; x += step * GROUND_PIECE) {
            int some = (int)fmin(GROUND_PIECE, ceil((b.x1 - x) / step));
            plb_ground_row(g, x, y, step, some, row);
            for (int k = 0; k < some; k++, n++) {
                sum += (double)row[k] * 255;
                squares += (double)row[k] * 255 * (double)row[k] * 255;
            }
        }
    if (deviation)
        *deviation = sqrt(squares / n - sum / n * (sum / n));
    return sum / n;
}

/* Scanned blank paper: means of 234 to 254.8, deviations of .4 to 3.3. */
static void blank_paper_is_as_scanned(void)
{
    for (uint64_t seed = 1; seed <= 5; seed++) {
        stroke_list list = page();
        double deviation;
        ground *g = plb_ground_new(&list, seed, NULL);
        CHECK_RANGE(mean_light(g, (box){0, 0, SIDE_MM, SIDE_MM}, 25.4 / 300, &deviation), 236, 252);
        CHECK_RANGE(deviation, 1, 3.3);
        plb_ground_free(g);
    }
}

static void it_is_the_same_at_any_resolution(void)
{
    stroke_list list = page();
    ground *g = plb_ground_new(&list, 3, NULL);
    for (int i = 0; i < 20; i++) {
        box b = {3 * i, 2 * i, 3 * i + 3, 2 * i + 3};
        double at_300 = mean_light(g, b, 25.4 / 300, NULL);
        CHECK_RANGE(mean_light(g, b, 25.4 / 600, NULL) - at_300, -0.4, 0.4);
        CHECK_RANGE(mean_light(g, b, 25.4 / 150, NULL) - at_300, -0.4, 0.4);
    }
    plb_ground_free(g);
}

static void a_row_may_be_cut_anywhere(void)
{
    stroke_list list = page();
    float whole[200], part[200];
    add(&list, 5, 5, 55, 9, 1);
    ground *g = plb_ground_new(&list, 3, NULL);
    double step = 0.25;
    plb_ground_row(g, step / 2, 6, step, 200, whole);
    for (int first = 0; first < 200; first += 8)
        plb_ground_row(g, (first + 0.5) * step, 6, step, 8, part + first);
    CHECK(!memcmp(whole, part, sizeof whole));
    plb_ground_free(g);
    plb_stroke_list_free(&list);
}

/* Right of a dark area it is darker than left of it, somewhere by some greys; of a light one nothing is seen. */
static void darks_are_smeared(void)
{
    double deepest = 0;
    for (uint64_t seed = 1; seed <= 6; seed++) {
        double beside[2];
        for (int is_dark = 0; is_dark < 2; is_dark++) {
            stroke_list list = page();
            for (int i = 0; i < 80; i++)
                add(&list, 20, 20 + .2 * i, 35, 20 + .2 * i, is_dark ? 1 : 0.05F);
            for (size_t i = 0; i < list.strokes.n; i++)
                list.strokes.v[i].style.kind = STROKE_HATCH;
            ground *g = plb_ground_new(&list, seed, NULL);
            beside[is_dark] = mean_light(g, (box){36, 22, 39, 38}, 25.4 / 300, NULL);
            if (is_dark)
                CHECK_RANGE(mean_light(g, (box){10, 22, 18, 38}, 25.4 / 300, NULL), 236, 252);
            plb_ground_free(g);
            plb_stroke_list_free(&list);
        }
        deepest = fmax(deepest, beside[0] - beside[1]);
        CHECK(beside[0] - beside[1] >= -0.01);
    }
    CHECK_RANGE(deepest, 1.5, 11);
}

/* A share of long lines has a ghost beyond its end; short ones have none. */
static void long_lines_leave_ghosts(void)
{
    int seen[2] = {0, 0};
    for (uint64_t seed = 1; seed <= 40; seed++)
        for (int is_long = 0; is_long < 2; is_long++) {
            stroke_list list = page(), none = page();
            add(&list, 40 - (is_long ? 30 : 10), 30, 40, 30, 1);
            ground *g = plb_ground_new(&list, seed, NULL), *bare = plb_ground_new(&none, seed, NULL);
            box beyond = {41, 29, 43, 31};
            double deeper = mean_light(bare, beyond, 25.4 / 300, NULL) - mean_light(g, beyond, 25.4 / 300, NULL);
            CHECK_RANGE(deeper, -0.01, 4);
            seen[is_long] += deeper > 0.1;
            plb_ground_free(g);
            plb_ground_free(bare);
            plb_stroke_list_free(&list);
        }
    CHECK(seen[0] == 0);
    CHECK_RANGE(seen[1], 4, 20);
}

int main(void)
{
    RUN(blank_paper_is_as_scanned);
    RUN(it_is_the_same_at_any_resolution);
    RUN(a_row_may_be_cut_anywhere);
    RUN(darks_are_smeared);
    RUN(long_lines_leave_ghosts);
    CHECK_EXIT;
}
