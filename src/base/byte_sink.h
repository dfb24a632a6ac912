/* SPDX-License-Identifier: MIT
 *
 * A byte sink takes the bytes of a result one after the other: into a file, into memory, or to a function of the caller's.
 */
#ifndef PLB_BASE_BYTE_SINK_H
#define PLB_BASE_BYTE_SINK_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    /* False, with the reason in errno (0: none is known), ends the work. */
    bool (*put)(void *closure, const void *data, size_t n);
    void *closure;
} byte_sink;

#endif
