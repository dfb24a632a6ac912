/* SPDX-License-Identifier: MIT
 *
 * This header has comparisons for qsort.
 */
#ifndef PLB_BASE_SORT_H
#define PLB_BASE_SORT_H

/* Orders doubles from the smallest to the largest. */
static inline int plb_compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

#endif
