/* SPDX-License-Identifier: MIT
 *
 * Numbers as text against the C library's, which is exact: all bits of the double must agree. With a number in the
 * environment variable NUMBERS as many random ones are tried (10,000,000 take a minute).
 */
#include "check.h"

#include "base/number/number.h"

#include <float.h>
#include <stdint.h>

static uint64_t state = 88172645463325252u;

static uint64_t next_random(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    return state ^= state << 17;
}

static long count(void)
{
    const char *asked = getenv("NUMBERS");
    return asked ? atol(asked) : 50000;
}

static double of_bits(uint64_t bits)
{
    double v;
    memcpy(&v, &bits, sizeof v);
    return v;
}

static bool same_bits(double a, double b) { return memcmp(&a, &b, sizeof a) == 0; }

static bool reads_like_the_library(const char *text)
{
    double v = 0;
    const char *next = NULL, *end = text + strlen(text);
    bool good = plb_parse_number(text, end, &v, &next) && next == end && same_bits(v, strtod(text, NULL));
    if (!good)
        printf("# %.80s gives %.17g, not %.17g\n", text, v, strtod(text, NULL));
    return good;
}

/* Digits that tell something: without zeros at either end. */
static int digits_in(const char *text)
{
    int n = 0, zeros = 0;
    for (; *text && *text != 'e'; text++)
        if (*text == '0') {
            zeros += n > 0;
        } else if (*text >= '1' && *text <= '9') {
            n += zeros + 1;
            zeros = 0;
        }
    return n;
}

/* The fewest digits with which the C library's text reads back as v. */
static int fewest_digits(double v)
{
    char text[40];
    for (int n = 1; n < 17; n++) {
        snprintf(text, sizeof text, "%.*g", n, v);
        if (same_bits(strtod(text, NULL), v))
            return digits_in(text);
    }
    return 17;
}

static bool comes_back(double v)
{
    char text[NUMBER_TEXT_MAX], plain[40];
    size_t n = plb_write_number(text, v);
    snprintf(plain, sizeof plain, "%.17g", v);
    bool good = n == strlen(text) && n < NUMBER_TEXT_MAX && same_bits(strtod(text, NULL), v) && reads_like_the_library(text) &&
                reads_like_the_library(plain);
    if (!good)
        printf("# %s is written %s\n", plain, text);
    return good;
}

static void any_bits_come_back(void)
{
    for (long i = 0; i < count(); i++) {
        double v = of_bits(next_random());
        CHECK(!isfinite(v) || comes_back(v));
    }
}

static void coordinates_come_back(void)
{
    for (long i = 0; i < count(); i++) {
        double part = (double)(next_random() >> 11) * 0x1p-53;
        CHECK(comes_back((double)(next_random() % 2000000000) / 1000 - 1e6));
        CHECK(comes_back(part * 300));
        CHECK(comes_back(part * pow(10, -(double)(next_random() % 60))));
    }
}

static void the_ends_of_the_range_come_back(void)
{
    static const double ends[] = {0.0, -0.0, DBL_MAX, -DBL_MAX, DBL_MIN, DBL_TRUE_MIN, -DBL_TRUE_MIN, 9007199254740992.0, 9007199254740993.0};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        CHECK(comes_back(ends[i]));
    for (int e = -1074; e < 1024; e++) {
        double v = ldexp(1, e);
        CHECK(comes_back(v) && comes_back(nextafter(v, 0)) && (e == 1023 || comes_back(nextafter(v, DBL_MAX))));
    }
    for (uint64_t bits = 1; bits < (uint64_t)1 << 53; bits *= 3)
        CHECK(comes_back(of_bits(bits)));
}

static void no_text_is_shorter(void)
{
    for (long i = 0; i < count() / 10; i++) {
        double v = i % 2 ? of_bits(next_random()) : (double)(next_random() >> 11) * 0x1p-53 * 300;
        char text[NUMBER_TEXT_MAX];
        if (!isfinite(v))
            continue;
        plb_write_number(text, v);
        CHECK(digits_in(text) <= fewest_digits(v));
    }
}

