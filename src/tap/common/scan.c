/* SPDX-License-Identifier: MIT
 *
 * Bytes to tokens, for PostScript and CairoScript (PostScript Language Reference, 3rd edition, section 3.2).
 * Most of what is scanned is plain decimal numbers and short names that lie whole in the bytes at hand: those
 * take a fast path and are not copied. Everything else goes through `buffer`.
 */
#include "tap/common/scan.h"

#include "base/number/number.h"

#include <stdint.h>
#include <string.h>

/* Classes of bytes (tables 3.1 and 3.2); all that are not named are regular. */
enum { REGULAR, NUMERIC, BLANK, SPECIAL };

static const uint8_t class_of[256] = {
    ['\0'] = BLANK, [4] = BLANK /* ^D, the end of a job on a serial line */, ['\t'] = BLANK, ['\n'] = BLANK,
    ['\f'] = BLANK, ['\r'] = BLANK, [' '] = BLANK,
    ['('] = SPECIAL, [')'] = SPECIAL, ['<'] = SPECIAL, ['>'] = SPECIAL, ['['] = SPECIAL, [']'] = SPECIAL,
    ['{'] = SPECIAL, ['}'] = SPECIAL, ['/'] = SPECIAL, ['%'] = SPECIAL,
    ['0'] = NUMERIC, ['1'] = NUMERIC, ['2'] = NUMERIC, ['3'] = NUMERIC, ['4'] = NUMERIC, ['5'] = NUMERIC,
    ['6'] = NUMERIC, ['7'] = NUMERIC, ['8'] = NUMERIC, ['9'] = NUMERIC, ['+'] = NUMERIC, ['-'] = NUMERIC,
    ['.'] = NUMERIC,
};

static unsigned class_at(const char *p)
{
    return class_of[(unsigned char)*p];
}

static bool is_regular(const char *p)
{
    return class_at(p) <= NUMERIC;
}

void plb_scan_init(scanner *s, const char *data, size_t size)
{
    *s = (scanner){.at = data, .end = data + size, .line = 1, .next_line = 1};
}

void plb_scan_free(scanner *s)
{
    array_free(&s->buffer);
}

/* ---- bytes ------------------------------------------------------------------------------------------------ */

static bool refill(scanner *s)
{
    while (s->refill) {
        const char *data = NULL;
        size_t size = 0;
        if (!s->refill(s->closure, &data, &size)) {
            s->refill = NULL;
            return false;
        }
        s->at = data;
        s->end = data + size;
        if (size)
            return true;
    }
    return false;
}

/* Tells whether there is a byte at s->at. */
static inline bool have(scanner *s)
{
    return s->at < s->end || refill(s);
}

/* Steps over one byte and counts lines; CR LF is one line end. */
static void step(scanner *s)
{
    char c = *s->at++;
    if (c == '\n') {
        s->next_line++;
    } else if (c == '\r') {
        s->next_line++;
        if (have(s) && *s->at == '\n')
            s->at++;
    }
}

static void skip_comment(scanner *s)
{
    while (have(s) && *s->at != '\n' && *s->at != '\r')
        s->at++;
}

/* Skips blanks and comments; false at the end of the input. */
static bool skip_blank(scanner *s)
{
    while (have(s)) {
        if (class_at(s->at) == BLANK)
            step(s);
        else if (*s->at == '%')
            skip_comment(s);
        else
            return true;
    }
    return false;
}

/* Steps over the blank that ends a name or number and belongs to it: data read by the program start behind the blank.
 * The token's text may lie in the bytes at hand, so they are not refilled here. */
static void eat_blank(scanner *s)
{
    if (s->at >= s->end || class_at(s->at) != BLANK)
        return;
    if (*s->at == '\r' && s->refill && s->at + 1 == s->end)
        return;
    step(s);
}

static bool too_long(error *err)
{
    return plb_fail(err, ERROR_LIMIT, "a name or string is longer than %zu bytes", SCAN_MAX_TOKEN);
}

static bool keep(scanner *s, char c, error *err)
{
    if (s->buffer.n >= SCAN_MAX_TOKEN)
        return too_long(err);
    return array_push(&s->buffer, c) || plb_fail_memory(err);
}

