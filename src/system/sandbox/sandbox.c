/* SPDX-License-Identifier: MIT
 *
 * See sandbox.h.
 */
#include "system/sandbox/sandbox.h"

#include <linux/securebits.h>
#include <stddef.h>
#include <sys/prctl.h>

void plb_sandbox_plan(cage *c, const char *program, const char *scratch, bool threads, char *const environment[])
{
    plb_landlock_plan(&c->files, program, scratch, environment);
    plb_seccomp_plan(&c->calls, (seccomp_rights){.writes = scratch != NULL, .threads = threads});
}

/* The program that root starts now has no privilege over others' files and processes: this process's memory, too. Who is not
 * root has none to lose, and may not ask. */
static void leave_privileges(void)
{
    prctl(PR_SET_SECUREBITS, SECBIT_NOROOT | SECBIT_NOROOT_LOCKED | SECBIT_NO_CAP_AMBIENT_RAISE | SECBIT_NO_CAP_AMBIENT_RAISE_LOCKED, 0, 0, 0);
    prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
}

bool plb_sandbox_enter(const cage *c)
{
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        return false;
    leave_privileges();
    if (c->files.version && !plb_landlock_enter(&c->files))
        return false;
    return !c->calls.n || plb_seccomp_enter(&c->calls);
}

const char *plb_sandbox_name(const cage *c)
{
    if (c->files.version && c->calls.n)
        return "Landlock, seccomp and limits";
    if (c->files.version)
        return "Landlock and limits; there is no seccomp here: it could reach the network and other processes";
    if (c->calls.n && c->files.scratch)
        return "seccomp and limits; there is no Landlock here: it could read and write this user's files";
    if (c->calls.n)
        return "seccomp and limits; there is no Landlock here: it could read this user's files, not write them";
    return "limits alone; there is neither Landlock nor seccomp here: it could do all that this user can";
}
