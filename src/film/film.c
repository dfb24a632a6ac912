/* SPDX-License-Identifier: MIT
 *
 * See film.h: the table of kinds of files, and a film from its beginning to its end.
 */
#include "film/film.h"

#include "base/array.h"
#include "film/format/film_format.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

/* To add a kind of file, write its file and its row. A name's suffix chooses among these; the first one is the usual. */
static const film_format *const formats[] = {&plb_apng_film, &plb_gif_film};
#define FORMATS (sizeof formats / sizeof *formats)

/* ---- which format ---- */

/* ASCII letters alone: suffixes do not depend on a locale. */
static bool is_word(const char *suffix, const char *word, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if ((suffix[i] >= 'A' && suffix[i] <= 'Z' ? suffix[i] + 32 : suffix[i]) != word[i])
            return false;
    return !suffix[n];
}

static bool has_suffix(const film_format *f, const char *suffix)
{
    for (const char *at = f->suffixes; *at;) {
        size_t n = strcspn(at, " ");
        if (is_word(suffix, at, n))
            return true;
        at += n + (at[n] == ' ');
    }
    return false;
}

/* From behind its dot on; NULL: none. */
static const char *suffix_of(const char *file)
{
    const char *slash = strrchr(file, '/'), *base = slash ? slash + 1 : file, *dot = strrchr(base, '.');
    return dot && dot > base ? dot + 1 : NULL;
}

static const film_format *among_suffixes(const char *file, error *err)
{
    const char *suffix = suffix_of(file);
    for (size_t i = 0; i < FORMATS; i++)
        if (!suffix || has_suffix(formats[i], suffix))
            return formats[i];
    char known[64] = "";
    for (size_t i = 0, n = 0; i < FORMATS; i++)
        n += (size_t)snprintf(known + n, sizeof known - n, "%s.%.*s", i == 0 ? "" : i + 1 < FORMATS ? ", " : " or ", (int)strcspn(formats[i]->suffixes, " "), formats[i]->suffixes);
    plb_fail(err, ERROR_ARGUMENT, "%s: no film is written with the suffix .%s: end the name in %s", file, suffix, known);
    return NULL;
}

static const film_format *format_of(const char *file, const film_page *page, error *err)
{
    bool is_named = page->columns == 0 && !plb_film_number(file, &(size_t){0}, &(int){0});
    if (is_named)
        return among_suffixes(file, err);
    const film_format *f = page->columns ? &plb_sheet_film : &plb_numbered_film;
    if (page->columns && !strcmp(file, "-"))
        return plb_fail(err, ERROR_ARGUMENT, "a sheet needs a name, which its table has, too: use -o"), NULL;
    if (suffix_of(file) && !has_suffix(f, suffix_of(file)))
        return plb_fail(err, ERROR_ARGUMENT, "%s: %s is written, which such a name does not promise: end the name in .png", file, f->name), NULL;
    return f;
}

static bool check_page(const film_format *f, const char *file, const film_page *page, error *err)
{
    if (!f->built)
        return plb_fail(err, ERROR_UNSUPPORTED, "%s: this build writes no %s: install %s and build again", file, f->name, f->package);
    if (page->width < 1 || page->height < 1 || page->width > 1000000 || page->height > 1000000 || page->channels < 1 || page->channels > 4 || page->rate < 1 ||
        page->rate > FILM_RATE_MAX || page->columns < 0 || page->columns > FILM_CELLS_MAX || page->rows < 0 || page->rows > FILM_CELLS_MAX)
        return plb_fail(err, ERROR_ARGUMENT, "%s: a film needs a size and a rate from 1 to %d frames a second", file, FILM_RATE_MAX);
    if (f->max_side && (page->width > f->max_side || page->height > f->max_side))
        return plb_fail(err, ERROR_LIMIT, "%s: %s holds at most %d pixels a side, not %d by %d: lower the resolution", file, f->name, f->max_side, page->width, page->height);
    return true;
}

bool plb_film_writer_suits(const char *file, const film_page *page, error *err)
{
    const film_format *f = format_of(file, page, err);
    return f && check_page(f, file, page, err);
}

/* ---- a film from its beginning to its end ---- */

film_writer *plb_film_writer_open(const char *file, const film_page *page, const log_sink *say, error *err)
{
    const film_format *f = format_of(file, page, err);
    if (!f || !check_page(f, file, page, err))
        return NULL;
    film_writer *w = plb_new(1, sizeof *w);
    if (!w)
        return plb_fail_memory(err), NULL;
    *w = (film_writer){.format = f, .page = *page, .say = say};
    size_t bytes = plb_film_row(page) * (size_t)page->height;
    w->name = plb_new(strlen(file) + 1, 1);
    w->waiting = plb_new(bytes, 1);
    w->shown = plb_new(bytes, 1);
    errno = 0;
    if (!w->name || !w->waiting || !w->shown)
        plb_fail_memory(err);
    else if (strcpy(w->name, file) && f->begin(w, err))
        return w;
    plb_film_writer_abort(w);
    return NULL;
}

