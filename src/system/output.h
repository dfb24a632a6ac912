/* SPDX-License-Identifier: MIT
 *
 * An output is a file that appears complete or not at all. It is written without a name where the file system can do that (so
 * that even a killed process leaves nothing behind), else under a temporary name beside its place, with a cleanup process that
 * removes it when this process is killed. Link or rename give it its name when it is done. Standard output and things that are
 * not regular files are written directly.
 */
#ifndef PLB_SYSTEM_OUTPUT_H
#define PLB_SYSTEM_OUTPUT_H

#include "base/error.h"
#include "system/cleanup_process.h"

#include <stdio.h>

typedef struct {
    FILE *to;       /* the caller writes here */
    char *name;     /* where it will appear; NULL: written directly */
    char *temporary; /* its name meanwhile; NULL: none */
    cleanup_process cleanup_process;   /* of the temporary name */
    bool is_kept;
    const char *asked; /* as the caller wrote it, for messages */
} output;

/* Returns a file's name as messages show it. */
const char *plb_output_shown(const char *file);

/* Opens the output; "-" is standard output. `file` must outlive the output. False and `err` on failure. */
bool plb_output_open(output *out, const char *file, error *err);
/* Closes the file and gives it its name. False and `err` when anything could not be written; nothing is left then. */
bool plb_output_commit(output *out, error *err);
/* Closes and removes the file. */
void plb_output_discard(output *out);

/* Returns a nameless file for reading and writing, in the folder of `beside` where that can be, which vanishes when it is closed or this process
 * ends. NULL and `err` on failure. */
FILE *plb_output_spool(const char *beside, error *err);

#endif
