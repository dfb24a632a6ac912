/* SPDX-License-Identifier: MIT
 *
 * Decimal text to the nearest double, ties to even. What the text says is digits times a power of ten; three ways lead from
 * there to the double, all exact: two doubles that hold both without error (Clinger 1990), whole numbers of 64 to 192 bits,
 * and whole numbers of any size.
 */
#include "base/number/number.h"

#include "base/number/big_integer.h"
#include "base/number/powers.h"

#include <math.h>
#include <string.h>

/* So many digits are kept in a whole number of 64 bits. */
#define MAX_DIGITS 19
/* No two neighbouring doubles have a midpoint with more digits than 767; what follows only tells "more than that". */
#define MAX_EXACT_DIGITS 800

/* A decimal holds what the text says: digits * 10^exponent, and something less than one more of the last digit if `cut`. */
typedef struct {
    bool minus, cut;
    uint64_t digits;
    int64_t exponent, count; /* of all digits from the first on that is not 0 */
    const char *first, *end; /* where they stand, a point among them */
} decimal;

static bool is_digit(const char *p, const char *end)
{
    return p < end && (unsigned char)(*p - '0') < 10;
}

/* The exponent part, if a whole one is there; leaves `*p` alone otherwise. */
static int parse_exponent(const char **p, const char *end)
{
    const char *q = *p;
    if (q >= end || (*q != 'e' && *q != 'E'))
        return 0;
    q++;
    bool minus = q < end && *q == '-';
    if (q < end && (*q == '-' || *q == '+'))
        q++;
    if (!is_digit(q, end))
        return 0;
    int e = 0;
    for (; is_digit(q, end); q++)
        if (e < 100000000)
            e = e * 10 + (*q - '0');
    *p = q;
    return minus ? -e : e;
}

/* Takes the digits from `p` on; gives the first byte that is none. */
static const char *take_digits(decimal *d, const char *p, const char *end)
{
    if (!d->digits)
        while (p < end && *p == '0')
            p++;
    if (is_digit(p, end) && !d->first)
        d->first = p;
    uint64_t digits = d->digits;
    int64_t count = d->count;
    for (; count < MAX_DIGITS && is_digit(p, end); p++, count++)
        digits = digits * 10 + (uint64_t)(*p - '0');
    for (; is_digit(p, end); p++, count++)
        d->cut = d->cut || *p != '0';
    d->digits = digits;
    d->count = count;
    return p;
}

/* False: there is no number. */
static bool take_decimal(decimal *d, const char *text, const char *end, const char **next)
{
    const char *p = text;
    d->minus = p < end && *p == '-';
    if (p < end && (*p == '-' || *p == '+'))
        p++;
    const char *whole = p;
    p = take_digits(d, p, end);
    bool any = p > whole;
    if (p < end && *p == '.') {
        const char *fraction = p + 1;
        p = take_digits(d, fraction, end);
        d->exponent = fraction - p;
        any = any || p > fraction;
    }
    if (!any)
        return false;
    d->end = p;
    if (d->count > MAX_DIGITS)
        d->exponent += d->count - MAX_DIGITS;
    d->exponent += parse_exponent(&p, end);
    *next = p;
    return true;
}

/* The double nearest to q * 2^e, q not 0; `more`: the value is above q, but below q + 1, and q is at least 2^62. */
static double nearest_double(uint64_t q, bool more, int64_t e)
{
    int zeros = __builtin_clzll(q);
    q <<= zeros;
    e += 63 - zeros; /* now 2^e <= value < 2^(e + 1) */
    if (e > 1023)
        return (double)INFINITY;
    int64_t drop = e >= -1022 ? 11 : 11 - 1022 - e; /* bits that do not fit; below 2^-1022 the doubles keep one distance */
    if (drop > 64)
        return 0;
    uint64_t kept = drop == 64 ? 0 : q >> drop, rest = drop == 64 ? q : q & (((uint64_t)1 << drop) - 1), half = (uint64_t)1 << (drop - 1);
    kept += rest > half || (rest == half && (more || (kept & 1)));
    /* The first bit kept of a normal number is added to its exponent, and so is a carry. */
    uint64_t bits = kept + (e >= -1022 ? (uint64_t)(e + 1022) << 52 : 0);
    double v;
    memcpy(&v, &bits, sizeof v);
    return v;
}

/* digits * 10^power, 0 <= power <= MAX_POWER_64. */
static double multiply(uint64_t digits, int power)
{
    uint128 product = (uint128)digits * power_of_five(power);
    uint64_t high = (uint64_t)(product >> 64), low = (uint64_t)product;
    if (!high)
        return nearest_double(low, false, power);
    int zeros = __builtin_clzll(high);
    product <<= zeros;
    return nearest_double((uint64_t)(product >> 64), (uint64_t)product != 0, power + 64 - zeros);
}

