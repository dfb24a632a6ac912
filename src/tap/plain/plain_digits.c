/* SPDX-License-Identifier: MIT */
#include "tap/plain/plain_digits.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static char *strip_zeros(char *start)
{
    char *end = start + strlen(start);
    while (end[-1] == '0')
        end--;
    return end[-1] == '.' ? end - 1 : end;
}

char *plb_plain_put_double(char *at, double v)
{
    int places = 6;
    if (v == 0)
        v = 0; /* not -0 */
    if (fabs(v) < 0.1) {
        snprintf(at, PLAIN_DIGITS_MAX, "%.18f", fabs(v));
        places += (int)strspn(at + 2, "0");
    }
    snprintf(at, PLAIN_DIGITS_MAX, "%.*f", places < 18 ? places : 18, v);
    return strip_zeros(at);
}

/* Of `v`, which has one digit before the point. */
static plain_fraction fraction_of(double v)
{
    char text[PLAIN_DIGITS_MAX];
    plain_fraction f = {.length = (unsigned char)(plb_plain_put_double(text, v) - text - 1)};
    memcpy(f.text, text + 1, f.length);
    return f;
}

void plb_plain_digits(plain_digits *d)
{
    for (int i = 0; i < 256; i++)
        d->part[i] = fraction_of(1 + i / PLAIN_STEPS);
    for (int i = 0; i <= PLAIN_SMALL; i++)
        d->small[i] = fraction_of(i / PLAIN_STEPS);
}

static char *put_whole(char *at, uint32_t v)
{
    char digits[12], *end = digits + sizeof digits, *d = end;
    do
        *--d = (char)('0' + v % 10);
    while (v /= 10);
    memcpy(at, d, (size_t)(end - d));
    return at + (end - d);
}

char *plb_plain_put_fixed(char *at, const plain_digits *d, int32_t v)
{
    uint32_t size = v < 0 ? -(uint32_t)v : (uint32_t)v;
    const plain_fraction *f = size <= PLAIN_SMALL ? &d->small[size] : &d->part[size & 255];
    if (v < 0)
        *at++ = '-';
    at = put_whole(at, size >> 8);
    memcpy(at, f->text, sizeof f->text);
    return at + f->length;
}
