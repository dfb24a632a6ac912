/* SPDX-License-Identifier: MIT
 *
 * A fill may say which characters it shows, where that is known: those whose outlines its path holds.
 */
#ifndef PLB_LIST_CHARACTERS_H
#define PLB_LIST_CHARACTERS_H

#include "base/array.h"
#include "base/geometry/geom.h"

#include <stdint.h>

/* A character is one shape of the text, of so many subpaths: a letter, one with its marks, or a ligature of several letters. */
#define CHARACTER_MAX_CODES 4
typedef struct {
    uint32_t code[CHARACTER_MAX_CODES]; /* Unicode; 0 where there are fewer */
    uint32_t subpaths;                  /* of the fill's path, behind those of the character before; at least 1 */
    point at;                           /* where it stands on the baseline, mm */
} character;

/* A text_run has one size and one baseline's direction. Their up is a quarter turn against the clock from there. */
typedef struct {
    double em;      /* size of the font, mm, above 0 */
    double degrees; /* direction of the baseline, clockwise from the right */
    ARRAY(character) characters;
} text_run;

/* Returns a copy, of lengths times `scale`, which the caller frees with plb_text_run_free; NULL when out of memory. */
text_run *plb_text_run_copy(const text_run *t, double scale);
void plb_text_run_free(text_run *t);
/* Maps places and direction by `m`, and the size by its expansion when `size_too`. False: the map turns the text over or squeezes it flat,
 * and what is left says nothing. */
bool plb_text_run_map(text_run *t, matrix m, bool size_too);
/* Tells how many subpaths all characters have. */
size_t plb_text_run_subpaths(const text_run *t);

#endif
