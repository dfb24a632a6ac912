/* SPDX-License-Identifier: MIT
 *
 * What a foreign program may touch: the kernel sees to it by Landlock (files, from Linux 5.13) and seccomp (system
 * calls), as far as it has them.
 */
#ifndef PLB_SYSTEM_SANDBOX_H
#define PLB_SYSTEM_SANDBOX_H

#include <stdbool.h>

#define SANDBOX_FONT_PATHS 12
#define SANDBOX_PATH_MAX 512

typedef struct {
    int landlock;         /* version of its interface; 0: none */
    bool seccomp;
    const char *program;  /* may be executed, once; the very pointer that execve will get */
    const char *scratch;  /* may be written in; NULL: nothing may */
    char fonts[SANDBOX_FONT_PATHS][SANDBOX_PATH_MAX]; /* the user's own; empty: none */
} cage;

/* Finds out what the kernel has, and where fonts lie by the environment (HOME, XDG_*, FONTCONFIG_*). */
void plb_sandbox_plan(cage *c, const char *program, const char *scratch, char *const environment[]);
/* Locks the calling process, a child before its execve, in; for good. False when the kernel refuses what it said it had. */
bool plb_sandbox_enter(const cage *c);
/* "Landlock and seccomp", "seccomp", "limits alone" … */
const char *plb_sandbox_name(const cage *c);

#endif
