/* SPDX-License-Identifier: MIT
 *
 * See nearest.h. The distance is Damerau's and Levenshtein's with neighbours swapped at most once.
 */
#include "tool/options/nearest.h"

#include <string.h>

#define MAX_LETTERS 31

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

size_t nearest_distance(const char *word, const char *text, size_t n)
{
    size_t m = strlen(word), d[MAX_LETTERS + 1][MAX_LETTERS + 1];
    if (m > MAX_LETTERS || n > MAX_LETTERS)
        return NEAREST_FAR;
    for (size_t i = 0; i <= m; i++)
        for (size_t k = 0; k <= n; k++) {
            if (i == 0 || k == 0) {
                d[i][k] = i + k;
                continue;
            }
            size_t change = word[i - 1] != text[k - 1];
            d[i][k] = least(least(d[i - 1][k], d[i][k - 1]) + 1, d[i - 1][k - 1] + change);
            if (i > 1 && k > 1 && word[i - 1] == text[k - 2] && word[i - 2] == text[k - 1])
                d[i][k] = least(d[i][k], d[i - 2][k - 2] + 1);
        }
    return d[m][n];
}

/* A short word may differ by one letter, a long one by a third (chosen by eye: more would propose words nobody meant). */
size_t nearest_limit(size_t n)
{
    return n < 6 ? 1 : n / 3;
}
