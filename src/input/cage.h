/* SPDX-License-Identifier: MIT
 *
 * What a foreign program may touch: the kernel sees to it by Landlock (files, from Linux 5.13) and seccomp (system
 * calls), as far as it has them.
 */
#ifndef PLB_INPUT_CAGE_H
#define PLB_INPUT_CAGE_H

#include <stdbool.h>

#define CAGE_FONT_PATHS 12
#define CAGE_PATH_MAX 512

typedef struct {
    int landlock;         /* version of its interface; 0: none */
    bool seccomp;
    const char *program;  /* may be executed, once; the very pointer that execve will get */
    const char *scratch;  /* may be written in; NULL: nothing may */
    char fonts[CAGE_FONT_PATHS][CAGE_PATH_MAX]; /* the user's own; empty: none */
} cage;

/* Finds out what the kernel has, and where fonts lie by the environment (HOME, XDG_*, FONTCONFIG_*). */
void plb_cage_plan(cage *c, const char *program, const char *scratch, char *const environment[]);
/* Locks the calling process, a child before its execve, in; for good. False when the kernel refuses what it said it had. */
bool plb_cage_enter(const cage *c);
/* "Landlock and seccomp", "seccomp", "limits alone" … */
const char *plb_cage_name(const cage *c);

#endif
