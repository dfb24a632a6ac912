/* SPDX-License-Identifier: MIT
 *
 * Eight numbers in a register: each step against the same step with plain numbers.
 */
#include "base/simd16.h"
#include "base/number/random.h"
#include "check.h"

#define TRIES 2000

/* Returns number k of a sequence in which the extremes are frequent. */
static int16_t number(uint64_t k)
{
    static const int16_t extremes[] = {INT16_MIN, INT16_MIN + 1, -1, 0, 1, INT16_MAX - 1, INT16_MAX, 255};
    uint64_t bits = random_bits(1, k);
    return bits >> 62 ? (int16_t)(bits & 0xffff) : extremes[bits & 7];
}

static void fill(int16_t v[SIMD16_LANES], uint64_t k)
{
    for (uint64_t i = 0; i < SIMD16_LANES; i++)
        v[i] = number(SIMD16_LANES * k + i);
}

static int cut(int v, int low, int high)
{
    return v < low ? low : v > high ? high : v;
}

static void products(void)
{
    int16_t a[SIMD16_LANES], b[SIMD16_LANES], out[SIMD16_LANES];
    for (uint64_t k = 0; k < TRIES; k++) {
        fill(a, 2 * k);
        fill(b, 2 * k + 1);
        simd16_put(out, simd16_high(simd16_at(a), simd16_at(b)));
        for (int i = 0; i < SIMD16_LANES; i++)
            CHECK(out[i] == (a[i] * b[i] - ((a[i] * b[i]) & 0xffff)) / 65536);
    }
}

static void bounds(void)
{
    int16_t a[SIMD16_LANES], out[SIMD16_LANES];
    int8_t with_sign[SIMD16_LANES];
    uint8_t without[SIMD16_LANES];
    for (uint64_t k = 0; k < TRIES; k++) {
        fill(a, k);
        int16_t low = (int16_t)(number(k) / 2 - 16384), high = (int16_t)(low + 16384);
        simd16_put(out, simd16_within(simd16_at(a), low, high));
        simd16_put_bytes(with_sign, simd16_at(a));
        simd16_put_unsigned(without, simd16_at(a));
        for (int i = 0; i < SIMD16_LANES; i++) {
            CHECK(out[i] == cut(a[i], low, high));
            CHECK(with_sign[i] == cut(a[i], -128, 127));
            CHECK(without[i] == cut(a[i], 0, 255));
        }
    }
}

static void sums_without_sign(void)
{
    int16_t drawn[2][SIMD16_LANES];
    uint16_t a[SIMD16_LANES], b[SIMD16_LANES], out[SIMD16_LANES];
    int cuts = 0;
    for (uint64_t k = 0; k < TRIES; k++) {
        fill(drawn[0], 2 * k);
        fill(drawn[1], 2 * k + 1);
        memcpy(a, drawn[0], sizeof a);
        memcpy(b, drawn[1], sizeof b);
        memcpy(out, a, sizeof out);
        simd16_add_within(out, b);
        for (int i = 0; i < SIMD16_LANES; i++) {
            CHECK(out[i] == cut(a[i] + b[i], 0, 65535));
            cuts += a[i] + b[i] > 65535;
        }
    }
    CHECK(cuts > TRIES && cuts < (SIMD16_LANES - 1) * TRIES);
}

static void bytes_and_equal_numbers(void)
{
    int8_t bytes[SIMD16_LANES];
    int16_t out[SIMD16_LANES], all[SIMD16_LANES];
    for (int v = -128; v < 128; v++) {
        for (int i = 0; i < SIMD16_LANES; i++)
            bytes[i] = (int8_t)(i % 2 ? v : -1 - v);
        simd16_put(out, simd16_of_bytes(bytes));
        simd16_put(all, simd16_all((int16_t)(v * 255)));
        for (int i = 0; i < SIMD16_LANES; i++) {
            CHECK(out[i] == 256 * bytes[i]);
            CHECK(all[i] == v * 255);
        }
    }
}

int main(void)
{
    RUN(products);
    RUN(bounds);
    RUN(sums_without_sign);
    RUN(bytes_and_equal_numbers);
    CHECK_EXIT;
}
