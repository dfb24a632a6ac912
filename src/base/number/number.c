/* SPDX-License-Identifier: MIT */
#include "base/number/number.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static double power_of_ten(int e)
{
    double r = 1, b = 10;
    for (int n = e < 0 ? -e : e; n; n >>= 1, b *= b)
        if (n & 1)
            r *= b;
    return r;
}

static bool is_digit(const char *p, const char *end)
{
    return p < end && *p >= '0' && *p <= '9';
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
        if (e < 10000)
            e = e * 10 + (*q - '0');
    *p = q;
    return minus ? -e : e;
}

bool plb_parse_number(const char *text, const char *end, double *value, const char **next)
{
    const char *p = text;
    bool minus = p < end && *p == '-', any = false;
    if (p < end && (*p == '-' || *p == '+'))
        p++;
    uint64_t digits = 0;
    int shift = 0;
    for (; is_digit(p, end); p++, any = true) {
        if (digits < 100000000000000000u)
            digits = digits * 10 + (uint64_t)(*p - '0');
        else
            shift++;
    }
    if (p < end && *p == '.')
        for (p++; is_digit(p, end); p++, any = true)
            if (digits < 100000000000000000u) {
                digits = digits * 10 + (uint64_t)(*p - '0');
                shift--;
            }
    if (!any)
        return false;
    shift += parse_exponent(&p, end);
    double v = (double)digits;
    if (shift < -300) /* in two steps, so that small numbers do not meet an infinite power */
        v = v / power_of_ten(300) / power_of_ten(shift < -600 ? 300 : -shift - 300);
    else if (shift < 0)
        v /= power_of_ten(-shift);
    else if (digits)
        v *= power_of_ten(shift > 400 ? 400 : shift);
    *value = minus ? -v : v;
    if (next)
        *next = p;
    return true;
}

char *plb_format_number(char out[48], double value, int decimals)
{
    if (isnan(value) || fabs(value) > 1e15)
        return strcpy(out, isnan(value) ? "nan" : value < 0 ? "-inf" : "inf");
    double scale = power_of_ten(decimals), whole = floor(fabs(value));
    uint64_t fraction = (uint64_t)floor((fabs(value) - whole) * scale + 0.5);
    if ((double)fraction >= scale) {
        whole += 1;
        fraction = 0;
    }
    bool minus = value < 0 && (whole > 0 || fraction > 0);
    int n = snprintf(out, 48, "%s%llu", minus ? "-" : "", (unsigned long long)whole);
    if (fraction) {
        n += snprintf(out + n, 48 - (size_t)n, ".%0*llu", decimals, (unsigned long long)fraction);
        while (out[n - 1] == '0')
            out[--n] = '\0';
    }
    return out;
}
