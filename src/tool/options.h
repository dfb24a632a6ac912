/* SPDX-License-Identifier: MIT
 *
 * Command lines from tables: the parser, --help and the check against the manual all read the same rows.
 */
#ifndef PLB_TOOL_OPTIONS_H
#define PLB_TOOL_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>

/* One option. Rows without a name are headings for --help. */
typedef struct {
    char letter;          /* 'o' for -o, or 0 */
    const char *name;     /* "output" for --output */
    const char *argument; /* what --help calls its argument; NULL: takes none */
    const char *help;
    /* Stores the value (NULL without an argument). False: the value is wrong. */
    bool (*set)(void *settings, const char *value);
} option;

/* Reads argv[1…]: options anywhere, "--" ends them, "-" is an operand. Operands are moved to the front of argv and
 * *operands gets their count. False after one line on stderr that names the culprit. */
bool options_parse(const char *program, const option *table, size_t n, int argc, char **argv, void *settings, int *operands);

/* Prints the rows of the table, for --help. */
void options_print(const option *table, size_t n);

#endif
