/* SPDX-License-Identifier: MIT
 *
 * Prepares the process that the programs were started in.
 */
#ifndef PLB_TOOL_OPTIONS_SURROUNDINGS_H
#define PLB_TOOL_OPTIONS_SURROUNDINGS_H

#include <stdbool.h>

/* Keeps the three standard descriptors taken, sets the signals that a shell may have left otherwise, makes the stack large enough
 * and keeps other programs of this user, the readers above all, out of our memory. False, and a line that says why, when the
 * program cannot work here. */
bool surroundings_prepare(const char *program);

#endif
