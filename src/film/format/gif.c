/* SPDX-License-Identifier: MIT
 *
 * GIF (89a) of grey films: its 256 colours are the greys. Each frame is the rectangle that has changed, compressed by Welch's variant of Lempel and Ziv's method.
 * Durations are whole hundredths of a second; their sum is kept, not each of them.
 */
#include "film/format/film_format.h"

#include "base/array.h"

#include <string.h>

#define CLEAR 256
#define END 257
#define CODES 4096
/* A table of codes by prefix and byte: open addressing, twice as many places as codes. */
#define PLACES 8192
#define BLOCK 255

typedef struct {
    uint32_t key[PLACES]; /* prefix << 8 | byte, plus 1; 0: empty */
    uint16_t code[PLACES];
    int next, bits;       /* the next code; bits of a code */
    uint32_t waiting;     /* bits that fill no byte yet … */
    int waits;            /* … so many */
    uint8_t block[BLOCK + 1];
    int n;                /* bytes of the block */
    unsigned long long frames, hundredths; /* passed so far */
} gif_film;

static void store16(uint8_t *to, unsigned v)
{
    to[0] = (uint8_t)v;
    to[1] = (uint8_t)(v >> 8);
}

static bool put_block(film_writer *w, error *err)
{
    gif_film *f = w->own;
    f->block[0] = (uint8_t)f->n;
    size_t n = (size_t)f->n + 1;
    f->n = 0;
    return n == 1 || plb_film_put(w, f->block, n, err);
}

static bool put_byte(film_writer *w, uint8_t byte, error *err)
{
    gif_film *f = w->own;
    f->block[++f->n] = byte;
    return f->n < BLOCK || put_block(w, err);
}

static bool put_code(film_writer *w, int code, error *err)
{
    gif_film *f = w->own;
    f->waiting |= (uint32_t)code << f->waits;
    for (f->waits += f->bits; f->waits >= 8; f->waits -= 8) {
        if (!put_byte(w, (uint8_t)f->waiting, err))
            return false;
        f->waiting >>= 8;
    }
    return true;
}

static void clear_table(gif_film *f)
{
    memset(f->key, 0, sizeof f->key);
    f->next = END + 1;
    f->bits = 9;
}

/* Finds the place of a string in the table: its own, or an empty one. */
static size_t place_of(const gif_film *f, uint32_t key)
{
    size_t at = key * 2654435761u >> 19;
    while (f->key[at] && f->key[at] != key)
        at = (at + 1) % PLACES;
    return at;
}

/* Ends the string `prefix`, after which comes `byte`. */
static bool end_string(film_writer *w, int prefix, uint32_t key, size_t at, error *err)
{
    gif_film *f = w->own;
    if (!put_code(w, prefix, err))
        return false;
    if (f->next == CODES) {
        bool ok = put_code(w, CLEAR, err);
        clear_table(f);
        return ok;
    }
    f->key[at] = key;
    f->code[at] = (uint16_t)f->next++;
    /* The reader is one code behind: codes grow when the last of their length has been given, not before. */
    f->bits += f->next > 1 << f->bits && f->bits < 12;
    return true;
}

static bool put_pixels(film_writer *w, const film_frame *frame, error *err)
{
    gif_film *f = w->own;
    const frame_rectangle *r = &frame->changed;
    int prefix = -1;
    f->waiting = 0;
    f->waits = f->n = 0;
    clear_table(f);
    bool ok = put_code(w, CLEAR, err);
    for (int y = r->y; y < r->y + r->height; y++)
        for (int x = r->x; ok && x < r->x + r->width; x++) {
            uint8_t byte = frame->pixels[(size_t)y * (size_t)w->page.width + (size_t)x];
            uint32_t key = ((uint32_t)(prefix < 0 ? 0 : prefix) << 8 | byte) + 1;
            size_t at = place_of(f, key);
            if (prefix >= 0 && f->key[at]) {
                prefix = f->code[at];
                continue;
            }
            ok = prefix < 0 || end_string(w, prefix, key, at, err);
            prefix = byte;
        }
    ok = ok && put_code(w, prefix, err);
    /* The reader has added a string by now, as the writer would have. */
    f->bits += ++f->next > 1 << f->bits && f->bits < 12;
    ok = ok && put_code(w, END, err) && (f->waits == 0 || put_byte(w, (uint8_t)f->waiting, err)) && put_block(w, err);
    return ok && plb_film_put(w, "", 1, err);
}

static bool begin(film_writer *w, error *err)
{
    const film_page *page = &w->page;
    if (page->channels != 1)
        return plb_fail(err, ERROR_ARGUMENT, "%s: GIF is written of grey films on paper only: write .png", w->name);
    if (!(w->own = plb_new(1, sizeof(gif_film))))
        return plb_fail_memory(err);
    uint8_t head[13 + 768] = "GIF89a", loop[] = "\x21\xff\x0bNETSCAPE2.0\x03\x01\0\0";
    store16(head + 6, (unsigned)page->width);
    store16(head + 8, (unsigned)page->height);
    head[10] = 0xf7; /* a table of 256 colours, 8 bits each */
    for (int k = 0; k < 768; k++)
        head[13 + k] = (uint8_t)(k / 3);
    /* Readers count how often it is repeated, 0: for ever; what is shown once has no such block. */
    store16(loop + 16, page->loops ? page->loops - 1 : 0);
    return plb_film_open_output(w, false, err) && plb_film_put(w, head, sizeof head, err) && (page->loops == 1 || plb_film_put(w, loop, sizeof loop, err));
}

static bool add(film_writer *w, const film_frame *frame, error *err)
{
    gif_film *f = w->own;
    f->frames += frame->duration;
    unsigned long long until = (f->frames * 100 + (unsigned)w->page.rate / 2) / (unsigned)w->page.rate, span = until - f->hundredths;
    uint8_t head[19] = {0x21, 0xf9, 4, 4, 0, 0, 0, 0, 0x2c};
    f->hundredths = until;
    store16(head + 4, span < 65535 ? (unsigned)span : 65535);
    store16(head + 9, (unsigned)frame->changed.x);
    store16(head + 11, (unsigned)frame->changed.y);
    store16(head + 13, (unsigned)frame->changed.width);
    store16(head + 15, (unsigned)frame->changed.height);
    head[17] = 0; /* no table of its own, rows in order */
    head[18] = 8; /* bits of the first codes */
    return plb_film_put(w, head, sizeof head, err) && put_pixels(w, frame, err);
}

static bool end(film_writer *w, error *err)
{
    return plb_film_put(w, ";", 1, err);
}

static void drop(film_writer *w)
{
    plb_free(w->own);
}

const film_format plb_gif_film = {.name = "GIF", .suffixes = "gif", .built = true, .merges = true, .max_side = 65535, .begin = begin, .add = add, .end = end, .drop = drop};
