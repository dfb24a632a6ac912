/* SPDX-License-Identifier: MIT
 *
 * A draughtsman's alphabet of single strokes, made for this program: how a hand letters each character, in the order of its strokes.
 *
 * A form is a text: strokes parted by |, each of points X,Y parted by blanks, through which the hand goes smoothly, but turns on the spot at
 * those that have a * behind. The baseline is at 0, y goes up, small letters are 70 high, capitals and figures 100, tails end at -30.
 */
#ifndef PLB_PLAN_LETTER_HAND_ALPHABET_H
#define PLB_PLAN_LETTER_HAND_ALPHABET_H

#include <stdint.h>

#define ALPHABET_SMALL 70
#define ALPHABET_CAPITAL 100
#define ALPHABET_FORMS 3

/* A letter_form has up to three forms; the others are NULL. */
typedef struct {
    uint32_t code;
    const char *form[ALPHABET_FORMS];
} letter_form;

/* A letter with a mark above or below: the letter's strokes and those of the mark. Marks are drawn about x = 0; those above stand over 0. */
typedef struct {
    uint32_t code;
    uint32_t letter;
    const char *mark;
    int below; /* 1: the mark hangs from the baseline */
} marked_letter;

/* Returns the forms of a character; NULL: the alphabet does not have it. */
const letter_form *plb_alphabet_find(uint32_t code);
/* Returns how a character is made of a letter of the alphabet and a mark; NULL: it is not. */
const marked_letter *plb_alphabet_find_marked(uint32_t code);

#endif
