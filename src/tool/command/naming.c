/* SPDX-License-Identifier: MIT
 *
 * See naming.h.
 */
#include "tool/command/naming.h"

#include <stdlib.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

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
    size_t size = strlen(pattern) + 1;
    for (const char *p = pattern; (p = strstr(p, PLACE)); p += strlen(PLACE))
        size += stem.n;
    char *name = malloc(size), *to = name;
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

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

const char *naming_repeated(char **names, size_t n)
{
    qsort(names, n, sizeof *names, by_name);
    for (size_t i = 1; i < n; i++)
        if (!strcmp(names[i - 1], names[i]))
            return names[i];
    return NULL;
}

char *naming_in_folder(const char *name, const char *suffix, bool several)
{
    struct stat st;
    size_t n = strlen(name), size = n + strlen(suffix) + 16;
    bool slash = n > 0 && name[n - 1] == '/';
    if (!slash && !(stat(name, &st) == 0 && S_ISDIR(st.st_mode)))
        return NULL;
    char *pattern = malloc(size);
    if (pattern)
        snprintf(pattern, size, "%s%s%s%s%s", name, slash ? "" : "/", PLACE, several ? "-%d" : "", suffix);
    return pattern;
}
