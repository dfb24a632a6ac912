/* SPDX-License-Identifier: MIT */
#include "tap/plain/plain_text.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- words -------------------------------------------------------------------------------------------------- */

bool plb_plain_is(plain_text t, const char *word)
{
    size_t n = strlen(word);
    return (size_t)(t.end - t.at) == n && !memcmp(t.at, word, n);
}

bool plb_plain_is_any(plain_text t, const char *const words[])
{
    while (*words && !plb_plain_is(t, *words))
        words++;
    return *words != NULL;
}

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
static bool is_digit(char c) { return (unsigned char)(c - '0') < 10; }

plain_text plb_plain_trim(plain_text t)
{
    while (t.at < t.end && is_blank(*t.at))
        t.at++;
    while (t.at < t.end && is_blank(t.end[-1]))
        t.end--;
    return t;
}

bool plb_plain_blank(plain_text *t)
{
    const char *start = t->at;
    while (t->at < t->end && is_blank(*t->at))
        t->at++;
    return t->at > start;
}

void plb_plain_comma(plain_text *t)
{
    plb_plain_blank(t);
    if (t->at < t->end && *t->at == ',')
        t->at++;
    plb_plain_blank(t);
}

/* ---- numbers ------------------------------------------------------------------------------------------------ */

/* The parts of a number lie here: sign, whole, point, fraction, exponent. */
typedef struct {
    const char *start, *whole, *fraction, *exponent, *end; /* fraction: NULL without a point; exponent: after e and sign */
    bool minus, exponent_minus;
} number_parts;

static const char *skip_digits(const char *at, const char *end)
{
    while (at < end && is_digit(*at))
        at++;
    return at;
}

/* Finds the exponent of `p`, whose end is known so far; an `e` without digits behind is none. */
static void split_exponent(number_parts *p, const char *end)
{
    const char *at = p->end;
    if (at == end || (*at | 32) != 'e')
        return;
    at++;
    bool minus = at < end && *at == '-';
    if (at < end && (*at == '-' || *at == '+'))
        at++;
    const char *past = skip_digits(at, end);
    if (past == at)
        return;
    p->exponent = at;
    p->exponent_minus = minus;
    p->end = past;
}

static bool split_number(plain_text t, number_parts *p)
{
    *p = (number_parts){.start = t.at, .minus = t.at < t.end && *t.at == '-'};
    p->whole = t.at + (t.at < t.end && (*t.at == '-' || *t.at == '+'));
    const char *at = skip_digits(p->whole, t.end);
    p->end = at;
    if (at < t.end && *at == '.') {
        p->fraction = at + 1;
        p->end = skip_digits(p->fraction, t.end);
    }
    bool ok = at > p->whole || (p->fraction && p->end > p->fraction);
    split_exponent(p, t.end);
    return ok;
}

static const double tens[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                              1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/* Converts by the C library, which rounds exactly; the tap stays in the C locale. */
static bool slow_number(const number_parts *p, double *v)
{
    char copy[400];
    size_t n = (size_t)(p->end - p->start);
    if (n >= sizeof copy)
        return false;
    memcpy(copy, p->start, n);
    copy[n] = '\0';
    *v = strtod(copy, NULL);
    return isfinite(*v);
}

/* Converts digits and powers of ten that a double holds exactly: one step gives the nearest double (Clinger 1990). */
bool plb_plain_number(plain_text *t, double *v)
{
    number_parts p;
    if (!split_number(*t, &p))
        return false;
    t->at = p.end;
    const char *whole_end = p.fraction ? p.fraction - 1 : p.end;
    if (p.exponent || p.end - p.whole > 16)
        return slow_number(&p, v);
    uint64_t digits = 0;
    for (const char *d = p.whole; d < whole_end; d++)
        digits = digits * 10 + (uint64_t)(*d - '0');
    for (const char *d = p.fraction; d && d < p.end; d++)
        digits = digits * 10 + (uint64_t)(*d - '0');
    if (digits > (uint64_t)1 << 53)
        return slow_number(&p, v);
    double value = (double)digits / tens[p.fraction ? p.end - p.fraction : 0];
    *v = p.minus ? -value : value;
    return true;
}

/* Converts digit by digit and to single precision, like the cssparser library of librsvg: its errors are ours. */
bool plb_plain_css_number(plain_text *t, double *v)
{
    number_parts p;
    if (!split_number(*t, &p))
        return false;
    double whole = 0, fraction = 0, factor = 0.1;
    const char *d = p.whole;
    for (; d < p.end && is_digit(*d); d++)
        whole = whole * 10 + (*d - '0');
    for (d = p.fraction; d && d < p.end && is_digit(*d); d++, factor *= 0.1)
        fraction += (*d - '0') * factor;
    if (p.fraction && d == p.fraction)
        return false;
    double value = (p.minus ? -1.0 : 1.0) * (whole + fraction);
    if (p.exponent) {
        double power = 0;
        for (d = p.exponent; d < p.end; d++)
            power = power * 10 + (*d - '0');
        value *= pow(10, p.exponent_minus ? -power : power);
    }
    *v = (double)(float)value;
    t->at = p.end;
    return isfinite(*v);
}

/* ---- lengths ------------------------------------------------------------------------------------------------ */

static const struct {
    const char *name;
    plain_unit unit;
} units[] = {{"", PLAIN_PX},   {"px", PLAIN_PX}, {"mm", PLAIN_MM}, {"cm", PLAIN_CM},
             {"in", PLAIN_IN}, {"pt", PLAIN_PT}, {"pc", PLAIN_PC}, {"%", PLAIN_SHARE}};

bool plb_plain_dimension(plain_text *t, double *v, plain_unit *unit)
{
    if (!plb_plain_css_number(t, v))
        return false;
    plain_text name = {t->at, t->at};
    while (name.end < t->end && !is_blank(*name.end) && *name.end != ',')
        name.end++;
    t->at = name.end;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (plb_plain_is(name, units[i].name)) {
            *unit = units[i].unit;
            return true;
        }
    return false;
}

bool plb_plain_next_length(plain_text *t, double *px)
{
    static const double per_inch[] = {[PLAIN_MM] = 25.4, [PLAIN_CM] = 2.54, [PLAIN_IN] = 1, [PLAIN_PT] = 72, [PLAIN_PC] = 6};
    plain_unit unit;
    if (!plb_plain_dimension(t, px, &unit) || unit == PLAIN_SHARE)
        return false;
    if (unit != PLAIN_PX)
        *px = *px * 96 / per_inch[unit];
    return true;
}

bool plb_plain_length(plain_text t, double *px)
{
    t = plb_plain_trim(t);
    return plb_plain_next_length(&t, px) && t.at == t.end;
}