/* Finds what differs between two rows, columns [from, to), which grow. */
static void widen(const uint8_t *a, const uint8_t *b, int width, int channels, int *from, int *to)
{
    size_t n = (size_t)channels;
    int x = 0;
    while (x < *from && !memcmp(a + (size_t)x * n, b + (size_t)x * n, n))
        x++;
    *from = x;
    for (x = width; x > *to && !memcmp(a + (size_t)(x - 1) * n, b + (size_t)(x - 1) * n, n);)
        x--;
    *to = x;
}

/* Returns the smallest rectangle that holds all pixels that differ; one pixel, if none does. */
static frame_rectangle difference(const film_page *page, const uint8_t *a, const uint8_t *b)
{
    size_t row = plb_film_row(page);
    int top = page->height, bottom = 0, from = page->width, to = 0;
    for (int y = 0; y < page->height; y++) {
        if (!memcmp(a + (size_t)y * row, b + (size_t)y * row, row))
            continue;
        top = y < top ? y : top;
        bottom = y + 1;
        widen(a + (size_t)y * row, b + (size_t)y * row, page->width, page->channels, &from, &to);
    }
    return bottom > top ? (frame_rectangle){from, top, to - from, bottom - top} : (frame_rectangle){0, 0, 1, 1};
}

/* Hands the frame that waits to the format. */
static bool release(film_writer *w, error *err)
{
    if (w->duration == 0)
        return true;
    film_frame frame = {.pixels = w->waiting, .before = w->frames ? w->shown : NULL, .duration = w->duration};
    frame.changed = w->frames ? difference(&w->page, w->waiting, w->shown) : (frame_rectangle){0, 0, w->page.width, w->page.height};
    errno = 0;
    if (!w->format->add(w, &frame, err))
        return false;
    w->frames++;
    w->elapsed += w->duration;
    w->duration = 0;
    uint8_t *free_room = w->shown;
    w->shown = w->waiting;
    w->waiting = free_room;
    return true;
}

static bool waits_already(const film_writer *w, const uint8_t *pixels, size_t stride)
{
    size_t row = plb_film_row(&w->page);
    bool same = w->duration > 0 && w->format->merges;
    for (int y = 0; same && y < w->page.height; y++)
        same = !memcmp(w->waiting + (size_t)y * row, pixels + (size_t)y * stride, row);
    return same;
}

bool plb_film_writer_add(film_writer *w, const uint8_t *pixels, size_t stride, unsigned duration, error *err)
{
    size_t row = plb_film_row(&w->page);
    if (duration < 1 || w->elapsed + w->duration + duration > FILM_FRAMES_MAX)
        return plb_fail(err, ERROR_LIMIT, "%s: a film has from 1 to %u frames", w->name, FILM_FRAMES_MAX);
    if (waits_already(w, pixels, stride)) {
        w->duration += duration;
        return true;
    }
    if (!release(w, err))
        return false;
    for (int y = 0; y < w->page.height; y++)
        memcpy(w->waiting + (size_t)y * row, pixels + (size_t)y * stride, row);
    w->duration = duration;
    return true;
}

/* Ends the file: what was written elsewhere first goes to its place. */
static bool finish(film_writer *w, error *err)
{
    errno = 0;
    if (!release(w, err) || !w->format->end(w, err))
        return false;
    if (!w->out.to)
        return true;
    if (w->is_spooled) {
        if (fseek(w->to, 0, SEEK_END) != 0 || !plb_film_copy(w->to, 0, (size_t)ftell(w->to), w->out.to))
            return plb_film_fail(w, err);
    }
    if (!plb_output_commit(&w->out, err))
        return false;
    if (!w->format->after || w->format->after(w, err))
        return true;
    unlink(w->name);
    return false;
}

bool plb_film_writer_close(film_writer *w, error *err)
{
    bool ok = w->frames || w->duration ? finish(w, err) : plb_fail(err, ERROR_ARGUMENT, "%s: a film needs a frame", w->name);
    plb_film_writer_abort(w);
    return ok;
}

void plb_film_writer_abort(film_writer *w)
{
    if (!w)
        return;
    if (w->format->drop)
        w->format->drop(w);
    if (w->is_spooled && w->to)
        fclose(w->to);
    plb_output_discard(&w->out);
    plb_free(w->name);
    plb_free(w->waiting);
    plb_free(w->shown);
    plb_free(w);
}
