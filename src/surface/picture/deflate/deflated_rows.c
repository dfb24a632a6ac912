/* SPDX-License-Identifier: MIT
 *
 * The rows of a page as one zlib stream (RFC 1950), as PNG and PDF hold them. The rows, each after a byte that says 'no filter'
 * (grain does not compress by prediction), are cut into pieces by their number alone, so the file does not depend on bands
 * or threads.
 */
#include "surface/picture/formats.h"

#include "base/array.h"
#include "surface/picture/deflate/deflate.h"
#include "system/thread_team.h"

#include <zlib.h>

/* Pieces that are compressed before they are written. */
#define PIECES 32

typedef struct {
    picture *p;
    data_function data;
    int piece_rows, first; /* rows of a piece; the first row of those at hand */
    size_t size;           /* bytes of the stream so far */
    uint32_t checksum;     /* Adler-32 of all rows */
    byte_buffer piece[PIECES];
    uint32_t piece_sum[PIECES];
    uint8_t *raw[THREAD_TEAM_MAX]; /* a piece's rows, for each member */
    size_t raw_size;
} deflated_rows;

static bool put(deflated_rows *d, const void *data, size_t n)
{
    d->size += n;
    return d->data(d->p, data, n);
}

static size_t row_bytes(const picture *p)
{
    return (size_t)p->page->width * (size_t)p->channels + 1;
}

bool plb_deflated_rows_begin(picture *p, data_function data, error *err)
{
    static const uint8_t head[] = {0x78, 0x01};
    deflated_rows *d = p->rows ? p->rows : plb_new(1, sizeof *d);
    if (!d)
        return plb_fail_memory(err);
    p->rows = d;
    d->p = p;
    d->data = data;
    d->size = 0;
    d->checksum = 1;
    d->piece_rows = plb_picture_rows(p->format, p->page);
    size_t raw_size = (size_t)d->piece_rows * row_bytes(p);
    for (int k = 0; k < THREAD_TEAM_MAX && raw_size > d->raw_size; k++) {
        plb_free(d->raw[k]);
        d->raw[k] = NULL;
    }
    d->raw_size = raw_size > d->raw_size ? raw_size : d->raw_size;
    return put(d, head, sizeof head) || plb_picture_fail(p, err);
}

void plb_deflated_rows_drop(picture *p)
{
    deflated_rows *d = p->rows;
    if (!d)
        return;
    for (int k = 0; k < PIECES; k++)
        array_free(&d->piece[k]);
    for (int k = 0; k < THREAD_TEAM_MAX; k++)
        plb_free(d->raw[k]);
    plb_free(d);
    p->rows = NULL;
}

size_t plb_deflated_rows_size(const picture *p)
{
    const deflated_rows *d = p->rows;
    return d->size;
}

/* How many rows the piece that begins at row y of the page has. */
static int rows_from(const deflated_rows *d, int y)
{
    int bottom = d->p->band->top + d->p->band->rows;
    return bottom - y < d->piece_rows ? bottom - y : d->piece_rows;
}

/* Makes piece number `k` from row `first` on. */
static bool make_piece(void *closure, int member, size_t k)
{
    deflated_rows *d = closure;
    size_t size = row_bytes(d->p);
    int y0 = d->first + (int)k * d->piece_rows, rows = rows_from(d, y0);
    if (!d->raw[member])
        d->raw[member] = plb_new(d->raw_size, 1);
    uint8_t *raw = d->raw[member];
    for (int y = 0; raw && y < rows; y++) {
        raw[(size_t)y * size] = 0;
        plb_picture_row(d->p, y0 + y, raw + (size_t)y * size + 1);
    }
    if (!raw || !plb_deflate_piece(raw, (size_t)rows * size, d->p->page->level, &d->piece[k]))
        return false;
    d->piece_sum[k] = (uint32_t)adler32_z(1, raw, (size_t)rows * size);
    return true;
}

bool plb_deflated_rows_add(picture *p, error *err)
{
    deflated_rows *d = p->rows;
    int bottom = p->band->top + p->band->rows;
    for (d->first = p->band->top; d->first < bottom; d->first += PIECES * d->piece_rows) {
        int left = (bottom - d->first + d->piece_rows - 1) / d->piece_rows, n = left < PIECES ? left : PIECES;
        if (!plb_thread_team_run(p->page->members, (size_t)n, make_piece, d))
            return plb_fail_memory(err);
        for (int k = 0; k < n; k++) {
            size_t size = row_bytes(p) * (size_t)rows_from(d, d->first + k * d->piece_rows);
            d->checksum = (uint32_t)adler32_combine(d->checksum, d->piece_sum[k], (z_off_t)size);
            if (!put(d, d->piece[k].v, d->piece[k].n))
                return plb_picture_fail(p, err);
        }
    }
    return true;
}

bool plb_deflated_rows_end(picture *p, error *err)
{
    deflated_rows *d = p->rows;
    uint32_t sum = d->checksum;
    uint8_t end[] = {DEFLATE_END, (uint8_t)(sum >> 24), (uint8_t)(sum >> 16), (uint8_t)(sum >> 8), (uint8_t)sum};
    return put(d, end, sizeof end) || plb_picture_fail(p, err);
}
