/* SPDX-License-Identifier: MIT
 *
 * Writes plumbago's warnings, progress and errors on standard error.
 */
#ifndef PLB_TOOL_COMMAND_TALK_H
#define PLB_TOOL_COMMAND_TALK_H

#include "tool/command/command_line.h"

#include <time.h>

enum { EXIT_DRAWN = 0, EXIT_NOT_DRAWN = 1, EXIT_WRONG_COMMAND = 2 };

typedef struct talk {
    const settings *command;
    const char *drawing; /* shown beside the progress; NULL: there is but one */
    time_t started;      /* the drawing */
    int shown;           /* columns of the line of progress that is on the terminal */
    int percent;         /* as shown last */
} talk;

/* Tells whether progress belongs on standard error: on a terminal that can go back to the start of a line. */
bool talk_can_show_progress(void);
/* These are the library's plb_message_function and plb_progress_function; `closure` is a talk. */
void talk_message(void *closure, int level, const char *text);
bool talk_progress(void *closure, double done);

/* Prints the note of the command line, if there is one. */
void talk_note(talk *t);

/* Prints a line that begins with the program's name. */
void talk_line(talk *t, const char *kind, const char *text);
/* These functions print a line and give the exit status that goes with it. */
int talk_fail(talk *t, const plb_error *e);
int talk_wrong(talk *t, const char *what);
int talk_no_memory(void);

#endif