static bool keep_run(scanner *s, const char *from, const char *to, error *err)
{
    size_t n = (size_t)(to - from);
    if (n > SCAN_MAX_TOKEN - s->buffer.n)
        return too_long(err);
    if (!array_reserve(&s->buffer, n))
        return plb_fail_memory(err);
    if (n)
        memcpy(s->buffer.v + s->buffer.n, from, n);
    s->buffer.n += n;
    return true;
}

static bool token_of_buffer(scanner *s, token *t, token_kind kind)
{
    t->kind = kind;
    t->text = s->buffer.n ? s->buffer.v : "";
    t->length = s->buffer.n;
    return true;
}

/* ---- numbers and names ------------------------------------------------------------------------------------ */

static const double tens[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8, 1e9,
                              1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18};

/* Reads a decimal without exponent, of at most 17 digits, that ends within the bytes at hand; false: something else
 * stands there. The value is that of plb_parse_number: the powers of ten of both are exact up to 1e22. */
static bool fast_number(scanner *s, token *t)
{
    const char *p = s->at, *end = s->end;
    bool minus = *p == '-';
    if (minus || *p == '+')
        p++;
    const char *start = p;
    uint64_t digits = 0;
    for (; p < end && (unsigned)(*p - '0') < 10; p++)
        digits = digits * 10 + (uint64_t)(*p - '0');
    size_t whole = (size_t)(p - start), fraction = 0;
    bool dot = p < end && *p == '.';
    if (dot) {
        const char *first = ++p;
        for (; p < end && (unsigned)(*p - '0') < 10; p++)
            digits = digits * 10 + (uint64_t)(*p - '0');
        fraction = (size_t)(p - first);
    }
    if (p >= end || is_regular(p) || whole + fraction == 0 || whole + fraction > 17 || digits > (uint64_t)1 << 53)
        return false;
    double v = (double)digits;
    if (fraction)
        v /= tens[fraction];
    t->kind = TOKEN_NUMBER;
    t->number = minus ? -v : v;
    t->integer = !dot;
    s->at = p;
    return true;
}

/* Gives the end of the regular bytes from s->at on. */
static bool take_regular(scanner *s, token *t, error *err)
{
    const char *p = s->at;
    while (p < s->end && is_regular(p))
        p++;
    if (p < s->end || !s->refill) {
        t->text = s->at;
        t->length = (size_t)(p - s->at);
        s->at = p;
        return t->length <= SCAN_MAX_TOKEN || too_long(err);
    }
    s->buffer.n = 0;
    if (!keep_run(s, s->at, p, err))
        return false;
    s->at = p;
    while (have(s) && is_regular(s->at)) {
        for (p = s->at; p < s->end && is_regular(p);)
            p++;
        if (!keep_run(s, s->at, p, err))
            return false;
        s->at = p;
    }
    return token_of_buffer(s, t, t->kind);
}

static unsigned digit_value(char c)
{
    if (c >= '0' && c <= '9')
        return (unsigned)(c - '0');
    if (c >= 'a' && c <= 'z')
        return (unsigned)(c - 'a') + 10;
    if (c >= 'A' && c <= 'Z')
        return (unsigned)(c - 'A') + 10;
    return 99;
}

/* Reads base#digits: an unsigned number whose 32 bits are taken as a signed integer. */
static bool radix_number(const char *text, size_t length, double *value)
{
    const char *hash = memchr(text, '#', length < 3 ? length : 3), *end = text + length;
    if (!hash || hash == text || hash + 1 == end)
        return false;
    unsigned base = 0;
    for (const char *p = text; p < hash; p++) {
        if (*p < '0' || *p > '9')
            return false;
        base = base * 10 + (unsigned)(*p - '0');
    }
    if (base < 2 || base > 36)
        return false;
    uint64_t v = 0;
    for (const char *p = hash + 1; p < end; p++) {
        if (digit_value(*p) >= base)
            return false;
        v = v * base + digit_value(*p);
        if (v > UINT32_MAX)
            return false;
    }
    *value = v > INT32_MAX ? (double)v - 4294967296.0 : (double)v;
    return true;
}

