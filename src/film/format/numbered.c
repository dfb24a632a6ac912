/* SPDX-License-Identifier: MIT
 *
 * A picture (PNG) for each frame, numbered from 1. They lie in one nameless file until the last one is drawn: so a film that is
 * broken off leaves none.
 */
#include "film/format/film_format.h"

#include "base/array.h"
#include "film/format/png_chunks.h"

#include <string.h>
#include <unistd.h>

/* One picture, shown for so many frames. */
typedef struct {
    long at;
    size_t size;
    unsigned duration;
} spooled;

typedef struct {
    ARRAY(spooled) pictures;
    byte_buffer data;
} numbered_film;

/* Returns the name of a frame's picture; NULL: out of memory. The caller frees. */
static char *name_of(const film_writer *w, unsigned number)
{
    size_t length = 0, size = strlen(w->name) + 16;
    int digits = 1;
    const char *place = plb_film_number(w->name, &length, &digits);
    char *name = plb_new(size, 1);
    if (name)
        snprintf(name, size, "%.*s%0*u%s", (int)(place - w->name), w->name, digits, number, place + length);
    return name;
}

static bool begin(film_writer *w, error *err)
{
    w->own = plb_new(1, sizeof(numbered_film));
    char *first = w->own ? name_of(w, 1) : NULL;
    if (!first)
        return plb_fail_memory(err);
    w->to = plb_output_spool(first, err);
    w->is_spooled = true;
    plb_free(first);
    return w->to != NULL;
}

static bool add(film_writer *w, const film_frame *frame, error *err)
{
    numbered_film *f = w->own;
    const film_page *page = &w->page;
    spooled picture = {.at = ftell(w->to), .duration = frame->duration};
    if (!plb_png_stream(page, frame->pixels, plb_film_row(page), page->width, page->height, 0, &f->data))
        return plb_fail_memory(err);
    if (!plb_png_head(w->to, page, page->width, page->height) || !plb_png_chunk(w->to, "IDAT", f->data.v, f->data.n) ||
        !plb_png_chunk(w->to, "IEND", "", 0))
        return plb_film_fail(w, err);
    picture.size = (size_t)(ftell(w->to) - picture.at);
    return array_push(&f->pictures, picture) || plb_fail_memory(err);
}

static bool write_picture(film_writer *w, const spooled *picture, unsigned number, error *err)
{
    output out;
    char *name = name_of(w, number);
    if (!name)
        return plb_fail_memory(err);
    bool ok = plb_output_open(&out, name, err);
    if (ok && !plb_film_copy(w->to, picture->at, picture->size, out.to)) {
        ok = plb_film_fail(w, err);
        plb_output_discard(&out);
    } else if (ok) {
        ok = plb_output_commit(&out, err);
    }
    plb_free(name);
    return ok;
}

/* Takes pictures 1 to `last` away. */
static void take_back(const film_writer *w, unsigned last)
{
    for (unsigned k = 1; k <= last; k++) {
        char *name = name_of(w, k);
        if (name)
            unlink(name);
        plb_free(name);
    }
}

static bool end(film_writer *w, error *err)
{
    const numbered_film *f = w->own;
    unsigned number = 0;
    if (fflush(w->to) != 0)
        return plb_film_fail(w, err);
    for (size_t i = 0; i < f->pictures.n; i++)
        for (unsigned k = 0; k < f->pictures.v[i].duration; k++)
            if (!write_picture(w, &f->pictures.v[i], ++number, err)) {
                take_back(w, number - 1);
                return false;
            }
    return true;
}

static void drop(film_writer *w)
{
    numbered_film *f = w->own;
    if (f) {
        array_free(&f->pictures);
        array_free(&f->data);
    }
    plb_free(f);
}

const film_format plb_numbered_film = {.name = "numbered PNG", .suffixes = "png", .built = true, .merges = true, .begin = begin, .add = add, .end = end, .drop = drop};
