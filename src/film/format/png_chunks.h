/* SPDX-License-Identifier: MIT
 *
 * Pieces of PNG files (RFC 2083) that films are made of: chunks, heads, rows compressed.
 */
#ifndef PLB_FILM_FORMAT_PNG_CHUNKS_H
#define PLB_FILM_FORMAT_PNG_CHUNKS_H

#include "film/film.h"
#include "surface/picture/deflate/deflate.h"

#include <stdio.h>

/* Stores the number with its highest byte first. */
void plb_png_store(uint8_t *to, uint32_t v, int bytes);
/* Writes a chunk; false and errno on failure. */
bool plb_png_chunk(FILE *to, const char type[4], const void *data, size_t n);
/* Writes signature, IHDR, pHYs and the texts for a picture of the page's kind of pixels, of another size. */
bool plb_png_head(FILE *to, const film_page *page, int width, int height);
/* Writes the chunk IHDR alone, `PNG_HEAD_AT` bytes behind the file's beginning. */
bool plb_png_size(FILE *to, const film_page *page, int width, int height);
#define PNG_HEAD_AT 8

/* Appends to `out` rows of `width` pixels as a deflate stream without end (RFC 1951), each after a byte that says 'no filter', and goes on with
 * the checksum (Adler-32) of these bytes. The result does not depend on the number of members. False when out of memory. */
bool plb_png_rows(const film_page *page, const uint8_t *pixels, size_t stride, int width, int rows, byte_buffer *out, uint32_t *checksum);
/* Replaces `out`, whose first `skip` bytes stay free for the caller, by a whole zlib stream of such rows. */
bool plb_png_stream(const film_page *page, const uint8_t *pixels, size_t stride, int width, int rows, size_t skip, byte_buffer *out);
/* The stream's first bytes, and its last: the empty last block, the checksum. */
#define PNG_STREAM_HEAD 0x78, 0x01
#define PNG_STREAM_END(sum) DEFLATE_END, (uint8_t)((sum) >> 24), (uint8_t)((sum) >> 16), (uint8_t)((sum) >> 8), (uint8_t)(sum)

#endif
