/* SPDX-License-Identifier: MIT
 *
 * See text.h.
 */
#include "tap/model/read/text.h"

#include "base/number/number.h"

#include <math.h>
#include <string.h>

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }
static bool is_end(char c) { return c == '\n' || c == '\r'; }

bool plb_text_line(text *t, word *line)
{
    if (t->at >= t->end)
        return false;
    const char *p = t->at;
    while (p < t->end && !is_end(*p))
        p++;
    *line = (word){t->at, p};
    if (p < t->end)
        p += *p == '\r' && p + 1 < t->end && p[1] == '\n' ? 2 : 1;
    t->at = p;
    t->line++;
    return true;
}

bool plb_text_word(word *line, bool has_comments, word *next)
{
    const char *p = line->at;
    while (p < line->end && (is_blank(*p) || *p == '\0'))
        p++;
    next->at = p;
    if (has_comments && p < line->end && *p == '#')
        p = line->end;
    while (p < line->end && !is_blank(*p) && *p != '\0')
        p++;
    line->at = next->end = p;
    return next->at < p && !(has_comments && *next->at == '#');
}

bool plb_text_next(text *t, word *next)
{
    for (;;) {
        while (t->at < t->end && (is_blank(*t->at) || is_end(*t->at))) {
            t->line += *t->at == '\n' || (*t->at == '\r' && !(t->at + 1 < t->end && t->at[1] == '\n'));
            t->at++;
        }
        if (t->at >= t->end)
            return false;
        if (*t->at != '#')
            break;
        while (t->at < t->end && !is_end(*t->at))
            t->at++;
    }
    next->at = t->at;
    while (t->at < t->end && !is_blank(*t->at) && !is_end(*t->at))
        t->at++;
    next->end = t->at;
    return true;
}

bool plb_word_is(word w, const char *is)
{
    size_t n = strlen(is);
    return (size_t)(w.end - w.at) == n && !memcmp(w.at, is, n);
}

/* Returns 1 where the word goes on with these letters, in upper or lower case. */
static bool begins(word w, const char *small)
{
    for (; *small; small++, w.at++)
        if (w.at >= w.end || (*w.at | 0x20) != *small)
            return false;
    return true;
}

bool plb_word_number(word w, double *value)
{
    const char *next;
    bool has_sign = w.at < w.end && (*w.at == '+' || *w.at == '-');
    word rest = {w.at + has_sign, w.end};
    /* Programs write what is no number in their own ways: nan, -nan(ind), 1.#QNAN, inf. */
    if (begins(rest, "nan") || begins(rest, "inf") || memchr(w.at, '#', (size_t)(w.end - w.at))) {
        *value = (double)NAN;
        return true;
    }
    return plb_parse_number(has_sign && *w.at == '+' ? rest.at : w.at, w.end, value, &next) && next == w.end;
}

bool plb_word_whole(word w, long long *value)
{
    bool negative = w.at < w.end && *w.at == '-';
    const char *p = w.at + (negative || (w.at < w.end && *w.at == '+'));
    long long v = 0;
    if (p == w.end || w.end - p > 15)
        return false;
    for (; p < w.end; p++) {
        if (*p < '0' || *p > '9')
            return false;
        v = v * 10 + (*p - '0');
    }
    *value = negative ? -v : v;
    return true;
}