/* Tells whether the word is a number. All other words are names, whatever they start with. */
static void classify(token *t)
{
    const char *next = NULL, *end = t->text + t->length;
    t->kind = TOKEN_NAME;
    if (!t->length || class_at(t->text) != NUMERIC)
        return;
    if (plb_parse_number(t->text, end, &t->number, &next) && next == end) {
        t->kind = TOKEN_NUMBER;
        t->integer = !memchr(t->text, '.', t->length) && !memchr(t->text, 'e', t->length) && !memchr(t->text, 'E', t->length);
    } else if (radix_number(t->text, t->length, &t->number)) {
        t->kind = TOKEN_NUMBER;
        t->integer = true;
    }
}

static bool scan_word(scanner *s, token *t, error *err)
{
    if (class_at(s->at) != NUMERIC || !fast_number(s, t)) {
        if (!take_regular(s, t, err))
            return false;
        classify(t);
    }
    eat_blank(s);
    return true;
}

static bool scan_slash(scanner *s, token *t, error *err)
{
    s->at++;
    t->kind = TOKEN_LITERAL;
    if (have(s) && *s->at == '/') {
        s->at++;
        t->kind = TOKEN_IMMEDIATE;
    }
    t->text = "";
    if (have(s) && is_regular(s->at) && !take_regular(s, t, err))
        return false;
    eat_blank(s);
    return true;
}

/* ---- strings ---------------------------------------------------------------------------------------------- */

/* Reads a string without escapes or CR that lies whole in the bytes at hand; false: something else stands there. */
static bool fast_string(scanner *s, token *t)
{
    int depth = 1, lines = 0;
    for (const char *p = s->at; p < s->end && *p != '\\' && *p != '\r'; p++) {
        lines += *p == '\n';
        depth += (*p == '(') - (*p == ')');
        if (depth)
            continue;
        if ((size_t)(p - s->at) > SCAN_MAX_TOKEN)
            return false;
        t->kind = TOKEN_STRING;
        t->text = s->at;
        t->length = (size_t)(p - s->at);
        s->at = p + 1;
        s->next_line += lines;
        return true;
    }
    return false;
}

/* Reads what follows a backslash: a letter of the table, one to three octal digits, a line end (nothing), itself. */
static bool scan_escape(scanner *s, error *err)
{
    static const char letters[] = "nrtbf", means[] = "\n\r\t\b\f";
    if (!have(s))
        return true;
    char c = *s->at;
    if (c >= '0' && c <= '7') {
        unsigned v = 0;
        for (int i = 0; i < 3 && have(s) && *s->at >= '0' && *s->at <= '7'; i++)
            v = v * 8 + (unsigned)(*s->at++ - '0');
        return keep(s, (char)(v & 255), err);
    }
    step(s);
    if (c == '\n' || c == '\r')
        return true;
    const char *found = c ? strchr(letters, c) : NULL;
    return keep(s, found ? means[found - letters] : c, err);
}

static bool scan_string(scanner *s, token *t, error *err)
{
    s->at++;
    if (fast_string(s, t))
        return true;
    s->buffer.n = 0;
    for (int depth = 1; have(s);) {
        char c = *s->at;
        step(s);
        depth += (c == '(') - (c == ')');
        if (!depth)
            return token_of_buffer(s, t, TOKEN_STRING);
        if (c == '\\' ? !scan_escape(s, err) : !keep(s, c == '\r' ? '\n' : c, err))
            return false;
    }
    return plb_fail(err, ERROR_SYNTAX, "the string that starts here never ends");
}

static bool scan_hex(scanner *s, token *t, error *err)
{
    unsigned high = 0;
    bool odd = false;
    for (s->buffer.n = 0; have(s);) {
        char c = *s->at;
        step(s);
        if (c == '>') {
            if (odd && !keep(s, (char)(high << 4), err))
                return false;
            return token_of_buffer(s, t, TOKEN_STRING);
        }
        if (class_at(&c) == BLANK)
            continue;
        unsigned v = digit_value(c);
        if (v > 15)
            return plb_fail(err, ERROR_SYNTAX, "a hexadecimal string holds a byte that is no digit");
        if (odd && !keep(s, (char)(high << 4 | v), err))
            return false;
        high = v;
        odd = !odd;
    }
    return plb_fail(err, ERROR_SYNTAX, "the hexadecimal string that starts here never ends");
}

