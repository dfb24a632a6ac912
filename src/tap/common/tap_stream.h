/* SPDX-License-Identifier: MIT
 *
 * The two ends of a tap: the whole drawing comes in on descriptor 0, the list goes out on descriptor 1.
 */
#ifndef PLB_TAP_COMMON_TAP_STREAM_H
#define PLB_TAP_COMMON_TAP_STREAM_H

#include <stdbool.h>
#include <stddef.h>

#define TAP_MAX_BYTES ((size_t)256 << 20) /* of the drawing, unpacked */

/* Reads the whole drawing into a block that lives as long as the process. NULL: it is larger than TAP_MAX_BYTES, or than the memory. */
char *plb_tap_read_all(size_t *size);
/* Writes all of it; false: the reader went away, and nobody is left to tell. */
bool plb_tap_put(const char *data, size_t size);

#endif
