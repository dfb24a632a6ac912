/* SPDX-License-Identifier: MIT
 *
 * This header has arrays that grow and checked allocation. Every size is checked for overflow before it reaches malloc.
 *
 *     ARRAY(point) dots = {0};
 *     if (!array_push(&dots, p)) return plb_fail_memory(err);      // false: out of memory, array unchanged
 *     for (size_t i = 0; i < dots.n; i++) use(dots.v[i]);
 *     array_free(&dots);
 */
#ifndef PLB_BASE_ARRAY_H
#define PLB_BASE_ARRAY_H

#include <stdbool.h>
#include <stddef.h>

#define ARRAY(type) \
    struct { \
        type *v; \
        size_t n, capacity; \
    }

/* Makes room for `extra` more elements; false when out of memory. */
#define array_reserve(a, extra) plb_array_reserve((void **)&(a)->v, (a)->n, &(a)->capacity, (extra), sizeof *(a)->v)
/* Gives an empty array room for exactly n elements, where it will not grow. */
#define array_make(a, n) plb_array_make((void **)&(a)->v, &(a)->capacity, (n), sizeof *(a)->v)
#define array_push(a, item) (array_reserve((a), 1) ? ((a)->v[(a)->n++] = (item), true) : false)
#define array_free(a) (plb_free((a)->v), (a)->v = NULL, (a)->n = (a)->capacity = 0)

/* Makes the memory larger, at least twice as large as it is; false when out of memory, with nothing changed. */
bool plb_array_grow(void **v, size_t n, size_t *capacity, size_t extra, size_t size);
static inline bool plb_array_reserve(void **v, size_t n, size_t *capacity, size_t extra, size_t size)
{
    return extra <= *capacity - n || plb_array_grow(v, n, capacity, extra, size);
}
bool plb_array_make(void **v, size_t *capacity, size_t n, size_t size);
/* Returns zeroed memory for `n` elements of `size` bytes, owned by the caller; NULL on overflow or when out of memory. */
void *plb_new(size_t n, size_t size);
/* Does the same in large pages of memory where the system has them: for large tables that are read in no order, which
 * in small pages miss the processor's cache of addresses at almost every look. */
void *plb_new_large(size_t n, size_t size);
void plb_free(void *p);

#endif
