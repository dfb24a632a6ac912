/* SPDX-License-Identifier: MIT
 *
 * The files that a foreign program may open, by Landlock (Linux 5.13 and later, where it is switched on).
 */
#ifndef PLB_SYSTEM_SANDBOX_LANDLOCK_H
#define PLB_SYSTEM_SANDBOX_LANDLOCK_H

#include <stdbool.h>

#define LANDLOCK_FONT_PATHS 12
#define LANDLOCK_PATH_MAX 512

typedef struct {
    int version;         /* of the kernel's interface; 0: none */
    const char *program; /* may be executed */
    const char *scratch; /* a folder in which files may be made and written; NULL: nowhere */
    char fonts[LANDLOCK_FONT_PATHS][LANDLOCK_PATH_MAX]; /* the user's own; empty: none */
} landlock_rules;

/* Finds out what the kernel has, and where fonts lie by the environment (HOME, XDG_*, FONTCONFIG_*). The strings stay the
 * caller's. */
void plb_landlock_plan(landlock_rules *c, const char *program, const char *scratch, char *const environment[]);
/* Binds the calling process, a child before its execve, for good; it must not gain privileges any more (PR_SET_NO_NEW_PRIVS).
 * False when the kernel refuses what it said it had. */
bool plb_landlock_enter(const landlock_rules *c);

#endif
