/* SPDX-License-Identifier: MIT
 *
 * The shortest decimal text of a double. All numbers that are read as the double make an interval about it: scaled by a power
 * of ten so that 17 digits stand before the point, its ends are whole numbers and a rest; the text has the digits of the
 * number in between that ends with most zeros (Steele and White 1990 asked for it; worked out here in whole numbers of 192
 * bits, of any size where those are too few).
 */
#include "base/number/number.h"

#include "base/number/big_integer.h"
#include "base/number/powers.h"

#include <string.h>

/* A double is m * 2^e. */
typedef struct {
    uint64_t m;
    int e;
    bool is_lowest; /* of those with its exponent: the next double below is only half as far as the one above */
} binary;

static binary take_apart(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    uint64_t fraction = bits & (((uint64_t)1 << 52) - 1);
    int field = (int)(bits >> 52 & 2047);
    if (!field)
        return (binary){fraction, -1074, false};
    return (binary){fraction | (uint64_t)1 << 52, field - 1075, !fraction && field > 1};
}

/* The whole part of f * 10^k * 2^e, which is below 2^64; `exact`: that is all of it. */
static uint64_t scale_slow(uint64_t f, int k, int e, bool *exact)
{
    big_integer a, b;
    plb_big_set(&a, f);
    plb_big_set(&b, 1);
    plb_big_multiply_fives(k < 0 ? &b : &a, k < 0 ? -k : k);
    plb_big_shift(k + e < 0 ? &b : &a, k + e < 0 ? -(k + e) : k + e);
    return plb_big_divide(&a, &b, exact);
}

static uint64_t scale(uint64_t f, int k, int e, bool *exact)
{
    int down = -(k + e);
    if (k < 0 || k > MAX_POWER_128 || down < 0 || down >= 192)
        return scale_slow(f, k, e, exact);
    /* f times five to the power of k, 192 bits in two parts that overlap, then without its last `down` bits. */
    uint128 five = wide_power_of_five(k), low = (uint128)f * (uint64_t)five, high = (uint128)f * (uint64_t)(five >> 64) + (uint64_t)(low >> 64);
    uint64_t last = (uint64_t)low;
    if (down >= 64) {
        int rest = down - 64;
        uint128 whole = high >> rest;
        *exact = !last && (whole << rest) == high;
        return (uint64_t)whole;
    }
    *exact = !(last & (((uint64_t)1 << down) - 1));
    return (uint64_t)(down ? high << (64 - down) | last >> down : (uint128)last);
}

static uint64_t power_of_ten(int k) { return power_of_five(k) << k; }

/* The most zeros that a whole number from `low` to `high` ends with. */
static int find_zeros(uint64_t low, uint64_t high)
{
    int zeros = 0;
    const uint64_t many = 100000000; /* most drawings' numbers have few digits */
    if (high / many > (low - 1) / many) {
        zeros = 8;
        high /= many;
        low = (low - 1) / many + 1;
    }
    for (; high / 10 > (low - 1) / 10; zeros++) {
        high /= 10;
        low = (low - 1) / 10 + 1;
    }
    return zeros;
}

/* The digits of the shortest number, as a whole number whose last digit counts 10^*exponent. */
static uint64_t shortest(binary v, int *exponent)
{
    /* The power of ten that brings 17 or 18 digits before the point: 78913 / 2^18 is the logarithm of 2. */
    int bits = 64 - __builtin_clzll(v.m), k = 16 - (((v.e + bits - 1) * 78913) >> 18);
    /* The ends of the interval, in eighths of the double's last bit; they belong to it if m is even. */
    bool at_high, at_low, at_twice, ends = !(v.m & 1);
    uint64_t high = scale(8 * v.m + 4, k, v.e - 3, &at_high), low = scale(8 * v.m - (v.is_lowest ? 2 : 4), k, v.e - 3, &at_low);
    uint64_t twice = scale(8 * v.m, k, v.e - 2, &at_twice);
    high -= at_high && !ends;
    low += !at_low || !ends;
    /* Takes the number with so many zeros that is nearest to the double itself, of which `twice` and a rest are the double. */
    int zeros = find_zeros(low, high);
    uint64_t unit = power_of_ten(zeros), digits = zeros ? twice / (2 * unit) : twice / 2, rest = twice - 2 * digits * unit;
    digits += rest > unit || (rest == unit && (!at_twice || (digits & 1)));
    if (digits * unit > high)
        digits--;
    if (digits * unit < low)
        digits++;
    *exponent = zeros - k;
    return digits;
}