/* digits / 10^power, 0 < power <= MAX_POWER_64: the quotient of two numbers whose highest bits are set has 63 or 64 bits. */
static double divide(uint64_t digits, int power)
{
    uint64_t five = power_of_five(power);
    int up = __builtin_clzll(digits), down = __builtin_clzll(five);
    uint128 dividend = (uint128)(digits << up) << 63;
    uint64_t divisor = five << down, quotient = (uint64_t)(dividend / divisor);
    return nearest_double(quotient, (uint64_t)dividend != quotient * divisor, -power - 63 + down - up);
}

/* words / divisor, the highest word first; gives the rest. */
static uint64_t divide_words(uint64_t words[3], uint64_t divisor)
{
    uint64_t rest = 0;
    for (int i = 0; i < 3; i++) {
        uint128 part = (uint128)rest << 64 | words[i];
        words[i] = (uint64_t)(part / divisor);
        rest = (uint64_t)(part - (uint128)words[i] * divisor);
    }
    return rest;
}

/* digits / 10^power, MAX_POWER_64 < power <= 2 * MAX_POWER_64: divided in two steps, of which each may leave a rest. Of the
 * 192 bits of digits * 2^128 the quotient keeps 65 to 127. */
static double divide_twice(uint64_t digits, int power)
{
    int up = __builtin_clzll(digits);
    uint64_t words[3] = {digits << up, 0, 0};
    bool more = divide_words(words, power_of_five(MAX_POWER_64)) != 0;
    more = divide_words(words, power_of_five(power - MAX_POWER_64)) != 0 || more;
    int zeros = __builtin_clzll(words[1]);
    uint128 top = ((uint128)words[1] << 64 | words[2]) << zeros;
    return nearest_double((uint64_t)(top >> 64), more || (uint64_t)top, -power - up - zeros - 64);
}

/* True if 64 to 192 bits are enough. */
static bool parse_fast(uint64_t digits, int64_t exponent, double *v)
{
    static const double tens[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    if (digits <= (uint64_t)1 << 53 && exponent >= -22 && exponent <= 22)
        *v = exponent < 0 ? (double)digits / tens[-exponent] : (double)digits * tens[exponent];
    else if (exponent >= 0 && exponent <= MAX_POWER_64)
        *v = multiply(digits, (int)exponent);
    else if (exponent < 0 && exponent >= -MAX_POWER_64)
        *v = divide(digits, (int)-exponent);
    else if (exponent < 0 && exponent >= -2 * MAX_POWER_64)
        *v = divide_twice(digits, (int)-exponent);
    else
        return false;
    return true;
}

/* The digits of the text as one whole number; gives how many there are. Beyond the midpoints it only matters whether
 * there is more. */
static int64_t take_all_digits(const decimal *d, big_integer *all)
{
    plb_big_set(all, 0);
    int64_t n = 0;
    bool more = false;
    for (const char *p = d->first; p < d->end; p++)
        if (*p != '.' && n < MAX_EXACT_DIGITS) {
            plb_big_multiply(all, 10, (uint32_t)(*p - '0'));
            n++;
        } else if (*p != '.' && *p != '0') {
            more = true;
        }
    if (more)
        plb_big_multiply(all, 10, 1);
    return n + more;
}

/* The exact way: the quotient of two large whole numbers, shifted until it has 63 or 64 bits. */
static double parse_slow(const decimal *d)
{
    big_integer a, b;
    int64_t magnitude = d->exponent + (d->count < MAX_DIGITS ? d->count : MAX_DIGITS); /* value < 10^magnitude */
    if (magnitude < -325)
        return 0;
    if (magnitude > 310)
        return (double)INFINITY;
    int64_t exponent = magnitude - take_all_digits(d, &a);
    plb_big_set(&b, 1);
    plb_big_multiply_fives(exponent < 0 ? &b : &a, (int)(exponent < 0 ? -exponent : exponent));
    int shift = 63 - plb_big_bits(&a) + plb_big_bits(&b);
    plb_big_shift(shift >= 0 ? &a : &b, shift >= 0 ? shift : -shift);
    bool exact;
    uint64_t quotient = plb_big_divide(&a, &b, &exact);
    return nearest_double(quotient, !exact, exponent - shift);
}

static double to_double(const decimal *d)
{
    double v, next;
    if (!d->digits)
        return 0;
    if (!parse_fast(d->digits, d->exponent, &v))
        return parse_slow(d);
    /* With digits left out the value lies between two numbers: mostly both have the same double. */
    if (d->cut && !(parse_fast(d->digits + 1, d->exponent, &next) && v == next))
        return parse_slow(d);
    return v;
}

bool plb_parse_number(const char *text, const char *end, double *value, const char **next)
{
    decimal d = {0};
    const char *after;
    if (!take_decimal(&d, text, end, &after))
        return false;
    double v = to_double(&d);
    *value = d.minus ? -v : v;
    if (next)
        *next = after;
    return true;
}
