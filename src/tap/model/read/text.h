/* SPDX-License-Identifier: MIT
 *
 * This header reads the words of a text, line by line, as all formats of models need it. Lines end with LF, CR or both.
 */
#ifndef PLB_TAP_MODEL_READ_TEXT_H
#define PLB_TAP_MODEL_READ_TEXT_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    const char *at, *end; /* the rest of the whole text */
    unsigned long line;   /* of `at`, from 1 */
} text;

/* A word, or the rest of a line. */
typedef struct {
    const char *at, *end;
} word;

/* Gives the next line without its end; false at the end of the text. */
bool plb_text_line(text *t, word *line);
/* Cuts the next word off the line; false when there is none. '#' begins a comment where `has_comments`. */
bool plb_text_word(word *line, bool has_comments, word *next);
/* Gives the next word of the text, whatever line it is in; comments begin with '#'. */
bool plb_text_next(text *t, word *next);
bool plb_word_is(word w, const char *is);
bool plb_word_number(word w, double *value);
/* Reads a whole number that fits. */
bool plb_word_whole(word w, long long *value);

#endif
