/* SPDX-License-Identifier: MIT
 *
 * Measures how far a mistyped name lies from another. The distance is Damerau's and Levenshtein's with neighbours swapped at
 * most once.
 */
#include "api/plumbago.h"

#include <string.h>

#define MAX_LETTERS 31

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

static size_t distance(const char *name, size_t m, const char *word, size_t n)
{
    size_t d[MAX_LETTERS + 1][MAX_LETTERS + 1];
    for (size_t i = 0; i <= m; i++)
        for (size_t k = 0; k <= n; k++) {
            if (i == 0 || k == 0) {
                d[i][k] = i + k;
                continue;
            }
            size_t change = name[i - 1] != word[k - 1];
            d[i][k] = least(least(d[i - 1][k], d[i][k - 1]) + 1, d[i - 1][k - 1] + change);
            if (i > 1 && k > 1 && name[i - 1] == word[k - 2] && name[i - 2] == word[k - 1])
                d[i][k] = least(d[i][k], d[i - 2][k - 2] + 1);
        }
    return d[m][n];
}

/* A short word may differ by one letter, a long one by a third (chosen by eye: more would propose names nobody meant). */
static size_t limit(size_t n)
{
    return n < 6 ? 1 : n / 3;
}

size_t plb_name_distance(const char *name, const char *word, size_t n)
{
    size_t m = strlen(name);
    if (m > MAX_LETTERS || n > MAX_LETTERS)
        return PLB_NAME_FAR;
    size_t away = distance(name, m, word, n);
    return away <= limit(n) ? away : PLB_NAME_FAR;
}
