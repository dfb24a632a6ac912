/* SPDX-License-Identifier: MIT
 *
 * A sprite sheet: all frames in one picture (PNG), in cells, row by row from the top left, with a table of them in a file of the same name with
 * the suffix .json. One row of cells at a time is in memory.
 */
#include "film/format/film_format.h"

#include "base/array.h"
#include "film/format/png_chunks.h"

#include <string.h>
#include <unistd.h>

/* A row of cells takes so much memory at the most. */
#define ROW_BYTES_MAX ((size_t)512 << 20)
/* A picture has so many pixels a side at the most. */
#define SIDE_MAX 1000000L

typedef struct {
    uint8_t *cells;       /* of the row at hand */
    size_t stride, size;  /* of a row of pixels; of all cells */
    int column, row;      /* of the next cell */
    uint32_t checksum;
    byte_buffer data;
    ARRAY(unsigned) durations;
} sheet_film;

static void clear_cells(film_writer *w)
{
    sheet_film *f = w->own;
    memset(f->cells, w->page.channels % 2 ? 255 : 0, f->size);
    f->column = 0;
}

static bool begin(film_writer *w, error *err)
{
    const film_page *page = &w->page;
    sheet_film *f = w->own = plb_new(1, sizeof *f);
    if (!f)
        return plb_fail_memory(err);
    f->stride = plb_film_row(page) * (size_t)page->columns;
    f->size = f->stride * (size_t)page->height;
    f->checksum = 1;
    if ((long)page->columns * page->width > SIDE_MAX || (long)page->rows * page->height > SIDE_MAX || f->size > ROW_BYTES_MAX)
        return plb_fail(err, ERROR_LIMIT, "%s: a sheet of %d columns of such frames is too large", w->name, page->columns);
    f->cells = plb_new(f->size, 1);
    if (!f->cells)
        return plb_fail_memory(err);
    clear_cells(w);
    if (!plb_film_open_output(w, true, err))
        return false;
    static const uint8_t head[] = {PNG_STREAM_HEAD};
    return (plb_png_head(w->to, page, page->columns * page->width, page->height) && plb_png_chunk(w->to, "IDAT", head, sizeof head)) || plb_film_fail(w, err);
}

/* Writes the row of cells at hand. */
static bool put_row(film_writer *w, error *err)
{
    sheet_film *f = w->own;
    f->data.n = 0;
    if (!plb_png_rows(&w->page, f->cells, f->stride, w->page.columns * w->page.width, w->page.height, &f->data, &f->checksum))
        return plb_fail_memory(err);
    clear_cells(w);
    f->row++;
    return plb_png_chunk(w->to, "IDAT", f->data.v, f->data.n) || plb_film_fail(w, err);
}

static bool add(film_writer *w, const film_frame *frame, error *err)
{
    const film_page *page = &w->page;
    sheet_film *f = w->own;
    size_t row = plb_film_row(page);
    if (page->rows && f->row == page->rows)
        return plb_fail(err, ERROR_ARGUMENT, "%s: the film has more frames than a sheet of %d by %d cells holds", w->name, page->columns, page->rows);
    if ((long)(f->row + 1) * page->height > SIDE_MAX)
        return plb_fail(err, ERROR_LIMIT, "%s: the sheet is too large", w->name);
    for (int y = 0; y < page->height; y++)
        memcpy(f->cells + (size_t)y * f->stride + (size_t)f->column * row, frame->pixels + (size_t)y * row, row);
    f->column++;
    if (!array_push(&f->durations, frame->duration))
        return plb_fail_memory(err);
    return f->column < page->columns || put_row(w, err);
}

/* ---- the table ---- */

/* Writes a name as a string of JSON. */
static void put_string(FILE *to, const char *text)
{
    fputc('"', to);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++)
        fprintf(to, *c == '"' || *c == '\\' ? "\\%c" : *c < ' ' ? "\\u%04x" : "%c", *c);
    fputc('"', to);
}

static void put_table(const film_writer *w, FILE *to)
{
    const sheet_film *f = w->own;
    const film_page *page = &w->page;
    const char *slash = strrchr(w->name, '/');
    fprintf(to, "{\"frames\": [\n");
    for (size_t k = 0; k < f->durations.n; k++) {
        int x = (int)(k % (size_t)page->columns) * page->width, y = (int)(k / (size_t)page->columns) * page->height;
        fprintf(to, " {\"frame\": {\"x\": %d, \"y\": %d, \"w\": %d, \"h\": %d}, \"duration\": %u}%s\n", x, y, page->width, page->height,
                (unsigned)(f->durations.v[k] * 1000ull / (unsigned)page->rate), k + 1 < f->durations.n ? "," : "");
    }
    fprintf(to, "],\n\"meta\": {\"image\": ");
    put_string(to, slash ? slash + 1 : w->name);
    fprintf(to, ", \"format\": \"%s\", \"size\": {\"w\": %d, \"h\": %d}, \"columns\": %d, \"rows\": %d, \"fps\": %d, \"loops\": %u}}\n",
            (const char *[]){"", "I8", "IA88", "RGB888", "RGBA8888"}[page->channels], page->columns * page->width, f->row * page->height, page->columns, f->row, page->rate, page->loops);
}

/* Returns the table's name; NULL: out of memory. The caller frees. */
static char *table_name(const film_writer *w)
{
    const char *slash = strrchr(w->name, '/'), *dot = strrchr(w->name, '.');
    size_t stem = dot && dot > (slash ? slash + 1 : w->name) ? (size_t)(dot - w->name) : strlen(w->name), size = stem + 8;
    char *name = plb_new(size, 1);
    if (name)
        snprintf(name, size, "%.*s.json", (int)stem, w->name);
    return name;
}

static bool write_table(film_writer *w, error *err)
{
    output out;
    char *name = table_name(w);
    if (!name)
        return plb_fail_memory(err);
    bool ok = plb_output_open(&out, name, err);
    if (ok) {
        put_table(w, out.to);
        ok = plb_output_commit(&out, err);
    }
    plb_free(name);
    return ok;
}

static bool end(film_writer *w, error *err)
{
    const film_page *page = &w->page;
    sheet_film *f = w->own;
    while (f->column > 0 || f->row < page->rows || f->row == 0)
        if (!put_row(w, err))
            return false;
    const uint8_t last[] = {PNG_STREAM_END(f->checksum)};
    bool ok = plb_png_chunk(w->to, "IDAT", last, sizeof last) && plb_png_chunk(w->to, "IEND", "", 0) && fseek(w->to, PNG_HEAD_AT, SEEK_SET) == 0 &&
              plb_png_size(w->to, page, page->columns * page->width, f->row * page->height);
    return ok || plb_film_fail(w, err);
}

static void drop(film_writer *w)
{
    sheet_film *f = w->own;
    if (f) {
        array_free(&f->data);
        array_free(&f->durations);
        plb_free(f->cells);
    }
    plb_free(f);
}

const film_format plb_sheet_film = {.name = "a sprite sheet", .suffixes = "png", .built = true, .begin = begin, .add = add, .end = end, .after = write_table, .drop = drop};
