/* SPDX-License-Identifier: MIT
 *
 * Animated PNG (W3C, PNG third edition): a PNG file whose first frame is the picture that others see, and each further one the rectangle that has
 * changed, which replaces what was there or is laid over it.
 */
#include "film/format/film_format.h"

#include "base/array.h"
#include "film/format/png_chunks.h"

#include <string.h>

typedef struct {
    long control_at;   /* where acTL lies */
    uint32_t sequence; /* of fcTL and fdAT together */
    byte_buffer data;
    film_page stored;  /* the page in the file: with alpha, where frames are laid over each other */
    byte_buffer over;  /* a frame's rectangle, to be laid over */
} apng_film;

/* Durations are fractions of a second, both numbers of 16 bits. */
#define DURATION_MAX 65535u

static bool put_control(film_writer *w, error *err)
{
    uint8_t control[8];
    plb_png_store(control, w->frames ? w->frames : 1, 4);
    plb_png_store(control + 4, w->page.loops, 4);
    return plb_png_chunk(w->to, "acTL", control, sizeof control) || plb_film_fail(w, err);
}

/* Tells whether frames without alpha are laid over what is there: nothing is stored of pixels that stay. */
static bool is_laid_over(const film_writer *w)
{
    return w->page.is_growing && w->page.channels % 2;
}

static bool begin(film_writer *w, error *err)
{
    apng_film *f = w->own = plb_new(1, sizeof *f);
    if (!f)
        return plb_fail_memory(err);
    f->stored = w->page;
    f->stored.channels += is_laid_over(w);
    if (!plb_film_open_output(w, true, err))
        return false;
    if (!plb_png_head(w->to, &f->stored, w->page.width, w->page.height))
        return plb_film_fail(w, err);
    f->control_at = ftell(w->to);
    return put_control(w, err);
}

static bool put_frame_control(film_writer *w, const film_frame *frame, error *err)
{
    apng_film *f = w->own;
    uint8_t control[26];
    plb_png_store(control, f->sequence++, 4);
    plb_png_store(control + 4, (uint32_t)frame->changed.width, 4);
    plb_png_store(control + 8, (uint32_t)frame->changed.height, 4);
    plb_png_store(control + 12, (uint32_t)frame->changed.x, 4);
    plb_png_store(control + 16, (uint32_t)frame->changed.y, 4);
    plb_png_store(control + 20, frame->duration < DURATION_MAX ? frame->duration : DURATION_MAX, 2);
    plb_png_store(control + 22, (uint32_t)w->page.rate, 2);
    control[24] = 0; /* the frame stays, … */
    control[25] = is_laid_over(w); /* … replaces what is there, or covers it where it is opaque */
    return plb_png_chunk(w->to, "fcTL", control, sizeof control) || plb_film_fail(w, err);
}

/* Makes f->over of the rectangle: pixels that have changed are opaque, all others nothing. */
static bool lay_over(film_writer *w, const film_frame *frame)
{
    apng_film *f = w->own;
    const frame_rectangle *r = &frame->changed;
    size_t n = (size_t)w->page.channels;
    f->over.n = 0;
    if (!array_reserve(&f->over, (size_t)r->width * (size_t)r->height * (n + 1)))
        return false;
    uint8_t *to = f->over.v;
    for (int y = r->y; y < r->y + r->height; y++)
        for (int x = r->x; x < r->x + r->width; x++, to += n + 1) {
            size_t at = ((size_t)y * (size_t)w->page.width + (size_t)x) * n;
            bool stays = frame->before && !memcmp(frame->pixels + at, frame->before + at, n);
            memset(to, 0, n + 1);
            if (stays)
                continue;
            memcpy(to, frame->pixels + at, n);
            to[n] = 255;
        }
    return true;
}

static bool add(film_writer *w, const film_frame *frame, error *err)
{
    apng_film *f = w->own;
    const frame_rectangle *r = &frame->changed;
    size_t stride = plb_film_row(&w->page), number = frame->before ? 4 : 0;
    const uint8_t *pixels = frame->pixels + (size_t)r->y * stride + (size_t)r->x * (size_t)w->page.channels;
    if (!put_frame_control(w, frame, err))
        return false;
    if (is_laid_over(w)) {
        if (!lay_over(w, frame))
            return plb_fail_memory(err);
        pixels = f->over.v;
        stride = (size_t)r->width * (size_t)f->stored.channels;
    }
    if (!plb_png_stream(&f->stored, pixels, stride, r->width, r->height, number, &f->data))
        return plb_fail_memory(err);
    if (number)
        plb_png_store(f->data.v, f->sequence++, 4);
    return plb_png_chunk(w->to, number ? "fdAT" : "IDAT", f->data.v, f->data.n) || plb_film_fail(w, err);
}

static bool end(film_writer *w, error *err)
{
    const apng_film *f = w->own;
    if (!plb_png_chunk(w->to, "IEND", "", 0) || fseek(w->to, f->control_at, SEEK_SET) != 0)
        return plb_film_fail(w, err);
    return put_control(w, err);
}

static void drop(film_writer *w)
{
    apng_film *f = w->own;
    if (f) {
        array_free(&f->data);
        array_free(&f->over);
    }
    plb_free(f);
}

const film_format plb_apng_film = {.name = "APNG", .suffixes = "png apng", .built = true, .merges = true, .begin = begin, .add = add, .end = end, .drop = drop};
