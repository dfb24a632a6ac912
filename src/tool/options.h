/* SPDX-License-Identifier: MIT
 *
 * Command lines from tables: the parser, --help and the check against the manual all read the same rows.
 */
#ifndef PLB_TOOL_OPTIONS_H
#define PLB_TOOL_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>

#define OPTION_WHY_SIZE 512

/* One option. Rows without a name are headings for --help. */
typedef struct {
    char letter;          /* 'o' for -o, or 0 */
    const char *name;     /* "output" for --output */
    const char *argument; /* what --help calls its argument; NULL: takes none */
    const char *help;
    /* Stores the value (NULL without an argument). False: the value is wrong. NULL: the caller of options_parse stores it. */
    bool (*set)(void *settings, const char *value);
} option;

/* Stores the value of an option that has no `set` of its own. False: `why` says what it takes. */
typedef bool option_store(void *settings, const option *o, const char *value, char why[OPTION_WHY_SIZE]);

/* Reads argv[1…]: options anywhere, "--" ends them, "-" is an operand. Operands are moved to the front of argv and
 * *operands gets their count. False after one line on stderr that names the culprit. */
typedef struct {
    const char *program;
    const option *table;
    size_t n;
    option_store *store; /* may be NULL where all options have a `set` */
} option_parser;
bool options_parse(const option_parser *p, int argc, char **argv, void *settings, int *operands);

/* Prints the rows of the table, for --help. */
void options_print(const option *table, size_t n);

#endif
