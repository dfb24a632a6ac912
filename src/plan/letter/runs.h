/* SPDX-License-Identifier: MIT
 *
 * Runs of lettering: fills that follow each other, beside each other, of one paint and like size, are letters of one word. Whether
 * letters are thin, broad or bold is decided for the run, so that no word comes out half pale and half dark.
 */
#ifndef PLB_PLAN_LETTER_RUNS_H
#define PLB_PLAN_LETTER_RUNS_H

#include "list/display_list.h"

/* A letter_run is what the fills of a run have in common. */
typedef struct {
    size_t fills;    /* so many items */
    double stem;     /* how broad its strokes are, mm: 2 area / perimeter over all letters */
    double size;     /* the longer side of most letters, mm: between the height of an x and that of a capital */
    bool is_bold;    /* its stems are broad for its size, as in a bold font */
} letter_run;

/* The runs of a display list. */
typedef struct letter_runs letter_runs;

/* Finds the runs of all fills. NULL and `err` when out of memory. The caller frees them. */
letter_runs *plb_letter_runs_new(const display_list *list, error *err);
void plb_letter_runs_free(letter_runs *r);
/* Gives the run of item number `i`, a fill; of other items an empty one. */
letter_run plb_letter_run_at(const letter_runs *r, size_t i);

#endif