static void texts_look_as_expected(void)
{
    static const struct {
        double v;
        const char *text;
    } cases[] = {{0, "0"},         {-0.0, "-0"},        {12.5, "12.5"},           {-0.001, "-0.001"},  {1e-6, "0.000001"}, {1e-7, "1e-7"},
                 {1e20, "100000000000000000000"},       {1e21, "1e21"},           {1.5e300, "1.5e300"}, {5e-324, "5e-324"}, {100, "100"},
                 {0.1 + 0.2, "0.30000000000000004"},    {123456789012.125, "123456789012.125"},         {2.5e-10, "2.5e-10"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[NUMBER_TEXT_MAX];
        plb_write_number(text, cases[i].v);
        CHECK(!strcmp(text, cases[i].text));
    }
}

/* Any digits, a point anywhere, any exponent. */
static void any_text_is_read(void)
{
    for (long i = 0; i < count() / 5; i++) {
        char text[900], *p = text;
        int n = 1 + (int)(next_random() % (i % 10 ? 25 : 780)), point = (int)(next_random() % (unsigned)(n + 1));
        for (int k = 0; k < n; k++) {
            if (k == point)
                *p++ = '.';
            *p++ = (char)('0' + next_random() % 10);
        }
        snprintf(p, 20, "e%d", (int)(next_random() % 700) - 350);
        CHECK(reads_like_the_library(text));
    }
}

/* Just between two doubles, a hair above, and the same with zeros behind. */
static void halves_go_to_the_even_side(void)
{
    static char text[1400];
    for (long i = 0; i < count() / 20; i++) {
        uint64_t bits = next_random() >> 1;
        double below = of_bits(i % 3 ? bits : bits >> 11), above = nextafter(below, DBL_MAX);
        if (!isfinite(below) || !isfinite(above))
            continue;
        snprintf(text, sizeof text, "%.1100Le", ((long double)below + (long double)above) / 2);
        CHECK(reads_like_the_library(text));
        char *e = strchr(text, 'e'), exponent[16];
        snprintf(exponent, sizeof exponent, "%s", e);
        snprintf(e, 60, "%040d%s%s", 0, i % 2 ? "1" : "", exponent);
        CHECK(reads_like_the_library(text));
    }
}

static void long_texts_are_read(void)
{
    static char text[5000];
    static const char *const some[] = {"2.2250738585072011e-308", "1e310", "-1e999999999", "1e-99999999999999", "0.0e400", "1e-400", "2.4703282292062327e-324",
                                       "2.4703282292062328e-324", "1.7976931348623158e308", "1.7976931348623159e308", "9223372036854775808", "18446744073709551616",
                                       "9007199254740993", "9007199254740992.99999999999999999999999999999999999999999"};
    for (size_t i = 0; i < sizeof some / sizeof *some; i++)
        CHECK(reads_like_the_library(some[i]));
    memset(text, '0', sizeof text - 1);
    memcpy(text + 4000, "1e4000", 7);
    CHECK(reads_like_the_library(text));
    memset(text, '0', sizeof text - 1);
    memcpy(text, "1", 1);
    memcpy(text + 4000, "e-4000", 7);
    CHECK(reads_like_the_library(text));
    memcpy(text, ".", 1);
    memcpy(text + 3000, "123e3000", 9);
    CHECK(reads_like_the_library(text));
}

int main(void)
{
    RUN(any_bits_come_back);
    RUN(coordinates_come_back);
    RUN(the_ends_of_the_range_come_back);
    RUN(no_text_is_shorter);
    RUN(texts_look_as_expected);
    RUN(any_text_is_read);
    RUN(halves_go_to_the_even_side);
    RUN(long_texts_are_read);
    CHECK_EXIT;
}
