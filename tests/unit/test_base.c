/* SPDX-License-Identifier: MIT
 *
 * The floor: numbers, lengths, geometry, paths, arrays, random numbers, output files.
 */
#include "check.h"

#include "base/array.h"
#include "base/number/number.h"
#include "system/output.h"
#include "base/geometry/path.h"
#include "base/number/random.h"
#include "base/number/units.h"

#include <stdint.h>
#include <sys/stat.h>
#include <unistd.h>

static void numbers_are_read(void)
{
    static const struct {
        const char *text;
        double value;
        size_t used;
    } cases[] = {{"0", 0, 1},         {"-12.5e-3x", -0.0125, 8}, {"+.5", 0.5, 3},       {"5.", 5, 2},
                 {"1e", 1, 1},        {"1e+", 1, 1},             {"1e2e", 100, 3},      {"123456789012345678901234", 1.2345678901234568e23, 24},
                 {"1e-320", 1e-320, 6}, {"0e999999999", 0, 11},  {"-0", 0, 2}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double v = 99;
        const char *next;
        CHECK(plb_parse_number(cases[i].text, cases[i].text + strlen(cases[i].text), &v, &next));
        CHECK(fabs(v - cases[i].value) <= fabs(cases[i].value) * 1e-15 && (size_t)(next - cases[i].text) == cases[i].used);
    }
    static const char *const wrong[] = {"", "-", ".", "e5", "+-1", "x"}, huge[] = "1e999";
    double v;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        CHECK(!plb_parse_number(wrong[i], wrong[i] + strlen(wrong[i]), &v, NULL));
    CHECK(plb_parse_number(huge, huge + strlen(huge), &v, NULL) && v > 1e308);
}

static void numbers_are_written(void)
{
    static const struct {
        double value;
        int decimals;
        const char *text;
    } cases[] = {{0, 3, "0"},        {-0.0001, 3, "0"}, {1.5, 3, "1.5"},   {-1.0006, 3, "-1.001"}, {0.9996, 3, "1"},
                 {12.3456, 3, "12.346"}, {1e14, 2, "100000000000000"}, {1e300, 3, "inf"}, {-1e300, 3, "-inf"}, {0.05, 2, "0.05"}};
    char text[48];
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        CHECK(!strcmp(plb_format_number(text, cases[i].value, cases[i].decimals), cases[i].text));
    CHECK(!strcmp(plb_format_number(text, (double)NAN, 3), "nan"));
}

