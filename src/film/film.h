/* SPDX-License-Identifier: MIT
 *
 * A film is a row of frames, all of one size, on their way into a file that shows them one after the other, into numbered pictures or
 * into one picture with all of them. Nothing has its name before the film is whole. Kinds of files are rows of one table
 * (film.c), each with a file of its own. Memory does not grow with the number of frames.
 *
 *     film_page page = {.width = 600, .height = 400, .channels = 1, .rate = 25, .loops = 0, .dpi = 150};
 *     film_writer *w = plb_film_writer_open("horse.png", &page, &say, err);
 *     for (each frame) if (!plb_film_writer_add(w, pixels, stride, 1, err)) { plb_film_writer_abort(w); return false; }
 *     return plb_film_writer_close(w, err);
 */
#ifndef PLB_FILM_FILM_H
#define PLB_FILM_FILM_H

#include "base/error.h"

#include <stddef.h>
#include <stdint.h>

/* Durations are counted in frames of 1 / rate s each, of which there are so many in a second at the most: no viewer shows more. */
#define FILM_RATE_MAX 100
/* A film has no more frames than this: eleven hours at 25 a second. */
#define FILM_FRAMES_MAX 1000000u
/* A sheet has so many cells a side at the most. */
#define FILM_CELLS_MAX 1000

typedef struct {
    int width, height; /* of each frame, pixels */
    int channels;      /* bytes of a pixel: 1 grey, 2 grey and alpha, 3 red green blue, 4 with alpha, which is not multiplied in */
    int rate;          /* frames in a second, 1 to FILM_RATE_MAX */
    unsigned loops;    /* how often the film is shown; 0: for ever */
    double dpi;
    int level;         /* of compression, 0 to 9 */
    int members;       /* threads that may compress; the bytes do not depend on them */
    int columns, rows; /* above 0: no film but a sheet of so many cells, with a table beside it, NAME.json; rows 0: as many as needed */
    bool is_growing;   /* each frame adds a little to the one before, here and there: kinds of files that can leave out what has not changed within the rectangle do so */
    const char *const *text; /* pairs keyword, text; ends with NULL; what the file says of itself. NULL: nothing */
} film_page;

typedef struct film_writer film_writer;

/* Begins a film in the kind of file that its name asks for: .png or .apng (APNG), .gif (grey alone); a name with a place for a number, %d or %04d, is a
 * picture (PNG) for each frame, numbered from 1; with columns, a sheet (PNG). "-": standard output, APNG. The page and the name are copied, but for the
 * texts, which are borrowed, as `say` is; it hears what the kind of file cannot hold. The caller closes or aborts the result. NULL and `err` on failure. */
film_writer *plb_film_writer_open(const char *file, const film_page *page, const log_sink *say, error *err);
/* Tells whether films of that name can be written, as plb_film_writer_open would. */
bool plb_film_writer_suits(const char *file, const film_page *page, error *err);
/* Adds a frame that is shown for `duration` frames, from 1 on. Rows of page->width * page->channels bytes lie `stride` bytes from each
 * other. The pixels are copied. After a failure only plb_film_writer_abort may follow. */
bool plb_film_writer_add(film_writer *w, const uint8_t *pixels, size_t stride, unsigned duration, error *err);
/* Ends the film, which then appears, and frees the writer. False and `err` on failure; nothing is left then. */
bool plb_film_writer_close(film_writer *w, error *err);
/* Frees the writer; no file appears. NULL is allowed. */
void plb_film_writer_abort(film_writer *w);

#endif
