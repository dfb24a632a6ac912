/* SPDX-License-Identifier: MIT
 *
 * See pages.h.
 */
#include "tool/command/pages.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* No document has more pages; larger numbers are mistakes. */
#define MAX_PAGES 1000000u

static bool take_page(const char **at, unsigned *page)
{
    unsigned n = 0;
    for (; **at >= '0' && **at <= '9' && n <= MAX_PAGES; ++*at)
        n = n * 10 + (unsigned)(**at - '0');
    *page = n;
    return n >= 1 && n <= MAX_PAGES;
}

bool pages_next(const char **list, page_range *range)
{
    const char *at = *list;
    if (!strncmp(at, "all", 3)) {
        *range = (page_range){1, PAGES_TO_THE_END};
        at += 3;
    } else {
        if (!take_page(&at, &range->first))
            return false;
        range->last = range->first;
        if (*at == '-') {
            at++;
            range->last = PAGES_TO_THE_END;
            if (*at >= '0' && *at <= '9' && (!take_page(&at, &range->last) || range->last < range->first))
                return false;
        }
    }
    if (*at && (*at != ',' || !at[1]))
        return false;
    *list = at + (*at == ',');
    return true;
}

bool pages_is_one(const char *list)
{
    page_range range;
    return pages_next(&list, &range) && range.first == range.last && !*list;
}

/* Finds the first %d or %0Nd, N one digit, with its length and N; NULL: there is none. */
static const char *find_number(const char *name, size_t *length, int *digits)
{
    for (const char *p = name; (p = strchr(p, '%')); p++) {
        bool padded = p[1] == '0' && p[2] >= '1' && p[2] <= '9';
        *length = padded ? 4 : 2;
        *digits = padded ? p[2] - '0' : 1;
        if (p[*length - 1] == 'd')
            return p;
    }
    return NULL;
}

bool pages_has_number(const char *name)
{
    size_t length;
    int digits;
    return find_number(name, &length, &digits) != NULL;
}

char *pages_name(const char *name, unsigned page)
{
    size_t length, size = strlen(name) + 1;
    int digits;
    for (const char *at = name; (at = find_number(at, &length, &digits)); at += length)
        size += 16; /* more than any number takes */
    char *made = malloc(size), *to = made;
    for (const char *at; made && (at = find_number(name, &length, &digits)); name = at + length)
        to += snprintf(to, size - (size_t)(to - made), "%.*s%0*u", (int)(at - name), name, digits, page);
    if (made)
        strcpy(to, name);
    return made;
}

char *pages_name_output(const char *input, bool numbered)
{
    const char *slash = strrchr(input, '/'), *base = slash ? slash + 1 : input;
    const char *dot = strrchr(base, '.');
    size_t stem = dot && dot > base ? (size_t)(dot - input) : strlen(input), size = stem + 8;
    char *name = malloc(size);
    if (name)
        snprintf(name, size, "%.*s%s.png", (int)stem, input, numbered ? "-%d" : "");
    return name;
}
