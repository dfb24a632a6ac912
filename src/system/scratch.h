/* SPDX-License-Identifier: MIT
 *
 * A scratch folder serves a foreign program that cannot do without temporary files. The folder goes away with its files in every
 * case: a process of its own removes it when we say so, or when we die.
 */
#ifndef PLB_SYSTEM_SCRATCH_H
#define PLB_SYSTEM_SCRATCH_H

#include "base/error.h"
#include "system/cleanup_process.h"

#define SCRATCH_PATH_MAX 1024

typedef struct {
    char folder[SCRATCH_PATH_MAX];
    cleanup_process cleanup_process;
} scratch;

/* Makes a folder that only this user may enter, below TMPDIR or /tmp. False and `err` when that fails; then there is
 * nothing to close. */
bool plb_scratch_open(scratch *s, error *err);
/* Removes the folder, whoever may still write in it. */
void plb_scratch_close(scratch *s);

#endif
