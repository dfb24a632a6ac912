/* SPDX-License-Identifier: MIT
 *
 * Prints what shells complete, from a table of options.
 */
#ifndef PLB_TOOL_OPTIONS_COMPLETIONS_H
#define PLB_TOOL_OPTIONS_COMPLETIONS_H

#include "tool/options/options.h"

/* Prints the file that makes `shell` ("bash", "zsh" or "fish") complete the options of `program` and their words; other operands are
 * files. False: there is no such shell. */
bool completions_print(const char *shell, const char *program, const option *table, size_t n);

#endif
