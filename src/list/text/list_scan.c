/* SPDX-License-Identifier: MIT */
#include "list/text/list_scan.h"

#include <string.h>

/* Asks for more bytes; false when none arrives. */
static bool refill(list_scan *s)
{
    const char *data = NULL;
    size_t size = 0;
    while (!size && !s->is_over)
        s->is_over = !s->refill(s->closure, &data, &size);
    s->at = s->is_over ? NULL : data;
    s->end = s->is_over ? NULL : data + size;
    return !s->is_over;
}

/* Is a byte at hand, or does one arrive? */
static inline bool have_byte(list_scan *s) { return s->at < s->end || refill(s); }

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
/* Tells whether the byte may stand in a word: printable ASCII, but not the sign of a comment. */
static bool is_inside(char c) { return (unsigned char)(c - '!') <= '~' - '!' && c != '#'; }

/* Skips to the end of the line, which stays unread. */
static void skip_comment(list_scan *s)
{
    while (have_byte(s)) {
        const char *newline = memchr(s->at, '\n', (size_t)(s->end - s->at));
        s->at = newline ? newline : s->end;
        if (newline)
            return;
    }
}

/* Puts together the pieces of a word that started at the end of the bytes at hand. */
static bool take_pieces(list_scan *s)
{
    size_t n = 0;
    do {
        const char *start = s->at;
        while (s->at < s->end && is_inside(*s->at))
            s->at++;
        size_t piece = (size_t)(s->at - start);
        if (piece > LIST_MAX_WORD - n)
            return plb_fail(s->err, ERROR_SYNTAX, "a word of more than %d bytes", LIST_MAX_WORD);
        memcpy(s->buffer + n, start, piece);
        n += piece;
    } while (s->at == s->end && have_byte(s) && is_inside(*s->at));
    s->word = s->buffer;
    s->length = n;
    return true;
}

bool plb_list_next_word(list_scan *s)
{
    s->length = 0;
    while (have_byte(s) && is_blank(*s->at))
        s->at++;
    if (s->at == s->end)
        return true;
    if (*s->at == '#')
        skip_comment(s);
    if (s->at == s->end || *s->at == '\n')
        return true;
    const char *p = s->at;
    while (p < s->end && is_inside(*p))
        p++;
    if (p == s->at)
        return plb_fail(s->err, ERROR_SYNTAX, "a byte that is no ASCII text (%d)", (unsigned char)*p);
    if (p == s->end)
        return take_pieces(s);
    s->word = s->at;
    s->length = (size_t)(p - s->at);
    s->at = p;
    return s->length <= LIST_MAX_WORD || plb_fail(s->err, ERROR_SYNTAX, "a word of more than %d bytes", LIST_MAX_WORD);
}

bool plb_list_next_line(list_scan *s)
{
    do {
        if (have_byte(s)) {
            s->line += *s->at == '\n';
            s->at += *s->at == '\n';
        }
        if (!plb_list_next_word(s))
            return false;
    } while (!s->length && s->at < s->end);
    return true;
}

bool plb_list_take_text(list_scan *s, char *text, size_t size)
{
    size_t n = 0;
    for (; have_byte(s) && *s->at != '\n'; s->at++)
        if (n + 1 < size && (n || !is_blank(*s->at)))
            text[n++] = is_inside(*s->at) || is_blank(*s->at) || *s->at == '#' ? *s->at : '?';
    while (n && is_blank(text[n - 1]))
        n--;
    text[n] = '\0';
    s->length = 0;
    return true;
}

bool plb_list_is_word(const list_scan *s, const char *word)
{
    return s->length && *word == *s->word && strlen(word) == s->length && !memcmp(word, s->word, s->length);
}
