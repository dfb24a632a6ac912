/* SPDX-License-Identifier: MIT
 *
 * The three standard streams, as both programs use them.
 */
#ifndef PLB_TOOL_OPTIONS_STREAMS_H
#define PLB_TOOL_OPTIONS_STREAMS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Standard descriptors that are closed would be given to the files we open, and messages written into them: fills them.
 * False when that cannot be done. */
bool streams_keep(void);

/* Writes what a user gave, a file's name above all, into a message: one line, whatever bytes it holds. */
void streams_put(FILE *to, const char *text, size_t length);

/* One line on standard error: "PROGRAM: KINDTEXT". */
void streams_say(const char *program, const char *kind, const char *text);

/* Writes out what is left for standard output. False, and a line that says why, when anything could not be written. */
bool streams_flush(const char *program);

#endif
