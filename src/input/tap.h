/* SPDX-License-Identifier: MIT
 *
 * A drawing through a tap: a program of ours that turns a foreign format into the list's text form, in its cage.
 */
#ifndef PLB_INPUT_TAP_H
#define PLB_INPUT_TAP_H

#include "input/input.h"
#include "list/text/tap_status.h"

#define TAP_MAX_ARGUMENTS 12

typedef struct {
    const char *who;                     /* does the work, as messages name it: "librsvg" */
    const char *argv[TAP_MAX_ARGUMENTS]; /* the tap's name first; NULL after the last */
    process process;     /* how it ended, for those who try again: end, code, message. Already finished */
    bool crashed;        /* it died, by itself */
    unsigned long pages; /* that the document has; 0: the tap does not say */
} tap;

/* Runs the tap on in->data and reads the list while it is written. True: the list is whole and the tap ended well. False: `err`
 * says why, "NAME: what" or "NAME:LINE: what", and `list` is empty as plb_list_init leaves it. */
bool plb_tap_read(const input_source *in, tap *t, display_list *list, error *err);

/* Did the tap end by itself with this status? */
bool plb_tap_ended_with(const tap *t, tap_status status);

/* Says why a tap ended with another status than TAP_DONE, for those who run it otherwise than by plb_tap_read; false always. */
bool plb_tap_explain_status(const input_source *in, const char *program, process *p, error *err);

#endif
