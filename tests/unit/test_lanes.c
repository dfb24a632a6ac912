/* SPDX-License-Identifier: MIT
 *
 * Eight numbers in a register: each step against the same step with plain numbers.
 */
#include "base/lanes.h"
#include "base/random.h"
#include "check.h"

#define TRIES 2000

/* Number k of a sequence in which the extremes are frequent. */
static int16_t number(uint64_t k)
{
    static const int16_t extremes[] = {INT16_MIN, INT16_MIN + 1, -1, 0, 1, INT16_MAX - 1, INT16_MAX, 255};
    uint64_t bits = random_bits(1, k);
    return bits >> 62 ? (int16_t)(bits & 0xffff) : extremes[bits & 7];
}

static void fill(int16_t v[LANES], uint64_t k)
{
    for (uint64_t i = 0; i < LANES; i++)
        v[i] = number(LANES * k + i);
}

static int cut(int v, int low, int high)
{
    return v < low ? low : v > high ? high : v;
}

static void products(void)
{
    int16_t a[LANES], b[LANES], out[LANES];
    for (uint64_t k = 0; k < TRIES; k++) {
        fill(a, 2 * k);
        fill(b, 2 * k + 1);
        lanes_put(out, lanes_high(lanes_at(a), lanes_at(b)));
        for (int i = 0; i < LANES; i++)
            CHECK(out[i] == (a[i] * b[i] - ((a[i] * b[i]) & 0xffff)) / 65536);
    }
}

static void bounds(void)
{
    int16_t a[LANES], out[LANES];
    int8_t with_sign[LANES];
    uint8_t without[LANES];
    for (uint64_t k = 0; k < TRIES; k++) {
        fill(a, k);
        int16_t low = (int16_t)(number(k) / 2 - 16384), high = (int16_t)(low + 16384);
        lanes_put(out, lanes_within(lanes_at(a), low, high));
        lanes_put_bytes(with_sign, lanes_at(a));
        lanes_put_unsigned(without, lanes_at(a));
        for (int i = 0; i < LANES; i++) {
            CHECK(out[i] == cut(a[i], low, high));
            CHECK(with_sign[i] == cut(a[i], -128, 127));
            CHECK(without[i] == cut(a[i], 0, 255));
        }
    }
}

static void sums_without_sign(void)
{
    int16_t drawn[2][LANES];
    uint16_t a[LANES], b[LANES], out[LANES];
    int cuts = 0;
    for (uint64_t k = 0; k < TRIES; k++) {
        fill(drawn[0], 2 * k);
        fill(drawn[1], 2 * k + 1);
        memcpy(a, drawn[0], sizeof a);
        memcpy(b, drawn[1], sizeof b);
        memcpy(out, a, sizeof out);
        lanes_add_within(out, b);
        for (int i = 0; i < LANES; i++) {
            CHECK(out[i] == cut(a[i] + b[i], 0, 65535));
            cuts += a[i] + b[i] > 65535;
        }
    }
    CHECK(cuts > TRIES && cuts < (LANES - 1) * TRIES);
}

static void bytes_and_equal_numbers(void)
{
    int8_t bytes[LANES];
    int16_t out[LANES], all[LANES];
    for (int v = -128; v < 128; v++) {
        for (int i = 0; i < LANES; i++)
            bytes[i] = (int8_t)(i % 2 ? v : -1 - v);
        lanes_put(out, lanes_of_bytes(bytes));
        lanes_put(all, lanes_all((int16_t)(v * 255)));
        for (int i = 0; i < LANES; i++) {
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