/* Most coordinates in drawings have a few decimals, those that cairo has printed six: value = digits / 10^6 to the last bit.
 * Of the texts with at most 15 digits no two are the same double, so no shorter one is. */
static bool find_short(double value, uint64_t *digits, int *exponent)
{
    enum { DECIMALS = 6 };
    const double unit = 1e6, most = 1e9;
    if (!(value < most))
        return false;
    uint64_t n = (uint64_t)(value * unit + 0.5);
    if (!n || (double)n / unit != value)
        return false;
    *exponent = -DECIMALS;
    for (; n % 10 == 0; n /= 10)
        ++*exponent;
    *digits = n;
    return true;
}

/* ---- text ---------------------------------------------------------------------------------------------------- */

/* The digits of n before `end`, the last two first; gives where they start. */
static char *put_digits(char *end, uint64_t n)
{
    static const char pairs[] = "00010203040506070809101112131415161718192021222324252627282930313233343536373839404142434445464748495"
                                "0515253545556575859606162636465666768697071727374757677787980818283848586878889909192939495969798"
                                "99";
    for (; n >= 100; n /= 100)
        memcpy(end -= 2, pairs + n % 100 * 2, 2);
    if (n >= 10)
        memcpy(end -= 2, pairs + n * 2, 2);
    else
        *--end = (char)('0' + n);
    return end;
}

/* 123.45, or 0.0012345 */
static char *put_plain(char *out, const char *digits, int n, int point)
{
    if (point <= 0) {
        *out++ = '0', *out++ = '.';
        for (; point < 0; point++)
            *out++ = '0';
        memcpy(out, digits, (size_t)n);
        return out + n;
    }
    int whole = n < point ? n : point;
    memcpy(out, digits, (size_t)whole);
    memset(out + whole, '0', (size_t)(point - whole));
    out += point;
    if (n <= point)
        return out;
    *out++ = '.';
    memcpy(out, digits + whole, (size_t)(n - whole));
    return out + (n - whole);
}

/* 1.2345e-17 */
static char *put_scientific(char *out, const char *digits, int n, int point)
{
    char text[8], *first;
    int exponent = point - 1;
    *out++ = digits[0];
    if (n > 1)
        *out++ = '.';
    memcpy(out, digits + 1, (size_t)n - 1);
    out += n - 1;
    *out++ = 'e';
    if (exponent < 0)
        *out++ = '-';
    first = put_digits(text + sizeof text, (uint64_t)(exponent < 0 ? -exponent : exponent));
    size_t length = (size_t)(text + sizeof text - first);
    memcpy(out, first, length);
    return out + length;
}

size_t plb_write_number(char out[NUMBER_TEXT_MAX], double value)
{
    /* Where a number is written in plain digits, as JavaScript does: from 0.000001 on, below 10^21. */
    enum { FIRST_POINT = -5, LAST_POINT = 21 };
    char buffer[24], *end = buffer + sizeof buffer, *at = out;
    binary v = take_apart(value);
    uint64_t sign;
    memcpy(&sign, &value, sizeof sign);
    if (sign >> 63)
        *at++ = '-';
    if (!v.m) {
        *at++ = '0';
    } else {
        int exponent;
        uint64_t digits;
        if (!find_short(value < 0 ? -value : value, &digits, &exponent))
            digits = shortest(v, &exponent);
        char *first = put_digits(end, digits);
        int n = (int)(end - first), point = n + exponent;
        at = (point >= FIRST_POINT && point <= LAST_POINT ? put_plain : put_scientific)(at, first, n, point);
    }
    *at = '\0';
    return (size_t)(at - out);
}
