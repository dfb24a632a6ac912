/* SPDX-License-Identifier: MIT
 *
 * Keeps the three standard streams safe, for both programs.
 */
#ifndef PLB_TOOL_OPTIONS_STREAMS_H
#define PLB_TOOL_OPTIONS_STREAMS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Opens standard descriptors that are closed, because the system would give them to the next files, and messages would
 * be written into these. False when a descriptor cannot be filled. */
bool streams_keep(void);

/* Writes what a user gave, a file's name above all, into a message: one line, whatever bytes it holds. */
void streams_put(FILE *to, const char *text, size_t length);

/* Prints one line on standard error: "PROGRAM: KINDTEXT". */
void streams_say(const char *program, const char *kind, const char *text);

/* Writes out what is left for standard output. False, after a line that says why, when anything could not be written. */
bool streams_flush(const char *program);

#endif
