/* SPDX-License-Identifier: MIT
 *
 * Animated PNG (W3C, PNG third edition): a PNG file whose first frame is the picture that others see, and each further one the rectangle that has
 * changed, which replaces what was there.
 */
#include "film/format/film_format.h"

#include "base/array.h"
#include "film/format/png_chunks.h"

typedef struct {
    long control_at;   /* where acTL lies */
    uint32_t sequence; /* of fcTL and fdAT together */
    byte_buffer data;
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

static bool begin(film_writer *w, error *err)
{
    apng_film *f = w->own = plb_new(1, sizeof *f);
    if (!f)
        return plb_fail_memory(err);
    if (!plb_film_open_output(w, true, err))
        return false;
    if (!plb_png_head(w->to, &w->page, w->page.width, w->page.height))
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
    control[24] = control[25] = 0; /* the frame stays, and replaces what is there */
    return plb_png_chunk(w->to, "fcTL", control, sizeof control) || plb_film_fail(w, err);
}

static bool add(film_writer *w, const film_frame *frame, error *err)
{
    apng_film *f = w->own;
    const frame_rectangle *r = &frame->changed;
    size_t stride = plb_film_row(&w->page), number = frame->before ? 4 : 0;
    const uint8_t *pixels = frame->pixels + (size_t)r->y * stride + (size_t)r->x * (size_t)w->page.channels;
    if (!put_frame_control(w, frame, err))
        return false;
    if (!plb_png_stream(&w->page, pixels, stride, r->width, r->height, number, &f->data))
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
    if (f)
        array_free(&f->data);
    plb_free(f);
}

const film_format plb_apng_film = {.name = "APNG", .suffixes = "png apng", .built = true, .merges = true, .begin = begin, .add = add, .end = end, .drop = drop};
