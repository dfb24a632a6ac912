/* SPDX-License-Identifier: MIT
 *
 * Rows of a picture compressed a piece at a time, each by itself, so that several threads can do it: the pieces put
 * one after the other are one deflate stream (RFC 1951).
 */
#ifndef PLB_SURFACE_PICTURE_DEFLATE_H
#define PLB_SURFACE_PICTURE_DEFLATE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    uint8_t *v;
    size_t n, capacity;
} byte_buffer;

/* Replaces `out` by the compressed `raw`, whole bytes, no last block. `level`: 0, not at all, to 9, smallest. False when
 * out of memory. */
bool plb_deflate_piece(const uint8_t *raw, size_t n, int level, byte_buffer *out);
/* The last block, empty: what ends the stream. */
#define DEFLATE_END 0x03, 0x00

#endif
