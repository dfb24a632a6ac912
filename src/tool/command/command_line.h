/* SPDX-License-Identifier: MIT
 *
 * Reads the command line of plumbago: the settings of the library, from its table, and the program's own options.
 */
#ifndef PLB_TOOL_COMMAND_COMMAND_LINE_H
#define PLB_TOOL_COMMAND_COMMAND_LINE_H

#include "api/plumbago.h"
#include "tool/options/options.h"

#define PROGRAM "plumbago"

struct talk;

typedef struct {
    plb_options *o;
    const char *output, *pencil;
    const char *pages;       /* as --page says: "2", "2-4", "1,5-" or "all"; NULL: the first */
    const char *completions; /* for which shell; NULL: for none */
    plb_document *document;  /* all pages in one file; NULL: a file each */
    int dump;                /* a plb_dump, or -1 */
    bool random_seed, quiet, no_clobber, film, list_pencils, version, help;
    int verbose;
    char note[160];          /* on a length without a unit; empty: none */
    struct talk *talk;       /* says what there is to say (talk.h) */
} settings;

#define MAX_OPTIONS 96 /* with headings */

/* Holds all options in the order of --help, and the texts that were made for them. */
typedef struct {
    option rows[MAX_OPTIONS];
    size_t n;
    char text[12288];
    size_t used;
} command_table;

void command_table_init(command_table *t);

/* Reads the arguments with options_parse. */
bool command_line_parse(settings *s, const command_table *t, int argc, char **argv, int *operands);

#endif
