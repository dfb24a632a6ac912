/* SPDX-License-Identifier: MIT */
#define _DEFAULT_SOURCE /* madvise */
#include "base/array.h"

#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>

/* In the test build for failing allocations the test says which of them succeed. */
#ifdef PLB_TEST_ALLOCATIONS
__attribute__((weak)) bool plb_test_may_allocate(void);
#define MAY_ALLOCATE (!plb_test_may_allocate || plb_test_may_allocate())
#else
#define MAY_ALLOCATE true
#endif

static bool resize(void **v, size_t *capacity, size_t n, size_t size)
{
    void *p = MAY_ALLOCATE ? realloc(*v, n * size) : NULL;
    if (!p)
        return false;
    *v = p;
    *capacity = n;
    return true;
}

bool plb_array_grow(void **v, size_t n, size_t *capacity, size_t extra, size_t size)
{
    if (extra > SIZE_MAX / 2 / size - n)
        return false;
    size_t want = n + extra, twice = *capacity * 2;
    size_t next = want > twice ? want : twice;
    if (next < 8)
        next = 8;
    return resize(v, capacity, next, size);
}

bool plb_array_make(void **v, size_t *capacity, size_t n, size_t size)
{
    return n <= *capacity || (n <= SIZE_MAX / 2 / size && resize(v, capacity, n, size));
}

void *plb_new(size_t n, size_t size)
{
    return MAY_ALLOCATE ? calloc(n ? n : 1, size) : NULL;
}

/* The size of a large page on x86-64 and, with pages of 4 KiB, on ARM64. Where large pages are larger, the advice has no effect. */
#define LARGE_PAGE ((uintptr_t)2 << 20)

void *plb_new_large(size_t n, size_t size)
{
    void *p = plb_new(n, size);
#ifdef MADV_HUGEPAGE
    uintptr_t first = ((uintptr_t)p + LARGE_PAGE - 1) & ~(LARGE_PAGE - 1), end = ((uintptr_t)p + n * size) & ~(LARGE_PAGE - 1);
    if (p && first < end)
        (void)madvise((void *)first, end - first, MADV_HUGEPAGE); /* where the system refuses, the pages are small */
#endif
    return p;
}

void plb_free(void *p)
{
    free(p);
}
