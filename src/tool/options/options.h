/* SPDX-License-Identifier: MIT
 *
 * Reads command lines by tables: the parser, --help, the completions of shells and the check against the manual all
 * read the same rows.
 */
#ifndef PLB_TOOL_OPTIONS_OPTIONS_H
#define PLB_TOOL_OPTIONS_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>

#define OPTION_WHY_SIZE 512

/* An option is a row of the table. Rows without a name are headings for --help. */
typedef struct {
    char letter;          /* 'o' for -o, or 0 */
    const char *name;     /* "output" for --output */
    const char *argument; /* what --help calls its argument: "FILE", "white|none"; NULL: takes none */
    const char *words;    /* what shells complete, between blanks: "white none"; NULL: no words; files where the argument is a FILE or FOLDER */
    const char *help;
    /* Stores the value (NULL without an argument). False: the value is wrong. NULL: the caller of options_parse stores it. */
    bool (*set)(void *settings, const char *value);
    const char *alias;    /* another name, which --help does not list by itself; NULL: none */
} option;

/* Stores the value of an option that has no `set` of its own. False: `why` says what the option takes. */
typedef bool option_store(void *settings, const option *o, const char *value, char why[OPTION_WHY_SIZE]);

typedef struct {
    const char *program;
    const option *table;
    size_t n;
    option_store *store; /* may be NULL where all options have a `set` */
} option_parser;

/* Reads argv[1…]: options anywhere, "--" ends them, "-" is an operand. Operands are moved to the front of argv and
 * *operands gets their count. False after one line on stderr that names the culprit and, perhaps, what was meant. */
bool options_parse(const option_parser *by, int argc, char **argv, void *settings, int *operands);

/* Prints the rows of the table for --help, within 80 columns. */
void options_print(const option *table, size_t n);

#endif