static void lengths_are_read(void)
{
    double mm;
    CHECK(plb_read_length("5/300in", &mm) && fabs(mm - 5 * MM_PER_PAPER_PX) < 1e-12);
    CHECK(plb_read_length("96", &mm) && fabs(mm - 25.4) < 1e-12);
    CHECK(plb_read_length("1.5cm", &mm) && fabs(mm - 15) < 1e-12);
    CHECK(plb_read_length("72pt", &mm) && fabs(mm - 25.4) < 1e-12);
    static const char *const wrong[] = {"", "mm", "5 mm", "5furlongs", "5/0in", "5//3in", "1e999mm"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        CHECK(!plb_read_length(wrong[i], &mm));
}

static void matrices_compose(void)
{
    matrix a = plb_matrix_multiply(plb_matrix_rotate(0.35), (matrix){2, 0, 0, 3, 5, 7}), back;
    point p = {1.25, -4}, q = plb_matrix_apply(a, p);
    CHECK(plb_matrix_invert(a, &back));
    CHECK(plb_point_distance(plb_matrix_apply(back, q), p) < 1e-12);
    CHECK(fabs(plb_matrix_expansion(a) - sqrt(6)) < 1e-12);
    CHECK(!plb_matrix_invert((matrix){1, 2, 2, 4, 0, 0}, &back));
    CHECK(!plb_matrix_invert((matrix){(double)NAN, 0, 0, 1, 0, 0}, &back));
}

static void paths_know_their_current_point(void)
{
    path p = {0};
    point at;
    CHECK(!plb_path_current(&p, &at) && plb_path_is_empty(&p));
    CHECK(plb_path_move(&p, (point){9, 9}) && plb_path_move(&p, (point){1, 2})); /* the second replaces the first */
    CHECK(plb_path_line(&p, (point){3, 4}) && plb_path_close(&p) && plb_path_close(&p));
    CHECK(p.ops.n == 3 && plb_path_current(&p, &at) && at.x == 1 && at.y == 2);
    box b = plb_path_bounds(&p);
    CHECK(b.x0 == 1 && b.y1 == 4);
    plb_path_free(&p);
}

/* All points of the curves lie on the circle to 3e-4 of the radius, whatever the angles and the sense. */
static void arcs_are_round(void)
{
    static const double angles[][2] = {{0, 6.283185307179586}, {1, 2}, {2, 1}, {-3, 8}, {0, 0}, {5, -9}};
    for (size_t i = 0; i < 6; i++)
        for (int clockwise = 0; clockwise < 2; clockwise++) {
            path p = {0};
            CHECK(plb_path_arc(&p, (point){10, 20}, 5, angles[i][0], angles[i][1], clockwise, MATRIX_IDENTITY));
            for (size_t k = 1; k + 2 < p.points.n; k += 3) {
                const point *c = p.points.v + k - 1;
                for (double t = 0; t <= 1; t += 0.125) {
                    double s = 1 - t, w0 = s * s * s, w1 = 3 * s * s * t, w2 = 3 * s * t * t, w3 = t * t * t;
                    point at = {w0 * c[0].x + w1 * c[1].x + w2 * c[2].x + w3 * c[3].x, w0 * c[0].y + w1 * c[1].y + w2 * c[2].y + w3 * c[3].y};
                    CHECK_RANGE(plb_point_distance(at, (point){10, 20}), 5 * (1 - 3e-4), 5 * (1 + 3e-4));
                }
            }
            point end = {10 + 5 * cos(angles[i][1]), 20 + 5 * sin(angles[i][1])}, at;
            CHECK(plb_path_current(&p, &at) && (fabs(angles[i][1] - angles[i][0]) > 6.3 || plb_point_distance(at, end) < 1e-9));
            plb_path_free(&p);
        }
}

static void arrays_refuse_overflow(void)
{
    ARRAY(double) a = {0};
    for (int i = 0; i < 1000; i++)
        CHECK(array_push(&a, i));
    CHECK(a.n == 1000 && a.v[999] == 999);
    CHECK(!array_reserve(&a, SIZE_MAX / 4) && a.n == 1000 && a.v[0] == 0);
    array_free(&a);
    CHECK(a.v == NULL && a.n == 0);
}

/* Uniform, and without correlation between neighbours, purposes, strokes and seeds. */
static void random_numbers_have_addresses(void)
{
    double sum = 0, squares = 0, neighbours = 0, purposes = 0, strokes = 0, seeds = 0;
    int n = 20000;
    for (int i = 0; i < n; i++) {
        uint64_t k = (uint64_t)i;
        double v = random_unit(random_key(1, 2, PURPOSE_SQUIGGLE), k) - 0.5;
        CHECK(v >= -0.5 && v < 0.5);
        sum += v;
        squares += v * v;
        neighbours += v * (random_unit(random_key(1, 2, PURPOSE_SQUIGGLE), k + 1) - 0.5);
        purposes += v * (random_unit(random_key(1, 2, PURPOSE_CENTRE), k) - 0.5);
        strokes += v * (random_unit(random_key(1, 3, PURPOSE_SQUIGGLE), k) - 0.5);
        seeds += v * (random_unit(random_key(2, 2, PURPOSE_SQUIGGLE), k) - 0.5);
    }
    double limit = 4 / sqrt(n); /* four standard deviations */
    CHECK_RANGE(sum / n, -limit / 3, limit / 3);
    CHECK_RANGE(squares / n * 12, 0.97, 1.03);
    CHECK_RANGE(neighbours / squares, -limit, limit);
    CHECK_RANGE(purposes / squares, -limit, limit);
    CHECK_RANGE(strokes / squares, -limit, limit);
    CHECK_RANGE(seeds / squares, -limit, limit);
}

/* The numbers behind every drawing: changing them changes all drawings, which NEWS must then say. */
static void random_numbers_never_change(void)
{
    CHECK(random_mix(1) == 0x5692161d100b05e5u);
    CHECK(random_bits(0, 0) == random_mix(0x9e3779b97f4a7c15u));
}

static void output_appears_whole_or_not_at_all(void)
{
    error err = {ERROR_NONE, ""};
    output out;
    struct stat st;
    CHECK(plb_output_open(&out, "whole.txt", &err));
    fputs("new", out.to);
    fflush(out.to);
    CHECK(stat("whole.txt", &st) != 0); /* not yet */
    CHECK(plb_output_commit(&out, &err) && stat("whole.txt", &st) == 0 && st.st_size == 3);
    CHECK(plb_output_open(&out, "whole.txt", &err));
    fputs("other text", out.to);
    plb_output_discard(&out);
    CHECK(stat("whole.txt", &st) == 0 && st.st_size == 3);
    CHECK(plb_output_open(&out, "whole.txt", &err));
    fputs("longer", out.to);
    CHECK(plb_output_commit(&out, &err) && stat("whole.txt", &st) == 0 && st.st_size == 6); /* replaced in one step */
    unlink("whole.txt");
    CHECK(!plb_output_open(&out, "no/such/folder/file", &err) && err.kind == ERROR_FILE);
    plb_error_clear(&err);
    CHECK(!plb_output_open(&out, ".", &err) && err.kind == ERROR_FILE);
    plb_error_clear(&err);
    CHECK(plb_output_open(&out, "/dev/full", &err));
    for (int i = 0; i < 10000; i++)
        fputs("more than any buffer", out.to);
    CHECK(!plb_output_commit(&out, &err) && err.kind == ERROR_FILE);
}

int main(void)
{
    RUN(numbers_are_read);
    RUN(numbers_are_written);
    RUN(lengths_are_read);
    RUN(matrices_compose);
    RUN(paths_know_their_current_point);
    RUN(arcs_are_round);
    RUN(arrays_refuse_overflow);
    RUN(random_numbers_have_addresses);
    RUN(random_numbers_never_change);
    RUN(output_appears_whole_or_not_at_all);
    CHECK_EXIT;
}
