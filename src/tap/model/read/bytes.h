/* SPDX-License-Identifier: MIT
 *
 * This header reads numbers from bytes, of either order.
 */
#ifndef PLB_TAP_MODEL_READ_BYTES_H
#define PLB_TAP_MODEL_READ_BYTES_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Returns the number without a sign in n <= 8 bytes; `big`: the highest byte comes first. */
static inline uint64_t plb_bytes_whole(const char *at, int n, bool big)
{
    uint64_t v = 0;
    for (int i = 0; i < n; i++)
        v |= (uint64_t)(unsigned char)at[i] << 8 * (big ? n - 1 - i : i);
    return v;
}

static inline double plb_bytes_float(const char *at, bool big)
{
    uint32_t bits = (uint32_t)plb_bytes_whole(at, 4, big);
    float v;
    memcpy(&v, &bits, sizeof v);
    return (double)v;
}

static inline double plb_bytes_double(const char *at, bool big)
{
    uint64_t bits = plb_bytes_whole(at, 8, big);
    double v;
    memcpy(&v, &bits, sizeof v);
    return v;
}

#endif
