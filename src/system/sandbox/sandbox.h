/* SPDX-License-Identifier: MIT
 *
 * The sandbox holds a foreign program to what it may touch. The kernel sees to that by Landlock (which files) and seccomp
 * (which system calls), as far as it has them, and by taking away what root may do beyond other users.
 */
#ifndef PLB_SYSTEM_SANDBOX_SANDBOX_H
#define PLB_SYSTEM_SANDBOX_SANDBOX_H

#include "system/sandbox/landlock.h"
#include "system/sandbox/seccomp.h"

typedef struct {
    landlock_rules files;
    seccomp_filter calls;
} cage;

/* Plans the cage of `program`: it may write in the folder `scratch` (NULL: nowhere), and start threads if `threads`. The strings
 * stay the caller's. */
void plb_sandbox_plan(cage *c, const char *program, const char *scratch, bool threads, char *const environment[]);
/* Locks the calling process, a child before its execve, in; for good. False when the kernel refuses what it said it had. */
bool plb_sandbox_enter(const cage *c);
/* Says what holds the program and, where something is missing, what it could do: a string for the user. */
const char *plb_sandbox_name(const cage *c);

#endif
