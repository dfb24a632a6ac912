/* SPDX-License-Identifier: MIT
 *
 * See naming.h.
 */
#include "tool/naming.h"

#include <stdlib.h>
#include <string.h>

#define PLACE "%s"

typedef struct {
    const char *v;
    size_t n;
} part;

static part stem_of(const char *input)
{
    const char *slash = strrchr(input, '/'), *base = slash ? slash + 1 : input, *dot = strrchr(base, '.');
    if (!strcmp(input, "-"))
        return (part){"standard-input", strlen("standard-input")};
    return (part){base, dot && dot > base ? (size_t)(dot - base) : strlen(base)};
}

bool naming_has_place(const char *pattern)
{
    return strstr(pattern, PLACE) != NULL;
}

char *naming_of(const char *pattern, const char *input)
{
    part stem = stem_of(input);
    size_t room = strlen(pattern) + 1;
    for (const char *p = pattern; (p = strstr(p, PLACE)); p += strlen(PLACE))
        room += stem.n;
    char *name = malloc(room), *to = name;
    while (name && *pattern) {
        if (!strncmp(pattern, PLACE, strlen(PLACE))) {
            memcpy(to, stem.v, stem.n);
            to += stem.n;
            pattern += strlen(PLACE);
        } else {
            *to++ = *pattern++;
        }
    }
    if (name)
        *to = '\0';
    return name;
}

typedef struct {
    part stem;
    size_t number;
} entry;

static int by_stem(const void *a, const void *b)
{
    const entry *x = a, *y = b;
    int by = memcmp(x->stem.v, y->stem.v, x->stem.n < y->stem.n ? x->stem.n : y->stem.n);
    if (by || x->stem.n != y->stem.n)
        return by ? by : x->stem.n < y->stem.n ? -1 : 1;
    return x->number < y->number ? -1 : x->number > y->number;
}

bool naming_collides(const char *pattern, char *const inputs[], size_t n, size_t *first, size_t *second)
{
    entry *all = n > 1 && naming_has_place(pattern) ? calloc(n, sizeof *all) : NULL;
    bool found = false;
    for (size_t i = 0; all && i < n; i++)
        all[i] = (entry){stem_of(inputs[i]), i};
    if (all)
        qsort(all, n, sizeof *all, by_stem);
    for (size_t i = 1; all && i < n && !found; i++)
        if (all[i].stem.n == all[i - 1].stem.n && !memcmp(all[i].stem.v, all[i - 1].stem.v, all[i].stem.n)) {
            *first = all[i - 1].number;
            *second = all[i].number;
            found = true;
        }
    free(all);
    return found;
}
