/* SPDX-License-Identifier: MIT
 *
 * For qsort.
 */
#ifndef PLB_BASE_SORT_H
#define PLB_BASE_SORT_H

/* Doubles, rising. */
static inline int plb_compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

#endif
