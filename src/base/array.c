/* SPDX-License-Identifier: MIT */
#include "base/array.h"

#include <stdint.h>
#include <stdlib.h>

/* The test build for failing allocations: the test says which of them succeeds. */
#ifdef PLB_TEST_ALLOCATIONS
__attribute__((weak)) bool plb_test_may_allocate(void);
#define MAY_ALLOCATE (!plb_test_may_allocate || plb_test_may_allocate())
#else
#define MAY_ALLOCATE true
#endif

bool plb_array_grow(void **v, size_t n, size_t *room, size_t extra, size_t size)
{
    if (extra <= *room - n)
        return true;
    if (extra > SIZE_MAX / 2 / size - n)
        return false;
    size_t want = n + extra, twice = *room * 2;
    size_t next = want > twice ? want : twice;
    if (next < 8)
        next = 8;
    void *p = MAY_ALLOCATE ? realloc(*v, next * size) : NULL;
    if (!p)
        return false;
    *v = p;
    *room = next;
    return true;
}

void *plb_new(size_t n, size_t size)
{
    return MAY_ALLOCATE ? calloc(n ? n : 1, size) : NULL;
}

void plb_free(void *p)
{
    free(p);
}
