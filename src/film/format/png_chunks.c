/* SPDX-License-Identifier: MIT
 *
 * See png_chunks.h.
 */
#include "film/format/png_chunks.h"

#include "base/array.h"
#include "system/thread_team.h"

#include <math.h>
#include <string.h>
#include <zlib.h>

/* Rows are cut into pieces of about so many bytes, by their number alone, and pieces are compressed by several threads (chosen by eye: a
 * smaller piece compresses worse, larger ones leave threads idle). */
#define PIECE_BYTES ((size_t)256 << 10)

void plb_png_store(uint8_t *to, uint32_t v, int bytes)
{
    for (int k = 0; k < bytes; k++)
        to[k] = (uint8_t)(v >> 8 * (bytes - 1 - k));
}

bool plb_png_chunk(FILE *to, const char type[4], const void *data, size_t n)
{
    uint8_t head[8], sum[4];
    uLong crc = crc32_z(crc32_z(0, (const Bytef *)type, 4), data, n);
    plb_png_store(head, (uint32_t)n, 4);
    memcpy(head + 4, type, 4);
    plb_png_store(sum, (uint32_t)crc, 4);
    return fwrite(head, 1, sizeof head, to) == sizeof head && fwrite(data, 1, n, to) == n && fwrite(sum, 1, sizeof sum, to) == sizeof sum;
}

bool plb_png_size(FILE *to, const film_page *page, int width, int height)
{
    static const uint8_t colour_types[] = {0, 0, 4, 2, 6};
    uint8_t head[13] = {0};
    plb_png_store(head, (uint32_t)width, 4);
    plb_png_store(head + 4, (uint32_t)height, 4);
    head[8] = 8;
    head[9] = colour_types[page->channels];
    return plb_png_chunk(to, "IHDR", head, sizeof head);
}

bool plb_png_head(FILE *to, const film_page *page, int width, int height)
{
    static const uint8_t signature[PNG_HEAD_AT] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    uint8_t physical[9];
    uint32_t per_metre = (uint32_t)floor(page->dpi / 0.0254 + 0.5);
    plb_png_store(physical, per_metre, 4);
    plb_png_store(physical + 4, per_metre, 4);
    physical[8] = 1; /* per metre */
    bool ok = fwrite(signature, 1, sizeof signature, to) == sizeof signature && plb_png_size(to, page, width, height) &&
              (page->dpi <= 0 || plb_png_chunk(to, "pHYs", physical, sizeof physical));
    for (const char *const *pair = page->text; ok && pair && pair[0]; pair += 2) {
        char text[512];
        int n = snprintf(text, sizeof text, "%.79s%c%s", pair[0], '\0', pair[1]);
        ok = plb_png_chunk(to, "tEXt", text, n < (int)sizeof text ? (size_t)n : sizeof text - 1);
    }
    return ok;
}

typedef struct {
    const film_page *page;
    const uint8_t *pixels;
    size_t stride, row; /* bytes from a row to the next; of a row with its filter's byte */
    int rows, piece_rows;
    byte_buffer *piece; /* of each */
    uint32_t *sum;
} rows_job;

static int rows_of(const rows_job *j, size_t piece)
{
    int left = j->rows - (int)piece * j->piece_rows;
    return left < j->piece_rows ? left : j->piece_rows;
}

static bool make_piece(void *closure, int member, size_t k)
{
    rows_job *j = closure;
    int rows = rows_of(j, k);
    (void)member;
    size_t n = (size_t)rows * j->row;
    uint8_t *raw = plb_new(n, 1);
    const uint8_t *from = j->pixels + k * (size_t)j->piece_rows * j->stride;
    for (int y = 0; raw && y < rows; y++)
        memcpy(raw + (size_t)y * j->row + 1, from + (size_t)y * j->stride, j->row - 1);
    bool ok = raw && plb_deflate_piece(raw, n, j->page->level, &j->piece[k]);
    if (ok)
        j->sum[k] = (uint32_t)adler32_z(1, raw, n);
    plb_free(raw);
    return ok;
}

static bool append(byte_buffer *out, const void *data, size_t n)
{
    if (!array_reserve(out, n))
        return false;
    memcpy(out->v + out->n, data, n);
    out->n += n;
    return true;
}

bool plb_png_rows(const film_page *page, const uint8_t *pixels, size_t stride, int width, int rows, byte_buffer *out, uint32_t *checksum)
{
    rows_job j = {.page = page, .pixels = pixels, .stride = stride, .row = (size_t)width * (size_t)page->channels + 1, .rows = rows};
    j.piece_rows = (int)(PIECE_BYTES / j.row < 1 ? 1 : PIECE_BYTES / j.row);
    size_t n = (size_t)((rows + j.piece_rows - 1) / j.piece_rows);
    j.piece = plb_new(n, sizeof *j.piece);
    j.sum = plb_new(n, sizeof *j.sum);
    bool ok = j.piece && j.sum && plb_thread_team_run(page->members, n, make_piece, &j);
    for (size_t k = 0; j.piece && k < n; k++) {
        ok = ok && append(out, j.piece[k].v, j.piece[k].n);
        if (ok)
            *checksum = (uint32_t)adler32_combine(*checksum, j.sum[k], (z_off_t)((size_t)rows_of(&j, k) * j.row));
        array_free(&j.piece[k]);
    }
    plb_free(j.piece);
    plb_free(j.sum);
    return ok;
}

bool plb_png_stream(const film_page *page, const uint8_t *pixels, size_t stride, int width, int rows, size_t skip, byte_buffer *out)
{
    static const uint8_t head[] = {PNG_STREAM_HEAD};
    uint32_t sum = 1;
    out->n = 0;
    if (!array_reserve(out, skip))
        return false;
    out->n = skip;
    if (!append(out, head, sizeof head) || !plb_png_rows(page, pixels, stride, width, rows, out, &sum))
        return false;
    const uint8_t end[] = {PNG_STREAM_END(sum)};
    return append(out, end, sizeof end);
}