/* Decodes the first `n` of the four bytes of a group of ASCII85 digits. */
static bool keep_group(scanner *s, uint64_t group, int n, error *err)
{
    if (group > UINT32_MAX)
        return plb_fail(err, ERROR_SYNTAX, "a group of ASCII85 digits is too large");
    for (int i = 0; i < n; i++)
        if (!keep(s, (char)(group >> (24 - 8 * i) & 255), err))
            return false;
    return true;
}

/* Decodes the last, partial group after the `~`, padded with the highest digit. */
static bool finish_ascii85(scanner *s, uint64_t group, int count, error *err)
{
    if (!have(s) || *s->at != '>')
        return plb_fail(err, ERROR_SYNTAX, "an ASCII85 string does not end in ~>");
    s->at++;
    if (count == 1)
        return plb_fail(err, ERROR_SYNTAX, "an ASCII85 string ends in a single digit");
    for (int i = count; i < 5; i++)
        group = group * 85 + 84;
    return count == 0 || keep_group(s, group, count - 1, err);
}

static bool scan_ascii85(scanner *s, token *t, error *err)
{
    uint64_t group = 0;
    int count = 0;
    for (s->buffer.n = 0; have(s);) {
        char c = *s->at;
        step(s);
        if (c == '~')
            return finish_ascii85(s, group, count, err) && token_of_buffer(s, t, TOKEN_STRING);
        if (class_at(&c) == BLANK)
            continue;
        if (c == 'z' && count == 0) {
            if (!keep_group(s, 0, 4, err))
                return false;
            continue;
        }
        if (c < '!' || c > 'u')
            return plb_fail(err, ERROR_SYNTAX, "an ASCII85 string holds a byte that is no digit");
        group = group * 85 + (uint64_t)(c - '!');
        if (++count == 5) {
            if (!keep_group(s, group, 4, err))
                return false;
            group = 0;
            count = 0;
        }
    }
    return plb_fail(err, ERROR_SYNTAX, "the ASCII85 string that starts here never ends");
}

static bool skip_data(scanner *s, token *t, error *err)
{
    t->kind = TOKEN_DATA;
    while (have(s)) {
        char c = *s->at;
        step(s);
        if (c == '~' && have(s) && *s->at == '>') {
            s->at++;
            return true;
        }
    }
    return plb_fail(err, ERROR_SYNTAX, "the data that start here never end");
}

/* ---- brackets --------------------------------------------------------------------------------------------- */

static bool scan_less(scanner *s, token *t, error *err)
{
    s->at++;
    char c = have(s) ? *s->at : '\0';
    if (c != '<' && c != '~' && c != '|')
        return scan_hex(s, t, err);
    s->at++;
    if (c == '~')
        return scan_ascii85(s, t, err);
    if (c == '|')
        return skip_data(s, t, err);
    t->kind = TOKEN_DICT_OPEN;
    return true;
}

static bool scan_greater(scanner *s, token *t, error *err)
{
    s->at++;
    if (!have(s) || *s->at != '>')
        return plb_fail(err, ERROR_SYNTAX, "a '>' without its '<'");
    s->at++;
    t->kind = TOKEN_DICT_CLOSE;
    return true;
}

static bool bracket(scanner *s, token *t, token_kind kind)
{
    s->at++;
    t->kind = kind;
    return true;
}

static bool scan_special(scanner *s, token *t, error *err)
{
    switch (*s->at) {
    case '/': return scan_slash(s, t, err);
    case '(': return scan_string(s, t, err);
    case '<': return scan_less(s, t, err);
    case '>': return scan_greater(s, t, err);
    case '[': return bracket(s, t, TOKEN_ARRAY_OPEN);
    case ']': return bracket(s, t, TOKEN_ARRAY_CLOSE);
    case '{': return bracket(s, t, TOKEN_PROC_OPEN);
    case '}': return bracket(s, t, TOKEN_PROC_CLOSE);
    default: s->at++; return plb_fail(err, ERROR_SYNTAX, "a ')' without its '('");
    }
}

bool plb_scan_next(scanner *s, token *t, error *err)
{
    t->text = NULL;
    t->length = 0;
    t->kind = TOKEN_END;
    if (s->at < s->end && is_regular(s->at)) {
        s->line = s->next_line;
        return scan_word(s, t, err);
    }
    bool more = skip_blank(s);
    s->line = s->next_line;
    if (!more)
        return true;
    return is_regular(s->at) ? scan_word(s, t, err) : scan_special(s, t, err);
}
