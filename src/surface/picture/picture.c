/* SPDX-License-Identifier: MIT
 *
 * See picture.h. The rows, each after a byte that says 'no filter' (grain does not compress by prediction), are cut into
 * pieces by their number alone, so the file does not depend on bands or threads.
 */
#include "surface/picture/picture.h"

#include "base/array.h"
#include "system/thread_team.h"
#include "surface/picture/picture_formats.h"

#include <errno.h>
#include <string.h>
#include <zlib.h>

/* Bytes of a piece: large enough that its own code tables and its flush do not matter. */
#define PIECE_BYTES (256 * 1024)

typedef struct {
    bool (*head)(picture *p);
    bool (*data)(picture *p, const void *data, size_t n);
    bool (*tail)(picture *p);
} format;

static const format formats[] = {
    [PICTURE_PNG] = {plb_png_head, plb_png_data, plb_png_tail},
    [PICTURE_PDF] = {plb_pdf_head, plb_pdf_data, plb_pdf_tail},
};

static size_t row_bytes(int width, int channels)
{
    return (size_t)width * (size_t)channels + 1;
}

/* A PDF's page is laid over others by multiplying, not by opacity. */
static page_background rows_background(const picture_options *o)
{
    return o->format == PICTURE_PDF ? PAGE_WHITE : o->background;
}

int plb_picture_rows(int width, const picture_options *o)
{
    size_t n = PIECE_BYTES / row_bytes(width, plb_page_channels(rows_background(o), o->colour));
    return n < 1 ? 1 : (int)n;
}

static bool put_data(picture *p, const void *data, size_t n)
{
    p->data_size += n;
    return formats[p->o->format].data(p, data, n);
}

static bool fail_to_write(const picture *p, error *err)
{
    if (errno == 0 || errno == ENOMEM)
        return plb_fail_memory(err);
    return plb_fail(err, ERROR_FILE, "%s: cannot be written: %s", p->name, strerror(errno));
}

picture *plb_picture_new(int width, int height, const picture_options *o, FILE *to, const char *name, error *err)
{
    static const uint8_t zlib_head[] = {0x78, 0x01};
    picture *p = plb_new(1, sizeof *p);
    if (!p) {
        plb_fail_memory(err);
        return NULL;
    }
    *p = (picture){.o = o, .width = width, .height = height, .to = to, .name = name, .checksum = 1};
    p->channels = plb_page_channels(rows_background(o), o->colour);
    p->piece_rows = plb_picture_rows(width, o);
    errno = 0;
    if (formats[o->format].head(p) && put_data(p, zlib_head, sizeof zlib_head))
        return p;
    fail_to_write(p, err);
    plb_picture_free(p);
    return NULL;
}

void plb_picture_free(picture *p)
{
    if (!p)
        return;
    for (int k = 0; k < PICTURE_PIECES; k++)
        array_free(&p->piece[k]);
    for (int k = 0; k < THREAD_TEAM_MAX; k++)
        plb_free(p->raw[k]);
    plb_free(p);
}

/* How many rows the piece that begins at row y of the page has. */
static int rows_from(const picture *p, int y)
{
    int foot = p->band->top + p->band->rows;
    return foot - y < p->piece_rows ? foot - y : p->piece_rows;
}

/* Makes piece number `k` from row `first` on. */
static bool make_piece(void *closure, int member, size_t k)
{
    picture *p = closure;
    size_t size = row_bytes(p->width, p->channels);
    int y0 = p->first + (int)k * p->piece_rows, rows = rows_from(p, y0);
    if (!p->raw[member])
        p->raw[member] = plb_new((size_t)p->piece_rows, size);
    uint8_t *raw = p->raw[member];
    for (int y = 0; raw && y < rows; y++) {
        raw[(size_t)y * size] = 0;
        plb_page_row(p->band, rows_background(p->o), y0 + y, raw + (size_t)y * size + 1);
    }
    if (!raw || !plb_deflate_piece(raw, (size_t)rows * size, p->o->level, &p->piece[k]))
        return false;
    p->piece_sum[k] = (uint32_t)adler32_z(1, raw, (size_t)rows * size);
    return true;
}

bool plb_picture_add(picture *p, const page *band, error *err)
{
    p->band = band;
    int foot = band->top + band->rows;
    for (p->first = band->top; p->first < foot; p->first += PICTURE_PIECES * p->piece_rows) {
        int left = (foot - p->first + p->piece_rows - 1) / p->piece_rows, n = left < PICTURE_PIECES ? left : PICTURE_PIECES;
        errno = 0;
        if (!plb_thread_team_run(p->o->members, (size_t)n, make_piece, p))
            return plb_fail_memory(err);
        for (int k = 0; k < n; k++) {
            size_t size = row_bytes(p->width, p->channels) * (size_t)rows_from(p, p->first + k * p->piece_rows);
            p->checksum = (uint32_t)adler32_combine(p->checksum, p->piece_sum[k], (z_off_t)size);
            if (!put_data(p, p->piece[k].v, p->piece[k].n))
                return fail_to_write(p, err);
        }
    }
    return true;
}

bool plb_picture_end(picture *p, error *err)
{
    uint32_t sum = p->checksum;
    uint8_t end[] = {DEFLATE_END, (uint8_t)(sum >> 24), (uint8_t)(sum >> 16), (uint8_t)(sum >> 8), (uint8_t)sum};
    errno = 0;
    return (put_data(p, end, sizeof end) && formats[p->o->format].tail(p)) || fail_to_write(p, err);
}
