/* SPDX-License-Identifier: MIT
 *
 * Describes a film in progress, and what a kind of file must do; for this folder and film.c only.
 */
#ifndef PLB_FILM_FORMAT_FILM_FORMAT_H
#define PLB_FILM_FORMAT_FILM_FORMAT_H

#include "film/film.h"
#include "system/output.h"

typedef struct film_format film_format;

/* A part of the frame: columns [x, x + width), rows [y, y + height). */
typedef struct {
    int x, y, width, height;
} frame_rectangle;

struct film_writer {
    const film_format *format;
    film_page page;
    char *name;          /* the caller's, copied */
    const log_sink *say; /* may be NULL */
    output out;
    FILE *to;            /* what the format writes to: out.to, or a nameless file that is copied there at the end */
    bool is_spooled;
    uint8_t *waiting;    /* the frame that waits for the end of its duration … */
    unsigned duration;   /* … so long so far; 0: none waits */
    uint8_t *shown;      /* the frame before it */
    unsigned frames;     /* handed to the format */
    unsigned long long elapsed; /* duration of these together */
    void *own;           /* the format's */
};

/* A frame on its way into the file. */
typedef struct {
    const uint8_t *pixels;  /* whole frame, rows one after the other */
    const uint8_t *before;  /* the frame before it; NULL: this is the first */
    frame_rectangle changed; /* what differs from that: at least one pixel; the whole frame, if it is the first */
    unsigned duration;
} film_frame;

/* A row of the table. All functions but `drop` return false with `err` filled; NULL: nothing to do. */
struct film_format {
    const char *name, *suffixes; /* the suffixes without dots, with blanks between them */
    const char *package;         /* Debian's, without which a build does not write it; NULL: needs none */
    bool built;
    bool merges;                 /* frames that do not differ are one, shown longer */
    int max_side;                /* pixels of a frame's side; 0: any */
    bool (*begin)(film_writer *w, error *err);
    bool (*add)(film_writer *w, const film_frame *frame, error *err);
    bool (*end)(film_writer *w, error *err); /* writes the last bytes, and what is not in w->out */
    bool (*after)(film_writer *w, error *err); /* writes what belongs to the file, which has its name now */
    void (*drop)(film_writer *w);            /* frees w->own, also half made */
};

extern const film_format plb_apng_film, plb_numbered_film, plb_sheet_film, plb_gif_film;

/* Opens w->out and w->to. A film that must be changed after it was written (`is_patched`) goes into a nameless file first where the output cannot
 * be changed, as a pipe cannot. */
bool plb_film_open_output(film_writer *w, bool is_patched, error *err);
/* Writes bytes; false and `err` on failure. */
bool plb_film_put(film_writer *w, const void *data, size_t n, error *err);
/* Fills `err` for a write that failed, as errno tells. Returns false. */
bool plb_film_fail(const film_writer *w, error *err);
/* Copies n bytes of a nameless file, from byte `from` on, to `to`. False and errno on failure. */
bool plb_film_copy(FILE *spool, long from, size_t n, FILE *to);
/* Finds the place of a frame's number in a name: %d, or %0Nd with one digit for N; gives its length and N, else 1. NULL: there is none. */
const char *plb_film_number(const char *name, size_t *length, int *digits);
/* Bytes of a frame's row. */
size_t plb_film_row(const film_page *page);

#endif
